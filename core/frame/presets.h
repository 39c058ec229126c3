// Compositions that have a textbook name. A method that stands alone is its own preset: its row in methods.h is enough.
#pragma once

#include <algorithm>
#include <array>

#include "core/frame/methods.h"
#include "core/frame/pipeline.h"

namespace zscope {

inline constexpr std::array kComposedPresets{
    Preset{"zbuffer", "Z-buffer: every triangle, every pixel it covers", {}},
    Preset{"edge-walk", "Z-buffer with edges walked from line to line", {.scan = Scan::EdgeWalk}},
    Preset{
        "zbuffer-late", "Z-buffer that shades every fragment and then tests its depth", {.depth = DepthMoment::Late}},
    Preset{"zbuffer-early", "Z-buffer that tests depth first and shades what passes", {.depth = DepthMoment::Early}},
    Preset{"zbuffer-zcull", "Z-buffer that compares whole tiles before their fragments", {.depth = DepthMoment::ZCull}},
    Preset{"zbuffer-prepass",
           "Z-buffer with a depth pre-pass, then fragments of equal depth",
           {.depth = DepthMoment::Prepass}},
    Preset{"quadtree",
           "Pyramid without a tree: every triangle is tested against it",
           {.cull = Cull::Triangles, .upkeep = Upkeep::OnQuery}},
    Preset{"octree-frustum", "Octree without a pyramid: front to back, frustum only", {.order = Order::Octree}},
    Preset{"octree-order",
           "Octree order, triangles tested against the pyramid, nodes not",
           {.order = Order::Octree, .cull = Cull::Triangles, .upkeep = Upkeep::OnQuery}},
    Preset{"hzb-octree",
           "Hierarchical z-buffer: octree front to back, nodes and triangles against the pyramid",
           {.order = Order::Octree, .cull = Cull::NodesAndTriangles, .upkeep = Upkeep::OnQuery}},
    Preset{"hzb-bvh",
           "Hierarchical z-buffer over a bounding volume hierarchy",
           {.order = Order::Bvh, .cull = Cull::NodesAndTriangles, .upkeep = Upkeep::OnQuery}},
    Preset{"two-pass",
           "Last frame's visible nodes first, then the rest against the pyramid they left",
           {.order     = Order::Octree,
            .cull      = Cull::NodesAndTriangles,
            .upkeep    = Upkeep::OnQuery,
            .coherence = Coherence::TwoPass}},
    Preset{"hzb-simple",
           "Pre-pass, pyramid built once, every triangle tested against it",
           {.cull = Cull::Triangles, .upkeep = Upkeep::AfterPrepass, .depth = DepthMoment::Prepass}},
    Preset{"hzb-bvh-prepass",
           "Pre-pass, pyramid built once, nodes of a BVH and triangles tested against it",
           {.order  = Order::Bvh,
            .cull   = Cull::NodesAndTriangles,
            .upkeep = Upkeep::AfterPrepass,
            .depth  = DepthMoment::Prepass}},
    Preset{"scanline", "Scanline z-buffer with edge table and active edge table", {.scan = Scan::SweepZLine}},
    Preset{"interval",
           "Interval scanline: the nearest polygon between two edges, without a z-buffer",
           {.scan = Scan::SweepIntervals}},
    Preset{"interval-polygon",
           "Interval scanline over polygons as they were read, of any number of corners",
           {.scan = Scan::SweepPolygons},
           Claim::ExactByFace},
    Preset{"auto",
           "Whichever of zbuffer, hzb-octree, hzb-bvh, two-pass (and scanline, if little is in view) drew earlier "
           "frames fastest",
           {.chooser = Chooser::Measured}},
};

inline constexpr std::array kPresets = [] {
    constexpr auto kAlone = static_cast<std::size_t>(
        std::ranges::count_if(kMethods, [](const MethodEntry& row) { return row.whole != nullptr; }));
    std::array<Preset, kComposedPresets.size() + kAlone> all;
    auto                                                 to = std::ranges::copy(kComposedPresets, all.begin()).out;
    for (std::size_t i = 0; i < kMethods.size(); ++i) {
        const MethodEntry& row = kMethods[i];
        if (!row.whole) continue;
        const Pipeline pipeline{.order = row.order, .scan = static_cast<Scan>(i)};
        *to++ = {row.choice.word, row.choice.title, pipeline, row.claim};
    }
    return all;
}();

}  // namespace zscope
