// The vertices of one batch on the screen, as the vertex stage leaves them.
//
// Layout     a triangle's corners lie anywhere in the batch. What is needed of a corner at one time therefore stands
//            together, to be fetched by one load, and lanes are filled from such loads instead of by gather
//            instructions (docs/performance.md)
// Units      pixels from the picture's upper left corner; snapped positions in 1/256 of a pixel
// Room       one batch, and as many vertices more as a vector may write beyond its last
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/geometry/batches.h"
#include "core/geometry/pixel_way.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct ScreenVertices {
    static constexpr std::size_t kCapacity = kBatchVertices + kBatchPadding;
    static constexpr std::size_t kRow      = 4;  // numbers per vertex in `rows`

    // Per vertex x, y (unsnapped, pixels), d (n / z), and the bits of its snapped position (snappedBits()).
    alignas(64) std::array<double, kRow * kCapacity> rows;

    /// If all are plain: from the least to the most of their snapped positions.
    struct Reach {
        std::int32_t left, above, right, below;
    };
    Reach reach;

    /// No vertex lies behind the near plane and none beyond the guard band. If false, those that do hold numbers
    /// without meaning (all but the snapped position, kNowhere), and triangles that have one are set up carefully from
    /// their positions instead.
    bool plain = false;

    /// x, and y, of what has no snapped position: beyond the guard band by so much that it shows in lanes of int32,
    /// which hold its distance from any other.
    static constexpr std::int32_t kNowhere = std::int32_t{1} << 30;

    /// Added to a number between -2^31 and 2^31 it rounds it to a whole one, ties to even, which is then the lower half
    /// of the sum's bits.
    static constexpr double kWhole = 0x1.8p52;

    /// A snapped position as it stands in a row: as a way (pixel_way.h) the lower 16 bits of x and y, and in the upper
    /// half of the 64 bits their upper 16. Whoever knows what all vertices lie near to fetches the lower half only.
    static constexpr std::uint64_t snappedBits(std::int32_t x, std::int32_t y)
    {
        return std::uint64_t{static_cast<std::uint32_t>(pixelsAndLines(x >> 16, y >> 16))} << 32
               | static_cast<std::uint32_t>(pixelsAndLines(x, y));
    }
    static constexpr std::int32_t xOf(std::uint64_t bits)
    {
        return static_cast<std::int32_t>((bits >> 16 & 0xFFFF'0000) | (bits & 0xFFFF));
    }
    static constexpr std::int32_t yOf(std::uint64_t bits)
    {
        return static_cast<std::int32_t>((bits >> 32 & 0xFFFF'0000) | (bits >> 16 & 0xFFFF));
    }

    /// The bits of vertex i.
    std::uint64_t snapped(std::size_t i) const { return std::bit_cast<std::uint64_t>(rows[kRow * i + kRow - 1]); }

    bool isPlain(std::size_t i) const { return xOf(snapped(i)) != kNowhere; }

    ScreenCorner corner(std::size_t i) const
    {
        const double*       row  = rows.data() + kRow * i;
        const std::uint64_t both = snapped(i);
        return {row[0], row[1], row[2], static_cast<double>(xOf(both)), static_cast<double>(yOf(both))};
    }
};

}  // namespace zscope
