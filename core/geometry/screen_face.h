// A face of several triangles, as it was read, ready to be swept: its sides on the snapped grid, and the plane of its
// depth.
//
// Sides      directed, as FaceBatches says; of a face that the near plane cuts, those of all its triangles' parts
// Inside     where the sides wind round a pixel centre at all, which for an outline that does not cross itself is the
//            even-odd rule; of a mended face, where they do so an odd number of times
// Depth      the face's plane (FacePlane), evaluated and limited as a triangle's
// Source     docs/correctness.md, Polygons
#pragma once

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/geometry/face_batches.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

/// From a to b, 1/256 pixel.
struct ScreenSide {
    double xa, ya, xb, yb;
};

struct ScreenFace {
    DepthPlane depth;
    double     top;   // the least y of its sides, 1/256 pixel
    TriangleId id;    // of its first triangle
    bool       wide;  // a corner lies beyond the guard band
    bool       isMended;
    bool       patterned;  // it has holes or a relief
};

/// Takes the planes of one instance's faces from model space to the screen.
class FaceDepth {
public:
    /// Borrows both.
    FaceDepth(const Projection& projection, const Affine* toWorld) : m_projection(projection), m_toWorld(toWorld)
    {
        if (!toWorld) return;
        // Normals go through the matrix of cofactors, which is right for mirrored and flattened instances too.
        const auto row = [&](std::size_t i) {
            return dvec3{toWorld->rows[i][0], toWorld->rows[i][1], toWorld->rows[i][2]};
        };
        m_cofactors = {glm::cross(row(1), row(2)), glm::cross(row(2), row(0)), glm::cross(row(0), row(1))};
    }

    /// Not usable if the plane is seen edge on, or there is none.
    DepthPlane of(const FacePlane& plane, double farthest, double nearest) const
    {
        const Projection& p    = m_projection;
        const dvec3       n    = normalInView(plane.normal);
        const dvec3       mean = p.toView(m_toWorld ? (*m_toWorld)(plane.mean) : plane.mean);
        const double      w    = glm::dot(n, mean);  // the plane is n . v = w in view space
        DepthPlane        depth;
        depth.farthest = static_cast<float>(farthest);
        depth.nearest  = static_cast<float>(nearest);
        depth.a        = n.x / (w * p.scale);
        depth.b        = -n.y / (w * p.scale);
        if (mean.z >= p.near) {
            const ScreenCorner seen = p.toScreen(mean);
            depth.c                 = seen.d - (depth.a * seen.x + depth.b * seen.y);
        } else {
            depth.c = p.depthAtOne * n.z / w - (depth.a * p.centreX + depth.b * p.centreY);
        }
        return depth;
    }

    /// Evaluating it at a pixel gives a number.
    static bool isUsable(const DepthPlane& depth)
    {
        return std::abs(depth.a) + std::abs(depth.b) + std::abs(depth.c) < 0x1p200;
    }

private:
    dvec3 normalInView(const dvec3& normal) const
    {
        dvec3 n = normal;
        if (m_toWorld)
            n = {glm::dot(m_cofactors[0], normal), glm::dot(m_cofactors[1], normal), glm::dot(m_cofactors[2], normal)};
        return {glm::dot(m_projection.right, n), glm::dot(m_projection.up, n), glm::dot(m_projection.forward, n)};
    }

    const Projection&    m_projection;
    const Affine*        m_toWorld;
    std::array<dvec3, 3> m_cofactors{};
};

}  // namespace zscope
