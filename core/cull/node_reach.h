// What a box could touch on the screen, rounded outward: which pixels, and how near.
//
// Promise    every vertex inside the box that lies in front of the near plane snaps inside `pixels` grown to pixel
//            centres, and its stored depth is at most `nearest`. All roundings go outward: the vertex arithmetic by a
//            slack far above its error, the snapping by its distance, the depth by one float32 step
// Near       a box that reaches before the near plane has no such bounds: it may cover anything, at any depth
// Source     docs/correctness.md, Rules that make hierarchical methods exact, 1 and 4
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/projection.h"
#include "core/geometry/screen_triangle.h"
#include "core/scene/mesh.h"

namespace zscope {

struct NodeReach {
    PixelBox pixels;           // inside the region; empty: no pixel centre can be covered
    float    nearest = 1;      // no depth inside the box is larger
    bool     crossesNear = false;
    double   area    = 0;      // of the whole rectangle, in the region or not, pixels
};

inline NodeReach reachOf(const Bounds& box, const Affine& toWorld, const Projection& p, const PixelBox& region)
{
    constexpr double kSlack = 1e-13;  // of the sum of magnitudes; the arithmetic errs by less than a hundredth of it
    const double     pixelsPerSlope = p.scale * p.near;
    double x0 = std::numeric_limits<double>::infinity(), x1 = -x0, y0 = x0, y1 = -x0, nearestZ = x0;
    for (int i = 0; i < 8; ++i) {
        const dvec3 q{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
        const dvec3 v = p.toView(toWorld(q));
        double      magnitude = 0;
        for (std::size_t row = 0; row < 3; ++row) {
            const auto& m = toWorld.rows[row];
            magnitude += std::abs(m[0] * q.x) + std::abs(m[1] * q.y) + std::abs(m[2] * q.z) + std::abs(m[3]) +
                         std::abs(p.eye[static_cast<int>(row)]);
        }
        const double error = kSlack * magnitude, z = v.z - error;
        if (!(z >= p.near)) return {region, 1, true, 0};
        const double slip = pixelsPerSlope * (error + error * std::max(std::abs(v.x), std::abs(v.y)) / z) / z + 1 / kSubpixels;
        const double x = p.centreX + v.x / v.z * pixelsPerSlope, y = p.centreY - v.y / v.z * pixelsPerSlope;
        const double wide = kSlack * (std::abs(x) + std::abs(y)) + slip;
        x0 = std::min(x0, x - wide), x1 = std::max(x1, x + wide);
        y0 = std::min(y0, y - wide), y1 = std::max(y1, y + wide);
        nearestZ = std::min(nearestZ, z);
    }
    const auto pixelFrom = [](double edge) { return static_cast<int>(std::clamp(std::ceil(edge - 0.5), -1e9, 1e9)); };
    NodeReach  reach;
    reach.pixels  = {std::max(region.x0, pixelFrom(x0)), std::max(region.y0, pixelFrom(y0)),
                     std::min(region.x1, pixelFrom(x1)), std::min(region.y1, pixelFrom(y1))};
    reach.area    = (x1 - x0) * (y1 - y0);
    reach.nearest = std::nextafter(static_cast<float>(p.near / nearestZ), 2.0f);
    return reach;
}

}  // namespace zscope
