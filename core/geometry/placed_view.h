// A placement as a camera sees it: from the model to view space by one matrix, for whole boxes. Vertices go the long
// way, in the arithmetic that defines the picture; a box only has to hold them.
//
// Promise    of every point q of a box, what the vertex arithmetic makes of it in view space lies within kError *
//            magnitude of the parallelepiped centre +- half[0] +- half[1] +- half[2], coordinate by coordinate (of
//            float32 vertices within Displacement::view * magnitude, core/geometry/displacement.h). Both
//            ways of computing it, and what is made of the box on the way, err by less than 40 roundings (5e-15) of the
//            sum of the magnitudes that are added up; `magnitude` bounds that sum: it counts the camera's longest axis
// Beyond     boxes without points and numbers that run over give NaN or infinities, of which no comparison below holds:
//            such a box is never called outside
// Cost       made once per placed tree, some 40 operations; 50 per box, none of them a division
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/geometry/projection.h"
#include "core/scene/mesh.h"

namespace zscope {

/// Of a ball that holds points no farther from its middle than the root of `squared`, rounded outward; infinite where
/// squares run over or under, so that such a ball bounds nothing.
inline double ballRadius(double squared)
{
    constexpr double kUnder = 1e-250;
    return squared > kUnder ? std::sqrt(squared) * (1 + 1e-12) : std::numeric_limits<double>::infinity();
}

/// A box of the model in view space.
struct ViewBox {
    dvec3                centre;
    std::array<dvec3, 3> half;       // from the centre to the middle of a side, along each axis of the model
    double               magnitude;  // of the numbers that were added up

    /// How far it reaches from its centre along a direction.
    [[gnu::always_inline]] double spread(double x, double y, double z) const
    {
        const auto along = [=](const dvec3& v) { return std::abs(x * v.x + y * v.y + z * v.z); };
        return along(half[0]) + along(half[1]) + along(half[2]);
    }
};

class PlacedView {
public:
    static constexpr double kError = Displacement().view;  // of float64 vertices

    /// `before`: magnitudes that are added up before `toWorld` is applied, where the boxes are of placed instances.
    PlacedView(const Projection& p, const Affine& toWorld, double before = 0)
    {
        const auto& m = toWorld.rows;
        for (std::size_t c = 0; c < 3; ++c) {
            m_axes[c]                     = turned(p, {m[0][c], m[1][c], m[2][c]});
            m_weight[static_cast<int>(c)] = std::abs(m[0][c]) + std::abs(m[1][c]) + std::abs(m[2][c]);
        }
        m_origin    = turned(p, {m[0][3] - p.eye.x, m[1][3] - p.eye.y, m[2][3] - p.eye.z});
        double most = 0;
        for (const dvec3& a : m_axes)
            most = std::max(most, std::abs(glm::dot(a, m_axes[0])) + std::abs(glm::dot(a, m_axes[1]))
                                      + std::abs(glm::dot(a, m_axes[2])));
        m_longest   = std::sqrt(most) * (1 + 1e-12);
        m_magnitude = std::abs(m[0][3]) + std::abs(m[1][3]) + std::abs(m[2][3]) + std::abs(p.eye.x) + std::abs(p.eye.y)
                      + std::abs(p.eye.z) + before;
        // A camera read from a file may have axes of any length.
        const double axis = std::max({1.0, glm::length(p.right), glm::length(p.up), glm::length(p.forward)});
        m_weight *= axis;
        m_magnitude *= axis;
    }

    /// The model's axes and its origin in view space.
    const std::array<dvec3, 3>& axes() const { return m_axes; }
    const dvec3&                origin() const { return m_origin; }
    /// No length of the model is more than so many times as long in view space: the largest singular value is at most
    /// the root of the largest sum of magnitudes in a row of the axes' products.
    double longest() const { return m_longest; }

    [[gnu::always_inline]] ViewBox operator()(const Bounds& box) const
    {
        const dvec3 c = 0.5 * box.min + 0.5 * box.max, h = 0.5 * box.max - 0.5 * box.min;
        return {.centre    = m_axes[0] * c.x + m_axes[1] * c.y + m_axes[2] * c.z + m_origin,
                .half      = {m_axes[0] * h.x, m_axes[1] * h.y, m_axes[2] * h.z},
                .magnitude = m_weight.x * (std::abs(c.x) + h.x) + m_weight.y * (std::abs(c.y) + h.y)
                             + m_weight.z * (std::abs(c.z) + h.z) + m_magnitude};
    }

private:
    static dvec3 turned(const Projection& p, const dvec3& d)
    {
        return {p.right.x * d.x + p.right.y * d.y + p.right.z * d.z, p.up.x * d.x + p.up.y * d.y + p.up.z * d.z,
                p.forward.x * d.x + p.forward.y * d.y + p.forward.z * d.z};
    }

    std::array<dvec3, 3> m_axes;    // of the model, in view space
    dvec3                m_origin;  // likewise
    dvec3                m_weight;  // magnitude per unit of each coordinate
    double               m_magnitude;
    double               m_longest;
};

}  // namespace zscope
