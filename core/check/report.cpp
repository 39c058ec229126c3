#include "core/check/report.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "core/base/grouped.h"
#include "core/check/report_pictures.h"
#include "core/io/file_writer.h"
#include "core/io/markup.h"
#include "core/io/phrase_book.h"
#include "core/io/png.h"

namespace zscope::check {
namespace {

constexpr std::string_view kHead  = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<title>)";
constexpr std::string_view kStyle = R"(</title><style>
body{font:15px/1.5 system-ui,"Noto Sans CJK SC","WenQuanYi Micro Hei",sans-serif;color:#1b1b1f;background:#fff;max-width:1100px;margin:24px auto;padding:0 16px}
h1{font-size:26px;margin:16px 0 4px;overflow-wrap:anywhere}h2{font-size:19px;margin:32px 0 8px;border-top:1px solid #ddd;padding-top:20px}
p.soft,figcaption,td.soft{color:#5a5a62}p.verdict{font-size:17px;border-left:6px solid #b00020;padding:4px 12px;margin:12px 0}
p.right{border-color:#1a7f4b}
div.row{display:flex;flex-wrap:wrap;gap:16px;margin-bottom:12px}figure{margin:0;flex:1 1 300px;max-width:520px}figure.wide{max-width:780px;flex-basis:100%}
svg.picture{width:100%;height:auto;display:block;border:1px solid #c9ccd3}image{image-rendering:pixelated}figcaption{font-size:13px;margin-top:2px}
table{border-collapse:collapse;font-variant-numeric:tabular-nums;font-size:14px;margin:8px 0}
th,td{padding:3px 10px;text-align:right;border-bottom:1px solid #e6e6ea}th.l,td.l{text-align:left;overflow-wrap:anywhere}
tr.first td{font-weight:600}ul.key{list-style:none;padding:0;display:flex;flex-wrap:wrap;gap:4px 18px;font-size:14px}
i{display:inline-block;width:14px;height:14px;border:1px solid #777;vertical-align:-2px;margin-right:6px}
pre{background:#f3f3f6;padding:8px;white-space:pre-wrap;overflow-wrap:anywhere;font-size:13px}
#en:checked~main .zh,#zh:checked~main .en{display:none}
h2{break-after:avoid}figure,tr{break-inside:avoid}
@media print{input,label{display:none}body{max-width:none;margin:0}*{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
</style></head><body>
<input type="radio" name="language" id="en" checked><label for="en" lang="en">English</label>
<input type="radio" name="language" id="zh"><label for="zh" lang="zh-CN">简体中文</label>
<main>
)";

/// What core says, in both languages; once, where they are the same.
std::string said(std::string_view english)
{
    const std::string chinese = chinesePhrases().said(english);
    const std::string text    = markupText(english);
    if (chinese == english) return text;
    return fmt::format(R"(<span class="en">{}</span><span class="zh" lang="zh-CN">{}</span>)", text,
                       markupText(chinese));
}

std::string heading(std::string_view english) { return fmt::format("<h2>{}</h2>\n", said(english)); }

/// Cells are HTML; the first columns of words, those after them of numbers.
class HtmlTable {
public:
    explicit HtmlTable(std::size_t words) : m_words(words) {}

    void head(const std::vector<std::string_view>& titles)
    {
        std::vector<std::string> cells;
        for (const std::string_view title : titles) cells.push_back(said(title));
        addRow("th", cells);
    }
    void row(const std::vector<std::string>& cells, std::string_view kind = {}) { addRow("td", cells, kind); }

    bool        isEmpty() const { return m_rows.empty(); }
    std::string text() const { return "<table>\n" + m_rows + "</table>\n"; }

private:
    void addRow(std::string_view tag, const std::vector<std::string>& cells, std::string_view kind = {})
    {
        m_rows += kind.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", kind);
        for (std::size_t i = 0; i < cells.size(); ++i)
            m_rows += fmt::format("<{0}{1}>{2}</{0}>", tag, i < m_words ? " class=\"l\"" : "", cells[i]);
        m_rows += "</tr>\n";
    }

    std::size_t m_words;
    std::string m_rows;
};

struct Ring {
    double x = 0, y = 0, radius = 0;  // of the picture's pixels
};

/// A picture that is in the page, with a ring around a place of it.
Result<std::string> figure(const Grid<std::uint32_t>& picture, const std::string& caption,
                           const std::optional<Ring>& ring = {}, std::string_view kind = {})
{
    const Result<std::string> png = pngOf(picture.view());
    if (!png) return png.error();
    std::string html = fmt::format(
        R"(<figure{2}><svg class="picture" role="img" viewBox="0 0 {0} {1}"><image width="{0}" height="{1}" href="data:image/png;base64,{3}"/>)",
        picture.width(), picture.height(), kind.empty() ? "" : fmt::format(" class=\"{}\"", kind), base64(*png));
    if (ring)
        for (const auto& [width, colour] : {std::pair(0.5, "#fff"), std::pair(0.25, "#000")})
            html += fmt::format(
                R"(<circle cx="{:.2f}" cy="{:.2f}" r="{:.2f}" fill="none" stroke="{}" stroke-width="{:.3f}"/>)",
                ring->x, ring->y, ring->radius, colour, width * ring->radius / 2);
    return html + fmt::format("</svg><figcaption>{}</figcaption></figure>\n", caption);
}

std::string keyEntry(std::uint32_t colour, std::string_view what, std::optional<std::uint64_t> pixels = {})
{
    return fmt::format("<li><i style=\"background:#{:06x}\"></i>{}{}</li>\n", colour & 0xFFFFFFu, said(what),
                       pixels ? ": " + grouped(*pixels) : "");
}

constexpr std::array<std::string_view, 4> kMistakeTitles{"Hole", "Spill", "Wrong surface", "Wrong depth"};
std::string_view titleOf(Mistake mistake) { return kMistakeTitles[static_cast<std::size_t>(mistake)]; }

constexpr std::array<std::string_view, 6> kCoverTitles{
    "Opaque",           "Transparent",          "Beyond the far plane", "Hole of its material",
    "Culled back face", "Before the near plane"};
std::string_view titleOf(Cover cover) { return kCoverTitles[static_cast<std::size_t>(cover)]; }

/// "Id 12, Depth 0.5", as numbers of the files.
std::string contentOf(const PixelContent& content)
{
    std::string html;
    if (content.id) html += said("Id") + fmt::format(" {}", *content.id);
    if (content.depth) html += (html.empty() ? "" : ", ") + said("Depth") + fmt::format(" {:.9g}", *content.depth);
    return html.empty() ? said("Nothing") : html;
}

/// The instance, mesh and group that a triangle belongs to, as far as the scene has several.
std::string ownerOf(const Scene& scene, TriangleId id)
{
    const InstanceId  instance = scene.instanceOf(id);
    const Mesh&       mesh     = scene.meshOf(instance);
    const std::size_t own      = id.value - scene.firstTriangle[instance.value];
    std::string       owner    = mesh.groups[mesh.polygonGroup[mesh.trianglePolygon[own].value].value];
    if (scene.instances.size() > 1) owner = fmt::format("instance {}: {} {}", instance.value, mesh.name, owner);
    return owner;
}

/// Of a pair both (core/check/causes.h).
std::string titlesOf(const Cause& cause)
{
    constexpr std::string_view kBetween = "' and '";
    const std::size_t          at       = cause.title.find(kBetween);
    if (at == std::string::npos) return said(cause.title);
    return said(cause.title.substr(0, at)) + " + " + said(cause.title.substr(at + kBetween.size()));
}

class Page {
public:
    Page(const CheckAnswer& answer, const std::string& command, const ReportedTrace& trace)
        : m_answer(answer), m_command(command), m_trace(trace), m_scene(answer.truth->scene->scene())
    {}

    Result<std::string> html() const
    {
        const auto pictures = picturesSection();
        if (!pictures) return pictures.error();
        const auto first = firstWrongSection();
        if (!first) return first.error();
        return std::string(kHead) + markupText("ZScope: " + m_scene.name) + std::string(kStyle) + headSection()
               + countsSection() + *pictures + *first + causesSection() + traceSection() + conventionsSection()
               + commandSection() + "</main></body></html>\n";
    }

private:
    std::string headSection() const
    {
        const Camera& camera = m_answer.camera;
        return fmt::format(
            "<h1>{}: {}</h1>\n<p class=\"soft\">{}: {} × {}. ZScope {}. {}: {}.</p>\n"
            "<p class=\"verdict{}\">{}</p>\n",
            said("Judged picture"), markupText(m_scene.name), said("Pixels"), camera.width, camera.height,
            ZSCOPE_VERSION, said("Scene digest"), markupText(m_scene.digest), m_answer.isRight() ? " right" : "",
            said(m_answer.sentence));
    }

    std::string countsSection() const
    {
        HtmlTable table(1);
        table.head({"Pixels", "Holes", "Spills", "Wrong surfaces", "Wrong depths", "Together"});
        for (const auto& [title, counts] :
             {std::pair("Wrong", &m_answer.wrong), std::pair("Rounding alone", &m_answer.rounding)}) {
            std::vector<std::string> cells{said(title)};
            for (const Mistake mistake : kMistakes) cells.push_back(grouped(counts->of(mistake)));
            cells.push_back(grouped(counts->total()));
            table.row(cells);
        }
        return table.text();
    }

    Result<std::string> picturesSection() const
    {
        const ReportPictures pictures = reportPictures(m_answer);
        std::optional<Ring>  ring;
        if (const auto& first = m_answer.firstWrong)
            ring = Ring{(first->pixel.x + 0.5) / pictures.scale, (first->pixel.y + 0.5) / pictures.scale,
                        std::max(3.0, std::max(pictures.map.width(), pictures.map.height()) / 60.0)};
        std::string html = heading("Where the pictures differ") + "<ul class=\"key\">\n";
        for (const Mistake mistake : kMistakes)
            html += keyEntry(kMistakeColours[static_cast<std::size_t>(mistake)], titleOf(mistake),
                             m_answer.wrong.of(mistake));
        html += keyEntry(kRoundingColour, "Rounding alone", m_answer.rounding.total());
        html += keyEntry(kRightColour, "Right") + keyEntry(kEmptyColour, "Empty in both") + "</ul>\n";
        const std::string caption = ring ? said("The ring is around the first wrong pixel.") : std::string();
        const auto        map     = figure(pictures.map, caption, ring, "wide");
        if (!map) return map.error();
        html += "<div class=\"row\">" + *map + "</div>\n";
        const auto pairs = pairsOf(pictures, {});
        if (!pairs) return pairs.error();
        html += *pairs;
        if (m_answer.shown.depth)
            html += fmt::format("<p class=\"soft\">{}</p>\n",
                                said("Lighter depths are nearer; equal steps of colour hold equally many pixels of the "
                                     "reference."));
        return html;
    }

    Result<std::string> pairsOf(const ReportPictures& pictures, const std::optional<Ring>& ring) const
    {
        std::string html;
        for (const ReportPair& pair : pictures.pairs) {
            html += "<div class=\"row\">";
            for (const auto& [whose, picture] :
                 {std::pair("Reference", &pair.reference), std::pair("Judged picture", &pair.found)}) {
                const auto shown = figure(*picture, said(pair.title) + ": " + said(whose), ring);
                if (!shown) return shown.error();
                html += *shown;
            }
            html += "</div>\n";
        }
        return html;
    }

    Result<std::string> firstWrongSection() const
    {
        if (!m_answer.firstWrong) return std::string();
        const WrongPixel& first = *m_answer.firstWrong;
        std::string       html  = heading("The first wrong pixel");
        html += fmt::format("<p>({}, {}): {}. {}: {}. {}: {}.</p>\n", first.pixel.x, first.pixel.y,
                            said(titleOf(first.mistake)), said("Expected"), contentOf(first.expected), said("Found"),
                            contentOf(first.found));
        if (first.covers.empty()) {
            html += fmt::format("<p>{}</p>\n", said("No triangle covers it."));
        } else {
            HtmlTable table(0);
            table.head({"Triangle", "near/z", "What it does there", "Part of"});
            constexpr std::size_t kMost = 100;
            for (const PixelCover& cover : std::span(first.covers).first(std::min(kMost, first.covers.size())))
                table.row({std::to_string(cover.triangle.value), fmt::format("{:.9g}", cover.depth),
                           said(titleOf(cover.cover)), markupText(ownerOf(m_scene, cover.triangle))});
            html +=
                fmt::format("<p>{}</p>\n", said("Triangles that meet its centre, the nearest first:")) + table.text();
            if (first.covers.size() > kMost)
                html += fmt::format("<p>{}</p>\n", said(fmt::format("{} more meet it.", first.covers.size() - kMost)));
        }
        constexpr int       kRadius = 10;
        const PictureWindow window  = windowAround(first.pixel, kRadius, m_answer.camera.width, m_answer.camera.height);
        const auto          around  = pairsOf(reportPictures(m_answer, window),
                                              Ring{first.pixel.x - window.x0 + 0.5, first.pixel.y - window.y0 + 0.5, 0.9});
        if (!around) return around.error();
        return html + fmt::format("<p>{}</p>\n", said("The pixels around it, enlarged:")) + *around;
    }

    std::string causesSection() const
    {
        if (m_answer.isRight()) return {};
        std::string html;
        if (!m_answer.causes.empty()) {
            HtmlTable table(2);
            table.head({"Mistake", "Name", "Explains", "Would spoil more pixels", "Lesson"});
            for (const Cause& cause : m_answer.causes)
                table.row({titlesOf(cause), markupText(cause.name), percentText(cause.explains), grouped(cause.adds),
                           markupText(cause.lesson)});
            html += heading("Likely causes") + table.text();
        }
        if (!m_answer.clusters.empty()) {
            HtmlTable table(1);
            table.head({"Place", "Of the wrong pixels", "Of the covered pixels"});
            for (const Cluster& cluster : m_answer.clusters)
                table.row({said(cluster.where), percentText(cluster.share), percentText(cluster.usual)});
            html += heading("Where the wrong pixels lie") + table.text();
        }
        return html;
    }

    std::string traceSection() const
    {
        constexpr std::size_t kMost = 20;  // rows that differ
        if (!m_trace.answer) return {};
        const TraceAnswer& answer = *m_trace.answer;
        std::string        html =
            heading("The trace")
            + fmt::format("<p class=\"verdict{}\">{}</p>\n", answer.isRight() ? " right" : "", said(answer.sentence));
        if (answer.isRight()) return html;
        HtmlTable     table(3);
        std::uint64_t shown = 0;
        table.head({"Line of the trace", "What differs", "Our step"});
        for (std::size_t row = 0; row < answer.rows.size() && shown < kMost; ++row) {
            const JudgedRow& judged = answer.rows[row];
            if (!judged.isWrong()) continue;
            ++shown;
            table.row({std::to_string(m_trace.trace->rows[row].line), said(judged.sentence),
                       judged.grain ? markupText(fmt::format("step --algorithm {} --grain {} --at {}", answer.algorithm,
                                                             wordOf(*judged.grain), judged.step.value))
                                    : said("None")});
        }
        html += table.text();
        if (answer.wrong > shown)
            html += fmt::format("<p>{}</p>\n",
                                said(fmt::format("More rows that differ: {}.", grouped(answer.wrong - shown, ','))));
        return html;
    }

    std::string conventionsSection() const
    {
        const Conventions& c = m_answer.conventions;
        HtmlTable          table(2);
        if (c.depth) table.row({said("What depths mean"), markupText(wordOf(*c.depth))});
        if (c.rows) table.row({said("Order of rows"), markupText(wordOf(*c.rows))});
        if (c.ids) table.row({said("What ids number"), markupText(wordOf(*c.ids))});
        if (c.idsFrom) table.row({said("Number of the first"), std::to_string(*c.idsFrom)});
        if (c.cull)
            table.row({said("Faces that are not drawn"), markupText(c.cull == FaceCulling::Back ? "back" : "none")});
        if (table.isEmpty()) return {};
        return heading("Conventions of the files") + table.text();
    }

    std::string commandSection() const
    {
        if (m_command.empty()) return {};
        return heading("The same judgement again") + fmt::format("<pre>{}</pre>\n", markupText(m_command));
    }

    const CheckAnswer& m_answer;
    const std::string& m_command;
    ReportedTrace      m_trace;
    const Scene&       m_scene;
};

}  // namespace

Result<std::string> reportPage(const CheckAnswer& answer, const std::string& command, const ReportedTrace& trace)
{
    return Page(answer, command, trace).html();
}

Result<Done> makeFolder(const std::string& folder)
{
    std::error_code trouble;
    std::filesystem::create_directories(folder, trouble);
    if (trouble) return Error{Trouble::Output, "this folder cannot be made: " + trouble.message(), folder};
    return Done{};
}

Result<std::string> writeReport(const CheckAnswer& answer, const std::string& command, const std::string& folder,
                                const ReportedTrace& trace)
{
    const auto page = reportPage(answer, command, trace);
    if (!page) return page.error();
    if (const auto done = makeFolder(folder); !done) return done.error();
    const std::string path = (std::filesystem::path(folder) / kReportFile).string();
    if (const auto done = writeFile(path, *page); !done) return done.error();
    return path;
}

}  // namespace zscope::check
