// How wrong a picture is whose method draws whole faces: what it shows against what the definition shows, by face. Both
// pictures' ids become the first triangle ids of their faces, and whatever then differs is looked into.
//
// Covers     a face covers a pixel that one of its triangles covers; a face that is mended (it crosses itself or has no
//            area), one that an odd number of its triangles cover, which is the even-odd rule over its outline
// Hole       a face covers the pixel and is nearer there, with all its corners, than what the picture shows
// Spill      the picture shows a face that does not cover the pixel
// Else       another face than the reference's is a matter of depth: a wrong surface, a figure, as the depths are
// Promise    no hole and no spill: the picture's faces cover exactly what they should, as far as a picture can tell
// Cost       as compare(); where faces differ, one walk over the scene for all such pixels together
// Source     docs/correctness.md, Polygons
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/measure/error_figures.h"
#include "core/measure/reference.h"

namespace zscope {

/// Figures as compare() gives them, holes and spills as said above; falseCulls are faces that are in no pixel of the
/// test and left a hole. `pixels` are those at `points`, with the ids of triangles; `testIds` are those of the whole
/// picture. `points` are distinct or not, inside the picture. Errors: Cancelled.
Result<ErrorFigures> compareByFace(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                   std::vector<PixelPair> pixels, std::span<const PixelPosition> points,
                                   std::span<const std::int64_t> testIds, const Progress& progress = {});

/// At all pixels of two pictures of one size.
Result<ErrorFigures> compareByFace(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                   const Picture& reference, const Picture& test, const Progress& progress = {});

}  // namespace zscope
