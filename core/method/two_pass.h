// Two passes: what the last frame saw is drawn first, unasked; then everything else, against the pyramid that it left.
//
// Guess      what was visible a frame ago is a good guess at what hides the rest. After a cut or a half-turn it is a
//            bad guess: the frame is slower, and the picture is the same
// Memory     the nodes whose triangles were drawn and mostly not found hidden (core/hierarchy/node_memory.h). A node of
//            the first pass is judged again by the second, to learn whether it stays, but is not drawn twice. In every
//            frame another eighth of the nodes is left for the second pass, to learn whether they are still worth it
// Source     Greene, Kass, Miller: Hierarchical Z-Buffer Visibility, SIGGRAPH 1993, Temporal coherence; Haar, Aaltonen:
//            GPU-Driven Rendering Pipelines, SIGGRAPH 2015, Two-phase occlusion culling
#pragma once

#include "core/plain/parts.h"
#include "core/plain/tree_visit.h"

namespace zscope::plain {

void twoPass(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit);

/// An entered node of the second pass: draws its own triangles if the first pass did not, and remembers the node if
/// that pays (NodeMemory::isWorthIt). The instances of a node of the tree over the instances wait on the stack.
void drawIfNotDrawnInPassOne(Work& work, const Parts& parts, const Pass& pass, TreeVisit& visit,
                             const PlacedNode& node);

}  // namespace zscope::plain
