// The screen triangles of one batch, structure of arrays, so that lanes write and read several of them side by side.
//
// Columns    one vector per number of a ScreenTriangle, entry i of each is triangle i; corners are turned as there
// Room       whole vectors may be stored from the entry after the last: reserve() leaves kBatchPadding entries behind it
// Cost       putting one ScreenTriangle together reads twenty columns: for whoever takes triangles one by one
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <vector>

#include "core/geometry/batches.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct TriangleList {
    static constexpr std::int64_t kLarge = 256;

    enum Kind : std::int32_t {
        kFront     = 1,  // as ScreenTriangle::front, wide, patterned
        kWide      = 2,
        kPatterned = 4,
        kHidden    = 8,  // found hidden after set-up: is not to be drawn
    };

    std::size_t                         count = 0;
    std::array<std::vector<double>, 3>  x, y;               // snapped corners
    std::vector<double>                 a, b, c;            // of the depth plane
    std::vector<float>                  farthest, nearest;  // likewise
    std::vector<std::uint32_t>          id;
    std::vector<std::int32_t>           x0, y0, x1, y1;     // box
    std::vector<std::int32_t>           kind;

    bool isEmpty() const { return count == 0; }
    void clear() { count = 0; }

    /// Room for so many triangles in all. What is in the list stays.
    void reserve(std::size_t capacity)
    {
        if (id.size() >= capacity + kBatchPadding) return;
        forEachColumn([size = 2 * capacity + kBatchPadding](auto& column) { column.resize(size); });
    }

    /// There must be room. Always inlined, so that each instruction set gets it in its own instructions.
    [[gnu::always_inline]] void add(const ScreenTriangle& t)
    {
        assert(count < id.size());
        for (std::size_t i = 0; i < 3; ++i) {
            x[i][count] = t.x[i];
            y[i][count] = t.y[i];
        }
        a[count]        = t.depth.a;
        b[count]        = t.depth.b;
        c[count]        = t.depth.c;
        farthest[count] = t.depth.farthest;
        nearest[count]  = t.depth.nearest;
        id[count]       = t.id.value;
        x0[count]       = t.box.x0;
        y0[count]       = t.box.y0;
        x1[count]       = t.box.x1;
        y1[count]       = t.box.y1;
        kind[count]     = (t.front ? kFront : 0) | (t.wide ? kWide : 0) | (t.patterned ? kPatterned : 0);
        ++count;
    }

    /// The boxes of all of them; the list is not empty.
    PixelBox reach() const
    {
        PixelBox all = box(0);
        for (std::size_t i = 1; i < count; ++i) all.include(box(i));
        return all;
    }
    /// True if their boxes have kLarge pixels or more on average.
    bool areLarge() const
    {
        std::int64_t pixels = 0;
        for (std::size_t i = 0; i < count; ++i) pixels += std::int64_t{x1[i] - x0[i]} * (y1[i] - y0[i]);
        return pixels >= kLarge * static_cast<std::int64_t>(count);
    }
    /// True if one of them has a box of kLarge pixels or more.
    bool hasLarge() const
    {
        for (std::size_t i = 0; i < count; ++i)
            if (std::int64_t{x1[i] - x0[i]} * (y1[i] - y0[i]) >= kLarge) return true;
        return false;
    }
    /// `scratch` is used to put them together.
    template <class IsBefore>
    void sort(std::vector<ScreenTriangle>& scratch, const IsBefore& isBefore)
    {
        scratch.clear();
        for (std::size_t i = 0; i < count; ++i) scratch.push_back((*this)[i]);
        std::ranges::sort(scratch, isBefore);
        clear();
        for (const ScreenTriangle& triangle : scratch) add(triangle);
    }

    PixelBox box(std::size_t i) const { return {x0[i], y0[i], x1[i], y1[i]}; }
    bool     isHidden(std::size_t i) const { return (kind[i] & kHidden) != 0; }

    ScreenTriangle operator[](std::size_t i) const
    {
        assert(i < count);
        return {.x         = {x[0][i], x[1][i], x[2][i]},
                .y         = {y[0][i], y[1][i], y[2][i]},
                .depth     = {a[i], b[i], c[i], farthest[i], nearest[i]},
                .id        = {id[i]},
                .box       = box(i),
                .wide      = (kind[i] & kWide) != 0,
                .front     = (kind[i] & kFront) != 0,
                .patterned = (kind[i] & kPatterned) != 0};
    }

    std::size_t bytes() const
    {
        std::size_t all = 0;
        forEachColumn([&all](const auto& column) { all += column.capacity() * sizeof(column[0]); });
        return all;
    }

private:
    template <class Self, class Each>
    static void visitColumns(Self& self, const Each& each)
    {
        for (auto& column : self.x) each(column);
        for (auto& column : self.y) each(column);
        each(self.a), each(self.b), each(self.c);
        each(self.farthest), each(self.nearest);
        each(self.id), each(self.kind);
        each(self.x0), each(self.y0), each(self.x1), each(self.y1);
    }
    template <class Each>
    void forEachColumn(const Each& each) { visitColumns(*this, each); }
    template <class Each>
    void forEachColumn(const Each& each) const { visitColumns(*this, each); }
};

}  // namespace zscope
