// The hierarchical z-buffer: near nodes first; what the pyramid hides is skipped, with everything below it.
//
// Node       outside the view: skipped. Farther than everything drawn in its rectangle: skipped. Else its own
//            triangles, those that fit in no child, are drawn and its children visited, the nearer ones first
// Presets    hzb-octree and hzb-bvh ask about nodes and about small triangles; octree-order and octree-frustum ask
//            nothing: they only skip what is outside the view
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

/// The node's own triangles are drawn; its own instances wait their turn.
DrawnTriangles drawNode(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node);
/// The own triangles of a node of a mesh tree, batch by batch.
DrawnTriangles drawOwn(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node);

/// The plain parts push and pop: a stack.
void pushOnStack(Call work, std::span<const PlacedNode> nodes);
bool popFromStack(Call work, PlacedNode& node);

}  // namespace zscope::plain
