// The brute-force renderer of the definition: every triangle against every pixel of its box, nothing clever. What
// it draws is the truth that every algorithm is held against, so it is meant to be believed by reading.
//
// Promise    the picture of docs/correctness.md to the bit, for any scene, on any number of threads
// Cost       about 0.2 us per triangle plus 2 ns per pixel of its box; 8 bytes per pixel besides the picture
// Threads    OpenMP inside; progress is reported from the calling thread only
// Source     docs/correctness.md, sections 1 to 4, 2a and the last point of 6
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/depth/visibility_buffer.h"
#include "core/geometry/pixel_box.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope {

/// Errors: Limit (the picture does not fit into memory), Cancelled.
Result<Picture> referencePicture(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                 const Progress& progress = {});

/// What the reference picture holds at one pixel.
struct SampleTruth {
    std::int64_t id    = -1;  // -1 is background
    float        depth = 0;

    friend bool operator==(const SampleTruth&, const SampleTruth&) = default;
};

/// The reference picture at some pixels only (inside the picture, repeats allowed), one answer per point and in
/// their order. Tests every triangle of every instance that can reach a point; memory per point and thread only,
/// so scenes far too large to draw by brute force can be judged. Errors: Cancelled.
Result<std::vector<SampleTruth>> referenceSamples(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                                  std::span<const PixelPosition> points, const Progress& progress = {});

/// A triangle that covers a pixel, whether or not it is seen there.
struct CoveringTriangle {
    TriangleId triangle;
    float      depth = 0;
    bool       kept  = true;  // false: beyond the far plane

    friend bool operator==(const CoveringTriangle&, const CoveringTriangle&) = default;
};

/// All triangles that cover a pixel, each once with its nearest sample, winner first: by falling depth, then rising
/// id. Errors: Cancelled.
Result<std::vector<CoveringTriangle>> coveringTriangles(const Scene& scene, const Camera& camera,
                                                        FaceCulling faceCulling, PixelPosition pixel,
                                                        const Progress& progress = {});

/// What became of the triangles of a frame; the six add up to the triangles of the scene. A triangle cut in two by
/// the near plane counts once, by the better of its parts.
struct TriangleFates {
    std::uint64_t drawn       = 0;  // has area on the grid, on a side that is drawn; may still cover no pixel
    std::uint64_t culled      = 0;  // seen from the back
    std::uint64_t degenerate  = 0;  // no area on the grid
    std::uint64_t outOfRange  = 0;  // a corner beyond 2^61 / 256 pixels, or not a number
    std::uint64_t behindNear  = 0;
    std::uint64_t transparent = 0;  // outside ids and depth

    friend bool operator==(const TriangleFates&, const TriangleFates&) = default;
};
Result<TriangleFates> referenceFates(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                     const Progress& progress = {});

}  // namespace zscope
