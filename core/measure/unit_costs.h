// What one piece of work cost: the time of a stage divided by how many of the things it works on there were, both of
// the median frame. Two algorithms that meet different amounts of work can then be held against each other, stage by
// stage.
//
// Divisors   the tallies of the timed frame itself (core/base/tally.h). Transform: vertices; setup: triangles, or of a
//            sweep the edges of its edge table; cull: nodes; raster of a sweep: active edges, each once per line.
//            Where plain text draws also prepass, raster: pixels tested; upkeep: pyramid cells; shade: fragments.
//            Where shortcuts draw raster: triangles and windows; shade: pixels of the picture
// Left out   clear, build and other work on nothing that is counted. A divisor of 0, a stage that took no time, and a
//            stage whose tally counts another stage too give no figure rather than a misleading one
// Times      wall time with the row's threads: a stage that two threads share costs half as much per piece
// Auto       a measured choice draws its frames by several presets, so it has no figures but those of the frame
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/measure/bench.h"

namespace zscope {

enum class WorkUnit { Vertex, Triangle, Pixel, Edge, ActiveEdge, Node, Cell, Window };

std::string_view wordOf(WorkUnit unit);

struct UnitCost {
    WorkUnit      unit  = WorkUnit::Pixel;
    std::uint64_t count = 0;  // at least 1
    double        ns    = 0;  // of one
};

/// Of the stage in the median frame; none, one, or two.
std::vector<UnitCost> unitCosts(const BenchRow& row, Stage stage);

/// Of the median frame: per triangle of the scene and per pixel of the picture.
std::vector<UnitCost> frameCosts(const BenchRow& row);

}  // namespace zscope
