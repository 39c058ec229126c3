// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/camera/camera_control.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace zscope::ui {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Rodrigues' formula; `axis` has length 1.
dvec3 rotated(const dvec3& v, const dvec3& axis, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

double sizeOf(const Bounds& scene)
{
    if (scene.isEmpty()) return 1;
    const double size = glm::length(scene.max - scene.min) / 2;
    return size > 0 && std::isfinite(size) ? size : 1;
}

}  // namespace

CameraControl CameraControl::of(const Camera& camera, const Bounds& scene)
{
    CameraControl control;
    control.right       = camera.right;
    control.up          = camera.up;
    control.forward     = camera.forward;
    control.unit        = sizeOf(scene);
    const dvec3  middle = scene.isEmpty() ? camera.eye + camera.forward : (scene.min + scene.max) * 0.5;
    const double ahead  = glm::dot(middle - camera.eye, camera.forward);
    control.distance    = ahead > 1e-6 * control.unit ? ahead : control.unit;
    control.pivot       = camera.eye + camera.forward * control.distance;
    return control;
}

void CameraControl::turn(double aboutUp, double aboutRight)
{
    const dvec3 worldUp{0, 1, 0};
    for (dvec3* axis : {&right, &up, &forward}) *axis = rotated(*axis, worldUp, aboutUp);
    const dvec3 tiltedUp = rotated(up, right, aboutRight);
    if (tiltedUp.y * up.y >= 0) {  // past the pole the world would stand on its head
        forward = rotated(forward, right, aboutRight);
        up      = tiltedUp;
    }
    forward = glm::normalize(forward);
    right   = glm::normalize(glm::cross(forward, up));
    up      = glm::cross(right, forward);
}

void CameraControl::orbit(double aboutUp, double aboutRight) { turn(aboutUp, aboutRight); }

void CameraControl::pan(double rightwards, double upwards, double focal)
{
    const double height = 2 * distance / focal;
    pivot += right * (rightwards * height) + up * (upwards * height);
}

void CameraControl::dolly(double factor) { distance = std::clamp(distance * factor, 1e-6 * unit, 1e6 * unit); }

void CameraControl::fly(double rightwards, double upwards, double forwards)
{
    pivot += (right * rightwards + up * upwards + forward * forwards) * unit;
}

void CameraControl::look(double aboutUp, double aboutRight)
{
    const dvec3 stays = eye();
    turn(aboutUp, aboutRight);
    pivot = stays + forward * distance;
}

void CameraControl::lookAlong(AxisView axis)
{
    switch (axis) {
        case AxisView::Front:
            right = {1, 0, 0}, up = {0, 1, 0}, forward = {0, 0, -1};
            break;
        case AxisView::Right:
            right = {0, 0, -1}, up = {0, 1, 0}, forward = {-1, 0, 0};
            break;
        case AxisView::Top:
            right = {1, 0, 0}, up = {0, 0, -1}, forward = {0, -1, 0};
            break;
    }
}

YzyAngles CameraControl::angles() const
{
    // The rows of the model's rotation are the camera's axes: right, up, backwards.
    const dvec3  back      = -forward;
    const double cosSecond = std::clamp(up.y, -1.0, 1.0);
    const double sinSecond = std::hypot(up.x, up.z);
    if (sinSecond < 1e-9) {  // both outer axes coincide: everything is the third angle
        const double sign = cosSecond > 0 ? 1 : -1;
        return {0, cosSecond > 0 ? 0.0 : 180.0, std::atan2(sign * right.z, sign * right.x) / kDegree};
    }
    return {std::atan2(back.y, -right.y) / kDegree, std::atan2(sinSecond, cosSecond) / kDegree,
            std::atan2(up.z, up.x) / kDegree};
}

void CameraControl::setAngles(const YzyAngles& angles)
{
    const double ca = std::cos(angles.first * kDegree), sa = std::sin(angles.first * kDegree);
    const double cb = std::cos(angles.second * kDegree), sb = std::sin(angles.second * kDegree);
    const double cc = std::cos(angles.third * kDegree), sc = std::sin(angles.third * kDegree);
    right   = {ca * cb * cc - sa * sc, -ca * sb, ca * cb * sc + sa * cc};
    up      = {sb * cc, cb, sb * sc};
    forward = -dvec3{-sa * cb * cc - ca * sc, sa * sb, -sa * cb * sc + ca * cc};
}

ViewRequest CameraControl::view(ViewRequest base) const
{
    base.exact.reset();
    base.eye    = eye();
    base.target = pivot;
    base.up     = up;
    return base;
}

NormalCube normalCubeOf(const Scene& scene)
{
    NormalCube cube;
    if (scene.bounds.isEmpty()) return cube;

    std::vector<dvec3> meanOfMesh;
    for (const auto& mesh : scene.meshes) {
        dvec3 sum{0, 0, 0};
        for (const dvec3& p : mesh->positions) sum += p;
        meanOfMesh.push_back(mesh->positions.empty() ? sum : sum / static_cast<double>(mesh->positions.size()));
    }
    dvec3  sum{0, 0, 0};
    double count = 0;
    for (const Instance& instance : scene.instances) {  // an affine map takes the mean to the mean
        const double vertices = static_cast<double>(scene.meshes[instance.mesh.value]->positions.size());
        sum += instance.toWorld(meanOfMesh[instance.mesh.value]) * vertices;
        count += vertices;
    }
    if (count > 0) cube.centre = sum / count;
    const dvec3  above = scene.bounds.max - cube.centre, below = cube.centre - scene.bounds.min;
    const double reach = std::max({above.x, above.y, above.z, below.x, below.y, below.z});
    if (reach > 0 && std::isfinite(reach)) cube.halfSize = reach;
    return cube;
}

CameraControl facing(const NormalCube& cube, double focal)
{
    CameraControl control;
    control.pivot    = cube.centre;
    control.unit     = cube.halfSize;
    control.distance = cube.halfSize * (1 + focal);  // the front face of the cube spans the picture's height
    return control;
}

}  // namespace zscope::ui
