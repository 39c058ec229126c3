// Scan conversion by half-spaces: a pixel is inside a triangle if it lies on the inner side of all three edges.
//
// Edges      values are integers below 2^53 (core/geometry/half_plane.h), so float64 lanes hold them exactly
// Compact    triangles, without a long side, are tested by windows, in float32 (windows-inl.h), unless their fragments are shaded
// Tiles      the box of the others is cut along the tiles of the visibility buffer, each of which is opened when something is drawn to
//            it, and those along the pyramid's. A tile wholly on the outer side of one edge is skipped, one on the inner side
//            of all edges needs no edge values, and if it is drawn over as a whole the pyramid learns its depth from the plane
// Z-cull     by tiles of the pyramid's lowest stored level instead: what the triangle's nearest depth in a tile cannot win
//            is not tested pixel by pixel. A tile's farthest depth is read, and found again when it is stale: no pixel
//            writes to it
// Wide       triangles beyond the guard band are handed to EdgeWalk, whose 128-bit edges find the same pixels
// Source     Pineda: A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; docs/correctness.md, Coverage
#if defined(ZSCOPE_HALF_SPACE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_HALF_SPACE_INL_H
#undef ZSCOPE_HALF_SPACE_INL_H
#else
#define ZSCOPE_HALF_SPACE_INL_H
#endif

#include <algorithm>
#include <array>

#include "core/depth/pyramid_told.h"
#include "core/geometry/half_plane.h"
#include "core/scan/depth_test-inl.h"
#include "core/scan/edge_walk-inl.h"
#include "core/scan/windows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

struct HalfSpace {
    /// `upkeep` is told what becomes of the pyramid's tiles: coveredTile(box) or touched(box), whose parameter lies in one tile, or
    /// in any number of them for triangles that are wide or compact. Opens what is drawn to.
    template <Keep kKeep, class Fragments, class Upkeep, class Rules, class Probe>
    static void fill(const ScreenTriangle& triangle, const Fragments& fragments, const Upkeep& upkeep, VisibilityBuffer& visible,
                     const Rules& rules, const Probe& probe)
    {
        const PixelBox& box = triangle.box;
        if (triangle.wide) {
            visible.open(box);
            EdgeWalk::fill<kKeep>(triangle, fragments, visible, rules, probe);
            upkeep.touched(box);
            return;
        }
        const std::array<HalfPlane, 3> planes = halfPlanesOf(triangle, rules.notOwned());
        const DepthTest<kKeep, Rules>  test(triangle.depth, triangle.rank(), visible.empty(), rules);
        if constexpr (kLanes == 1) {  // in the order of windows, so that a step shows the same pixel whether fragments are shaded or not
            if (isCompact(triangle)) {
                visible.open(box);
                forEachPixelByWindows(box, [&](int x, int y) {
                    fillTile(triangle, planes, test, test.column(x, box.x0), x, y, y + 1, fragments, visible, rules, probe);
                });
                upkeep.touched(box);
                return;
            }
        }
        constexpr int kWidth = VisibilityBuffer::kTileWidth, kLines = VisibilityBuffer::kTileLines;
        for (int top = box.y0 / kLines * kLines; top < box.y1; top += kLines) {
            for (int left = box.x0 / kWidth * kWidth; left < box.x1; left += kWidth) {
                const PixelBox here{std::max(left, box.x0), std::max(top, box.y0), std::min(left + kWidth, box.x1), std::min(top + kLines, box.y1)};
                if (areOutsideIn(here, triangle, planes)) continue;
                visible.open(here);
                fillStoredTile(here, areInsideIn(here, triangle, planes), triangle, planes, test, fragments, upkeep, visible, rules, probe);
            }
        }
    }

