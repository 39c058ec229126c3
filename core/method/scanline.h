// The scanline algorithm: the picture is swept line by line; the active edge table holds the edges that cross the line.
//
// Idea       an edge enters the table on its first line, moves by a constant from line to line, and leaves after its
//            last; between a polygon's left and right edge lie its pixels
// Resolve    the part resolveLine decides which polygon each pixel of the line shows: here by a depth test on row y of
//            the visibility buffer (the lecture's one-line z-buffer), in intervals.h by intervals. transparency.cpp
//            sweeps with the same steps in a loop of its own
// Source     Wylie, Romney, Evans, Erdahl: Half-tone perspective drawings by computer, FJCC 1967
#pragma once

#include <span>
#include <string>

#include "core/plain/parts.h"

namespace zscope::plain {

/// Needs a filled edge table.
void scanline(Work& work, const Parts& parts);

/// Enters into the edge table every triangle that reaches the stripe.
void fillEdgeTable(Work& work, const Parts& parts);
/// Enters into the edge table every face that reaches the stripe, with all its corners.
void fillEdgeTableWithFaces(Work& work);

/// The sentence of the step that ends the set-up.
std::string sentenceOfEdgeTable(std::uint64_t edges);

/// The plain part resolveLine: every active polygon offers its pixels to the depth test.
void resolveByDepth(Call work, int y);

/// Pixels [x0, x1) of line y are offered by a polygon of the edge table.
void offerSpan(Work& work, const Polygon& polygon, int y, int x0, int x1);

/// The pixels of each active polygon on the line, in the order in which its right edge is met; none is empty. Valid
/// until the next call.
std::span<const LineSpan> spansOf(Work& work);

}  // namespace zscope::plain
