// Windows of a batch's compact triangles that wait to become pixels, and samples of those that are tiny.
//
// Room       grows to what a batch needs and stays there
// Source     see window_finder-inl.h, which fills it, and windows-inl.h, which works it off
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <deque>
#include <vector>

#include "core/base/cache_aligned.h"
#include "core/depth/pixel_key.h"
#include "core/geometry/batches.h"
#include "core/geometry/triangle_list.h"

namespace zscope {

/// Up to kRoom windows. Columns at fixed places, so that whoever works them off needs one address for all of them.
struct WindowChunk {
    static constexpr std::size_t kRoom  = 2048;
    static constexpr std::size_t kAhead = 24;  // entries after the last that are read to fetch what they name

    template <class T>
    using Column = std::array<T, kRoom + std::max(kBatchPadding, kAhead)>;

    // Entry i is window i.
    alignas(64) Column<std::uint32_t> owners;   // which triangle's
    alignas(64) Column<std::uint32_t> corners;  // its first pixel: x + 65536 y
    std::size_t count = 0;
};

struct WindowList {
    std::deque<WindowChunk> chunks;     // those in use come first
    std::size_t             inUse = 0;  // so many; the last of them takes what comes next

    AlignedVector<double> centres;  // entry i is i + 0.5, of all columns and lines of the picture

    /// Triangles of a batch with up to kMost x kMost windows, which are still to be found.
    struct alignas(64) Some {
        static constexpr int kMost = 4;
        template <class T>
        using Column = std::array<T, 2 * kBatchTriangles + kBatchPadding>;

        Column<std::uint32_t>               owners, corners;  // as of a window at the corner (x0, top) of its box
        Column<std::int32_t>                width, height;    // of its box, in pixels
        std::array<Column<std::int32_t>, 3> edges, steps;     // at that corner; core/fast/lanes/edge_steps-inl.h
        std::size_t                         count = 0;
    };
    Some some;

    // Those with more, one after another.
    std::size_t                 manyCount = 0;
    Some::Column<std::uint32_t> many;

    /// How many windows are listed.
    std::size_t windows() const
    {
        std::size_t all = 0;
        for (std::size_t i = 0; i < inUse; ++i) all += chunks[i].count;
        return all;
    }
    void clear()
    {
        for (std::size_t i = 0; i < inUse; ++i) chunks[i].count = 0;
        inUse = 0, manyCount = 0, some.count = 0;
    }

    /// A chunk with room for so many windows more, at most WindowChunk::kRoom, and for whole vectors behind them.
    WindowChunk& withRoomFor(std::size_t more)
    {
        assert(more <= WindowChunk::kRoom);
        if (inUse == 0 || chunks[inUse - 1].count + more > WindowChunk::kRoom) {
            if (inUse == chunks.size()) chunks.emplace_back();
            ++inUse;
        }
        return chunks[inUse - 1];
    }

    /// Of so many columns or lines, and of those that a window may reach beyond them.
    void knowCentres(std::size_t size)
    {
        std::size_t x = centres.size();
        if (x >= size + kWindowSide) return;
        centres.resize(size + kWindowSide);
        for (; x < centres.size(); ++x) centres[x] = static_cast<double>(x) + 0.5;
    }

    std::size_t bytes() const { return chunks.size() * sizeof(WindowChunk) + centres.capacity() * sizeof(double); }
};

struct SampleList {
    // Entry i is sample i.
    AlignedVector<PixelKey>      keys;
    AlignedVector<std::uint32_t> places;  // its pixel's place among the picture's keys
    AlignedVector<std::uint32_t> pixels;  // its pixel, x + 65536 y, if fragments are shaded as they come

    /// Room for so many samples, and for whole vectors behind them.
    void reserve(std::size_t samples)
    {
        if (keys.size() >= samples + kBatchPadding) return;
        places.resize(samples + kBatchPadding), pixels.resize(samples + kBatchPadding);
        keys.resize(samples + kBatchPadding);  // last: its size says what all have
    }

    std::size_t bytes() const { return keys.capacity() * (sizeof(PixelKey) + 2 * sizeof(std::uint32_t)); }
};

}  // namespace zscope
