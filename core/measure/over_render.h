// How much more was drawn than is seen: the price of drawing in the wrong order or of hiding nothing.
//
// Triangles  entered into pixels (or into an edge table), a pre-pass included, against those that own a pixel at the
//            end
// Fragments  depth tests, a pre-pass included, against covered pixels. A sweep by intervals gives whole runs away
//            untested
// Source     docs/correctness.md, What is promised, what is measured
#pragma once

#include <cstdint>

#include "core/depth/visibility_buffer.h"
#include "core/frame/frame_work.h"

namespace zscope {

struct OverRender {
    std::uint64_t trianglesRasterised = 0, trianglesVisible = 0;
    std::uint64_t fragmentsTested = 0, pixelsCovered = 0;

    /// Rasterised per visible triangle, tested per covered pixel; 0 where nothing is seen.
    double ofTriangles() const { return ratio(trianglesRasterised, trianglesVisible); }
    double ofFragments() const { return ratio(fragmentsTested, pixelsCovered); }

private:
    static double ratio(std::uint64_t all, std::uint64_t seen)
    {
        return seen == 0 ? 0 : static_cast<double>(all) / static_cast<double>(seen);
    }
};

/// `work` and `visible` are of one frame.
OverRender overRenderOf(const FrameWork& work, const VisibilityBuffer& visible);

}  // namespace zscope
