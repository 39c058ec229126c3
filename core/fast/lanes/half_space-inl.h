// Scan conversion by half-spaces: a pixel is inside a triangle if it lies on the inner side of all three edges.
//
// Edges      values are integers below 2^53 (core/geometry/half_plane.h), so float64 lanes hold them exactly
// Compact    triangles, without a long side, are tested by windows, in float32 (windows-inl.h)
// Tiles      the box of the others is cut along the tiles of the visibility buffer, each of which is opened when
//            something is drawn to it, and those along the pyramid's, which are judged side by side. A tile wholly on
//            the outer side of one edge is skipped, and one that is covered whole may be kept as a plane
//            (tile_plane-inl.h)
// Large      without patterns, large_triangle-inl.h finds all of a triangle's tiles first
// Pyramid    where stale cells wait for a query: a tile whose stored depth hides the triangle is skipped, and one
//            whose pixels are all gone over tells its farthest depth, which was in registers anyway
// Z-cull     by tiles of the pyramid's lowest stored level instead: what the triangle's nearest depth in a tile cannot
//            win is not tested pixel by pixel. A tile's farthest depth is read, and found again when it is stale: no
//            pixel writes to it
// Wide       of triangles beyond the guard band each tile finds the edges anew, in 128 bits; those beyond
//            kWidestByTiles are handed to EdgeWalk, which finds the same pixels
// Source     Pineda: A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; docs/correctness.md, Coverage
#if defined(ZSCOPE_HALF_SPACE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_HALF_SPACE_INL_H
#undef ZSCOPE_HALF_SPACE_INL_H
#else
#define ZSCOPE_HALF_SPACE_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

#include "core/depth/pyramid_told.h"
#include "core/fast/lanes/depth_test-inl.h"
#include "core/fast/lanes/edge_walk-inl.h"
#include "core/fast/lanes/lane_order-inl.h"
#include "core/fast/large_triangles/large_triangle-inl.h"
#include "core/fast/tile_planes/tile_plane-inl.h"
#include "core/fast/windows/windows-inl.h"
#include "core/geometry/half_plane.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

struct HalfSpace {
    /// `upkeep` (TileUpkeep) is asked whether the pyramid's tiles hide the triangle and told what becomes of them.
    /// Opens what is drawn to.
    template <Keep kKeep, class Fragments, class Upkeep, class Rules>
    static void fill(const ScreenTriangle& triangle, const Fragments& fragments, const Upkeep& upkeep,
                     VisibilityBuffer& visible, const Rules& rules)
    {
        if constexpr (Rules::kExactDepths && Fragments::kMoment == ShadingMoment::Never && !Fragments::kPatterned)
            if (areNormal(visible.empty())) return fillBox<kKeep, true>(triangle, fragments, upkeep, visible, rules);
        fillBox<kKeep, false>(triangle, fragments, upkeep, visible, rules);
    }

    /// The same, tile by tile of `tiles`, which is told what may have changed; `told` hears what it brings up to date.
    template <Keep kKeep, class Fragments, class Told, class Rules>
    static void fillByTiles(const ScreenTriangle& triangle, Pyramid& tiles, const Told& told,
                            const Fragments& fragments, VisibilityBuffer& visible, const Rules& rules)
    {
        visible.open(triangle.box);
        if (triangle.wide) {
            EdgeWalk::fill<kKeep>(triangle, fragments, visible, rules);
            tiles.touched(triangle.box);
            return;
        }
        static_assert(kTile % hn::MaxLanes(F64()) == 0, "columns must not reach over the border of a tile");
        const PixelBox&               box = triangle.box;
        const HalfPlanes              edges{halfPlanesOf(triangle, rules.notOwned()), box.x0, box.y0};
        const DepthTest<kKeep, Rules> test(triangle.depth, triangle.rank(), visible.empty(), rules);

        for (int top = tiles.tileAt(box.x0, box.y0).y0; top < box.y1; top += kTile) {
            for (int left = tiles.tileAt(box.x0, box.y0).x0; left < box.x1; left += kTile) {
                if (edges.areOutside({left, top, left + kTile, top + kTile})) continue;
                const PixelBox   here{std::max(left, box.x0), std::max(top, box.y0), std::min(left + kTile, box.x1),
                                    std::min(top + kTile, box.y1)};
                const float      nearest = nearestIn(triangle.depth, here, rules);
                const TileAnswer answer  = tiles.askTile(left, top, nearest, told);
                if (answer.hidden) continue;
                for (int x = left; x < here.x1; x += laneCount())
                    fillTile(triangle, edges, test, test.column(x), x, here.y0, here.y1, false, fragments, visible,
                             rules);
                tiles.touched(here);
            }
        }
    }

private:
    static constexpr int kTile = 1 << Pyramid::kTileLevel;

