// Scan conversion by half-spaces: a pixel is inside a triangle if it lies on the inner side of all three edges.
//
// Edges      values are integers below 2^53 (core/geometry/half_plane.h), so float64 lanes hold them exactly
// Tiles      the triangle's box is cut into columns one vector wide and tiles of kTileLines lines; a tile
//            wholly on the outer side of one edge is skipped
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

#include "core/geometry/half_plane.h"
#include "core/scan/depth_test-inl.h"
#include "core/scan/edge_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

struct HalfSpace {
    static constexpr int kTileLines = 8;

    template <Keep kKeep, class Rules, class Probe>
    static void fill(const ScreenTriangle& triangle, VisibilityBuffer& visible, const Rules& rules, const Probe& probe)
    {
        if (triangle.wide) {
            EdgeWalk::fill<kKeep>(triangle, visible, rules, probe);
            return;
        }
        const PixelBox&                box    = triangle.box;
        const std::array<HalfPlane, 3> planes = halfPlanesOf(triangle, rules.notOwned());
        const DepthTest<kKeep, Rules> test(triangle.depth, triangle.rank(), visible.empty(), rules);
        const bool oneTile = box.x1 - box.x0 <= laneCount() && box.y1 - box.y0 <= kTileLines;

        for (int x = box.x0; x < box.x1; x += laneCount()) {
            const Vec64 column = test.column(x, box.x0);
            for (int y = box.y0; y < box.y1; y += kTileLines) {
                const int end = std::min(y + kTileLines, box.y1);
                const int right = x - box.x0, down = y - box.y0;
                if (!oneTile && areOutside(planes, right, down, right + laneCount() - 1, down + kTileLines - 1)) continue;
                fillTile(triangle, planes, test, column, x, y, end, visible, rules, probe);
            }
        }
    }

private:
    /// Lines [y, end) of the column of pixels x, x + 1, ...
    template <Keep kKeep, class Rules, class Probe>
    static void fillTile(const ScreenTriangle& triangle, const std::array<HalfPlane, 3>& planes,
                         const DepthTest<kKeep, Rules>& test, Vec64 column, int x, int y, int end, VisibilityBuffer& visible,
                         const Rules& rules, const Probe& probe)
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
                test.offer(column, lineDepth(triangle.depth, y, rules), inside, visible.depthRow(y) + x, visible.rankRow(y) + x, x,
                           y, probe);
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
