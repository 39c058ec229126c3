// Windows of a batch's compact triangles that wait to become pixels, and samples of those that are tiny.
//
// Room       grows to what a batch needs and stays there
// Source     see windows-inl.h, which fills it and works it off
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/cache_aligned.h"
#include "core/depth/pixel_key.h"
#include "core/geometry/batches.h"
#include "core/geometry/triangle_list.h"

namespace zscope {

struct WindowList {
    // Entry i is window i.
    std::size_t                         count = 0;
    AlignedVector<std::uint32_t>        owners;            // which triangle's
    AlignedVector<std::uint32_t>        places;            // its first pixel: x + 65536 y; when it is worked off, that pixel's place among the keys
    std::array<AlignedVector<std::int32_t>, 3> edges;      // the owner's there, as TriangleList counts them
    AlignedVector<std::uint32_t>        columns;           // the first pixel's, when it is worked off
    AlignedVector<double>               centreY;           // likewise

    AlignedVector<double> centres;  // entry x is x + 0.5, of all columns of the picture

    /// Triangles of a batch with up to kMost x kMost windows, which are still to be found.
    struct alignas(64) Some {
        static constexpr int kMost = 4;
        template <class T>
        using Column = std::array<T, 2 * kBatchTriangles + kBatchPadding>;

        Column<std::uint32_t>        owners, places;         // as of a window at the corner (x0, top) of its box
        Column<std::int32_t>         width, height;          // of its box, in pixels
        std::array<Column<std::int32_t>, 3> edges, steps;    // at that corner; core/geometry/edge_steps-inl.h
        std::size_t                  count = 0;
    };
    Some some;

    // Those with more, one after another.
    std::size_t                 manyCount = 0;
    Some::Column<std::uint32_t> many;

    void clear() { count = 0, manyCount = 0, some.count = 0; }

    /// Room for so many windows more, and for whole vectors behind them.
    void reserve(std::size_t more)
    {
        if (owners.size() >= count + more + kBatchPadding) return;
        const std::size_t size = 2 * (count + more + kBatchPadding);
        places.resize(size), columns.resize(size), centreY.resize(size);
        for (auto& edge : edges) edge.resize(size);
        owners.resize(size);  // last: if one of them finds no memory, all are asked again
    }

    /// Of so many columns, and of those that a window may reach beyond them.
    void knowCentres(std::size_t width)
    {
        std::size_t x = centres.size();
        if (x >= width + kWindowSide) return;
        centres.resize(width + kWindowSide);
        for (; x < centres.size(); ++x) centres[x] = static_cast<double>(x) + 0.5;
    }

    std::size_t bytes() const
    {
        return owners.capacity() * (3 * sizeof(std::uint32_t) + 3 * sizeof(std::int32_t) + sizeof(double)) + centres.capacity() * sizeof(double);
    }
};

struct SampleList {
    // Entry i is sample i.
    AlignedVector<PixelKey>      keys;
    AlignedVector<std::uint32_t> places;  // its pixel's place among the picture's keys

    /// Room for so many samples, and for whole vectors behind them.
    void reserve(std::size_t samples)
    {
        if (keys.size() >= samples + kBatchPadding) return;
        places.resize(samples + kBatchPadding), keys.resize(samples + kBatchPadding);  // in this order, likewise
    }

    std::size_t bytes() const { return keys.capacity() * (sizeof(PixelKey) + sizeof(std::uint32_t)); }
};

}  // namespace zscope
