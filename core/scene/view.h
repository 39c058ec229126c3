// From what a user says about the view to the ten numbers that are the camera.
//
// Camera     world to view by three dot products: x = right.(p - eye), y = up.(p - eye), z = forward.(p - eye);
//            in front of the eye means z > 0
// Promise    the ten numbers are computed once, in float64, without fused operations; from then on they are exact
// Source     docs/correctness.md, Scene and camera
#pragma once

#include <optional>
#include <string>

#include "core/base/affine.h"
#include "core/base/result.h"

namespace zscope {

struct Bounds;

/// Which side of a triangle is drawn, decided by the sign of its snapped area.
enum class FaceCulling { None, Back };

struct Camera {
    dvec3  eye{0, 0, 0};
    dvec3  right{1, 0, 0};
    dvec3  up{0, 1, 0};
    dvec3  forward{0, 0, -1};
    double focal  = 1;     // 1 / tan(vertical field of view / 2)
    double near   = 0.1;   // > 0
    double far    = 1e6;   // > near, may be infinite
    int    width  = 1280;  // pixels
    int    height = 720;

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// The view options of the command line and of scene files; what is absent is chosen from the scene's bounds.
struct ViewRequest {
    std::optional<dvec3>       eye, target;
    dvec3                      up{0, 1, 0};
    double                     verticalFov = 45;  // degrees, in (0, 180)
    std::optional<double>      near, far;
    int                        width = 1280, height = 720;
    std::optional<FaceCulling> faceCulling;  // absent: whoever draws decides
    std::optional<Camera>      exact;        // all ten numbers given; everything above but faceCulling is ignored
};

/// Longest side of a picture: 16384 pixels.
inline constexpr int kMaxPictureSide = 16384;

/// Without eye the scene is framed: it fits the picture both ways, seen along -z and slightly from above; a target
/// moves the middle of the picture. With an eye and no target the middle of the scene is looked at. Without near and
/// far no part of a framed scene is clipped; an eye in the scene keeps what is farther than 1e-4 of its diagonal.
/// Errors (Usage): up parallel to the view, eye = target, near >= far, near <= 0, a size outside
/// 1..kMaxPictureSide, a field of view outside (0, 180), anything not finite (far may be infinite).
Result<Camera> makeCamera(const ViewRequest& view, const Bounds& scene);

/// Why these ten numbers are no camera, in one sentence; nothing if they are.
std::optional<std::string> explainInvalid(const Camera& camera);

/// The camera from its ten numbers; `text` is the JSON of --camera. `file` is named in errors.
Result<Camera> cameraFromJson(const std::string& text, const std::string& file);
/// The same form in hex floats, so that reading it back gives the same bits.
std::string cameraToJson(const Camera& camera);

}  // namespace zscope
