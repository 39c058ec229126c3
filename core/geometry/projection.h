// From world space to the snapped grid, in the arithmetic that defines the picture: float64, one rounding per
// written operation, in the written order, nothing fused.
//
// View       x right, y up, z = distance in front of the eye
// Screen     pixels, y down; pixel (i, j) has its centre at (i + 0.5, j + 0.5)
// Snapped    1/256 pixel, integers held in float64 (exact up to 2^53, and rounded to even beyond, as defined)
// Source     docs/correctness.md, The arithmetic, written out
#pragma once

#include <cmath>

#include "core/base/affine.h"
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
    double d;       // n / z, in (0, 1]
    double xs, ys;  // snapped, 1/256 pixel
};

struct Projection {
    explicit Projection(const Camera& camera)
        : eye(camera.eye),
          right(camera.right),
          up(camera.up),
          forward(camera.forward),
          near(camera.near),
          scale(((camera.height * 0.5) * camera.focal) / camera.near),
          centreX(camera.width * 0.5),
          centreY(camera.height * 0.5)
    {
    }

    dvec3 toView(const dvec3& world) const
    {
        const dvec3 d{world.x - eye.x, world.y - eye.y, world.z - eye.z};
        return {(right.x * d.x + right.y * d.y) + right.z * d.z,
                (up.x * d.x + up.y * d.y) + up.z * d.z,
                (forward.x * d.x + forward.y * d.y) + forward.z * d.z};
    }

    /// `view` must lie at or beyond the near plane.
    ScreenCorner toScreen(const dvec3& view) const
    {
        const double d = near / view.z;
        const double x = centreX + (view.x * d) * scale;
        const double y = centreY - (view.y * d) * scale;
        return {x, y, d, std::nearbyint(x * kSubpixels), std::nearbyint(y * kSubpixels)};
    }

    dvec3  eye, right, up, forward;
    double near;
    double scale;             // k of the definition: pixels per unit of (v.x * D)
    double centreX, centreY;  // of the picture, pixels
};

}  // namespace zscope
