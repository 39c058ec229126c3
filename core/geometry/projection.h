// From world space to the snapped grid, in the arithmetic that defines the picture: float64, one rounding per
// written operation, in the written order, nothing fused.
//
// View       x right, y up, z = distance in front of the eye
// Screen     pixels, y down; pixel (i, j) has its centre at (i + 0.5, j + 0.5)
// Scale      depths may be wanted times a power of two (core/base/depth_format.h): no rounding sees it, nor does a
//            position
// Snapped    1/256 pixel, integers held in float64 (exact up to 2^53, and rounded to even beyond, as defined)
// Source     docs/correctness.md, The arithmetic, written out
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include "core/base/affine.h"
#include "core/geometry/displacement.h"
#include "core/scene/view.h"

namespace zscope {

/// Snapped positions of one pixel's width.
inline constexpr double kSubpixels = 256;
/// A corner whose snapped position is not below this in magnitude is out of range: its part is not drawn.
inline constexpr double kSnapLimit = 2305843009213693952.0;  // 2^61
/// Up to here edge values of a triangle are exact in float64 at every pixel centre of the largest picture;
/// triangles that reach beyond take the wide path. 2^24 is 65,536 pixels.
inline constexpr double kGuardBand = 16777216.0;

/// A corner on the screen: where it is, how near it is, and where it snaps to.
struct ScreenCorner {
    double x, y;    // unsnapped, pixels
    double d;       // n / z, in (0, 1], times the depth scale
    double xs, ys;  // snapped, 1/256 pixel
};

struct Projection {
    explicit Projection(const Camera& camera, double scaleOfDepths = 1, const Displacement& ofVertices = {})
        : eye(camera.eye), right(camera.right), up(camera.up), forward(camera.forward), near(camera.near),
          depthScale(scaleOfDepths), depthAtOne(camera.near * scaleOfDepths),
          scale(((camera.height * 0.5) * camera.focal) / camera.near / scaleOfDepths), centreX(camera.width * 0.5),
          centreY(camera.height * 0.5), focalPixels((camera.height * 0.5) * camera.focal), displacement(ofVertices)
    {}

    /// `Real` is the type the arithmetic is done in: double by definition, float as an approximation.
    template <class Real = double>
    dvec3 toView(const dvec3& world) const
    {
        using Vec = glm::vec<3, Real>;
        const Vec p(world), e(eye), r(right), u(up), f(forward);
        const Vec d{p.x - e.x, p.y - e.y, p.z - e.z};
        return {(r.x * d.x + r.y * d.y) + r.z * d.z, (u.x * d.x + u.y * d.y) + u.z * d.z,
                (f.x * d.x + f.y * d.y) + f.z * d.z};
    }

    /// `view` must lie at or beyond the near plane. `snaps`: how many snapped positions a pixel has on a side.
    template <class Real = double>
    ScreenCorner toScreen(const dvec3& view, double snaps = kSubpixels) const
    {
        const Real   d = static_cast<Real>(depthAtOne) / static_cast<Real>(view.z);
        const double x = static_cast<Real>(centreX) + (static_cast<Real>(view.x) * d) * static_cast<Real>(scale);
        const double y = static_cast<Real>(centreY) - (static_cast<Real>(view.y) * d) * static_cast<Real>(scale);
        return {x, y, d, std::nearbyint(x * snaps) * (kSubpixels / snaps),
                std::nearbyint(y * snaps) * (kSubpixels / snaps)};
    }

    /// From a slope, x / z or y / z, to pixels, but for the roundings of toScreen().
    double pixelsPerSlope() const { return scale * depthAtOne; }

    dvec3  eye, right, up, forward;
    double near;
    double depthScale;        // the largest depth: what lies on the near plane has it. A power of two
    double depthAtOne;        // depth at z = 1
    double scale;             // k of the definition: pixels per unit of (v.x * D), where D is at depthScale
    double centreX, centreY;  // of the picture, pixels
    double focalPixels;       // pixels per unit of view x / z

    Displacement displacement;  // of the pipeline's vertices
};

}  // namespace zscope
