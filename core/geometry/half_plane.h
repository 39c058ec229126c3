// The three half-spaces of a triangle at pixel centres, counted from the first pixel of its box or, of a wide triangle,
// of a tile.
//
// Edge value E(P) = dx (Py - Ya) - dy (Px - Xa) for the edge from a to b; positive inside, and zero belongs to left and
//            top edges only. It is lowered by one (or by what `notOwned` says) for edges that do not own their points,
//            so that "inside" is "not negative" for every edge
// Exact      inside the guard band: the values are integers below 2^53. Of wider triangles 128 bits hold them at one
//            pixel, and what changes within a tile around it is below 2^52 again: a value beyond that keeps its sign
//            there and may be cut off
// Source     docs/correctness.md, Coverage
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/geometry/screen_triangle.h"

namespace zscope {

struct HalfPlane {
    double origin, perPixel, perLine;

    [[gnu::always_inline]] double at(int right, int down) const { return origin + right * perPixel + down * perLine; }
};

/// Always inlined, so that each instruction set gets it in its own instructions.
[[gnu::always_inline]] inline std::array<HalfPlane, 3> halfPlanesOf(const ScreenTriangle& t, double notOwned)
{
    const auto halfPlane = [&](std::size_t a, std::size_t b) __attribute__((always_inline))
    {
        const double dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
        const double px = t.box.x0 * kSubpixels + 128, py = t.box.y0 * kSubpixels + 128;
        const bool   isLeftOrTop = dy < 0 || (dy == 0 && dx > 0);
        return HalfPlane{dx * (py - t.y[a]) - dy * (px - t.x[a]) - (isLeftOrTop ? 0 : notOwned), -dy * kSubpixels,
                         dx * kSubpixels};
    };
    return {halfPlane(0, 1), halfPlane(1, 2), halfPlane(2, 0)};
}

/// Corners of a wide triangle may lie so far out, in subpixels, for wideHalfPlanesOf().
inline constexpr double kWidestByTiles = 0x1p36;

inline bool fitsTiles(const ScreenTriangle& t)
{
    const auto reaches = [](double a, double b, double c) { return std::max({std::abs(a), std::abs(b), std::abs(c)}); };
    return std::max(reaches(t.x[0], t.x[1], t.x[2]), reaches(t.y[0], t.y[1], t.y[2])) <= kWidestByTiles;
}

/// Counted from the pixel (x, y), and true of the 64 x 8 pixels that begin there. The triangle fits tiles and its
/// corners are whole.
inline std::array<HalfPlane, 3> wideHalfPlanesOf(const ScreenTriangle& t, int x, int y)
{
    __extension__ using Wide = __int128;
    constexpr Wide kCut = Wide{1} << 52;  // 64 columns and 8 lines change a value by less: 2^8 2^37 (63 + 7) < 2^52
    const auto     halfPlane = [&](std::size_t a, std::size_t b) {
        const double dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
        const auto   px = static_cast<std::int64_t>(x) * 256 + 128, py = static_cast<std::int64_t>(y) * 256 + 128;
        const auto   whole       = [](double value) { return static_cast<std::int64_t>(value); };
        const bool   isLeftOrTop = dy < 0 || (dy == 0 && dx > 0);
        const Wide   value =
            Wide{whole(dx)} * (py - whole(t.y[a])) - Wide{whole(dy)} * (px - whole(t.x[a])) - (isLeftOrTop ? 0 : 1);
        return HalfPlane{static_cast<double>(static_cast<std::int64_t>(std::clamp(value, -kCut, kCut))),
                         -dy * kSubpixels, dx * kSubpixels};
    };
    return {halfPlane(0, 1), halfPlane(1, 2), halfPlane(2, 0)};
}

/// The half-planes of a triangle, counted from the pixel (x0, y0). All of it inlined, as above.
struct HalfPlanes {
    std::array<HalfPlane, 3> planes;
    int                      x0, y0;

    /// True if some edge has all of the pixels on its outer side, judged at the innermost of their corners.
    [[gnu::always_inline]] bool areOutside(const PixelBox& pixels) const
    {
        for (const HalfPlane& plane : planes)
            if (plane.at((plane.perPixel > 0 ? pixels.x1 - 1 : pixels.x0) - x0,
                         (plane.perLine > 0 ? pixels.y1 - 1 : pixels.y0) - y0)
                < 0)
                return true;
        return false;
    }
    /// True if all edges have all of the pixels on their inner side.
    [[gnu::always_inline]] bool areInside(const PixelBox& pixels) const
    {
        for (const HalfPlane& plane : planes)
            if (plane.at((plane.perPixel > 0 ? pixels.x0 : pixels.x1 - 1) - x0,
                         (plane.perLine > 0 ? pixels.y0 : pixels.y1 - 1) - y0)
                < 0)
                return false;
        return true;
    }
};

}  // namespace zscope
