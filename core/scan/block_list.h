// Small triangles of one batch that wait to become pixels, and the blocks of the picture that each of them may cover.
//
// Room       grows to what a batch needs and stays there
// Source     see blocks-inl.h, which fills it and works it off
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/geometry/triangle_list.h"

namespace zscope {

/// Sides up to this long, in subpixels along each axis, are tested by blocks: 128 pixels.
inline constexpr double kCompactSide = 32768;

inline bool isCompact(const ScreenTriangle& t)
{
    const auto reach = [](const std::array<double, 3>& at) { return std::max({at[0], at[1], at[2]}) - std::min({at[0], at[1], at[2]}); };
    return reach(t.x) <= kCompactSide && reach(t.y) <= kCompactSide;
}

struct BlockPlace {
    int x, y;  // its first pixel
};

struct BlockList {
    // Entry i belongs to triangle i of the batch. Edge values are divided by 256 and rounded down: integers. An origin is the
    // value at the first pixel of the triangle's box.
    std::array<std::vector<float>, 3> origin, perPixel, perLine;

    // Entry i is block i.
    std::size_t                count = 0;
    std::vector<std::uint32_t> places;  // x + 65536 y
    std::vector<std::uint32_t> owners;  // which triangle's

    void clear() { count = 0; }

    /// Room for the edges of so many triangles.
    void reserveTriangles(std::size_t triangles)
    {
        if (origin[0].size() >= triangles + kBatchPadding) return;
        for (auto* columns : {&origin, &perPixel, &perLine})
            for (std::vector<float>& column : *columns) column.resize(triangles + kBatchPadding);
    }
    /// Room for so many blocks more, and for whole vectors behind them.
    void reserveBlocks(std::size_t more)
    {
        if (places.size() >= count + more + kBatchPadding) return;
        places.resize(2 * (count + more + kBatchPadding));
        owners.resize(places.size());
    }

    BlockPlace  block(std::size_t i) const { return {static_cast<int>(places[i] & 0xffff), static_cast<int>(places[i] >> 16)}; }
    std::size_t bytes() const
    {
        return 9 * origin[0].capacity() * sizeof(float) + (places.capacity() + owners.capacity()) * sizeof(std::uint32_t);
    }
};

}  // namespace zscope
