#include "core/measure/comparison_sheet.h"

#include <algorithm>
#include <array>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "core/measure/record.h"
#include "core/probe/words.h"

namespace zscope {
namespace {

constexpr std::uint32_t kInk = 0xFF1A1A1Au, kPale = 0xFF6B6B6Bu, kWrong = 0xFFB00020u;
constexpr int           kStep = 8, kMargin = 3 * kStep, kGap = 2 * kStep;
// sizes of letters and height of a line, pixels
constexpr int kSmall = 13, kLarge = 18, kTitle = 24, kLine = 19;
constexpr int kMaxPictureWidth = 480, kMinColumn = 400;

/// One colour per stage, from dark to light and back, told apart by their names too.
constexpr std::array<std::uint32_t, kStages.size()> kStageColours{0xFF999999u, 0xFF0072B2u, 0xFF56B4E9u, 0xFF004D7Au,
                                                                  0xFFCC79A7u, 0xFF7A4A66u, 0xFFE69F00u, 0xFFF0E442u,
                                                                  0xFF009E73u, 0xFFCCCCCCu};

/// As the window writes it.

/// Differences must not fade in a smaller picture: where one pixel stands for several, one that differs is shown.
Grid<std::uint32_t> shrunk(const Grid<std::uint32_t>& differences, int width, int height)
{
    Grid<std::uint32_t> small(width, height);
    const auto          isGrey = [](std::uint32_t c) {
        return (c & 0xFFu) == (c >> 8 & 0xFFu) && (c & 0xFFu) == (c >> 16 & 0xFFu);
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int x0     = static_cast<int>(std::int64_t{x} * differences.width() / width),
                      y0     = static_cast<int>(std::int64_t{y} * differences.height() / height);
            const int     x1 = std::max(x0 + 1, static_cast<int>(std::int64_t{x + 1} * differences.width() / width));
            const int     y1 = std::max(y0 + 1, static_cast<int>(std::int64_t{y + 1} * differences.height() / height));
            std::uint32_t shown = differences.at(x0, y0);
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u)
                    if (isGrey(shown)) shown = differences.at(u, v);
            small.at(x, y) = shown;
        }
    return small;
}

struct Line {
    std::string   text;
    std::uint32_t colour = kInk;
};

std::string figureLine(const ErrorFigures& f)
{
    if (f.isExact()) return "same to the bit";
    return fmt::format("{} holes, {} spills, {} other, {} steps", withCommas(f.holes), withCommas(f.spills),
                       withCommas(f.wrongSurface()), withCommas(f.maxDepthSteps));
}

std::vector<Line> figuresOf(const ComparedAlgorithm& a, bool isFirst)
{
    std::vector<Line> lines;
    lines.push_back({fmt::format("{:.3f} ms a frame (quartiles {:.3f} to {:.3f}, best {:.3f})", a.report.frameMs,
                                 a.q1Ms, a.q3Ms, a.bestMs)});
    lines.push_back(
        {fmt::format("{} thread{}, {}{}", a.report.threads, a.report.threads == 1 ? "" : "s", wordOf(a.report.simd),
                     a.report.chosen.empty() ? "" : fmt::format(", drawn by {}", a.report.chosen)),
         kPale});
    if (a.againstReference) {
        const bool wrong = a.againstReference->wrongPixels() > 0 && a.algorithm.claim == Claim::Exact;
        lines.push_back({"Reference: " + figureLine(*a.againstReference), wrong ? kWrong : kInk});
    }
    if (isFirst)
        lines.push_back({"First: this one", kPale});
    else
        lines.push_back({"First: "
                         + (a.coloursDiffer > 0 && a.againstFirst.isExact()
                                ? fmt::format("{} other colours", withCommas(a.coloursDiffer))
                                : figureLine(a.againstFirst))});
    return lines;
}

std::uint64_t countOf(const ComparedAlgorithm& a, std::string_view name)
{
    const auto counter = std::ranges::find(a.counters, name, &NamedCount::name);
    return counter == a.counters.end() ? 0 : counter->value;
}

/// What at least one of them counted, in the order of stats.json: the same lines in every column.
std::vector<std::string> countersOf(const Comparison& comparison)
{
    std::vector<std::string> names;
    for (const ComparedAlgorithm& each : comparison.algorithms)
        for (const NamedCount& counter : each.counters) {
            const bool counts = std::ranges::any_of(comparison.algorithms, [&](const ComparedAlgorithm& other) {
                return countOf(other, counter.name) > 0;
            });
            if (counts && std::ranges::find(names, counter.name) == names.end()) names.push_back(counter.name);
        }
    return names;
}

class Sheet {
public:
    Sheet(const Comparison& comparison, const Scene& scene, const SheetWords& words, SheetCanvas& canvas)
        : m_comparison(comparison), m_scene(scene), m_words(words), m_canvas(canvas), m_counters(countersOf(comparison))
    {}

