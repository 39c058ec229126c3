// The scanline algorithm: the picture is swept line by line; the active edge table holds the edges that cross the line.
//
// Idea       an edge enters the table on its first line, moves by a constant from line to line, and leaves after its
//            last; between a polygon's left and right edge lie its pixels
// Resolve    the part resolveLine decides who is seen on the line: by the depth test here, by intervals in intervals.h,
//            by blending in transparency.h
// Source     Wylie, Romney, Evans, Erdahl: Half-tone perspective drawings by computer, FJCC 1967
#pragma once

#include <string>

#include "core/plain/parts.h"

namespace zscope::plain {

/// The edge table is full (fillEdgeTable).
void scanline(Work& work, const Parts& parts);

/// Enters every triangle that reaches the stripe in the edge table.
void fillEdgeTable(Work& work, const Parts& parts);
/// The same of whole faces, as they were read.
void fillEdgeTableWithFaces(Work& work);

/// What the set-up of a sweep has come to, as a sentence.
std::string tableIsComplete(std::uint64_t edges);

/// The plain part resolveLine: every active polygon offers its pixels to the depth test.
void resolveByDepth(Call work, int y);

/// Pixels [x0, x1) of line y are offered by a polygon of the edge table.
void offerSpan(Work& work, const Polygon& polygon, int y, int x0, int x1);

/// Calls span(polygon, x0, x1) for the pixels of each active polygon on the line, in the order in which its right edge
/// is met; never an empty one.
template <class Span>
void forEachSpan(Work& work, const Span& span)
{
    ActiveEdges& active = work.scratch.active;
    for (const Edge& edge : active.edges()) {
        PolygonSpan& line    = active.spanOf(edge.polygon);
        const int    x       = firstPixelRightOf(edge, work.stripe.visible.width(), work.rules);
        const bool   wasOpen = line.isOpen();
        line.winding += edge.winding;
        if (line.isOpen() == wasOpen) continue;
        if (!wasOpen)
            line.from = x;
        else if (line.from < x)
            span(edge.polygon, line.from, x);
    }
}

}  // namespace zscope::plain