    /// The same, tile by tile of `tiles`, which is told what may have changed; `told` hears what it brings up to date.
    template <Keep kKeep, class Fragments, class Told, class Rules, class Probe>
    static void fillByTiles(const ScreenTriangle& triangle, Pyramid& tiles, const Told& told, const Fragments& fragments,
                            VisibilityBuffer& visible, const Rules& rules, const Probe& probe)
    {
        visible.open(triangle.box);
        if (triangle.wide) {
            EdgeWalk::fill<kKeep>(triangle, fragments, visible, rules, probe);
            tiles.touched(triangle.box);
            return;
        }
        constexpr int kTile = 1 << Pyramid::kTileLevel;
        static_assert(kTile % hn::MaxLanes(F64()) == 0, "columns must not reach over the border of a tile");
        const PixelBox&                box    = triangle.box;
        const std::array<HalfPlane, 3> planes = halfPlanesOf(triangle, rules.notOwned());
        const DepthTest<kKeep, Rules>  test(triangle.depth, triangle.rank(), visible.empty(), rules);

        for (int top = tiles.tileAt(box.x0, box.y0).y0; top < box.y1; top += kTile) {
            for (int left = tiles.tileAt(box.x0, box.y0).x0; left < box.x1; left += kTile) {
                const int right = left - box.x0, down = top - box.y0;
                if (areOutside(planes, right, down, right + kTile - 1, down + kTile - 1)) continue;
                const PixelBox here{std::max(left, box.x0), std::max(top, box.y0), std::min(left + kTile, box.x1),
                                    std::min(top + kTile, box.y1)};
                const float      nearest = nearestIn(triangle.depth, here, rules);
                const TileAnswer answer  = tiles.askTile(left, top, nearest, told);
                probe(TileTested{here, triangle.id, nearest, answer.farthest, answer.hidden});
                if (answer.hidden) continue;
                for (int x = left; x < here.x1; x += laneCount())
                    fillTile(triangle, planes, test, test.column(x, box.x0), x, here.y0, here.y1, fragments, visible, rules, probe);
                tiles.touched(here);
            }
        }
    }

private:
    static bool areOutsideIn(const PixelBox& here, const ScreenTriangle& t, const std::array<HalfPlane, 3>& planes)
    {
        return areOutside(planes, here.x0 - t.box.x0, here.y0 - t.box.y0, here.x1 - 1 - t.box.x0, here.y1 - 1 - t.box.y0);
    }
    static bool areInsideIn(const PixelBox& here, const ScreenTriangle& t, const std::array<HalfPlane, 3>& planes)
    {
        return areInside(planes, here.x0 - t.box.x0, here.y0 - t.box.y0, here.x1 - 1 - t.box.x0, here.y1 - 1 - t.box.y0);
    }

    /// The part of the triangle's box in one tile of the visibility buffer, by tiles of the pyramid.
    template <Keep kKeep, class Fragments, class Upkeep, class Rules, class Probe>
    static void fillStoredTile(const PixelBox& stored, bool isInside, const ScreenTriangle& triangle, const std::array<HalfPlane, 3>& planes,
                               const DepthTest<kKeep, Rules>& test, const Fragments& fragments, const Upkeep& upkeep,
                               VisibilityBuffer& visible, const Rules& rules, const Probe& probe)
    {
        constexpr int kTile = 1 << Pyramid::kTileLevel;
        static_assert(kTile == VisibilityBuffer::kTileLines && kTile % hn::MaxLanes(F64()) == 0);
        for (int left = stored.x0 & -kTile; left < stored.x1; left += kTile) {
            const PixelBox here{std::max(left, stored.x0), stored.y0, std::min(left + kTile, stored.x1), stored.y1};
            if (!isInside && areOutsideIn(here, triangle, planes)) continue;
            const int  from = here.x0 & -laneCount();
            const bool isWhole = isInside || areInsideIn(here, triangle, planes);
            for (int x = from; x < here.x1; x += laneCount()) {
                const auto column = test.column(x, triangle.box.x0);
                // Edges may say no of pixels beside the box; where it ends inside a vector, they are asked.
                if (isWhole && x >= here.x0 && x + laneCount() <= here.x1)
                    fillWholeTile(triangle, test, column, x, here.y0, here.y1, fragments, visible, rules, probe);
                else
                    fillTile(triangle, planes, test, column, x, here.y0, here.y1, fragments, visible, rules, probe);
            }
            const bool fillsTile = (here.x1 - here.x0 == kTile || here.x1 == visible.width()) && here.x0 == left && here.y1 - here.y0 == kTile;
            if (isWhole && fillsTile)
                upkeep.coveredTile(here);
            else
                upkeep.touched(here);
        }
    }