    void draw()
    {
        const Frame& first = m_comparison.algorithms.front().frame;
        const int    width = first.visible.width(), height = first.visible.height();
        m_pictureWidth  = std::min(width, kMaxPictureWidth);
        m_pictureHeight = std::max(1, static_cast<int>(std::int64_t{height} * m_pictureWidth / width));
        m_column        = std::max(m_pictureWidth, kMinColumn);
        // the legend stands in one
        m_cell                = std::max(m_pictureHeight, (static_cast<int>(differences().size()) + 2) * kLine);
        const auto columns    = static_cast<int>(m_comparison.algorithms.size());
        const int  textLines  = 4 + static_cast<int>(kStages.size()) + 2 + static_cast<int>(m_counters.size());
        const int  header     = kTitle + 2 * kLine + 2 * kStep,
                  column      = kLarge + m_pictureHeight + m_cell + 3 * kStep + 2 * kLine + textLines * kLine;
        const int  sheetWidth = 2 * kMargin + columns * m_column + (columns - 1) * kGap;
        const auto command    = wrapped(m_words.command, sheetWidth - 2 * kMargin);
        m_canvas.begin(sheetWidth, 2 * kMargin + header + column + kStep + static_cast<int>(command.size()) * kLine);

        int y = kMargin + kTitle;
        write(kMargin, y, m_words.scene, kTitle, kInk);
        write(kMargin, y += kLine + kStep / 2, m_words.machine, kSmall, kPale);
        for (int i = 0; i < columns; ++i)
            drawColumn(kMargin + i * (m_column + kGap), kMargin + header,
                       m_comparison.algorithms[static_cast<std::size_t>(i)], i == 0);
        y = kMargin + header + column + kStep;
        for (const std::string& line : command) write(kMargin, y += kLine, line, kSmall, kPale);
    }

private:
    void write(int x, int y, std::string_view text, int size, std::uint32_t colour)
    {
        m_canvas.text(x, y, text, size, colour);
    }

    /// Lines no wider than that, broken at spaces where there are any.
    std::vector<std::string> wrapped(std::string_view text, int width)
    {
        std::vector<std::string> lines{""};
        while (!text.empty()) {
            const std::size_t end = std::min(text.find(' '), text.size() - 1) + 1;
            const std::string word(text.substr(0, end));
            if (!lines.back().empty() && m_canvas.width(lines.back() + word, kSmall) > width) lines.emplace_back();
            lines.back() += word;
            text.remove_prefix(end);
        }
        return lines;
    }

    /// As much of it as fits.
    std::string fitted(std::string text)
    {
        if (m_canvas.width(text, kSmall) <= m_column) return text;
        while (!text.empty() && m_canvas.width(text + "...", kSmall) > m_column) text.pop_back();
        return text + "...";
    }

    void drawColumn(int x, int y, const ComparedAlgorithm& a, bool isFirst)
    {
        write(x, y += kLarge, a.algorithm.name, kLarge, kInk);
        m_canvas.picture(x, y += kStep, m_pictureWidth, m_pictureHeight, a.frame.colour);
        y += m_pictureHeight + kStep;
        const ComparedAlgorithm& first  = m_comparison.algorithms.front();
        const bool               byFace = drawsFaces(a.algorithm.pipeline) || drawsFaces(first.algorithm.pipeline);
        if (isFirst) {
            drawLegend(x, y + kLine);
        } else {
            m_canvas.picture(
                x, y, m_pictureWidth, m_pictureHeight,
                shrunk(paintDifference(first.frame, a.frame, m_scene, byFace), m_pictureWidth, m_pictureHeight));
        }
        y += m_cell;
        for (const Line& line : figuresOf(a, isFirst)) write(x, y += kLine, fitted(line.text), kSmall, line.colour);
        y += kLine;
        drawStages(x, y, a);
        drawCounters(x, y + (static_cast<int>(kStages.size()) + 1) * kLine, a);
    }

