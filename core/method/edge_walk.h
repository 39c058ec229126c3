// Scan conversion by walking the left and the right edge of a triangle from line to line.
//
// Idea       on every line a triangle covers the pixels between two edges; both move by a constant per line
// Promise    the same pixels as the half-space test, because the steps are exact integers with remainder
// Cost       two additions per line and edge, two divisions per edge
// Source     docs/correctness.md, Coverage
#pragma once

#include "core/plain/pass.h"
#include "core/plain/work.h"

namespace zscope::plain {

void walkEdges(Work& work, const Pass& pass, const ScreenTriangle& triangle);

}  // namespace zscope::plain
