// The hierarchical z-buffer: near nodes first; what the pyramid hides is skipped, with everything below it.
//
// Node       outside the view: skipped. Farther than everything drawn in its rectangle: skipped. Else its own triangles
//            are drawn and its children visited, the nearer ones first
// Presets    with the node question, the triangle question, both, or neither (frustum only)
// Source     Greene, Kass, Miller: Hierarchical Z-Buffer Visibility, SIGGRAPH 1993
#pragma once

#include "core/plain/parts.h"
#include "core/plain/tree_visit.h"

namespace zscope::plain {

/// `remembers`: notes which nodes were worth drawing, for the next frame (two_pass.h).
void hierarchical(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, bool remembers = false);

/// The node's own triangles are drawn; its own instances wait their turn.
DrawnTriangles drawNode(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node);
/// The own triangles of a node of a mesh tree, batch by batch.
DrawnTriangles drawOwn(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit, const PlacedNode& node);

/// The plain parts push and pop: a stack.
void pushOnStack(Call work, std::span<const PlacedNode> nodes);
bool popFromStack(Call work, PlacedNode& node);

}  // namespace zscope::plain
