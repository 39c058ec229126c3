// From the matrices of OpenGL, Direct3D or Vulkan to the ten numbers of a camera.
//
// Vectors    are columns: clip = projection * view * world. Sixteen numbers are four rows, or four columns; row vectors
//            stored by rows lie in memory as columns do
// Order      the one by which the matrix is a perspective; if both are, rows
// Depth      z_clip / w = a + b/z. b > 0 is reversed depth. Otherwise the matrix does not say whether 0 or -1 is near:
//            both cameras are given back, the likelier first (-1 where w is -z, as OpenGL has it), and a depth buffer
//            may decide
// Rows       a projection that points y down (Vulkan) is turned over: the picture's top row is the one it draws first
// Refused    a matrix that is no perspective, has pixels that are not square, or its centre elsewhere than in the
//            middle of the picture
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/check/foreign.h"
#include "core/scene/view.h"

namespace zscope::check {

using Matrix = std::array<double, 16>;

struct CameraMatrices {
    std::optional<Matrix>      view, projection;  // both, or
    std::optional<Matrix>      clipFromWorld;
    std::optional<MatrixOrder> order;
    std::optional<DepthRange>  range;
};

/// {"view":[16],"projection":[16]} or {"clip_from_world":[16]}, with "order" and "depth" if one likes.
Result<CameraMatrices> matricesOf(const std::string& json, const std::string& file);
Result<CameraMatrices> readMatrices(const std::string& path);

/// One camera, or two that differ in `near` alone, the likelier first. Errors: Input; `file` is named in them.
Result<std::vector<Camera>> camerasOf(const CameraMatrices& matrices, int width, int height, const std::string& file);

}  // namespace zscope::check
