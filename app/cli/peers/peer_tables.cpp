#include "app/cli/peers/peer_tables.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "app/cli/bench_tables.h"
#include "app/cli/peers/peer_rows.h"
#include "app/cli/table.h"

namespace zscope::cli {
namespace {

/// Whether two rows time the same thing.
bool areComparable(const BenchRow& a, const BenchRow& b)
{
    return a.scene == b.scene && a.threads == b.threads && a.shaded == b.shaded;
}

/// nullptr: that peer did not run.
const BenchRow* peerOf(const BenchRow& row, std::span<const BenchRow> rows)
{
    const auto peer =
        std::ranges::find_if(rows, [&](const BenchRow& other) { return isPeer(other) && areComparable(row, other); });
    return peer == rows.end() ? nullptr : &*peer;
}

bool isFastest(const BenchRow& row, std::span<const BenchRow> rows)
{
    const auto counts = [](const BenchRow& each) { return !isPeer(each) && each.wrongPixels.value_or(0) == 0; };
    return counts(row) && std::ranges::none_of(rows, [&](const BenchRow& other) {
               return counts(other) && areComparable(row, other) && other.medianMs < row.medianMs;
           });
}

std::string ratio(double value) { return fmt::format("{:.2f}", value); }

std::string peerPicture(const BenchRow& row)
{
    return fmt::format("{} differ, {} beside edges", row.counters[0].value, row.counters[1].value);
}

std::string runsOf(std::span<const BenchRow> rows)
{
    Table table({{"scene", Table::Align::Left},
                 {"algorithm", Table::Align::Left},
                 {"threads"},
                 {"drawn", Table::Align::Left},
                 {"picture", Table::Align::Left},
                 {"best ms"},
                 {"median"},
                 {"q1"},
                 {"q3"},
                 {"peer / this"},
                 {"", Table::Align::Left}});
    for (const BenchRow& row : rows) {
        const BenchRow*   peer = isPeer(row) ? nullptr : peerOf(row, rows);
        const std::string note = isPeer(row) ? row.chosen
                                             : fmt::format("{}{}", isFastest(row, rows) ? "fastest" : "",
                                                           row.chosen.empty() ? "" : fmt::format(" ({})", row.chosen));
        table.row({row.scene, row.algorithm, std::to_string(row.threads), drawnOf(row),
                   isPeer(row) ? peerPicture(row) : pictureOf(row), ms(row.bestMs), ms(row.medianMs), ms(row.q1Ms),
                   ms(row.q3Ms), peer ? ratio(peer->medianMs / row.medianMs) : "", note});
    }
    return table.text();
}

/// The fastest presets of one kind of run against their peer; nothing if no peer ran.
std::string summaryOf(std::span<const BenchRow> rows, int threads, bool shaded)
{
    Table               table({{"scene", Table::Align::Left},
                               {"fastest preset", Table::Align::Left},
                               {"median ms"},
                               {"peer", Table::Align::Left},
                               {"median ms"},
                               {"times as fast"}});
    std::vector<double> ratios;
    for (const BenchRow& row : rows) {
        if (row.threads != threads || row.shaded != shaded || !isFastest(row, rows)) continue;
        const BenchRow* peer = peerOf(row, rows);
        if (!peer) continue;
        ratios.push_back(peer->medianMs / row.medianMs);
        table.row(
            {row.scene, row.algorithm, ms(row.medianMs), peer->algorithm, ms(peer->medianMs), ratio(ratios.back())});
    }
    if (ratios.empty()) return "";
    double logarithms = 0;
    for (const double each : ratios) logarithms += std::log(each);
    table.row({"geometric mean", "", "", "", "", ratio(std::exp(logarithms / static_cast<double>(ratios.size())))});
    table.row({"least", "", "", "", "", ratio(*std::ranges::min_element(ratios))});
    return fmt::format("\n{}, {} thread{}\n{}", shaded ? "Shaded" : "Ids and depth", threads, threads == 1 ? "" : "s",
                       table.text());
}

}  // namespace

std::string peerTablesOf(std::span<const BenchRow> rows)
{
    std::set<int> threads;
    for (const BenchRow& row : rows) threads.insert(row.threads);
    std::string text = runsOf(rows);
    for (const int count : threads)
        for (const bool shaded : {true, false}) text += summaryOf(rows, count, shaded);
    return text;
}

}  // namespace zscope::cli
