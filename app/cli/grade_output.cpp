#include "app/cli/grade_output.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "app/cli/check_output.h"
#include "app/cli/grade_journal.h"
#include "app/cli/table.h"
#include "core/io/markup.h"

namespace zscope::cli {
namespace {

constexpr std::array<std::pair<GradeVerdict, std::string_view>, 10> kVerdicts{{
    {GradeVerdict::Right, "right"},
    {GradeVerdict::Rounding, "rounding"},
    {GradeVerdict::Wrong, "wrong"},
    {GradeVerdict::Crashed, "crashed"},
    {GradeVerdict::Failed, "failed"},
    {GradeVerdict::TimedOut, "timed-out"},
    {GradeVerdict::TooMuchMemory, "too-much-memory"},
    {GradeVerdict::TooMuchOutput, "too-much-output"},
    {GradeVerdict::WroteNothing, "wrote-nothing"},
    {GradeVerdict::Unreadable, "unreadable"},
}};

std::string firstSentence(const std::string& text)
{
    const std::size_t end = text.find(". ");
    return end == std::string::npos ? text : text.substr(0, end + 1);
}

/// The likeliest one; empty: none was found, or there is nothing to explain.
std::string causeOf(const GradeRow& row)
{
    if (row.check.is_null() || row.check["causes"].empty()) return "";
    // an empty program has made no mistake of the gallery
    if (row.check["sentence"].get<std::string>().starts_with("Nothing was drawn")) return "";
    return row.check["causes"][0]["name"].get<std::string>();
}

std::string junitSuite(std::span<const GradeRow> rows)
{
    std::string cases;
    int         failures = 0, errors = 0;
    double      seconds = 0;
    for (const GradeRow& row : rows) {
        const bool isWrong = row.verdict == GradeVerdict::Wrong;
        if (!isGood(row.verdict)) ++(isWrong ? failures : errors);
        seconds += row.seconds;
        const std::string_view kind = isWrong ? "failure" : "error";
        cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", markupText(row.submission),
                             markupText(row.scene), row.seconds);
        cases += isGood(row.verdict)
                     ? "/>\n"
                     : fmt::format(">\n      <{0} type=\"{1}\" message=\"{1}\">{2}</{0}>\n    </testcase>\n", kind,
                                   wordOf(row.verdict), markupText(row.detail));
    }
    return fmt::format(
               "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"0\" time=\"{:.3f}\">\n",
               markupText(rows.front().submission), rows.size(), failures, errors, seconds)
           + cases + "  </testsuite>\n";
}

}  // namespace

std::string_view wordOf(GradeVerdict verdict)
{
    return std::ranges::find(kVerdicts, verdict, &std::pair<GradeVerdict, std::string_view>::first)->second;
}

std::optional<GradeVerdict> gradeVerdictOf(std::string_view word)
{
    const auto found = std::ranges::find(kVerdicts, word, &std::pair<GradeVerdict, std::string_view>::second);
    if (found == kVerdicts.end()) return std::nullopt;
    return found->first;
}

std::string gradeTableOf(std::span<const GradeRow> rows)
{
    Table table({{"submission", Table::Align::Left},
                 {"scene", Table::Align::Left},
                 {"verdict", Table::Align::Left},
                 {"cause", Table::Align::Left},
                 {"detail", Table::Align::Left}});
    for (const GradeRow& row : rows)  // a program's own words stand there whole
        table.row({row.submission, row.scene, std::string(wordOf(row.verdict)), causeOf(row),
                   row.check.is_null() ? row.detail : firstSentence(row.detail)});
    return table.text(outputWidth());
}

std::string gradeJsonOf(std::span<const GradeRow> rows)
{
    Json json = Json::array();
    for (const GradeRow& row : rows) json.push_back(cli::jsonOf(row));
    return textOf(json);
}

std::string gradeJunitOf(std::span<const GradeRow> rows)
{
    std::string suites;
    for (auto begin = rows.begin(); begin != rows.end();) {
        const auto end =
            std::find_if(begin, rows.end(), [&](const GradeRow& row) { return row.submission != begin->submission; });
        suites += junitSuite({begin, end});
        begin = end;
    }
    const auto bad   = [](const GradeRow& row) { return !isGood(row.verdict); };
    const auto wrong = std::ranges::count(rows, GradeVerdict::Wrong, &GradeRow::verdict);
    return fmt::format(
               "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
               rows.size(), wrong, std::ranges::count_if(rows, bad) - wrong)
           + suites + "</testsuites>\n";
}

std::string gradescopeOf(std::span<const GradeRow> rows)
{
    Json tests = Json::array();
    for (const GradeRow& row : rows)
        tests.push_back({{"name", row.scene},
                         {"score", isGood(row.verdict) ? 1 : 0},
                         {"max_score", 1},
                         {"status", isGood(row.verdict) ? "passed" : "failed"},
                         {"output", fmt::format("{}: {}", wordOf(row.verdict), row.detail)}});
    return textOf(Json{{"tests", std::move(tests)}});
}

}  // namespace zscope::cli
