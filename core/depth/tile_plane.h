// A rectangle of pixels that show one triangle: its plane stands for their depths.
//
// Depth      of a pixel is the definition's expression, float64 until it is limited and rounded: the same bits as in
//            memory. It is monotone in x and in y, roundings included, so two corners of a rectangle have its nearest
//            and farthest depth
// Source     docs/correctness.md, Depth and the winner
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/depth/pixel_key.h"
#include "core/geometry/pixel_box.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

/// Depth of a plane at the centre of a pixel, as float32 stores it.
inline float depthAt(const DepthPlane& plane, int x, int y)
{
    const double z = plane.a * (x + 0.5) + (plane.b * (y + 0.5) + plane.c);
    return static_cast<float>(std::min(std::max(z, double{plane.farthest}), double{plane.nearest}));
}
inline float nearestOver(const DepthPlane& plane, const PixelBox& pixels)
{
    return depthAt(plane, plane.a > 0 ? pixels.x1 - 1 : pixels.x0, plane.b > 0 ? pixels.y1 - 1 : pixels.y0);
}
inline float farthestOver(const DepthPlane& plane, const PixelBox& pixels)
{
    return depthAt(plane, plane.a > 0 ? pixels.x0 : pixels.x1 - 1, plane.b > 0 ? pixels.y0 : pixels.y1 - 1);
}

struct TilePlane {
    DepthPlane    depth;
    std::uint32_t rank;

    PixelKey keyAt(int x, int y) const { return keyOf(depthAt(depth, x, y), rank); }
};

}  // namespace zscope
