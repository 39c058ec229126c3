// Reading one NumPy array of two dimensions, as another program may have written it.
//
// Types      float16, float32, float64, signed and unsigned integers of 8 to 64 bits; either byte order
// Layout     C or Fortran order; header versions 1.0, 2.0 and 3.0
// Values     float64, or int64 for integers: uint64 above 2^63 - 1 becomes the nearest that int64 holds
// Bounds     the shape is compared with the one that is wanted before memory is taken for it
// Errors     Input, one sentence with the file's name
// Source     numpy.lib.format, "Format Version 1.0" to "3.0"
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/grid.h"
#include "core/base/result.h"

namespace zscope {

struct NpyNumbers {
    char        kind  = 'f';  // 'f' float, 'i' signed, 'u' unsigned
    std::size_t bytes = 4;    // of one number
};

struct NpyGrid {
    NpyNumbers         numbers;
    Grid<double>       reals;   // of floats, and of unsigned integers: row 0 is the array's first
    Grid<std::int64_t> wholes;  // of integers
};

/// `bytes` is the whole file; its shape must be (height, width).
Result<NpyGrid> npyGridOf(std::string_view bytes, const std::string& file, int width, int height);

}  // namespace zscope
