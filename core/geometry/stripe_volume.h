// The part of space that can reach a stripe of lines, as planes in the model space of one instance: what lies
// outside need not be transformed.
//
// Promise    misses() never says yes of a box with a point that could touch a pixel centre of the stripe: the planes
//            stand one pixel outside, and every comparison leaves a slack far above the rounding of the vertex
//            arithmetic. Boxes that reach behind the near plane are judged by the same planes, which is right
//            because only the points in front of it are drawn
// Cost       five dot products per box
#pragma once

#include <array>
#include <cmath>

#include "core/geometry/projection.h"
#include "core/scene/mesh.h"

namespace zscope {

class StripeVolume {
public:
    /// Lines [firstRow, endRow) of a picture `width` pixels wide, for a mesh placed by `toWorld`.
    StripeVolume(const Projection& projection, const Affine& toWorld, int width, int firstRow, int endRow)
    {
        const double k = projection.scale * projection.near;  // pixels: X = centreX + v.x / v.z * k
        const double left = projection.centreX + 1, right = width + 1 - projection.centreX;
        const double top = projection.centreY - firstRow + 1, bottom = endRow + 1 - projection.centreY;
        const std::array<dvec3, 5> inward{dvec3{0, 0, 1}, dvec3{k, 0, left}, dvec3{-k, 0, right},
                                          dvec3{0, -k, top}, dvec3{0, k, bottom}};
        for (std::size_t i = 0; i < inward.size(); ++i) m_planes[i] = toModel(inward[i], projection, toWorld);
        m_planes[0].offset -= projection.near;
    }

    bool misses(const Bounds& box) const
    {
        const dvec3 centre = 0.5 * (box.min + box.max), half = 0.5 * (box.max - box.min);
        for (const Plane& plane : m_planes) {
            const dvec3  n       = plane.normal;
            const double highest = n.x * centre.x + n.y * centre.y + n.z * centre.z + std::abs(n.x) * half.x +
                                   std::abs(n.y) * half.y + std::abs(n.z) * half.z + plane.offset;
            const dvec3  w       = plane.weight;
            const double size = w.x * (std::abs(centre.x) + half.x) + w.y * (std::abs(centre.y) + half.y) +
                                w.z * (std::abs(centre.z) + half.z) + plane.magnitude;
            if (highest < -kSlack * size) return true;
        }
        return false;
    }

private:
    /// Points with normal . q + offset >= 0 may be inside. `weight` and `magnitude` bound the terms that were
    /// added up to make normal and offset, before anything cancelled: rounding is judged against them.
    struct Plane {
        dvec3  normal, weight;
        double offset, magnitude;
    };

    static constexpr double kSlack = 1e-11;

    static Plane toModel(const dvec3& inward, const Projection& p, const Affine& m)
    {
        Plane plane{.normal = {}, .weight = {}, .offset = 0, .magnitude = 0};
        for (int axis = 0; axis < 3; ++axis) {  // of world space
            const auto&  row = m.rows[static_cast<std::size_t>(axis)];
            const double rx = inward.x * p.right[axis], uy = inward.y * p.up[axis], fz = inward.z * p.forward[axis];
            const double n = rx + uy + fz, w = std::abs(rx) + std::abs(uy) + std::abs(fz);
            plane.normal += n * dvec3{row[0], row[1], row[2]};
            plane.weight += w * dvec3{std::abs(row[0]), std::abs(row[1]), std::abs(row[2])};
            plane.offset += n * (row[3] - p.eye[axis]);
            plane.magnitude += w * (std::abs(row[3]) + std::abs(p.eye[axis]) + p.near);
        }
        return plane;
    }

    std::array<Plane, 5> m_planes;
};

}  // namespace zscope
