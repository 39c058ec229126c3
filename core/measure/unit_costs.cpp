#include "core/measure/unit_costs.h"

#include <algorithm>
#include <array>

namespace zscope {
namespace {

constexpr double kNsPerMs = 1e6;

std::uint64_t counted(const BenchRow& row, std::string_view name)
{
    const auto found = std::ranges::find(row.counters, name, &NamedCount::name);
    return found == row.counters.end() ? 0 : found->value;
}

/// Every triangle that a batch handed to set-up, whatever became of it there.
std::uint64_t trianglesSetUp(const BenchRow& row)
{
    constexpr std::array kFates{
        "triangles_clipped_away", "triangles_back_facing", "triangles_degenerate", "triangles_no_pixel_centre",
        "triangles_out_of_range", "triangles_hidden",      "triangles_drawn"};
    std::uint64_t all = 0;
    for (const char* fate : kFates) all += counted(row, fate);
    return all;
}

struct Divisor {
    WorkUnit      unit;
    std::uint64_t count;
};

std::vector<Divisor> divisorsOf(const BenchRow& row, Stage stage)
{
    const std::uint64_t edges      = counted(row, "edges");
    const bool          hasPrepass = counted(row, "prepass_pixels_tested") > 0;
    switch (stage) {
        case Stage::Transform:  // of a pre-pass the vertices are counted here, and their time is not
            if (hasPrepass) return {};
            return {{WorkUnit::Vertex, counted(row, "vertices_transformed")}};
        case Stage::Setup:
            if (edges > 0) return {{WorkUnit::Edge, edges}};
            return {{WorkUnit::Triangle, trianglesSetUp(row)}};
        case Stage::Cull:
            return {{WorkUnit::Node, counted(row, "nodes_visited")}};
        case Stage::Prepass:
            return {{WorkUnit::Pixel, counted(row, "prepass_pixels_tested")}};
        case Stage::Raster:
            return {{WorkUnit::ActiveEdge, counted(row, "active_edge_lines")},
                    {WorkUnit::Pixel, counted(row, "pixels_tested")}};
        case Stage::Upkeep:
            return {{WorkUnit::Cell, counted(row, "pyramid_writes")}};
        case Stage::Shade:  // what blends transparent surfaces is in the same time
            if (counted(row, "fragments_transparent") > 0) return {};
            return {{WorkUnit::Pixel, counted(row, "fragments_shaded")}};
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
    constexpr std::array<std::string_view, 7> words{"vertex",      "triangle", "pixel", "edge",
                                                    "active edge", "node",     "cell"};
    return words[static_cast<std::size_t>(unit)];
}

std::vector<UnitCost> unitCosts(const BenchRow& row, Stage stage)
{
    if (!row.chosen.empty()) return {};
    return shared(row.stageQuartiles[static_cast<std::size_t>(stage)].median, divisorsOf(row, stage));
}

std::vector<UnitCost> frameCosts(const BenchRow& row)
{
    return shared(row.medianMs, {{WorkUnit::Triangle, row.triangles}, {WorkUnit::Pixel, row.pixels}});
}

}  // namespace zscope
