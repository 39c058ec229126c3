// The screen triangles of one batch, structure of arrays, so that lanes write and read several of them side by side.
//
// Columns    one array per number of a triangle, entry i of each is triangle i; corners are turned as in ScreenTriangle
// Compact    triangles whose sides are below kCompactSide and whose corners are whole numbers carry their edges too, as
//            integers: an edge value at a pixel centre is 256 times an integer plus what it is at the first pixel.
//            Divided by 256 and rounded down it keeps its sign, which says on which side the pixel lies, and grows from
//            pixel to pixel by less than kCompactSide: below 2^30 over a whole picture (kMaxPictureSide), so that 32
//            bits hold its value at any pixel
// Alone      triangles that are not compact, or patterned, are listed: they are drawn one after another, the others may
//            be drawn together
// Room       fixed: a batch's triangles, each of which the near plane may cut in two. Whole vectors may be stored from
//            the entry after the last
// Cost       putting one ScreenTriangle together reads twenty columns: for whoever takes triangles one by one
// Source     Pineda: A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; docs/correctness.md, Coverage
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <span>

#include "core/geometry/batches.h"
#include "core/geometry/pixel_way.h"
#include "core/geometry/screen_triangle.h"
#include "core/scene/view.h"

namespace zscope {

/// Sides of compact triangles stay below this, in subpixels along each axis: 127 pixels, so that 16 bits hold a side
/// and 32 an edge's value before it is divided.
inline constexpr std::int32_t kCompactSide = 127 * 256;
// An edge rises by less than a side from pixel to pixel, and from line to line.
static_assert(2 * std::int64_t{kCompactSide} * (kMaxPictureSide + 128) < std::int64_t{1} << 30,
              "what it rises by over a picture has to fit 32 bits");
/// Compact triangles become pixels by windows of so many pixels and lines, the first line of them at `top`.
inline constexpr int kWindowSide = 4;

struct TriangleList {
    static constexpr std::int64_t kLarge    = 256;
    static constexpr std::size_t  kCapacity = 2 * kBatchTriangles;

    enum Kind : std::int32_t {
        kCounterClockwise = 1,  // as ScreenTriangle::counterClockwise, wide, patterned
        kWide             = 2,
        kPatterned        = 4,
        kHidden           = 8,   // found hidden after set-up: is not to be drawn
        kCompact          = 16,  // its corners are in `corner`, not in x and y, and its edges are there
    };
    /// So many bits above the kind of a compact triangle stand the lines, fewer than kWindowSide, by which its first
    /// windows begin above its box.
    static constexpr int kRaised = 5;

    template <class T>
    using Column = std::array<T, kCapacity + kBatchPadding>;

    std::size_t count         = 0;
    bool        startsNearest = false;  // whatever is drawn one after another: the nearest first
    PixelBox    compactReach;           // the boxes of all that are compact; empty if none is

    // box, as ways (pixel_way.h): its first pixel, and the one right of and below its last
    alignas(64) Column<std::int32_t> start, end;
    alignas(64) Column<std::int32_t> kind;
    alignas(64) Column<std::uint32_t> notRank;       // complement of the rank, id + 1: what pixels hold of it
    alignas(64) Column<double> a, b, c;              // of the depth plane
    alignas(64) Column<float> farthest, nearest;     // likewise
    alignas(64) std::array<Column<double>, 3> x, y;  // snapped corners of those that are not compact

    // Of compact triangles. Snapped corners, by how many subpixels they lie to the right of the centre of the box's
    // first pixel and below it: less than kCompactSide either way.
    alignas(64) std::array<Column<std::int32_t>, 3> corner;
    // Edges, as above: what they rise by from pixel to pixel (edge_steps-inl.h). Where a pixel is covered, each of the
    // first two has risen by leastRise or more on the way from the picture's first pixel, and both together by mostRise
    // or less: the three add up to the same everywhere.
    alignas(64) std::array<Column<std::int32_t>, 3> steps;
    alignas(64) std::array<Column<std::int32_t>, 2> leastRise;
    alignas(64) Column<std::int32_t> mostRise;
    // Corners as they were given: positions in the batch, the first in the lower 16 bits, the second in the upper; the
    // third in the lower 16 bits of the other, whose upper half says which of the batch's triangles it is. All entries
    // are, from the first on: the lanes of a vector that lie beyond the last triangle look their corners up like the
    // others.
    alignas(64) Column<std::uint32_t> firstTwo{}, thirdAndPlace{};

    const MeshBatches* mesh  = nullptr;  // of the batch that they are
    const Batch*       batch = nullptr;  // nullptr: of no mesh's batch

    bool isEmpty() const { return count == 0; }
    void clear() { count = 0, m_inTurn = 0, startsNearest = false, compactReach = {}, mesh = nullptr, batch = nullptr; }