    static constexpr std::size_t kParts = VisibilityBuffer::kTileWidth / kTile;
    using Depths                        = std::array<float, kParts>;

    /// Which parts of a box in one tile of the visibility buffer are not wholly on the outer side of an edge: bit i is
    /// the i-th tile of the pyramid in there, from the left.
    static std::uint32_t partsReached(const PixelBox& box, const HalfPlanes& edges)
    {
        const F64     d64;
        std::uint32_t all      = 0;
        const int     tileLeft = VisibilityBuffer::leftOfTile(box.x0) - edges.x0;
        for (std::size_t i = 0; i < kParts; i += hn::Lanes(d64)) {
            const auto left  = countFrom(d64, static_cast<double>(i)) * hn::Set(d64, kTile) + hn::Set(d64, tileLeft);
            const auto first = hn::Max(left, hn::Set(d64, box.x0 - edges.x0)),
                       last  = hn::Min(left + hn::Set(d64, kTile - 1), hn::Set(d64, box.x1 - 1 - edges.x0));
            auto reached     = first <= last;
            for (const HalfPlane& plane : edges.planes) {
                const auto   slope = hn::Set(d64, plane.perPixel);
                const double line  = std::max(plane.at(0, box.y0 - edges.y0), plane.at(0, box.y1 - 1 - edges.y0));
                reached = hn::And(reached, hn::Max(first * slope, last * slope) + hn::Set(d64, line) >= hn::Zero(d64));
            }
            all |= bitsOf(d64, reached) << i;
        }
        return all;
    }

    /// The nearest depth that the triangle could store in each of those parts.
    template <class Rules>
    static Depths nearestOfParts(const DepthPlane& plane, const PixelBox& box, [[maybe_unused]] const Rules& rules)
    {
        if constexpr (Rules::kExactDepths) return depthsAlong<kTile, true>(plane, box);
        Depths all;
        all.fill(rules.stored(plane.nearest));
        return all;
    }

    /// fill(); `kNormal` as in DepthTest.
    template <Keep kKeep, bool kNormal, class Fragments, class Upkeep, class Rules>
    static void fillBox(const ScreenTriangle& triangle, const Fragments& fragments, const Upkeep& upkeep,
                        VisibilityBuffer& visible, const Rules& rules)
    {
        const PixelBox& box = triangle.box;
        if (triangle.wide && !(upkeep.shortcuts.has(Shortcut::WideTiles) && fitsTiles(triangle))) {
            visible.open(box);
            EdgeWalk::fill<kKeep>(triangle, fragments, visible, rules);
            upkeep.touched(box);
            return;
        }
        const HalfPlanes                       fromBox{halfPlanesOf(triangle, rules.notOwned()), box.x0, box.y0};
        const DepthTest<kKeep, Rules, kNormal> test(triangle.depth, triangle.rank(), visible.empty(), rules);
        const auto                             fillTiles = [&](const PixelBox& pixels) {
            forEachTile(pixels, [&](const PixelBox& here) {
                const int left = VisibilityBuffer::leftOfTile(here.x0), top = VisibilityBuffer::topOfTile(here.y0);
                const HalfPlanes edges =
                    triangle.wide ? HalfPlanes{wideHalfPlanesOf(triangle, left, top), left, top} : fromBox;
                fillStoredTile(here, triangle, edges, test, fragments, upkeep, visible, rules);
            });
        };
        if (takesParts<Fragments>() && upkeep.shortcuts.has(Shortcut::LargeTriangles))
            LargeTriangle<kKeep, kNormal, Fragments, Upkeep, Rules>(triangle, fragments, fromBox, upkeep, visible,
                                                                    rules)
                .draw(fillTiles);
        else
            fillTiles(box);
    }

    /// Calls each(PixelBox) with what the box has of every tile of the visibility buffer.
    template <class Each>
    static void forEachTile(const PixelBox& box, const Each& each)
    {
        constexpr int kWidth = VisibilityBuffer::kTileWidth, kLines = VisibilityBuffer::kTileLines;
        for (int top = VisibilityBuffer::topOfTile(box.y0); top < box.y1; top += kLines)
            for (int left = VisibilityBuffer::leftOfTile(box.x0); left < box.x1; left += kWidth)
                each(PixelBox{std::max(left, box.x0), std::max(top, box.y0), std::min(left + kWidth, box.x1),
                              std::min(top + kLines, box.y1)});
    }

