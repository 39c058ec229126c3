// The part of space that can reach a stripe of lines, as planes in view space: what lies outside need not be
// transformed.
//
// Promise    misses() never says yes of a box with a point that could touch a pixel centre of the stripe: the planes
//            stand one pixel outside, and every comparison leaves a slack far above the rounding of the vertex
//            arithmetic. Boxes that reach behind the near plane are judged by the same planes, which is right
//            because only the points in front of it are drawn
// Planes     a box within another asks only the planes that the other one crosses: what lies wholly inside of a plane
//            holds nothing that it could part off. A plane that is left out can only make misses() say no
// Cost       four short dot products per plane that is asked
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/geometry/placed_view.h"

namespace zscope {

class StripeVolume {
public:
    /// Which planes are to be asked, a bit for each.
    using Planes                 = std::uint8_t;
    static constexpr Planes kAll = 0x1f;

    /// Lines [firstRow, endRow) of a picture `width` pixels wide.
    StripeVolume(const Projection& projection, int width, int firstRow, int endRow)
        : m_near(projection.near), m_slack(std::max(kSlack, 2 * projection.displacement.view))
    {
        const double k    = projection.pixelsPerSlope();  // X = centreX + v.x / v.z * k
        const double left = projection.centreX + 1, right = width + 1 - projection.centreX;
        const double top = projection.centreY - firstRow + 1, bottom = endRow + 1 - projection.centreY;
        m_inward = {dvec3{0, 0, 1}, dvec3{k, 0, left}, dvec3{-k, 0, right}, dvec3{0, -k, top}, dvec3{0, k, bottom}};
    }

    bool misses(const ViewBox& box) const
    {
        Planes open = kAll;
        return misses(box, open);
    }
    /// The same by the planes in `open`; those that the box lies wholly inside of are struck out.
    [[gnu::always_inline]] bool misses(const ViewBox& box, Planes& open) const
    {
        if (open == 0) return false;
        const double slack = m_slack * (box.magnitude + m_near);
        for (std::size_t i = 0; i < m_inward.size(); ++i) {
            const Planes bit = static_cast<Planes>(1u << i);
            if (!(open & bit)) continue;
            const dvec3& n      = m_inward[i];
            const double middle = n.x * box.centre.x + n.y * box.centre.y + n.z * box.centre.z - (i == 0 ? m_near : 0);
            const double spread = box.spread(n.x, n.y, n.z);
            if (middle + spread < -slack * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z))) return true;
            if (middle - spread >= 0) open = static_cast<Planes>(open & ~bit);
        }
        return false;
    }

private:
    static constexpr double kSlack = 1e-11;

    double               m_near;
    double               m_slack;
    std::array<dvec3, 5> m_inward;  // points with inward . v >= 0 (first: >= near) may be inside
};

}  // namespace zscope
