// PNG in, by libpng. For core/io alone: core/io/image_read.h says how its callers read pictures.
//
// Errors     a clause of libpng's, or of ours, in `trouble`; the size is compared before memory is taken
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/grid.h"

namespace zscope {

struct PngRead {
    std::uint32_t width = 0, height = 0;
    bool          differs = false;  // from the size that is wanted: nothing was read
    std::string   trouble = {};

    bool isOtherSize() const { return differs; }
};

/// 0xRRGGBB; grey and palettes become colours, 16 bits become 8, alpha is left out.
PngRead readPng8(std::string_view bytes, int width, int height, Grid<std::uint32_t>& colours);
/// Grey of 16 bits, alpha left out; anything else is refused.
PngRead readPngGrey16(std::string_view bytes, int width, int height, Grid<std::uint16_t>& grey);
/// Of the text with this keyword that stands before the pixels.
std::optional<std::string> readPngText(std::string_view bytes, std::string_view keyword);

}  // namespace zscope
