// The vertices of one batch on the screen, structure of arrays, as the vertex stage leaves them.
#pragma once

#include <array>

#include "core/geometry/batches.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct ScreenVertices {
    static constexpr std::size_t kCapacity = kBatchVertices + kBatchPadding;

    alignas(64) std::array<double, kCapacity> x, y;    // unsnapped, pixels
    alignas(64) std::array<double, kCapacity> d;       // n / z
    alignas(64) std::array<double, kCapacity> xs, ys;  // snapped, 1/256 pixel
    alignas(64) std::array<std::int32_t, kCapacity> sx, sy;  // likewise, where positions are snapped to whole numbers

    /// No vertex lies behind the near plane and none beyond the guard band. If false, the arrays may hold numbers
    /// without meaning, and each triangle is set up carefully from its positions instead.
    bool plain = false;

    ScreenCorner corner(std::size_t i) const { return {x[i], y[i], d[i], xs[i], ys[i]}; }
};

}  // namespace zscope
