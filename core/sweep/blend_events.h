// What blending tells: a pixel whose transparent surfaces have been laid over its opaque colour.
#pragma once

#include <cstdint>

#include "core/probe/about.h"
#include "core/probe/grain.h"

namespace zscope {

/// Pixel (x, y) has its final colour.
struct PixelBlended {
    static constexpr Grain grain = Grain::Pixel;
    int                    x, y;
    std::uint32_t          surfaces;       // blended, farthest first
    std::uint32_t          before, after;  // its colour, 0xAARRGGBB

    About about() const { return {.line = y, .pixels = PixelBox{x, y, x + 1, y + 1}}; }
};

/// Fragments of one line that were found, and how many of them the opaque surface hides.
struct FragmentsJudged {
    std::uint64_t found, hidden;
};

}  // namespace zscope
