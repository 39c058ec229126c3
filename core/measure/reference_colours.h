// The colours of the definition, by brute force: every opaque pixel from its triangle, and every transparent triangle
// against every pixel of its box, fragments sorted and blended. What blending is held against.
//
// Promise    the colours of docs/correctness.md, Polygons, last point, to the bit; shares with the renderer only the
//            shaded colour of a triangle (core/shade/colour_table.h)
// Shading    the fragment shader runs on opaque pixels: its chain leaves one bit in blue, which is written down here
//            once more. Transparent fragments have the colour of their triangle, whatever shading costs
// Cost       as referencePicture(), and 12 bytes per transparent fragment
#pragma once

#include <cstdint>

#include "core/base/grid.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/depth/visibility_buffer.h"
#include "core/frame/pipeline.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope {

/// 0xAARRGGBB over `opaque`, a picture of the same scene and camera: the reference picture, or what a method of another
/// claim shows, whose colours are then judged by its own ids and depths. Errors: Limit, Cancelled.
Result<Grid<std::uint32_t>> referenceColours(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                             const Picture& opaque, ShadingCost cost = ShadingCost::None,
                                             const Progress& progress = {});

/// How two shaded pictures of one size differ.
struct ColourFigures {
    std::uint64_t wrong      = 0;  // pixels
    int           maxChannel = 0;  // the largest difference of a red, green or blue value, 0 to 255

    friend bool operator==(const ColourFigures&, const ColourFigures&) = default;
};
ColourFigures compareColours(const Grid<std::uint32_t>& reference, const Grid<std::uint32_t>& test);

}  // namespace zscope
