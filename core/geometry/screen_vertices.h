// The vertices of one batch on the screen, as the vertex stage leaves them.
//
// Layout     a triangle's corners lie anywhere in the batch. What is needed of a corner at one time therefore stands together, to be
//            fetched by one load, and lanes are filled from such loads instead of by gather instructions (docs/performance.md)
// Units      pixels from the picture's upper left corner; snapped positions in 1/256 of a pixel
// Room       one batch, and as many vertices more as a vector may write beyond its last
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "core/geometry/batches.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct ScreenVertices {
    static constexpr std::size_t kCapacity = kBatchVertices + kBatchPadding;
    static constexpr std::size_t kRow      = 4;  // numbers per vertex in `rows`

    // Per vertex x, y (unsnapped, pixels), d (n / z), and by exact rules the bits of its snapped position.
    alignas(64) std::array<double, kRow * kCapacity> rows;
    alignas(64) std::array<double, kCapacity>        xs, ys;  // snapped, 1/256 pixel, by other rules

    /// No vertex lies behind the near plane and none beyond the guard band. If false, those that do hold numbers without meaning (by exact rules
    /// all but the snapped position, kNowhere), and triangles are set up carefully from their positions instead: those that have one, or all.
    bool plain = false;

    /// x, and y, of what has no snapped position: beyond the guard band by so much that it shows in lanes of int32, which hold its distance from any other.
    static constexpr std::int32_t kNowhere = std::int32_t{1} << 30;

    /// Added to a number between -2^31 and 2^31 it rounds it to a whole one, ties to even, which is then the lower half of the sum's bits.
    static constexpr double kWhole = 0x1.8p52;

    /// The snapped position of vertex i by exact rules: x in the lower, y in the upper half, each an int32.
    std::uint64_t snapped(std::size_t i) const { return std::bit_cast<std::uint64_t>(rows[kRow * i + kRow - 1]); }

    /// By exact rules.
    bool isPlain(std::size_t i) const { return static_cast<std::int32_t>(snapped(i)) != kNowhere; }

    /// `Rules` are those that it was transformed by.
    template <class Rules>
    ScreenCorner corner(std::size_t i) const
    {
        const double* row = rows.data() + kRow * i;
        if constexpr (Rules::kExact) {
            const std::uint64_t both = snapped(i);
            return {row[0], row[1], row[2], static_cast<double>(static_cast<std::int32_t>(both)), static_cast<double>(static_cast<std::int32_t>(both >> 32))};
        } else {
            return {row[0], row[1], row[2], xs[i], ys[i]};
        }
    }

    /// out[k][i] becomes the snapped position of vertex places[k][i], for all i < count; places are below kCapacity.
    void fetchSnapped(const std::array<const std::uint16_t*, 3>& places, std::size_t count, const std::array<std::uint64_t*, 3>& out) const;
};

}  // namespace zscope