    /// There must be room. Always inlined, so that each instruction set gets it in its own instructions.
    [[gnu::always_inline]] void add(const ScreenTriangle& t)
    {
        assert(count < kCapacity);
        for (std::size_t i = 0; i < 3; ++i) {
            x[i][count] = t.x[i];
            y[i][count] = t.y[i];
        }
        a[count]        = t.depth.a;
        b[count]        = t.depth.b;
        c[count]        = t.depth.c;
        farthest[count] = t.depth.farthest;
        nearest[count]  = t.depth.nearest;
        notRank[count]  = ~(t.id.value + 1);
        start[count]    = pixelsAndLines(t.box.x0, t.box.y0);
        end[count]      = pixelsAndLines(t.box.x1, t.box.y1);
        kind[count] =
            (t.counterClockwise ? kCounterClockwise : 0) | (t.wide ? kWide : 0) | (t.patterned ? kPatterned : 0);
        listAlone(count);
        ++count;
    }

    /// A triangle that is not compact, or patterned.
    void listAlone(std::size_t i) { m_order[m_inTurn++] = static_cast<std::uint32_t>(i); }
    bool isAlone(std::size_t i) const { return (kind[i] & (kPatterned | kCompact)) != kCompact; }
    /// Those that stand alone, or all, in the order in which they are to be drawn one after another. Call once.
    std::span<const std::uint32_t> inTurn(bool all)
    {
        if (all) {
            std::iota(m_order.begin(), m_order.begin() + static_cast<std::ptrdiff_t>(count), 0u);
            m_inTurn = count;
        }
        const auto listed = std::span(m_order).first(m_inTurn);
        // One that is hidden saves more pixels than its place costs. The parts of a clipped triangle stay together,
        // because all of them reach the near plane.
        if (startsNearest)
            std::ranges::sort(listed, [this](std::uint32_t i, std::uint32_t k) {
                return nearest[i] != nearest[k]   ? nearest[i] > nearest[k]
                       : notRank[i] != notRank[k] ? notRank[i] > notRank[k]
                                                  : i < k;
            });
        return listed;
    }

    /// True if their boxes have kLarge pixels or more on average.
    bool areLarge() const
    {
        std::int64_t pixels = 0;
        for (std::size_t i = 0; i < count; ++i) pixels += std::int64_t{width(i)} * height(i);
        return pixels >= kLarge * static_cast<std::int64_t>(count);
    }
    /// True if one of them has a box of kLarge pixels or more.
    bool hasLarge() const
    {
        std::int64_t largest = 0;
        for (std::size_t i = 0; i < count; ++i) largest = std::max(largest, std::int64_t{width(i)} * height(i));
        return largest >= kLarge;
    }
    /// Of a compact triangle: which of its batch's it is.
    std::size_t placeInBatch(std::size_t i) const { return thirdAndPlace[i] >> 16; }
    TriangleId  id(std::size_t i) const { return {~notRank[i] - 1}; }
    PixelBox    box(std::size_t i) const
    {
        return {pixelsOf(start[i]), linesOf(start[i]), pixelsOf(end[i]), linesOf(end[i])};
    }
    int width(std::size_t i) const { return pixelsOf(end[i]) - pixelsOf(start[i]); }
    int height(std::size_t i) const { return linesOf(end[i]) - linesOf(start[i]); }
    /// Of a compact triangle: the first line of its windows.
    int    top(std::size_t i) const { return linesOf(start[i]) - (kind[i] >> kRaised); }
    bool   is(Kind what, std::size_t i) const { return (kind[i] & what) != 0; }
    double cornerX(std::size_t k, std::size_t i) const
    {
        return is(kCompact, i) ? pixelsOf(corner[k][i]) + 256 * pixelsOf(start[i]) + 128 : x[k][i];
    }
    double cornerY(std::size_t k, std::size_t i) const
    {
        return is(kCompact, i) ? linesOf(corner[k][i]) + 256 * linesOf(start[i]) + 128 : y[k][i];
    }
    bool isHidden(std::size_t i) const { return is(kHidden, i); }

    ScreenTriangle operator[](std::size_t i) const
    {
        assert(i < count);
        return {.x                = {cornerX(0, i), cornerX(1, i), cornerX(2, i)},
                .y                = {cornerY(0, i), cornerY(1, i), cornerY(2, i)},
                .depth            = {a[i], b[i], c[i], farthest[i], nearest[i]},
                .id               = id(i),
                .box              = box(i),
                .wide             = is(kWide, i),
                .counterClockwise = is(kCounterClockwise, i),
                .patterned        = is(kPatterned, i)};
    }

private:
    std::size_t                          m_inTurn = 0;
    std::array<std::uint32_t, kCapacity> m_order;  // m_inTurn of them: which are drawn one after another
};

}  // namespace zscope
