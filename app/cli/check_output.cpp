#include "app/cli/check_output.h"

#include <cmath>

#include <fmt/format.h>

#include "app/cli/table.h"
#include "core/base/quotable.h"
#include "core/io/markup.h"

namespace zscope::cli {

using check::CheckAnswer;
using check::Mistake;

namespace {

std::string_view wordOf(FaceCulling culling) { return culling == FaceCulling::Back ? "back" : "none"; }

template <class Value>
Json wordOrNull(const std::optional<Value>& value)
{
    if (!value) return nullptr;
    if constexpr (std::is_same_v<Value, FaceCulling>)
        return wordOf(*value);
    else
        return check::wordOf(*value);
}

Json jsonOf(const check::MistakeCounts& counts)
{
    return {{"holes", counts.of(Mistake::Hole)},
            {"spills", counts.of(Mistake::Spill)},
            {"wrong_surface", counts.of(Mistake::WrongSurface)},
            {"wrong_depth", counts.of(Mistake::WrongDepth)}};
}

Json jsonOf(const check::PixelContent& content)
{
    Json json{{"id", nullptr}, {"depth", nullptr}};
    if (content.id) json["id"] = *content.id;
    if (content.depth && std::isfinite(*content.depth)) json["depth"] = *content.depth;
    return json;
}

Json jsonOf(const std::optional<check::WrongPixel>& wrong)
{
    if (!wrong) return nullptr;
    return {{"x", wrong->pixel.x},
            {"y", wrong->pixel.y},
            {"kind", check::wordOf(wrong->mistake)},
            {"expected", jsonOf(wrong->expected)},
            {"found", jsonOf(wrong->found)}};
}

std::string textOf(const check::PixelContent& content)
{
    std::string text;
    if (content.id) text += fmt::format("id {}", *content.id);
    if (content.depth) text += fmt::format("{}depth {:.9g}", text.empty() ? "" : ", ", *content.depth);
    return text.empty() ? "nothing" : text;
}

std::string conventionsText(const check::Conventions& c)
{
    const auto word = [](const auto& value) -> std::string {
        const Json json = wordOrNull(value);
        return json.is_null() ? "-" : json.get<std::string>();
    };
    return fmt::format("depth {}   rows {}   ids {}   ids from {}   cull {}\n", word(c.depth), word(c.rows),
                       word(c.ids), c.idsFrom ? std::to_string(*c.idsFrom) : "-", word(c.cull));
}

std::string messageOf(const CheckCase& judged)
{
    return judged.wrong == 0 ? std::string("nothing is wrong beyond rounding")
                             : fmt::format("{} wrong {}{}", judged.wrong, judged.what, judged.wrong == 1 ? "" : "s");
}

}  // namespace

Json jsonOf(const CheckAnswer& answer)
{
    const check::Conventions& c      = answer.conventions;
    Json                      causes = Json::array();
    for (const check::Cause& cause : answer.causes)
        causes.push_back({{"name", cause.name},
                          {"explains", cause.explains},
                          {"adds", cause.adds},
                          {"lesson", cause.lesson.empty() ? Json(nullptr) : Json(cause.lesson)}});
    return {{"conventions",
             {{"depth", wordOrNull(c.depth)},
              {"rows", wordOrNull(c.rows)},
              {"ids", wordOrNull(c.ids)},
              {"ids_from", c.idsFrom ? Json(*c.idsFrom) : Json(nullptr)},
              {"cull", wordOrNull(c.cull)}}},
            {"covered", answer.covered},
            {"wrong", jsonOf(answer.wrong)},
            {"rounding", jsonOf(answer.rounding)},
            {"first_wrong", jsonOf(answer.firstWrong)},
            {"causes", std::move(causes)},
            {"sentence", answer.sentence}};
}

Json jsonOf(const Judged& judged)
{
    Json json = judged.picture ? jsonOf(*judged.picture) : Json::object();
    if (!judged.trace) return json;
    const check::TraceAnswer& trace = *judged.trace;
    json["sentence"]                = judged.sentence();
    json["trace"]                   = {{"algorithm", trace.algorithm},
                                       {"rows", trace.rows.size()},
                                       {"wrong", trace.wrong},
                                       {"rounding", trace.rounding},
                                       {"first_wrong", nullptr}};
    if (const auto first = trace.firstWrong) {
        const check::JudgedRow& row  = trace.rows[*first];
        Json&                   said = json["trace"]["first_wrong"];
        said          = {{"row", *first}, {"line", judged.rows->rows[*first].line}, {"sentence", row.sentence}};
        said["grain"] = row.grain ? Json(wordOf(*row.grain)) : Json(nullptr);
        said["step"]  = row.grain ? Json(row.step.value) : Json(nullptr);
    }
    return json;
}

std::string Judged::sentence() const
{
    std::string text = picture ? picture->sentence : std::string();
    if (trace) text += (text.empty() ? "" : " ") + trace->sentence;
    return text;
}

namespace {

std::string textOf(const CheckAnswer& answer)
{
    std::string text = answer.sentence + "\n\n" + conventionsText(answer.conventions) + "\n";
    Table       counts({{"", Table::Align::Left}, {"holes"}, {"spills"}, {"wrong surface"}, {"wrong depth"}});
    for (const auto& [name, row] : {std::pair("wrong", &answer.wrong), std::pair("rounding", &answer.rounding)}) {
        std::vector<std::string> cells{name};
        for (const Mistake mistake : check::kMistakes) cells.push_back(grouped(row->of(mistake)));
        counts.row(std::move(cells));
    }
    text += counts.text();
    if (answer.firstWrong) {
        const check::WrongPixel& first = *answer.firstWrong;
        text += fmt::format("\nfirst wrong pixel ({}, {}): {}; expected {}; found {}\n", first.pixel.x, first.pixel.y,
                            check::wordOf(first.mistake), textOf(first.expected), textOf(first.found));
        Table covers({{"triangle"}, {"near/z"}, {"", Table::Align::Left}});
        for (const PixelCover& cover : first.covers)
            covers.row({std::to_string(cover.triangle.value), fmt::format("{:.9g}", cover.depth),
                        std::string(zscope::wordOf(cover.cover))});
        text += first.covers.empty() ? "no triangle covers it\n" : covers.text();
    }
    if (!answer.causes.empty() && answer.plight == check::Plight::None) {
        Table causes({{"cause", Table::Align::Left}, {"explains"}, {"adds"}, {"lesson", Table::Align::Left}});
        for (const check::Cause& cause : answer.causes)
            causes.row(
                {cause.name, check::percentText(cause.explains), grouped(cause.adds), std::string(cause.lesson)});
        text += "\n" + causes.text();
    }
    if (!answer.clusters.empty()) {
        Table clusters({{"where wrong pixels lie", Table::Align::Left}, {"of the wrong"}, {"of the covered"}});
        for (const check::Cluster& cluster : answer.clusters)
            clusters.row(
                {std::string(cluster.where), check::percentText(cluster.share), check::percentText(cluster.usual)});
        text += "\n" + clusters.text();
    }
    return text;
}

std::string textOf(const check::TraceAnswer& answer, const check::Trace& trace)
{
    std::string text = answer.sentence + "\n";
    if (!answer.firstWrong) return text;
    const check::JudgedRow& row   = answer.rows[*answer.firstWrong];
    const check::TraceRow&  first = trace.rows[*answer.firstWrong];
    text += fmt::format("\nfirst wrong row: {}, {}:{}\n", *answer.firstWrong, printable(trace.file), first.line);
    if (row.grain)
        text += fmt::format("ours: step --algorithm {} --grain {} --at {}\n", answer.algorithm, wordOf(*row.grain),
                            row.step.value);
    return text;
}

}  // namespace

std::string textOf(const Judged& judged)
{
    std::string text = judged.picture ? textOf(*judged.picture) : std::string();
    if (judged.trace) text += (text.empty() ? "" : "\n") + textOf(*judged.trace, *judged.rows);
    return text;
}

std::vector<CheckCase> casesOf(const Judged& judged)
{
    std::vector<CheckCase> cases;
    if (judged.picture) {
        // What a file of background alone shows is judged by its coverage.
        const auto& wrong       = judged.picture->wrong;
        const auto& conventions = judged.picture->conventions;
        cases                   = {{"coverage", true, wrong.of(Mistake::Hole) + wrong.of(Mistake::Spill)},
                                   {"surface", conventions.ids.has_value(), wrong.of(Mistake::WrongSurface)},
                                   {"depth", conventions.depth.has_value(), wrong.of(Mistake::WrongDepth)}};
    }
    if (judged.trace) cases.push_back({"trace", true, judged.trace->wrong, "row"});
    return cases;
}

std::string junitOf(const Judged& judged, const std::string& name)
{
    std::string cases;
    int         failures = 0, skipped = 0, tests = 0;
    for (const CheckCase& each : casesOf(judged)) {
        std::string inside;
        ++tests;
        if (!each.isJudged) {
            ++skipped;
            inside = "      <skipped message=\"the files do not show it\"/>\n";
        } else if (each.wrong > 0) {
            ++failures;
            inside = fmt::format("      <failure type=\"wrong\" message=\"{}\">{}</failure>\n", messageOf(each),
                                 markupText(judged.sentence()));
        }
        cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"", markupText(name), each.name)
                 + (inside.empty() ? "/>\n" : ">\n" + inside + "    </testcase>\n");
    }
    return fmt::format(
               "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"{2}\" failures=\"{0}\" errors=\"0\">\n"
               "  <testsuite name=\"zscope-cli check\" tests=\"{2}\" failures=\"{0}\" errors=\"0\" skipped=\"{1}\" "
               "time=\"0\">\n",
               failures, skipped, tests)
           + cases + "  </testsuite>\n</testsuites>\n";
}

std::string gradescopeOf(const Judged& judged, const std::string& name)
{
    Json tests = Json::array();
    for (const CheckCase& each : casesOf(judged)) {
        if (!each.isJudged) continue;
        tests.push_back({{"name", name + ": " + std::string(each.name)},
                         {"score", each.wrong == 0 ? 1 : 0},
                         {"max_score", 1},
                         {"status", each.wrong == 0 ? "passed" : "failed"},
                         {"output", messageOf(each)}});
    }
    return cli::textOf(Json{{"output", judged.sentence()}, {"tests", std::move(tests)}});
}

}  // namespace zscope::cli
