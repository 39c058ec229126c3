#include "core/scene/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/base/products.h"
#include "core/scene/mesh.h"

namespace zscope {

namespace {

/// How much of the picture's half width or height a framed scene may fill.
constexpr double kFilled = 0.88;
/// Sine of the smallest angle between up and the view that still tells where right is.
constexpr double kParallel = 0x1p-26;
/// Nearest distance of interest to an eye inside the scene, as a part of the scene's diagonal.
constexpr double kNearPart = 1e-4;
/// "Along -z, slightly from above"; any length.
constexpr dvec3 kDefaultDirection{0, -0.3, -1};

Error usage(std::string sentence) { return {Trouble::Usage, std::move(sentence)}; }

double largest(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// v / |v|. The power of two taken out first changes no bit of the answer and keeps the squares from vanishing.
dvec3 normalised(dvec3 v)
{
    const int exponent  = std::ilogb(largest(v));
    v                   = {std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)};
    const double length = std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z);
    return {v.x / length, v.y / length, v.z / length};
}

/// What is framed: the scene's box, or something of a sensible size where the box has none.
struct Subject {
    dvec3  middle{0, 0, 0};
    dvec3  half{1, 1, 1};  // half the box's sides
    double diagonal = 0;   // of the box, > 0

    std::array<dvec3, 8> corners() const  // relative to the middle
    {
        std::array<dvec3, 8> all;
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
        return all;
    }
};

Subject subjectOf(const Bounds& box)
{
    Subject subject;
    if (!box.isEmpty()) {
        subject.middle = {box.min.x * 0.5 + box.max.x * 0.5, box.min.y * 0.5 + box.max.y * 0.5,
                          box.min.z * 0.5 + box.max.z * 0.5};
        subject.half   = {box.max.x * 0.5 - box.min.x * 0.5, box.max.y * 0.5 - box.min.y * 0.5,
                          box.max.z * 0.5 - box.min.z * 0.5};
        // A point, or a box so small for its place that an eye beside it could not be told from it.
        const double least = largest(subject.middle) * 0x1p-40;
        if (largest(subject.half) <= least) {
            const double side = least > 0 ? least : 1;
            subject.half      = {side, side, side};
        }
    }
    const double scale = largest(subject.half);
    const dvec3  part  = {subject.half.x / scale, subject.half.y / scale, subject.half.z / scale};
    subject.diagonal   = 2 * scale * std::sqrt(dotAsWritten(part, part));
    return subject;
}

/// Right, up and forward, or why there are none.
struct Axes {
    dvec3 right, up, forward;
};
Result<Axes> axesOf(const dvec3& direction, const dvec3& up)
{
    if (!isFinite(up) || largest(up) == 0) return usage("up must be three finite numbers that are not all 0");
    Axes axes;
    axes.forward     = normalised(direction);
    const dvec3 side = crossAsWritten(axes.forward, normalised(up));
    if (!(largest(side) > kParallel))
        return usage("up is parallel to the direction of view, so nobody can tell what is right: choose another up");
    // f x up, not f x norm(up): the same direction, and the written definition to the bit.
    axes.right = normalised(crossAsWritten(axes.forward, up));
    axes.up    = crossAsWritten(axes.right, axes.forward);
    return axes;
}

/// The eye from which the corners of the subject, seen along the axes, fill kFilled of the tighter side and are in the
/// middle of the picture. `slope`s: tangents of half the angles of view.
dvec3 framingEye(const Subject& subject, const Axes& axes, const dvec3& middle, bool centred, double slopeX,
                 double slopeY)
{
    // With the eye at distance d behind the middle and shifted by s, a corner (x, z) fits if |x - s| <= (d + z) *
    // slope.
    const auto fit = [&](const dvec3& axis, double slope) {
        double most  = -std::numeric_limits<double>::infinity();
        double least = most;
        for (const dvec3& corner : subject.corners()) {
            const double x = dotAsWritten(axis, corner);
            const double z = dotAsWritten(axes.forward, corner);
            most           = std::max(most, x - z * slope);    // s + d * slope must reach this
            least          = std::max(least, -x - z * slope);  // d * slope - s must reach this
        }
        const double shift    = centred ? (most - least) * 0.5 : 0;
        const double distance = std::max(most - shift, least + shift) / slope;
        return std::array{shift, distance};
    };
    const auto [shiftX, distanceX] = fit(axes.right, slopeX * kFilled);
    const auto [shiftY, distanceY] = fit(axes.up, slopeY * kFilled);
    const double distance          = std::max(distanceX, distanceY);
    return middle + axes.right * shiftX + axes.up * shiftY - axes.forward * distance;
}

/// Chooses what is absent of near and far from where the subject lies along the view.
void chooseDepths(Camera& camera, const ViewRequest& view, const Subject& subject)
{
    double nearest  = std::numeric_limits<double>::infinity();
    double farthest = -nearest;
    for (const dvec3& corner : subject.corners()) {
        const double z = dotAsWritten(camera.forward, (subject.middle - camera.eye) + corner);
        nearest        = std::min(nearest, z);
        farthest       = std::max(farthest, z);
    }
    const double closest = subject.diagonal * kNearPart;
    camera.near          = std::max(nearest * 0.5, closest);
    camera.far           = std::max(farthest * 1.01, 0.0) + subject.diagonal * 0.01;
    if (view.near) camera.near = *view.near;
    if (view.far) camera.far = *view.far;
    if (camera.near < camera.far) return;
    if (!view.far)
        camera.far = camera.near * 2;  // the scene lies before the near plane that was asked for
    else if (!view.near)
        camera.near = camera.far * 1e-3;  // it lies behind the far plane that was asked for
}

std::optional<std::string> sizeTrouble(int width, int height)
{
    if (width >= 1 && height >= 1 && width <= kMaxPictureSide && height <= kMaxPictureSide) return std::nullopt;
    return fmt::format("the picture's size must be from 1x1 to {0}x{0} pixels, not {1}x{2}", kMaxPictureSide, width,
                       height);
}

}  // namespace

