// The vertices of one batch on the screen, as the vertex stage leaves them.
//
// Layout     a triangle's corners lie anywhere in the batch. What is needed of a corner at one time therefore stands together, to be
//            fetched by one load, and lanes are filled from such loads instead of by gather instructions (docs/performance.md)
// Units      pixels from the picture's upper left corner; snapped positions in 1/256 of a pixel
// Room       one batch, and as many vertices more as a vector may write beyond its last
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/batches.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct ScreenVertices {
    static constexpr std::size_t kCapacity = kBatchVertices + kBatchPadding;
    static constexpr std::size_t kRow      = 4;  // numbers per vertex in `rows`

    alignas(64) std::array<double, kRow * kCapacity> rows;      // per vertex x, y (unsnapped, pixels), d (n / z), and d again
    alignas(64) std::array<std::uint64_t, kCapacity> snapped;   // xs and ys, where they are whole numbers: int32 in the lower and upper half
    alignas(64) std::array<double, kCapacity>        xs, ys;    // snapped, 1/256 pixel

    /// No vertex lies behind the near plane and none beyond the guard band. If false, the arrays may hold numbers
    /// without meaning, and each triangle is set up carefully from its positions instead.
    bool plain = false;

    ScreenCorner corner(std::size_t i) const { return {rows[kRow * i], rows[kRow * i + 1], rows[kRow * i + 2], xs[i], ys[i]}; }

    /// out[k][i] becomes the snapped position of vertex places[k][i], for all i < count; places are below kCapacity.
    void fetchSnapped(const std::array<const std::uint16_t*, 3>& places, std::size_t count, const std::array<std::uint64_t*, 3>& out) const;
};

}  // namespace zscope
