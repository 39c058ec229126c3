// The patterns of one triangle's material (holes, relief) as they lie on the screen.
//
// Idea       one plane per face, that of its first triangle: with g, hu, hv as below, a pattern coordinate at the pixel
//            whose view ray is r is u0 + (hu.r)/(g.r): the plane through the three corners in view space, before any
//            clipping, so that parts agree with the whole
// Cost       nothing is kept: it is made anew from the scene for each such triangle (or span of one) that is drawn
// Source     docs/correctness.md, Cut-outs and Reliefs: float64, one rounding per written operation
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/base/products.h"
#include "core/geometry/projection.h"
#include "core/scene/scene.h"

namespace zscope {

struct PatternPlane {
    std::optional<Cutout> cutout;
    std::optional<Relief> relief;
    double                reliefDepth;       // in near distances
    dvec3                 g, hu, hv;         // linear in the view ray
    double                u0, v0;            // of the first corner
    double                centreX, centreY;  // of the picture, pixels
    double                focal;             // pixels
};

/// `id` must be a triangle whose material has a pattern.
inline PatternPlane patternPlaneOf(const Scene& scene, const Projection& projection, TriangleId id)
{
    const InstanceId    instance = scene.instanceOf(id);
    const Affine&       toWorld  = scene.instances[instance.value].toWorld;
    const Mesh&         mesh     = scene.meshOf(instance);
    const std::uint32_t t        = id.value - scene.firstTriangle[instance.value];
    const PolygonId     face     = mesh.trianglePolygon[t];
    const auto&         corners  = mesh.triangles[mesh.firstTriangle[face.value]];
    const Material&     material = mesh.materialOf(face);

    std::array<dvec3, 3> model, view;
    for (std::size_t i = 0; i < 3; ++i) {
        model[i] = mesh.positions[corners[i]];
        view[i]  = projection.toView(toWorld.isIdentity() ? model[i] : toWorld(model[i]));
    }
    const dvec3 facing = crossAsWritten(model[1] - model[0], model[2] - model[0]);
    const dvec3 size{std::abs(facing.x), std::abs(facing.y), std::abs(facing.z)};
    const bool  dropsX = size.x >= size.y && size.x >= size.z;
    const bool  dropsY = !dropsX && size.y >= size.z;
    const auto  u      = [&](std::size_t i) { return dropsX ? model[i].y : model[i].x; };
    const auto  v      = [&](std::size_t i) { return dropsX || dropsY ? model[i].z : model[i].y; };

    const dvec3 e1 = view[1] - view[0], e2 = view[2] - view[0];
    const dvec3 by1 = crossAsWritten(e2, view[0]), by2 = crossAsWritten(view[0], e1);
    const auto  linear = [&](double d1, double d2) {
        return dvec3{d1 * by1.x + d2 * by2.x, d1 * by1.y + d2 * by2.y, d1 * by1.z + d2 * by2.z};
    };
    const double reliefDepth = material.relief ? std::min(material.relief->depth / projection.near, 0x1p1000) : 0;
    return {material.cutout,
            material.relief,
            reliefDepth,
            crossAsWritten(e1, e2),
            linear(u(1) - u(0), u(2) - u(0)),
            linear(v(1) - v(0), v(2) - v(0)),
            u(0),
            v(0),
            projection.centreX,
            projection.centreY,
            projection.focalPixels};
}

}  // namespace zscope
