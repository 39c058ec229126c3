// What is hidden: nodes and triangles compared with the pyramid before they are drawn; and how the pyramid is kept true
// after a triangle has been drawn.
//
// Pyramid    level 0 is the depth buffer; a cell of level n + 1 holds the FARTHEST depth of the cells below it. What is
//            farther than the cell is hidden in all of the cell's pixels (core/depth/pyramid.h)
// Question   a rectangle and the nearest depth that may lie in it: the rectangle is rounded outward, the depth nearer
// Promise    nothing is called hidden, or outside, that could win a pixel; a node that reaches before the near plane,
//            as one that holds the eye does, is always entered
#pragma once

#include "core/cull/cull_events.h"
#include "core/plain/pass.h"
#include "core/plain/tree_visit.h"
#include "core/plain/work.h"

namespace zscope::plain {

/// Outside the stripe, hidden, entered, or (an approximation) too small; `node.open` loses the planes of the stripe
/// that the node lies wholly inside of.
Verdict judgeNode(Call work, const Pass& pass, TreeVisit& visit, PlacedNode& node);

/// Whether the pyramid says that the triangle cannot win a pixel. False if the pass does not ask about triangles.
bool isHidden(Work& work, const Pass& pass, const ScreenTriangle& triangle);

/// Whether the triangle cannot win a pixel of the tile of the pyramid that holds `pixels` of its box.
bool isHiddenInTile(Work& work, const ScreenTriangle& triangle, const PixelBox& pixels);

/// The triangle's pixels have been drawn: tells the pyramid, by the upkeep of the pass.
void keepPyramidTrue(Work& work, const Pass& pass, const ScreenTriangle& triangle);

}  // namespace zscope::plain