    template <class Each>
    static void forEachPixelByWindows(const PixelBox& box, const Each& each)
    {
        for (int top = box.y0; top < box.y1; top += kWindowSide)
            for (int left = box.x0; left < box.x1; left += kWindowSide)
                for (int y = top; y < std::min(top + kWindowSide, box.y1); ++y)
                    for (int x = left; x < std::min(left + kWindowSide, box.x1); ++x) each(x, y);
    }

    /// The nearest depth that the triangle could store in `box`. Its expression is monotone in x and in y, roundings
    /// included, so a corner of the box has it.
    template <class Rules>
    static float nearestIn(const DepthPlane& plane, const PixelBox& box, const Rules& rules)
    {
        if constexpr (!Rules::kExact) return rules.stored(plane.nearest);
        const int    x = plane.a > 0 ? box.x1 - 1 : box.x0, y = plane.b > 0 ? box.y1 - 1 : box.y0;
        const double z = plane.a * (x + 0.5) + lineDepth(plane, y, rules);
        return rules.stored(std::min(std::max(z, double{plane.farthest}), double{plane.nearest}));
    }

    /// Lines [y, end) of the column of pixels x, x + 1, ..., all of them covered.
    template <Keep kKeep, class Fragments, class Rules, class Probe>
    static void fillWholeTile(const ScreenTriangle& triangle, const DepthTest<kKeep, Rules>& test, Vec64 column, int x, int y, int end,
                              const Fragments& fragments, VisibilityBuffer& visible, const Rules& rules, const Probe& probe)
    {
        const auto all = hn::FirstN(F64(), hn::Lanes(F64()));
        for (; y < end; ++y)
            test.offer(column, lineDepth(triangle.depth, y, rules), all, visible.row(y) + x, x, y, fragments, probe);
    }

    /// Lines [y, end) of the column of pixels x, x + 1, ...
    template <Keep kKeep, class Fragments, class Rules, class Probe>
    static void fillTile(const ScreenTriangle& triangle, const std::array<HalfPlane, 3>& planes,
                         const DepthTest<kKeep, Rules>& test, Vec64 column, int x, int y, int end, const Fragments& fragments,
                         VisibilityBuffer& visible, const Rules& rules, const Probe& probe)
    {
        const F64  d64;
        const auto lane  = hn::Iota(d64, x - triangle.box.x0);
        const auto start = [&](const HalfPlane& plane) HWY_ATTR {
            return hn::Set(d64, plane.at(0, y - triangle.box.y0)) + lane * hn::Set(d64, plane.perPixel);
        };
        auto       e0 = start(planes[0]), e1 = start(planes[1]), e2 = start(planes[2]);
        const auto down0 = hn::Set(d64, planes[0].perLine), down1 = hn::Set(d64, planes[1].perLine),
                   down2 = hn::Set(d64, planes[2].perLine);
        for (; y < end; ++y) {
            const auto inside = hn::Min(hn::Min(e0, e1), e2) >= hn::Zero(d64);
            if (!hn::AllFalse(d64, inside)) {
                test.offer(column, lineDepth(triangle.depth, y, rules), inside, visible.row(y) + x, x, y, fragments, probe);
            }
            e0 = e0 + down0;
            e1 = e1 + down1;
            e2 = e2 + down2;
        }
    }
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_HALF_SPACE_INL_H
