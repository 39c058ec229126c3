// One number per pixel that says who is seen there: depth above, triangle below. Of two of them the larger is the
// winner's, so that the depth test, its rule for equal depths included, is one maximum.
//
// Layout     bits 63 to 32: the stored depth, mapped so that signed integers compare as the float32 do (of a negative
//            number the other bits are turned over). Bits 31 to 0: the complement of the rank
// Rank       triangle id + 1; 0 is background. On equal depth the lower rank wins, so background never loses to one
// Promise    keyOf() is monotone in (depth, -rank); depthOf() and rankOf() give back what it was made of, to the bit
// Source     docs/correctness.md, Depth and the winner
#pragma once

#include <bit>
#include <cstdint>

namespace zscope {

using PixelKey = std::int64_t;

/// Turns a float32's bits into an integer that compares as it does, and back.
constexpr std::int32_t inOrder(std::int32_t bits) { return bits ^ ((bits >> 31) & 0x7FFFFFFF); }

constexpr PixelKey keyOf(float depth, std::uint32_t rank)
{
    const auto above = static_cast<std::uint32_t>(inOrder(std::bit_cast<std::int32_t>(depth)));
    return static_cast<PixelKey>(std::uint64_t{above} << 32 | (0xFFFFFFFFu - rank));
}
constexpr float depthOf(PixelKey key) { return std::bit_cast<float>(inOrder(static_cast<std::int32_t>(key >> 32))); }
constexpr std::uint32_t rankOf(PixelKey key) { return 0xFFFFFFFFu - static_cast<std::uint32_t>(key & 0xFFFFFFFF); }

}  // namespace zscope
