// Which pixels of its box a triangle covers, asked of rectangles or one by one, without a scan.
//
// Promise    covers() is the coverage of the definition. overlaps() says no only of a rectangle without a covered
//            centre, and yes only if the triangle meets the rectangle of its centres, in a corner, across an edge or as
//            a whole
// Wide       of a triangle beyond the guard band nothing is known: it counts as covering its box
// Source     docs/correctness.md, Coverage
#pragma once

#include "core/geometry/half_plane.h"

namespace zscope {

class TriangleCover {
public:
    /// `notOwned` as of the rules: what an edge value is lowered by where the edge does not own its points.
    TriangleCover(const ScreenTriangle& triangle, double notOwned)
        : m_edges{halfPlanesOf(triangle, notOwned), triangle.box.x0, triangle.box.y0}, m_wide(triangle.wide)
    {}

    /// `pixels` is not empty and inside the triangle's box.
    bool overlaps(const PixelBox& pixels) const { return m_wide || !m_edges.areOutside(pixels); }
    bool covers(int x, int y) const { return overlaps({x, y, x + 1, y + 1}); }

private:
    HalfPlanes m_edges;
    bool       m_wide;
};

/// The shape that is its box.
struct WholeBox {
    static constexpr bool overlaps(const PixelBox&) { return true; }
    static constexpr bool covers(int, int) { return true; }
};

}  // namespace zscope
