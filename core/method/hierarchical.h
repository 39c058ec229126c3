// The hierarchical z-buffer: near nodes first; what the pyramid hides is skipped, with everything below it.
//
// Node       outside the view: skipped. Farther than everything drawn in its rectangle: skipped. Else a leaf's
//            triangles are drawn, and an inner node's children are visited, the nearer ones first. What fits in no
//            octant has nodes of its own beside the octants. A leaf of the tree over the instances holds instances: the
//            trees over their triangles are visited next
// Presets    hzb-octree, hzb-bvh, two-pass and the second pass of hzb-bvh-prepass ask the pyramid about nodes and
//            triangles, octree-order about triangles only; octree-frustum asks nothing
// Source     Greene, Kass, Miller: Hierarchical Z-Buffer Visibility, SIGGRAPH 1993
#pragma once

#include <cstdint>

#include "core/plain/parts.h"
#include "core/plain/tree_visit.h"

namespace zscope::plain {

/// Whether the nodes that were worth drawing are noted for the next frame (two_pass.h).
enum class Remembers : std::uint8_t { No, Yes };

void hierarchical(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit,
                  Remembers remembers = Remembers::No);

/// Draws the own triangles of a node of a mesh tree, batch by batch.
DrawnTriangles drawOwn(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node);

/// The plain parts push and pop: a stack.
void pushOnStack(Call work, std::span<const PlacedNode> nodes);
bool popFromStack(Call work, PlacedNode& node);

}  // namespace zscope::plain