    void drawLegend(int x, int y)
    {
        write(x, y, "Beside it: where a picture differs from this one", kSmall, kPale);
        for (const DifferenceEntry& entry : differences()) {
            y += kLine;
            m_canvas.fill(x, y - kSmall + 2, x + kSmall, y + 2, entry.colour);
            write(x + kSmall + kStep, y, entry.title, kSmall, kInk);
        }
    }

    /// Bars of one scale for all columns.
    void drawStages(int x, int y, const ComparedAlgorithm& a)
    {
        double longest = 0;
        for (const ComparedAlgorithm& each : m_comparison.algorithms)
            for (const StageTime& stage : each.report.stages) longest = std::max(longest, stage.ms);
        constexpr int kName = 80, kNumber = 72;
        for (const StageTime& stage : a.report.stages) {
            const auto colour = kStageColours[static_cast<std::size_t>(stage.stage)];
            write(x, y + kSmall, wordOf(stage.stage), kSmall, stage.ran ? kInk : kPale);
            const int length =
                longest > 0 ? static_cast<int>(stage.ms / longest * (m_column - kName - kNumber - kStep)) : 0;
            if (stage.ran) m_canvas.fill(x + kName, y + 2, x + kName + std::max(length, 1), y + kSmall + 1, colour);
            writeToTheRight(x, y, stage.ran ? fmt::format("{:.3f} ms", stage.ms) : "-", stage.ran ? kInk : kPale);
            y += kLine;
        }
    }

    /// They come from a run of their own, not from the timed one above them.
    void drawCounters(int x, int y, const ComparedAlgorithm& a)
    {
        if (m_counters.empty()) return;
        write(x, y + kSmall, "Work of the textbook method", kSmall, kPale);
        y += kLine;
        for (const std::string& name : m_counters) {
            const std::uint64_t count = countOf(a, name);
            m_canvas.name(x, y + kSmall, name, kSmall, count > 0 ? kInk : kPale);
            writeToTheRight(x, y, count > 0 ? withCommas(count) : "-", count > 0 ? kInk : kPale);
            y += kLine;
        }
    }

    /// At the right end of a line that begins at y.
    void writeToTheRight(int x, int y, std::string_view text, std::uint32_t colour)
    {
        write(x + m_column - m_canvas.width(text, kSmall), y + kSmall, text, kSmall, colour);
    }

    const Comparison&              m_comparison;
    const Scene&                   m_scene;
    const SheetWords&              m_words;
    SheetCanvas&                   m_canvas;
    const std::vector<std::string> m_counters;  // the names of those that are shown
    int                            m_pictureWidth = 0, m_pictureHeight = 0, m_column = 0, m_cell = 0;
};

}  // namespace

void drawSheet(const Comparison& comparison, const Scene& scene, const SheetWords& words, SheetCanvas& canvas)
{
    Sheet(comparison, scene, words, canvas).draw();
}

SheetWords sheetWordsOf(const Comparison& comparison, const Scene& scene, const Camera& camera, std::string command)
{
    const FrameReport& report = comparison.algorithms.front().report;
    const std::size_t  count  = scene.triangleCount();
    return {.scene   = fmt::format("{}   {} triangle{}   {}x{}", scene.name, withCommas(count), count == 1 ? "" : "s",
                                   camera.width, camera.height),
            .machine = fmt::format("{}, {} cores; {} thread{}, {}; ZScope " ZSCOPE_VERSION "; scene {}",
                                   processorName(), std::thread::hardware_concurrency(), report.threads,
                                   report.threads == 1 ? "" : "s", wordOf(report.simd), scene.digest),
            .command = std::move(command)};
}

}  // namespace zscope
