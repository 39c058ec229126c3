// What a box could touch on the screen, rounded outward: which pixels, and how near.
//
// Promise    every vertex inside the box that lies in front of the near plane snaps inside `pixels` grown to pixel
//            centres, and its stored depth is at most `nearest`. All roundings go outward: the vertex arithmetic by a
//            slack far above its error, the snapping by its distance, the depth by one float32 step
// Why        all of the box lies in the hull of its corners, and a projection keeps hulls in front of the eye
// Near       a box that reaches before the near plane has no such bounds: it may cover anything, at any depth
// Ball       where a ball about the box's middle holds what is in the box, reaches of both hold it: a ball that has
//            been turned is one still
// Source     docs/correctness.md, Rules that make hierarchical methods exact, 1 and 4
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/geometry/placed_view.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct NodeReach {
    PixelBox pixels;           // inside the region; empty: no pixel centre can be covered
    float    nearest     = 1;  // no depth inside the box is larger
    bool     crossesNear = false;
    double   area        = 0;  // of the whole rectangle, in the region or not, pixels
};

/// The first pixel whose centre is at `edge` or beyond, for edges within 1e9 pixels; by hand: not every instruction set
/// has an instruction that rounds up.
[[gnu::always_inline]] inline int firstPixelFrom(double edge)
{
    const double place = edge - 0.5;
    const int    pixel = static_cast<int>(place);
    return pixel + (pixel < place);
}

/// The next float32 up, as nextafter() finds it of a number that is not negative.
[[gnu::always_inline]] inline float nextUp(float value)
{
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) + 1);
}

/// Always inlined, so that each instruction set gets it in its own instructions.
[[gnu::always_inline]] inline NodeReach reachOf(const ViewBox& box, const Projection& p, const PixelBox& region)
{
    const NodeReach anywhere{region, static_cast<float>(p.depthScale), true, 0};
    const double    error    = p.displacement.view * box.magnitude;
    const double    nearestZ = box.centre.z - box.spread(0, 0, 1) - error;
    if (!(nearestZ >= p.near)) return anywhere;

    constexpr double kFar = std::numeric_limits<double>::infinity();
    double           x0 = kFar, x1 = -kFar, y0 = kFar, y1 = -kFar;  // slopes: of view space, x / z and y / z
    for (const dvec3& low : {box.centre - box.half[2], box.centre + box.half[2]})
        for (const dvec3& middle : {low - box.half[1], low + box.half[1]})
            for (const dvec3& corner : {middle - box.half[0], middle + box.half[0]}) {
                const double inverse = 1 / corner.z, x = corner.x * inverse, y = corner.y * inverse;
                x0 = std::min(x0, x), x1 = std::max(x1, x);
                y0 = std::min(y0, y), y1 = std::max(y1, y);
            }
    // What an error of the corners, and of the points inside, may move on the screen; then the snapping.
    const double steepest = std::max(std::max(-x0, x1), std::max(-y0, y1)), pixelsPerSlope = p.pixelsPerSlope();
    const double slip = pixelsPerSlope * ((error + error * steepest) / nearestZ + PlacedView::kError * steepest)
                        + p.displacement.pixels;
    const double left = p.centreX + x0 * pixelsPerSlope - slip, right = p.centreX + x1 * pixelsPerSlope + slip;
    const double top = p.centreY - y1 * pixelsPerSlope - slip, bottom = p.centreY - y0 * pixelsPerSlope + slip;
    const double area = (right - left) * (bottom - top);
    if (!(area < kFar)) return anywhere;  // numbers that run over bound nothing

    const auto pixelFrom = [](double edge) { return firstPixelFrom(std::min(std::max(edge, -1e9), 1e9)); };
    NodeReach  reach;
    reach.pixels  = {std::max(region.x0, pixelFrom(left)), std::max(region.y0, pixelFrom(top)),
                     std::min(region.x1, pixelFrom(right)), std::min(region.y1, pixelFrom(bottom))};
    reach.area    = area;
    reach.nearest = nextUp(static_cast<float>(p.depthAtOne / nearestZ));
    return reach;
}

/// `reach` of the box, narrowed to what a ball of so large a radius about the middle of the box reaches, too; how large
/// its rectangle is stays what it is. A ball that reaches before the near plane narrows nothing, nor does one whose
/// numbers run over.
[[gnu::always_inline]] inline NodeReach narrowedToBall(NodeReach reach, const ViewBox& box, double radius,
                                                       const Projection& p)
{
    const double r = radius + PlacedView::kError * box.magnitude, near = box.centre.z - r;
    if (!(near >= p.near)) return reach;
    // Along x and y a slope is largest at the ball's near or far side.
    const double perNear = 1 / near, perFar = 1 / (box.centre.z + r), pixelsPerSlope = p.pixelsPerSlope(),
                 slip   = 2 / kSubpixels;
    const auto   least  = [=](double v) { return v * (v < 0 ? perNear : perFar); };
    const auto   most   = [=](double v) { return v * (v < 0 ? perFar : perNear); };
    const double left   = p.centreX + least(box.centre.x - r) * pixelsPerSlope - slip,
                 right  = p.centreX + most(box.centre.x + r) * pixelsPerSlope + slip;
    const double top    = p.centreY - most(box.centre.y + r) * pixelsPerSlope - slip,
                 bottom = p.centreY - least(box.centre.y - r) * pixelsPerSlope + slip;
    if (!(std::abs(left) + std::abs(right) + std::abs(top) + std::abs(bottom) < 1e9)) return reach;
    reach.pixels  = {std::max(reach.pixels.x0, firstPixelFrom(left)), std::max(reach.pixels.y0, firstPixelFrom(top)),
                     std::min(reach.pixels.x1, firstPixelFrom(right)),
                     std::min(reach.pixels.y1, firstPixelFrom(bottom))};
    reach.nearest = std::min(reach.nearest, nextUp(static_cast<float>(p.depthAtOne * perNear)));
    return reach;
}

inline NodeReach reachOf(const Bounds& box, const Affine& toWorld, const Projection& p, const PixelBox& region)
{
    return reachOf(PlacedView(p, toWorld)(box), p, region);
}

}  // namespace zscope
