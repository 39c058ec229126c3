// The three half-spaces of a triangle at pixel centres, counted from the first pixel of its box.
//
// Edge value E(P) = dx (Py - Ya) - dy (Px - Xa) for the edge from a to b; positive inside, and zero belongs to left and top
//            edges only. It is lowered by one (or by what `notOwned` says) for edges that do not own their points, so that
//            "inside" is "not negative" for every edge
// Exact      inside the guard band: the values are integers below 2^53. Wider triangles need other arithmetic
// Source     docs/correctness.md, Coverage
#pragma once

#include <array>

#include "core/geometry/screen_triangle.h"

namespace zscope {

struct HalfPlane {
    double origin, perPixel, perLine;

    double at(int right, int down) const { return origin + right * perPixel + down * perLine; }
};

/// Always inlined, so that each instruction set gets it in its own instructions.
[[gnu::always_inline]] inline std::array<HalfPlane, 3> halfPlanesOf(const ScreenTriangle& t, double notOwned)
{
    const auto halfPlane = [&](std::size_t a, std::size_t b) __attribute__((always_inline)) {
        const double dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
        const double px = t.box.x0 * kSubpixels + 128, py = t.box.y0 * kSubpixels + 128;
        const bool   isLeftOrTop = dy < 0 || (dy == 0 && dx > 0);
        return HalfPlane{dx * (py - t.y[a]) - dy * (px - t.x[a]) - (isLeftOrTop ? 0 : notOwned), -dy * kSubpixels, dx * kSubpixels};
    };
    return {halfPlane(0, 1), halfPlane(1, 2), halfPlane(2, 0)};
}

/// True if some edge has all of the pixels [right, lastRight] x [down, lastDown] on its outer side, judged at the innermost of
/// their corners.
[[gnu::always_inline]] inline bool areOutside(const std::array<HalfPlane, 3>& planes, int right, int down, int lastRight, int lastDown)
{
    for (const HalfPlane& plane : planes)
        if (plane.at(plane.perPixel > 0 ? lastRight : right, plane.perLine > 0 ? lastDown : down) < 0) return true;
    return false;
}

/// True if all edges have all of those pixels on their inner side.
[[gnu::always_inline]] inline bool areInside(const std::array<HalfPlane, 3>& planes, int right, int down, int lastRight, int lastDown)
{
    for (const HalfPlane& plane : planes)
        if (plane.at(plane.perPixel > 0 ? right : lastRight, plane.perLine > 0 ? down : lastDown) < 0) return false;
    return true;
}

}  // namespace zscope
