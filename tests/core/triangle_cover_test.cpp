// A triangle asked of rectangles and pixels, against the definition's coverage in whole numbers, and what the pyramid
// answers about it, against every pixel it covers.
#include "core/depth/triangle_cover.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/depth/pyramid_told.h"
#include "core/scene/generators/random.h"

namespace zscope {
namespace {

constexpr PixelBox kRegion{0, 0, 75, 61};

/// Coverage as docs/correctness.md writes it.
bool isInside(const ScreenTriangle& t, int x, int y)
{
    const std::int64_t px = 256 * x + 128, py = 256 * y + 128;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t  b  = (a + 1) % 3;
        const auto         xa = static_cast<std::int64_t>(t.x[a]), ya = static_cast<std::int64_t>(t.y[a]);
        const std::int64_t dx = static_cast<std::int64_t>(t.x[b]) - xa, dy = static_cast<std::int64_t>(t.y[b]) - ya;
        const std::int64_t e = dx * (py - ya) - dy * (px - xa);
        if (e < 0 || (e == 0 && !(dy < 0 || (dy == 0 && dx > 0)))) return false;
    }
    return true;
}

/// A triangle with corners in and around the region; some on pixel centres, some slivers. Nothing if it has no pixel.
bool anyTriangle(Random& random, ScreenTriangle& triangle)
{
    std::array<ScreenCorner, 3> corners{};
    const bool                  onCentres = random.below(3) == 0, sliver = random.below(4) == 0;
    for (ScreenCorner& corner : corners) {
        corner.xs = random.between(-30, 105) * 256, corner.ys = random.between(-30, 90) * 256;
        if (sliver && &corner != &corners[0]) {
            corner.xs = corners[0].xs + random.between(-60, 60) * 256;
            corner.ys = corners[0].ys + (corner.xs - corners[0].xs) * 0.5 + random.between(-300, 300);
        }
        corner.xs = onCentres ? std::floor(corner.xs / 256) * 256 + 128 : std::rint(corner.xs);
        corner.ys = onCentres ? std::floor(corner.ys / 256) * 256 + 128 : std::rint(corner.ys);
        corner.x = corner.xs / 256, corner.y = corner.ys / 256;
        corner.d = random.between(0.2, 0.8);
    }
    return setUpTriangle(corners[0], corners[1], corners[2], TriangleId{0}, false, Facing{}, kRegion, ExactRules{},
                         triangle)
           == SetUp::Drawn;
}

PixelBox boxIn(Random& random, const PixelBox& within)
{
    const auto side = [&random](int low, int high) {
        const int a = low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low)));
        return std::array{a, a + 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(high - a)))};
    };
    const auto x = side(within.x0, within.x1), y = side(within.y0, within.y1);
    return {x[0], y[0], x[1], y[1]};
}

TEST(TriangleCover, CoversThePixelsOfTheDefinition)
{
    Random random(3);
    int    covered = 0, drawn = 0;
    for (int i = 0; i < 400; ++i) {
        ScreenTriangle triangle;
        if (!anyTriangle(random, triangle)) continue;
        ++drawn;
        const TriangleCover cover(triangle, ExactRules::notOwned());
        for (int y = triangle.box.y0; y < triangle.box.y1; ++y)
            for (int x = triangle.box.x0; x < triangle.box.x1; ++x) {
                ASSERT_EQ(cover.covers(x, y), isInside(triangle, x, y)) << i << ": " << x << ' ' << y;
                covered += cover.covers(x, y);
            }
    }
    EXPECT_GT(drawn, 200);
    EXPECT_GT(covered, 10000);
}

