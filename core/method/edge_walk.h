// Scan conversion by walking the left and the right edge of a triangle from line to line.
//
// Idea       on every line a triangle covers the pixels between two edges; both move by a constant per line (a digital
//            differential analyser, as Bresenham's: whole numbers and a remainder)
// Halves     the long side joins the top and the bottom corner. The middle corner cuts the triangle in two halves; each
//            half lies between the long side and one short side
// Promise    the same pixels as the half-space test, because the steps are exact
// Cost       two additions per line and edge; four edge set-ups per triangle, with two divisions each
// Source     docs/correctness.md, Coverage
#pragma once

#include "core/plain/pass.h"
#include "core/plain/work.h"

namespace zscope::plain {

void walkEdges(Work& work, const Pass& pass, const ScreenTriangle& triangle);

}  // namespace zscope::plain
