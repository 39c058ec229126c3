// Reading pictures that another program wrote: PNG of 8 and 16 bits, BMP, PPM, and PFM for floats.
//
// Rows       row 0 is the top line, whatever order the file has
// Bounds     the size is compared with the one that is wanted before memory is taken for the pixels
// Errors     Input, one sentence with the file's name
// Source     PNG: libpng. BMP: Microsoft's BITMAPINFOHEADER, uncompressed, 8, 24 and 32 bits. PPM: Netpbm's ppm(5), P3
//            and P6. PFM: Paul Debevec's HDR Shop
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/grid.h"
#include "core/base/result.h"

namespace zscope {

/// 0xRRGGBB of every pixel; alpha is left out. The kind of file is found from its first bytes.
Result<Grid<std::uint32_t>> coloursOf(std::string_view bytes, const std::string& file, int width, int height);

/// The numbers of a grey PNG of 16 bits.
Result<Grid<std::uint16_t>> grey16Of(std::string_view bytes, const std::string& file, int width, int height);

/// The text that a PNG carries under a keyword (core/io/png.h); nothing if it has none, or is no PNG.
std::optional<std::string> pngTextOf(std::string_view bytes, std::string_view keyword);

/// The floats of a PFM file; of one with colours the first of each pixel.
Result<Grid<float>> pfmOf(std::string_view bytes, const std::string& file, int width, int height);

}  // namespace zscope
