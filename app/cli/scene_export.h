// The triangles of all instances of a scene as other programs can read them: in world space, in the order of their ids.
//
// Promise    the coordinates are ZScope's to the bit: float64 in the array, in OBJ the shortest decimals that give them
//            back. So an OBJ that is read again has the same picture
// Errors     Output; Cancelled
#pragma once

#include <atomic>
#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace zscope::cli {

/// A NumPy array, float64 (N, 3, 3): corners, the row is the triangle's id.
Result<Done> writeTriangles(const Scene& scene, const std::string& path, const std::atomic<bool>* cancel);

/// An OBJ file: three vertices and one face for each triangle. Nothing else of the scene is kept.
Result<Done> writeObj(const Scene& scene, const std::string& path, const std::atomic<bool>* cancel);

}  // namespace zscope::cli
