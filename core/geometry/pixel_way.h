// A way over the picture in one number of 32 bits: so many pixels to the right in the lower half, so many lines down in
// the upper, each of 16 bits with a sign. A pixel is the way to it from the picture's first.
#pragma once

#include <cstdint>

namespace zscope {

/// Of each part the lower 16 bits.
constexpr std::int32_t pixelsAndLines(int pixels, int lines)
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(lines) << 16
                                     | (static_cast<std::uint32_t>(pixels) & 0xFFFF));
}
constexpr int pixelsOf(std::int32_t way) { return static_cast<std::int16_t>(way); }
constexpr int linesOf(std::int32_t way) { return way >> 16; }

}  // namespace zscope
