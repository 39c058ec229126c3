// Which triangles meet the centre of a pixel, by the definition: those that can be seen there, and those that would
// have been if they did not show their backs, had no hole there, or lay between near and far.
//
// Exact      Opaque, BeyondFar, Hole, BackFace, Transparent: coverage on the snapped grid, depth by its plane
// BeforeNear is geometry without snapping (the ray through the pixel's centre meets the triangle before the near
//            plane), because what the near plane cuts away is never snapped
// Cost       as referenceSamples(): every triangle of the instances that can reach a point; memory per cover found
// Source     docs/correctness.md, sections 1 to 4
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/measure/reference.h"

namespace zscope {

/// The best that can be said of a triangle comes first.
enum class Cover {
    Opaque,       // covers the pixel: one of them is the winner
    Transparent,  // covers it, and is blended over the opaque picture if it is nearer
    BeyondFar,
    Hole,      // of a cut-out material
    BackFace,  // turns away, and such faces are culled
    BeforeNear,
};
std::string_view wordOf(Cover cover);

struct PixelCover {
    TriangleId triangle;
    Cover      cover = Cover::Opaque;
    float      depth = 0;  // near/z at the pixel's centre; above 1 before the near plane

    friend bool operator==(const PixelCover&, const PixelCover&) = default;
};

/// One list per point, in their order, each ascending by triangle; of two parts of a triangle the better cover, then
/// the nearer, stays. The points lie inside the picture. Errors: Cancelled.
Result<std::vector<std::vector<PixelCover>>> coversOf(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                                      std::span<const PixelPosition> points,
                                                      const Progress&                progress = {});

/// How one triangle meets the pixels of the picture.
struct TriangleCovers {
    std::vector<PixelPosition> opaque;  // pixels that it covers, row by row; transparent ones too
    std::vector<float>         depth;   // of each of them
    std::uint64_t              beyondFar = 0, holes = 0, backFacing = 0;  // pixels
    bool                       isTransparent = false;
    int                        parts         = 0;  // in front of the near plane, with area on the grid
    // why there is no part
    bool isBehindNear = false, isDegenerate = false, isOutOfRange = false;
};
TriangleCovers coversOf(const Scene& scene, const Camera& camera, FaceCulling faceCulling, TriangleId triangle);

}  // namespace zscope
