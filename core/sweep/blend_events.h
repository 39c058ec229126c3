// What blending tells: a pixel whose transparent surfaces have been laid over its opaque colour.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/blend_order.h"
#include "core/probe/about.h"
#include "core/probe/grain.h"
#include "core/probe/telling.h"

namespace zscope {

/// Pixel (x, y) has its final colour.
struct PixelBlended {
    static constexpr Grain grain = Grain::Pixel;
    int                    x, y;
    std::uint32_t          surfaces;       // blended
    std::uint32_t          before, after;  // its colour, 0xAARRGGBB
    BlendOrder             order;

    About       about() const { return {.line = y, .pixels = PixelBox{x, y, x + 1, y + 1}}; }
    std::string sentence(const Telling&) const;
};

/// Fragments of one line that were found, and how many of them the opaque surface hides.
struct FragmentsJudged {
    std::uint64_t found, hidden;
};

}  // namespace zscope