    /// The part of the triangle's box in one tile of the visibility buffer, by tiles of the pyramid.
    template <Keep kKeep, bool kNormal, class Fragments, class Upkeep, class Rules>
    static void fillStoredTile(const PixelBox& stored, const ScreenTriangle& triangle, const HalfPlanes& edges,
                               const DepthTest<kKeep, Rules, kNormal>& test, const Fragments& fragments,
                               const Upkeep& upkeep, VisibilityBuffer& visible, const Rules& rules)
    {
        static_assert(kTile == VisibilityBuffer::kTileLines && kTile % hn::MaxLanes(F64()) == 0);
        if (edges.areOutside(stored)) return;
        if constexpr (keepsPlanes<kKeep, Fragments, Rules>())
            if (upkeep.takesPlanes
                && isKeptAsPlane(stored, edges.areInside(stored), triangle, fragments, upkeep, visible))
                return;
        const auto nearest = upkeep.isKept() ? nearestOfParts(triangle.depth, stored, rules) : Depths{};
        bool       isOpen  = false;
        for (std::uint32_t reached = partsReached(stored, edges); reached != 0; reached &= reached - 1) {
            const auto part = static_cast<unsigned>(std::countr_zero(reached));
            const int  left = VisibilityBuffer::leftOfTile(stored.x0) + static_cast<int>(part) * kTile;
            if (upkeep.isKept() && upkeep.hides(left, stored.y0, nearest[part])) continue;
            const PixelBox here{std::max(left, stored.x0), stored.y0, std::min(left + kTile, stored.x1), stored.y1};
            if (!isOpen) openTiles(visible, here);
            isOpen = true;
            // Who goes over all of a tile sees what it holds, and need not look again.
            const bool sees = upkeep.isKept() && here.y1 - here.y0 == kTile && left + kTile <= visible.width();
            const int  from = sees ? left : here.x0 & -laneCount(), end = sees ? left + kTile : here.x1;
            auto       least = hn::Set(I64(), kNearestKey);
            for (int x = from; x < end; x += laneCount())
                least = fartherOf(least, fillTile(triangle, edges, test, test.column(x), x, here.y0, here.y1, sees,
                                                  fragments, visible, rules));
            if (sees)
                upkeep.drawnTile(left, here.y0, farthestOf(least, visible));
            else
                upkeep.touched(here);
        }
    }

    /// True if such fragments are tested part by part, in passes.
    template <class Fragments>
    static constexpr bool takesParts()
    {
        return !Fragments::kPatterned;
    }

    /// True if planes say of such fragments all there is to say.
    template <Keep kKeep, class Fragments, class Rules>
    static constexpr bool keepsPlanes()
    {
        return kKeep == Keep::Nearest && Rules::kExactDepths && !Fragments::kPatterned;
    }

    /// The nearest depth that the triangle could store in `box`.
    template <class Rules>
    static float nearestIn(const DepthPlane& plane, const PixelBox& box, [[maybe_unused]] const Rules& rules)
    {
        if constexpr (!Rules::kExactDepths) return rules.stored(plane.nearest);
        return nearestOver(plane, box);
    }

    /// Lines [y, end) of the column of pixels x, x + 1, ... Returns keys with the farthest depth that each of its
    /// columns holds then, in lines that the triangle misses only if the caller `sees` all.
    template <Keep kKeep, bool kNormal, class Fragments, class Rules>
    static Keys fillTile(const ScreenTriangle& triangle, const HalfPlanes& edges,
                         const DepthTest<kKeep, Rules, kNormal>& test, Vec64 column, int x, int y, int end, bool sees,
                         const Fragments& fragments, VisibilityBuffer& visible, const Rules& rules)
    {
        const F64   d64;
        const auto& planes = edges.planes;
        const auto  lane   = countFrom(d64, x - edges.x0);
        const auto  start  = [&](const HalfPlane& plane) HWY_ATTR {
            return hn::Set(d64, plane.at(0, y - edges.y0)) + lane * hn::Set(d64, plane.perPixel);
        };
        auto       least = hn::Set(I64(), kNearestKey);
        auto       e0 = start(planes[0]), e1 = start(planes[1]), e2 = start(planes[2]);
        const auto down0 = hn::Set(d64, planes[0].perLine), down1 = hn::Set(d64, planes[1].perLine),
                   down2            = hn::Set(d64, planes[2].perLine);
        const std::ptrdiff_t stride = visible.stride();
        PixelKey*            row    = visible.row(y) + x;
        LineDepths           lines(triangle.depth, y, rules);
        for (; y < end; ++y, row += stride, lines.toNext()) {
            const auto inside = hn::Min(hn::Min(e0, e1), e2) >= hn::Zero(d64);
            if (!hn::AllFalse(d64, inside))
                least = fartherOf(least, test.offer(column, lines.here(), inside, row, x, y, fragments));
            else if (sees)
                least = fartherOf(least, hn::LoadU(I64(), row));
            e0 = e0 + down0;
            e1 = e1 + down1;
            e2 = e2 + down2;
        }
        return least;
    }
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_HALF_SPACE_INL_H
