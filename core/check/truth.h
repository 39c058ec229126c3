// What a foreign picture is held against: the reference of one scene and camera, how much each of its depths may be
// displaced, and the numbers of faces.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/grid.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/depth/visibility_buffer.h"
#include "core/geometry/prepared_scene.h"
#include "core/scene/view.h"

namespace zscope::check {

/// Faces of the whole scene, numbered in load order from 0.
class FaceNumbers {
public:
    explicit FaceNumbers(const Scene& scene);

    std::int64_t count() const { return m_first.back(); }
    /// Of a triangle of the scene.
    std::int64_t faceOf(std::int64_t triangle) const;
    /// Its triangles: [first, end).
    std::pair<std::int64_t, std::int64_t> trianglesOf(std::int64_t face) const;
    std::size_t                           cornersOf(std::int64_t face) const;
    /// Its triangles depend on who cuts it: it has more than three corners and is not convex.
    bool mayBeCutOtherwise(std::int64_t face) const;
    /// The triangles that other programs may number otherwise, because they cut the face otherwise: [first, end). Of a
    /// convex face the triangle alone.
    std::pair<std::int64_t, std::int64_t> surfaceOf(std::int64_t triangle) const;
    bool                                  areOneSurface(std::int64_t triangle, std::int64_t other) const;

private:
    struct Place {
        InstanceId instance;
        PolygonId  polygon;
    };
    Place placeOf(std::int64_t face) const;

    const Scene*              m_scene;
    std::vector<std::int64_t> m_first;  // of each instance; instances + 1 entries
};

struct Truth {
    std::shared_ptr<const PreparedScene> scene;
    FaceNumbers                          faces;
    Camera                               camera;
    FaceCulling                          culling;
    double                               halfStep;  // of the coarser sub-pixel grid, pixels
    Picture                              picture;
    Grid<float>                          slack;  // of each covered pixel's depth: what displacement may change
    std::uint64_t                        covered = 0;

    bool isCovered(std::size_t pixel) const { return picture.ids.values()[pixel] >= 0; }
};

/// Half a step of the coarser of two sub-pixel grids, ours and one of so many bits; pixels.
double halfStepOf(int subpixelBits);

/// Errors: Limit, Cancelled.
Result<std::shared_ptr<const Truth>> truthOf(const std::shared_ptr<const PreparedScene>& scene, const Camera& camera,
                                             FaceCulling culling, int subpixelBits, const Progress& progress);

}  // namespace zscope::check
