// Which pixels a triangle covers, asked of single pixels and of rectangles, without a scan: of a wide triangle, too.
//
// Promise    all answers are exact, but isOutside() may say no of a rectangle whose centres all lie outside
// Numbers    inside the guard band edge values are integers in float64; of wider triangles 128 bits hold them, because
//            corners lie within 2^61. Corners are whole numbers of 1/256 pixel
// Source     docs/correctness.md, Coverage
#pragma once

#include "core/geometry/half_plane.h"

namespace zscope::plain {

class Coverage {
public:
    explicit Coverage(const ScreenTriangle& triangle)
        : m_triangle(triangle), m_edges{halfPlanesOf(triangle, 1), triangle.box.x0, triangle.box.y0}
    {}

    bool covers(int x, int y) const { return m_triangle.box.holds({x, y}) && !isBeyondAnEdge({x, y, x + 1, y + 1}); }

    /// True if no pixel of the rectangle is covered, as far as one edge or the triangle's box can tell.
    bool isOutside(const PixelBox& pixels) const
    {
        const PixelBox& box = m_triangle.box;
        return box.x1 <= pixels.x0 || pixels.x1 <= box.x0 || box.y1 <= pixels.y0 || pixels.y1 <= box.y0
               || isBeyondAnEdge(pixels);
    }
    /// True if every pixel of the rectangle is covered.
    bool surrounds(const PixelBox& pixels) const
    {
        return covers(pixels.x0, pixels.y0) && covers(pixels.x1 - 1, pixels.y0) && covers(pixels.x0, pixels.y1 - 1)
               && covers(pixels.x1 - 1, pixels.y1 - 1);
    }

private:
    __extension__ using Wide = __int128;

    bool isBeyondAnEdge(const PixelBox& pixels) const
    {
        if (!m_triangle.wide) return m_edges.areOutside(pixels);
        return isBeyond(0, 1, pixels) || isBeyond(1, 2, pixels) || isBeyond(2, 0, pixels);
    }
    /// Judged at the innermost of the rectangle's centres.
    bool isBeyond(std::size_t a, std::size_t b, const PixelBox& pixels) const
    {
        const Wide xa = whole(m_triangle.x[a]), ya = whole(m_triangle.y[a]);
        const Wide dx = whole(m_triangle.x[b]) - xa, dy = whole(m_triangle.y[b]) - ya;
        const Wide px = centre(dy < 0 ? pixels.x1 - 1 : pixels.x0), py = centre(dx > 0 ? pixels.y1 - 1 : pixels.y0);
        const bool isLeftOrTop = dy < 0 || (dy == 0 && dx > 0);
        return dx * (py - ya) - dy * (px - xa) < (isLeftOrTop ? 0 : 1);
    }
    static Wide whole(double subpixels) { return static_cast<std::int64_t>(subpixels); }
    static Wide centre(int pixel) { return Wide{256} * pixel + 128; }

    const ScreenTriangle& m_triangle;
    HalfPlanes            m_edges;
};

}  // namespace zscope::plain
