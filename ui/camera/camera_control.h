// SPDX-License-Identifier: GPL-3.0-or-later
// How the hand moves the camera: orbit, pan, dolly, fly, look along an axis, turn by y-z-y angles. Plain values; the
// ten numbers of the camera are made from the view request by core, so that a command line with the same request
// draws the same picture to the bit.
//
// World      right-handed, y up; the camera looks at `pivot` from `distance` behind it
// Angles     radians, except in YzyAngles and its users, which are degrees as a person types them
// Turning    turning the model by R about the pivot is moving the camera by the inverse of R; the scene, and the
//            light in it, stay as they were read
// Source     y-z-y angles: R = Ry(first) Rz(second) Ry(third)
#pragma once

#include <glm/mat3x3.hpp>

#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope::ui {

/// Degrees; all zero is the view along -z.
struct YzyAngles {
    double first = 0, second = 0, third = 0;
};

enum class AxisView { Front, Right, Top };  // looks along -z, -x, -y

struct CameraControl {
    dvec3  pivot{0, 0, 0};
    double distance = 1;  // from the eye to the pivot, > 0
    double unit     = 1;  // a length of the scene's order of magnitude, > 0
    dvec3  right{1, 0, 0};
    dvec3  up{0, 1, 0};
    dvec3  forward{0, 0, -1};

    /// Starts from a camera; its pivot is the point of its view nearest to the middle of the scene.
    static CameraControl of(const Camera& camera, const Bounds& scene);

    dvec3 eye() const { return pivot - forward * distance; }

    /// About the world's y axis, then about the camera's right axis; stops short of turning the world over.
    void orbit(double aboutUp, double aboutRight);
    /// Shifts eye and pivot in the plane of the picture, in multiples of the picture's height at the pivot.
    void pan(double rightwards, double upwards, double focal);
    /// factor > 1 moves away from the pivot.
    void dolly(double factor);
    /// Moves eye and pivot along the camera's axes, in scene units.
    void fly(double rightwards, double upwards, double forwards);
    /// Turns the head: the eye stays, the pivot moves.
    void look(double aboutUp, double aboutRight);
    void lookAlong(AxisView axis);

    YzyAngles angles() const;
    void      setAngles(const YzyAngles& angles);

    /// `base` gives size, field of view, near and far; eye, target and up come from here.
    ViewRequest view(ViewRequest base) const;

private:
    void turn(double aboutUp, double aboutRight);
};

/// The centre and half size of the cube that a normalised model fills: [-1, 1] in each direction around the mean of
/// its vertices.
struct NormalCube {
    dvec3  centre{0, 0, 0};
    double halfSize = 1;
};
NormalCube normalCubeOf(const Scene& scene);

/// Looks along -z at the cube, from where it fills the height of the picture.
CameraControl facing(const NormalCube& cube, double focal);

}  // namespace zscope::ui
