// A triangle (or a part of one, after near clipping) ready to become pixels: snapped corners for coverage,
// the plane of its unsnapped corners for depth, and the box of pixel centres it may cover.
//
// Coverage   corners are turned so that the snapped area is positive; top-left rule
// Depth      Z(i, j) = float32(a*(i+0.5) + (b*(j+0.5) + c)), then limited to the corners' depths (rule P)
// Source     docs/correctness.md, The arithmetic, Coverage, Depth and the winner
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/ids.h"
#include "core/geometry/facing.h"
#include "core/geometry/pixel_box.h"
#include "core/geometry/projection.h"
#include "core/geometry/rules.h"

namespace zscope {

/// Depth as an affine function of the pixel.
struct DepthPlane {
    double a, b, c;
    float  farthest, nearest;  // lo and hi of the definition: float32 of the corners' depths
};

struct ScreenTriangle {
    std::array<double, 3> x, y;  // snapped, 1/256 pixel, integers; area > 0
    DepthPlane            depth;
    TriangleId            id;
    PixelBox              box;                // inside the region it was set up for
    bool                  wide;               // a corner lies beyond the guard band: use exact 128-bit arithmetic
    bool                  counterClockwise;   // to the viewer, as its snapped corners were given
    bool                  patterned = false;  // it has holes or a relief (core/geometry/pattern_plane.h)

    std::uint32_t rank() const { return id.value + 1; }
};

/// What became of a triangle at set-up.
enum class SetUp { Drawn, Transparent, Outside, ClippedAway, BackFacing, Degenerate, NoPixelCentre, OutOfRange };

/// The plane of the corners in the order given, as the definition writes it.
[[gnu::always_inline]] inline DepthPlane depthPlane(const ScreenCorner& p0, const ScreenCorner& p1,
                                                    const ScreenCorner& p2)
{
    double x0 = p0.x, y0 = p0.y;
    double e1x = p1.x - p0.x, e1y = p1.y - p0.y, e2x = p2.x - p0.x, e2y = p2.y - p0.y;
    double det = e1x * e2y - e2x * e1y;

    const double longest = std::max({std::abs(e1x), std::abs(e1y), std::abs(e2x), std::abs(e2y)});
    if (!(std::abs(det) > longest * 0x1p-10)) {  // thinner than a quarter of a snapping step: use the snapped plane
        x0 = p0.xs / kSubpixels, y0 = p0.ys / kSubpixels;
        e1x = p1.xs / kSubpixels - x0, e1y = p1.ys / kSubpixels - y0;
        e2x = p2.xs / kSubpixels - x0, e2y = p2.ys / kSubpixels - y0;
        det = e1x * e2y - e2x * e1y;
    }

    DepthPlane plane;
    plane.farthest = static_cast<float>(std::min({p0.d, p1.d, p2.d}));
    plane.nearest  = static_cast<float>(std::max({p0.d, p1.d, p2.d}));
    if (det == 0) {
        plane.a = plane.b = 0;
        plane.c           = plane.nearest;
        return plane;
    }
    const double d1 = p1.d - p0.d, d2 = p2.d - p0.d;
    const double inv = 1 / det;
    plane.a          = (d1 * e2y - d2 * e1y) * inv;
    plane.b          = (d2 * e1x - d1 * e2x) * inv;
    plane.c          = p0.d - (plane.a * x0 + plane.b * y0);
    return plane;
}

/// A fault: 1 / depth, which is proportional to the distance, as an affine function of the pixel.
inline DepthPlane distancePlane(ScreenCorner p0, ScreenCorner p1, ScreenCorner p2)
{
    const auto [farthest, nearest] = std::minmax({p0.d, p1.d, p2.d});
    for (ScreenCorner* p : {&p0, &p1, &p2}) p->d = 1 / p->d;
    DepthPlane plane = depthPlane(p0, p1, p2);
    plane.farthest   = static_cast<float>(farthest);
    plane.nearest    = static_cast<float>(nearest);
    return plane;
}

/// What is interpolated over the pixels, by the rules.
template <class Rules>
[[gnu::always_inline]] inline DepthPlane depthPlane(const ScreenCorner& p0, const ScreenCorner& p1,
                                                    const ScreenCorner& p2, const Rules& rules)
{
    DepthPlane plane = rules.interpolatesDistance() ? distancePlane(p0, p1, p2) : depthPlane(p0, p1, p2);
    if (rules.dividesBehindTheEye()) {  // corners behind the eye have depths that nothing can be stored at
        plane.farthest = std::clamp(plane.farthest, 0.0f, 1.0f);
        plane.nearest  = std::clamp(plane.nearest, 0.0f, 1.0f);
    }
    return plane;
}

/// Twice the snapped area, its sign only: -1 counter-clockwise to the viewer, 0 degenerate, 1 clockwise.
/// Exact for corners within kSnapLimit.
[[gnu::always_inline]] inline int turnOf(const ScreenCorner& p0, const ScreenCorner& p1, const ScreenCorner& p2,
                                         bool wide)
{
    if (!wide) {
        const double area = (p1.xs - p0.xs) * (p2.ys - p0.ys) - (p1.ys - p0.ys) * (p2.xs - p0.xs);
        return area > 0 ? 1 : area < 0 ? -1 : 0;
    }
    __extension__ using Wide = __int128;
    const auto minus         = [](double a, double b) { return static_cast<Wide>(a) - static_cast<Wide>(b); };
    const Wide area          = minus(p1.xs, p0.xs) * minus(p2.ys, p0.ys) - minus(p1.ys, p0.ys) * minus(p2.xs, p0.xs);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Sets up one part for the pixels of `region`. `out` is complete only if the answer is SetUp::Drawn.
/// Always inlined, so that each instruction set gets it in its own instructions.
template <class Rules>
[[gnu::always_inline]] inline SetUp setUpTriangle(const ScreenCorner& p0, const ScreenCorner& p1,
                                                  const ScreenCorner& p2, TriangleId id, bool wide,
                                                  const Facing& facing, const PixelBox& region, const Rules& rules,
                                                  ScreenTriangle& out)
{
    if (rules.dropsCrossing(p0, p1, p2)) return SetUp::Outside;
    const int turn = turnOf(p0, p1, p2, wide);
    if (turn == 0) return SetUp::Degenerate;
    if (facing.isCulled(turn)) return SetUp::BackFacing;

    out.box = {std::max(region.x0, rules.firstCentreFrom(std::min({p0.xs, p1.xs, p2.xs}))),
               std::max(region.y0, rules.firstCentreFrom(std::min({p0.ys, p1.ys, p2.ys}))),
               std::min(region.x1, rules.firstCentreFrom(std::max({p0.xs, p1.xs, p2.xs}))),
               std::min(region.y1, rules.firstCentreFrom(std::max({p0.ys, p1.ys, p2.ys})))};
    if (out.box.isEmpty()) return SetUp::NoPixelCentre;

    const ScreenCorner& second = turn > 0 ? p1 : p2;
    const ScreenCorner& third  = turn > 0 ? p2 : p1;
    out.x                      = {p0.xs, second.xs, third.xs};
    out.y                      = {p0.ys, second.ys, third.ys};
    out.depth                  = depthPlane(p0, p1, p2, rules);
    out.id                     = id;
    out.wide                   = wide;
    out.counterClockwise       = turn < 0;
    out.patterned              = false;
    return SetUp::Drawn;
}

}  // namespace zscope