std::optional<std::string> explainInvalid(const Camera& camera)
{
    if (auto size = sizeTrouble(camera.width, camera.height)) return size;
    if (!isFinite(camera.eye)) return "the eye must be three finite numbers";
    if (!isFinite(camera.right) || !isFinite(camera.up) || !isFinite(camera.forward))
        return "the camera's axes must be finite numbers";
    if (!std::isfinite(camera.focal) || camera.focal <= 0) return "the focal factor must be a finite number above 0";
    if (!std::isfinite(camera.near) || camera.near <= 0) return "near must be a finite number above 0";
    if (!(camera.far > camera.near))
        return fmt::format("far must be above near, and {} is not above {}", camera.far, camera.near);
    return std::nullopt;
}

Result<Camera> makeCamera(const ViewRequest& view, const Bounds& scene)
{
    if (view.exact) {
        if (const auto why = explainInvalid(*view.exact)) return usage(*why);
        return *view.exact;
    }
    if (const auto why = sizeTrouble(view.width, view.height)) return usage(*why);
    if (!(view.verticalFov > 0 && view.verticalFov < 180))
        return usage(fmt::format("the field of view must be between 0 and 180 degrees, not {}", view.verticalFov));
    if (view.eye && !isFinite(*view.eye)) return usage("the eye must be three finite numbers");
    if (view.target && !isFinite(*view.target)) return usage("the target must be three finite numbers");
    if (view.near && !(std::isfinite(*view.near) && *view.near > 0))
        return usage("near must be a finite number above 0");
    if (view.far && !(*view.far > 0)) return usage("far must be above near, and may be inf");
    if (view.near && view.far && !(*view.near < *view.far))
        return usage(fmt::format("far must be above near, and {} is not above {}", *view.far, *view.near));

    constexpr double kRadiansPerDegree = 3.141592653589793 / 180;
    const double     slopeY            = std::tan(view.verticalFov * kRadiansPerDegree * 0.5);
    Camera           camera;
    camera.width  = view.width;
    camera.height = view.height;
    camera.focal  = 1 / slopeY;
    if (!std::isfinite(camera.focal) || !(camera.focal > 0))
        return usage(fmt::format("a field of view of {} degrees is too close to its limit", view.verticalFov));

    const Subject subject   = subjectOf(scene);
    const dvec3   middle    = view.target.value_or(subject.middle);
    const dvec3   direction = view.eye ? middle - *view.eye : kDefaultDirection;
    if (!isFinite(direction)) return usage("eye and target are too far apart");
    if (largest(direction) == 0) {
        if (view.target) return usage("eye and target are the same point, so there is no direction of view");
        return usage("the eye is in the middle of the scene: say with a target where it looks");
    }
    const Result<Axes> axes = axesOf(direction, view.up);
    if (!axes) return axes.error();
    camera.right   = axes->right;
    camera.up      = axes->up;
    camera.forward = axes->forward;

    const double slopeX = slopeY * view.width / view.height;
    camera.eye          = view.eye ? *view.eye : framingEye(subject, *axes, middle, !view.target, slopeX, slopeY);
    chooseDepths(camera, view, subject);
    if (!view.eye && !(isFinite(camera.eye) && std::isfinite(camera.near) && !std::isnan(camera.far)))
        return usage("the scene is too large to be framed: give an eye and a target");
    if (const auto why = explainInvalid(camera)) return usage(*why);
    return camera;
}

}  // namespace zscope
