#include "core/measure/unit_costs.h"

#include <algorithm>
#include <array>

#include "core/base/tally.h"

namespace zscope {
namespace {

constexpr double kNsPerMs = 1e6;

std::uint64_t talliedOf(const BenchRow& row, Unit unit)
{
    const auto found = std::ranges::find(row.tallies, wordOf(unit), &NamedCount::name);
    return found == row.tallies.end() ? 0 : found->value;
}

struct Divisor {
    WorkUnit      unit;
    std::uint64_t count;
};

std::vector<Divisor> divisorsOf(const BenchRow& row, Stage stage)
{
    const auto tallied = [&row](Unit unit) { return talliedOf(row, unit); };
    // What a pre-pass transforms, sets up and draws is counted with the rest, and its time is not.
    const bool hasPrepass = row.stageMs[static_cast<std::size_t>(Stage::Prepass)] > 0;
    switch (stage) {
        case Stage::Transform:
            if (hasPrepass) return {};
            return {{WorkUnit::Vertex, tallied(Unit::Vertices)}};
        case Stage::Setup:
            if (hasPrepass) return {};
            if (tallied(Unit::Edges) > 0) return {{WorkUnit::Edge, tallied(Unit::Edges)}};
            return {{WorkUnit::Triangle, tallied(Unit::TrianglesSetUp)}};
        case Stage::Cull:
            return {{WorkUnit::Node, tallied(Unit::Nodes)}};
        case Stage::Prepass:
            return {{WorkUnit::Pixel, tallied(Unit::PrepassPixels)}};
        case Stage::Raster:
            if (hasPrepass) return {{WorkUnit::Pixel, tallied(Unit::Pixels)}};
            return {{WorkUnit::ActiveEdge, tallied(Unit::ActiveEdges)},
                    {WorkUnit::Pixel, tallied(Unit::Pixels)},
                    {WorkUnit::Triangle, tallied(Unit::TrianglesDrawn)},
                    {WorkUnit::Window, tallied(Unit::Windows)}};
        case Stage::Upkeep:
            return {{WorkUnit::Cell, tallied(Unit::CellsWritten)}};
        case Stage::Shade:  // what blends transparent surfaces is in the same time
            if (tallied(Unit::Transparent) > 0) return {};
            return {{WorkUnit::Pixel, tallied(Unit::Fragments) + tallied(Unit::PicturePixels)}};
        case Stage::Clear:
        case Stage::Build:
        case Stage::Other:
            return {};
    }
    return {};
}

std::vector<UnitCost> shared(double ms, const std::vector<Divisor>& divisors)
{
    std::vector<UnitCost> costs;
    if (!(ms > 0)) return costs;
    for (const Divisor& divisor : divisors)
        if (divisor.count > 0)
            costs.push_back({divisor.unit, divisor.count, ms * kNsPerMs / static_cast<double>(divisor.count)});
    return costs;
}

}  // namespace

std::string_view wordOf(WorkUnit unit)
{
    constexpr std::array<std::string_view, 8> words{"vertex",      "triangle", "pixel", "edge",
                                                    "active edge", "node",     "cell",  "window"};
    return words[static_cast<std::size_t>(unit)];
}

std::vector<UnitCost> unitCosts(const BenchRow& row, Stage stage)
{
    if (!row.chosen.empty()) return {};
    return shared(row.stageMs[static_cast<std::size_t>(stage)], divisorsOf(row, stage));
}

std::vector<UnitCost> frameCosts(const BenchRow& row)
{
    return shared(row.medianMs, {{WorkUnit::Triangle, row.triangles}, {WorkUnit::Pixel, row.pixels}});
}

}  // namespace zscope
