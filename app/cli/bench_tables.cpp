#include "app/cli/bench_tables.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/cli/table.h"
#include "core/frame/shortcuts.h"
#include "core/measure/suites.h"

namespace zscope::cli {
namespace {

double msOf(const BenchRow& row, Stage stage) { return row.stageMs[static_cast<std::size_t>(stage)]; }

std::uint64_t counted(const BenchRow& row, std::string_view name)
{
    const auto found = std::ranges::find(row.counters, name, &NamedCount::name);
    return found == row.counters.end() ? 0 : found->value;
}

/// "0.42": how long it took, the baseline being 1. Nothing where the baseline was not run.
std::string againstBaseline(const BenchRow& row, std::span<const BenchRow> rows)
{
    for (const BenchRow& other : rows) {
        const bool alike = other.scene == row.scene && other.threads == row.threads && other.simd == row.simd
                           && other.shaded == row.shaded;
        if (alike && other.algorithm == kSuiteBaseline && other.medianMs > 0)
            return fmt::format("{:.2f}", row.medianMs / other.medianMs);
    }
    return "";
}

/// Plain text has one lane, whatever the machine has.
std::string lanesOf(const BenchRow& row) { return row.shortcuts.isEmpty() ? "plain" : std::string(wordOf(row.simd)); }

std::string shareOf(std::uint64_t part, std::uint64_t whole)
{
    return whole == 0 ? "" : fmt::format("{:.1f} %", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

}  // namespace

std::string pictureOf(const BenchRow& row)
{
    if (!row.wrongPixels) return "not checked";
    return *row.wrongPixels == 0 ? "verified" : fmt::format("{} wrong", *row.wrongPixels);
}

std::string drawnOf(const BenchRow& row) { return row.shaded ? "shaded" : "ids, depth"; }

std::string benchTableOf(std::span<const BenchRow> rows)
{
    Table table({{"scene", Table::Align::Left},
                 {"algorithm", Table::Align::Left},
                 {"threads"},
                 {"simd", Table::Align::Left},
                 {"drawn", Table::Align::Left},
                 {"picture", Table::Align::Left},
                 {"best ms"},
                 {"median"},
                 {"q1"},
                 {"q3"},
                 {"transform"},
                 {"setup"},
                 {"build"},
                 {"raster"},
                 {"shade"}});
    for (const BenchRow& row : rows)
        table.row({row.scene, row.algorithm, std::to_string(row.threads), lanesOf(row), drawnOf(row), pictureOf(row),
                   ms(row.bestMs), ms(row.medianMs), ms(row.q1Ms), ms(row.q3Ms), ms(msOf(row, Stage::Transform)),
                   ms(msOf(row, Stage::Setup)), ms(msOf(row, Stage::Build)), ms(msOf(row, Stage::Raster)),
                   ms(msOf(row, Stage::Shade))});
    return table.text();
}

std::string ladderTableOf(std::span<const BenchRow> rows)
{
    Table table({{"scene", Table::Align::Left},
                 {"algorithm", Table::Align::Left},
                 {"threads"},
                 {"drawn", Table::Align::Left},
                 {"shortcuts", Table::Align::Left},
                 {"picture", Table::Align::Left},
                 {"median ms"},
                 {"/ all"},
                 {"interval"}});
    for (const BenchRow& row : rows) {
        const auto whole = std::ranges::find_if(rows, [&](const BenchRow& other) {
            return other.shortcuts.isAll() && other.scene == row.scene && other.algorithm == row.algorithm
                   && other.threads == row.threads && other.simd == row.simd && other.shaded == row.shaded;
        });
        const bool isPaired =
            whole != rows.end() && row.roundMs.size() == whole->roundMs.size() && !row.roundMs.empty();
        const auto ratio = isPaired ? pairedRatio(row.roundMs, whole->roundMs) : PairedRatio{};
        table.row({row.scene, row.algorithm, std::to_string(row.threads), drawnOf(row), wordsOf(row.shortcuts),
                   pictureOf(row), ms(row.medianMs), isPaired ? fmt::format("{:.2f}", ratio.median) : "",
                   isPaired ? fmt::format("{:.2f} to {:.2f}", ratio.low, ratio.high) : ""});
    }
    return table.text();
}

std::string suiteTableOf(std::span<const BenchRow> rows)
{
    std::vector<Stage> stages;
    for (const Stage stage : kStages)
        if (std::ranges::any_of(rows, [stage](const BenchRow& row) { return msOf(row, stage) > 0; }))
            stages.push_back(stage);

    std::vector<Table::Column> columns{
        {"scene", Table::Align::Left},        {"algorithm", Table::Align::Left}, {"threads"},
        {"drawn", Table::Align::Left},        {"picture", Table::Align::Left},   {"median ms"},
        {fmt::format("/ {}", kSuiteBaseline)}};
    for (const Stage stage : stages) columns.push_back({std::string(wordOf(stage))});
    // of the textbook method, counted in a run of its own
    for (const char* title : {"textbook: in view", "culled by node", "by triangle", "share", "nodes"})
        columns.push_back({title});
    Table table(std::move(columns));
    for (const BenchRow& row : rows) {
        std::vector<std::string> cells{row.scene,      row.algorithm,    std::to_string(row.threads), drawnOf(row),
                                       pictureOf(row), ms(row.medianMs), againstBaseline(row, rows)};
        for (const Stage stage : stages) cells.push_back(ms(msOf(row, stage)));
        const std::uint64_t inView =
            counted(row, "triangles_in") - counted(row, "triangles_outside") - counted(row, "triangles_transparent");
        const std::uint64_t byNode     = counted(row, "triangles_hidden_by_node"),
                            byTriangle = counted(row, "triangles_hidden");
        cells.insert(cells.end(), {grouped(inView), grouped(byNode), grouped(byTriangle),
                                   shareOf(byNode + byTriangle, inView), grouped(counted(row, "nodes_visited"))});
        table.row(std::move(cells));
    }
    return table.text();
}

std::string experimentTableOf(std::span<const BenchRow> rows, std::string_view baseline)
{
    std::vector<Stage> stages;
    for (const Stage stage : kStages)
        if (std::ranges::any_of(rows, [stage](const BenchRow& row) { return msOf(row, stage) > 0; }))
            stages.push_back(stage);
    const auto baselineOf = [&](const BenchRow& row) -> const BenchRow* {
        const auto found = std::ranges::find_if(rows, [&](const BenchRow& other) {
            return other.algorithm == baseline && other.scene == row.scene && other.threads == row.threads
                   && other.shaded == row.shaded;
        });
        return found == rows.end() || found->isBroken() || found->roundMs.size() != row.roundMs.size()
                       || row.roundMs.empty()
                   ? nullptr
                   : &*found;
    };

    std::vector<Table::Column> columns{{"scene", Table::Align::Left},
                                       {"algorithm", Table::Align::Left},
                                       {"threads"},
                                       {"picture", Table::Align::Left},
                                       {"median ms"}};
    if (!baseline.empty()) columns.push_back({fmt::format("/ {}", baseline)});
    if (!baseline.empty()) columns.push_back({"interval"});
    for (const Stage stage : stages) columns.push_back({std::string(wordOf(stage))});
    Table table(std::move(columns));
    for (const BenchRow& row : rows) {
        const bool               isBroken = row.isBroken();
        std::vector<std::string> cells{row.scene, row.algorithm, std::to_string(row.threads), pictureOf(row),
                                       isBroken ? "struck out" : ms(row.medianMs)};
        if (!baseline.empty()) {
            const BenchRow* other = isBroken ? nullptr : baselineOf(row);
            const auto      ratio = other ? pairedRatio(row.roundMs, other->roundMs) : PairedRatio{};
            cells.push_back(other ? fmt::format("{:.2f}", ratio.median) : "");
            cells.push_back(other && row.roundMs.size() > 1 ? fmt::format("{:.2f}-{:.2f}", ratio.low, ratio.high) : "");
        }
        for (const Stage stage : stages) cells.push_back(isBroken ? "" : ms(msOf(row, stage)));
        table.row(std::move(cells));
    }
    return table.text();
}

std::string seriesTableOf(std::span<const BenchRow> rows)
{
    Table table({{"scene", Table::Align::Left},
                 {"algorithm", Table::Align::Left},
                 {"threads"},
                 {"frames"},
                 {"slowest ms"},
                 {"wrong frames"},
                 {"worst frame"},
                 {"after cuts"},
                 {"drawn by", Table::Align::Left}});
    for (const BenchRow& row : rows) {
        if (!row.series) continue;
        const Series& series  = *row.series;
        const auto    slowest = std::ranges::max_element(series.frames, {}, &SeriesFrame::ms);
        const auto    wrong   = std::ranges::count_if(
                 series.frames, [](const SeriesFrame& frame) { return frame.wrongPixels.value_or(0) > 0; });
        std::vector<std::string> lags;
        for (const Lag& lag : series.lags) lags.push_back(lag.frames ? std::to_string(*lag.frames) : "all");
        std::vector<std::pair<std::string, int>> chosen;
        for (const SeriesFrame& frame : series.frames) {
            if (frame.chosen.empty()) continue;
            const auto known = std::ranges::find(chosen, frame.chosen, &std::pair<std::string, int>::first);
            if (known == chosen.end())
                chosen.emplace_back(frame.chosen, 1);
            else
                ++known->second;
        }
        std::vector<std::string> drawn;
        for (const auto& [name, count] : chosen) drawn.push_back(fmt::format("{} {}", count, name));
        table.row({row.scene, row.algorithm, std::to_string(row.threads), std::to_string(series.frames.size()),
                   ms(slowest->ms), row.wrongPixels ? std::to_string(wrong) : "",
                   row.wrongPixels ? fmt::format("{:.2f} %", 100 * worstShare(series)) : "",
                   fmt::format("{}", fmt::join(lags, ", ")), fmt::format("{}", fmt::join(drawn, ", "))});
    }
    return table.text();
}

}  // namespace zscope::cli
