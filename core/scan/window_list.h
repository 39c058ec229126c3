// Windows of a batch's compact triangles that wait to become pixels.
//
// Room       grows to what a batch needs and stays there
// Source     see windows-inl.h, which fills it and works it off
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/batches.h"

namespace zscope {

struct WindowList {
    // Entry i is window i.
    std::size_t                count = 0;
    std::vector<std::uint32_t> owners;            // which triangle's
    std::vector<std::uint32_t> places;            // its first pixel: x + 65536 y
    std::vector<float>         right, down;       // likewise, counted from the owner's first window
    std::vector<double>        centreX, centreY;  // likewise, in the picture

    void clear() { count = 0; }

    /// Room for so many windows more, and for whole vectors behind them.
    void reserve(std::size_t more)
    {
        if (owners.size() >= count + more + kBatchPadding) return;
        const std::size_t size = 2 * (count + more + kBatchPadding);
        owners.resize(size), places.resize(size);
        right.resize(size), down.resize(size);
        centreX.resize(size), centreY.resize(size);
    }

    std::size_t bytes() const { return owners.capacity() * (2 * sizeof(std::uint32_t) + 2 * sizeof(float) + 2 * sizeof(double)); }
};

}  // namespace zscope
