// The spans of a line of the sweep: each active polygon covers the pixels between the edges on this line that open it
// and those that close it.
#pragma once

#include <algorithm>
#include <span>

#include "core/sweep/active_polygons.h"

namespace zscope {

/// Calls visit(polygon, x0, x1) for each run of pixels [x0, x1) that a polygon covers, from left to right by where they
/// end, inside the `width` pixels of a line; never an empty one. Always inlined, so that each instruction set gets it
/// in its own instructions.
template <class Visit>
[[gnu::always_inline]] inline void forEachSpan(std::span<const ActiveEdge> active, ActivePolygons& polygons, int width,
                                               const Visit& visit)
{
    const auto pass = [&](const ActiveEdge& edge, std::uint32_t polygon) __attribute__((always_inline))
    {
        ActivePolygons::Span& span    = polygons.spanOf(polygon);
        const int             pixel   = edge.firstPixel();
        const bool            wasOpen = span.isOpen();
        if (span.pass(edge) == wasOpen) return;
        if (!wasOpen) {
            span.openAt = pixel;
            return;
        }
        const int x0 = std::max(span.openAt, 0), x1 = std::min(pixel, width);
        if (x0 < x1) visit(polygon, x0, x1);
    };
    for (const ActiveEdge& edge : active) {
        pass(edge, edge.polygon());
        if (edge.isShared()) pass(edge, edge.opens());
    }
}

}  // namespace zscope