TEST(TriangleCover, MissesNoRectangleWithACoveredPixelAndLeavesOutThoseBesideAnEdge)
{
    Random random(4);
    int    without = 0, leftOut = 0;
    for (int i = 0; i < 400; ++i) {
        ScreenTriangle triangle;
        if (!anyTriangle(random, triangle)) continue;
        const TriangleCover cover(triangle, ExactRules::notOwned());
        for (int r = 0; r < 60; ++r) {
            const PixelBox box = boxIn(random, triangle.box);
            bool           any = false;
            for (int y = box.y0; y < box.y1; ++y)
                for (int x = box.x0; x < box.x1; ++x) any = any || isInside(triangle, x, y);
            if (any) {
                ASSERT_TRUE(cover.overlaps(box)) << i;
            }
            without += !any;
            leftOut += !cover.overlaps(box);
        }
    }
    EXPECT_GT(leftOut, without * 9 / 10) << "few rectangles are met between the centres only";
}

TEST(TriangleCover, OfAWideTriangleCountsAsItsBox)
{
    ScreenTriangle triangle{};
    triangle.wide = true;
    triangle.box  = kRegion;
    const TriangleCover cover(triangle, 1);
    EXPECT_TRUE(cover.overlaps({3, 4, 5, 6}));
    EXPECT_TRUE(cover.covers(70, 60));
}

TEST(TriangleQuery, HidesATriangleExactlyIfEveryPixelItCoversIsNearer)
{
    constexpr float kEmpty = 0.001f;
    Random          random(5);
    int             boxes = 0, triangles = 0, visibleInBox = 0;
    for (int i = 0; i < 150; ++i) {
        VisibilityBuffer visible;
        visible.resize(kRegion.x1, kRegion.y1, DepthEncoding::withBackground(kEmpty));
        visible.clearRows(0, kRegion.y1);
        Pyramid pyramid;
        pyramid.reset(visible, 0, kRegion.y1);
        // Most of the picture is filled; a few rectangles stay far.
        for (int y = 0; y < kRegion.y1; ++y) std::fill_n(visible.row(y), kRegion.x1, keyOf(0.5f, 0));
        for (int hole = 0; hole < 4; ++hole) {
            PixelBox box = boxIn(random, kRegion);
            box.x1       = std::min(box.x1, box.x0 + 9);
            box.y1       = std::min(box.y1, box.y0 + 9);
            for (int y = box.y0; y < box.y1; ++y) std::fill_n(visible.row(y) + box.x0, box.x1 - box.x0, keyOf(0.1f, 0));
        }
        pyramid.allTouched();
        for (int t = 0; t < 40; ++t) {
            ScreenTriangle triangle;
            if (!anyTriangle(random, triangle)) continue;
            const float nearest = random.below(2) == 0 ? 0.3f : 0.1f;
            bool        behind = true, boxBehind = true;
            for (int y = triangle.box.y0; y < triangle.box.y1; ++y)
                for (int x = triangle.box.x0; x < triangle.box.x1; ++x) {
                    const bool nearer = nearest < visible.storedAt(x, y);
                    boxBehind         = boxBehind && nearer;
                    behind            = behind && (nearer || !isInside(triangle, x, y));
                }
            const PyramidQuery byShape =
                pyramid.ask(triangle.box, nearest, TriangleCover(triangle, ExactRules::notOwned()), Untold{});
            const PyramidQuery byBox = pyramid.ask(triangle.box, nearest);
            ASSERT_EQ(byShape.hidden, behind) << i << ", " << t;
            ASSERT_EQ(byBox.hidden, boxBehind) << i << ", " << t;
            ASSERT_TRUE(byShape.hidden || !byBox.hidden);
            if (byBox.hidden) {
                ASSERT_LE(byShape.cells, byBox.cells) << "it asks no cell that the rectangle does not";
            }
            boxes += byBox.hidden;
            triangles += byShape.hidden;
            visibleInBox += !behind;
        }
    }
    EXPECT_GT(boxes, 100);
    EXPECT_GT(triangles, boxes + 100) << "background beside an edge hides nothing of the triangle";
    EXPECT_GT(visibleInBox, 100);
}

}  // namespace
}  // namespace zscope
