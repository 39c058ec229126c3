// Cutting a triangle at the near plane z = n. What lies behind is dropped; the rest is a fan of at most two parts.
//
// Promise    a crossing is computed from its inside end towards its outside end, so two triangles that share the
//            edge get the same point, whichever way round they list it
// Source     docs/correctness.md, The arithmetic, written out
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/base/affine.h"

namespace zscope {

/// A convex polygon of three or four corners in view space, or nothing.
struct ClippedTriangle {
    std::array<dvec3, 4> corner;
    std::size_t          count = 0;      // 0, 3 or 4
    bool                 isCut = false;  // a side met the plane; what is left ends there

    std::size_t parts() const { return count < 3 ? 0 : count - 2; }
    /// Part p of the fan from the first corner.
    std::array<dvec3, 3> part(std::size_t p) const { return {corner[0], corner[p + 1], corner[p + 2]}; }
};

inline dvec3 nearCrossing(const dvec3& inside, const dvec3& outside, double near)
{
    const double t = (inside.z - near) / (inside.z - outside.z);
    return {inside.x + t * (outside.x - inside.x), inside.y + t * (outside.y - inside.y), near};
}

inline ClippedTriangle clipNear(const std::array<dvec3, 3>& view, double near)
{
    ClippedTriangle kept;
    const auto      isInside = [near](const dvec3& v) { return v.z >= near; };
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3& a = view[i];
        const dvec3& b = view[(i + 1) % 3];
        if (isInside(a)) kept.corner[kept.count++] = a;
        if (isInside(a) == isInside(b)) continue;
        kept.isCut                = true;
        kept.corner[kept.count++] = isInside(a) ? nearCrossing(a, b, near) : nearCrossing(b, a, near);
    }
    return kept;
}

/// A fault: nothing is cut of a triangle that has a corner in front of the plane. One with a corner in the plane of the
/// eye, where no projection exists, is dropped.
inline ClippedTriangle unclipped(const std::array<dvec3, 3>& view, double near)
{
    constexpr double kNothing = 0x1p-40;  // of the distance of the near plane
    ClippedTriangle  all{{view[0], view[1], view[2]}, 0, false};
    bool             isInFront = false;
    for (const dvec3& v : view) {
        isInFront = isInFront || v.z >= near;
        if (!(std::abs(v.z) > near * kNothing)) return all;
    }
    all.count = isInFront ? 3 : 0;
    return all;
}

}  // namespace zscope
