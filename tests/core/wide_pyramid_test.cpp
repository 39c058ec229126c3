// A wide pyramid against a look at every pixel, in every instruction set that the machine has: hidden exactly when each
// pixel asked about is strictly nearer.
#include "core/depth/pyramid.h"
#include "core/depth/triangle_cover.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/wide_pyramid_test.cpp"
#include <hwy/foreach_target.h>  // includes this file once per target

#include "core/fast/two_level_pyramid/wide_pyramid-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

bool boxIsHidden(Pyramid& pyramid, const PixelBox& box, float nearest)
{
    return WidePyramid(pyramid).hides(box, nearest, WholeBox{});
}
bool shapeIsHidden(Pyramid& pyramid, const PixelBox& box, float nearest, const TriangleCover& shape)
{
    return WidePyramid(pyramid).hides(box, nearest, shape);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <hwy/targets.h>

#include "core/scene/generators/random.h"

namespace zscope {

HWY_EXPORT(boxIsHidden);
HWY_EXPORT(shapeIsHidden);

namespace {

constexpr float kEmpty = 0.0009765f;
constexpr int   kTile  = 1 << Pyramid::kTileLevel;

/// Depths and the wide pyramid over the lines [firstRow, endRow) of them.
struct Screen {
    Screen(int width, int height, int first, int end) : firstRow(first), endRow(end)
    {
        visible.resize(width, height, DepthEncoding::withBackground(kEmpty));
        visible.clearRows(0, height);
        pyramid.reset(visible, firstRow, endRow, Fault::None, PyramidKind::Wide);
    }

    PixelBox region() const { return {0, firstRow, visible.width(), endRow}; }

    /// Small ones mostly.
    PixelBox anyBox(Random& random) const
    {
        const auto side = [&random](int low, int high) {
            const int a    = low + static_cast<int>(random.below(static_cast<std::uint64_t>(high - low)));
            const int most = random.below(3) == 0 ? high - a : std::min(high - a, 40);
            return std::array{a, a + 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(most)))};
        };
        const auto [x0, x1] = side(0, visible.width());
        const auto [y0, y1] = side(firstRow, endRow);
        return {x0, y0, x1, y1};
    }

    /// Depths only grow. Of tiles that are drawn over as a whole it is told what they hold, if `seen`; of the others
    /// that they may have changed.
    void draw(const PixelBox& box, float depth, bool seen)
    {
        visible.open(box);
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x) visible.row(y)[x] = std::max(visible.row(y)[x], keyOf(depth, 0));
        for (int top = firstRow + (box.y0 - firstRow) / kTile * kTile; top < box.y1; top += kTile)
            for (int left = box.x0 / kTile * kTile; left < box.x1; left += kTile) {
                const PixelBox tile{left, top, std::min(left + kTile, visible.width()), std::min(top + kTile, endRow)};
                const PixelBox drawn{std::max(tile.x0, box.x0), std::max(tile.y0, box.y0), std::min(tile.x1, box.x1),
                                     std::min(tile.y1, box.y1)};
                if (seen && drawn == tile)
                    pyramid.drawnTile(left, top, farthest(tile));
                else
                    pyramid.touched(drawn);
            }
    }

    template <class Covers>
    float farthest(const PixelBox& box, const Covers& covers) const
    {
        float least = std::numeric_limits<float>::infinity();
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; ++x)
                if (covers(x, y)) least = std::min(least, visible.comparedAt(x, y));
        return least;
    }
    float farthest(const PixelBox& box) const
    {
        return farthest(box, [](int, int) { return true; });
    }

    /// No stored cell is nearer than its pixels.
    void expectNoCellTooNear()
    {
        const auto expectOf = [this](GridView<const float> cells, int level) {
            for (int y = 0; y < cells.height; ++y)
                for (int x = 0; x < cells.width; ++x) {
                    const int top = firstRow + (y << level);
                    ASSERT_LE(cells.at(x, y), farthest({x << level, top, std::min((x + 1) << level, visible.width()),
                                                        std::min(top + (1 << level), endRow)}))
                        << level << ": " << x << ' ' << y;
                }
        };
        expectOf(pyramid.tiles(), Pyramid::kTileLevel);
        expectOf(pyramid.blocks(), Pyramid::kBlockLevel);
    }

    int              firstRow, endRow;
    VisibilityBuffer visible;
    Pyramid          pyramid;
};

ScreenTriangle triangleIn(const PixelBox& region, Random& random)
{
    for (;;) {
        std::array<ScreenCorner, 3> corners{};
        for (ScreenCorner& corner : corners) {
            corner.xs = std::rint(random.between(region.x0, region.x1) * 256),
            corner.ys = std::rint(random.between(region.y0, region.y1) * 256);
            corner.x = corner.xs / 256, corner.y = corner.ys / 256;
            corner.d = random.between(0.2, 0.8);
        }
        ScreenTriangle triangle;
        if (setUpTriangle(corners[0], corners[1], corners[2], TriangleId{0}, false, Facing{}, region, ExactRules{},
                          triangle)
            == SetUp::Drawn)
            return triangle;
    }
}

struct Answers {
    std::size_t yes = 0, no = 0, yesOfShapes = 0, noOfShapes = 0;
};

/// Asks at the depth of the farthest pixel, a hair before and behind it, and somewhere.
void expectExact(Screen& screen, Random& random, Answers& answers)
{
    const PixelBox       box      = screen.anyBox(random);
    const ScreenTriangle triangle = triangleIn(screen.region(), random);
    const TriangleCover  shape(triangle, ExactRules{}.notOwned());
    const float          ofBox = screen.farthest(box),
                ofShape        = screen.farthest(triangle.box, [&](int x, int y) { return shape.covers(x, y); });
    const auto depths          = [&random](float farthest) {
        return std::array{std::nextafter(farthest, 0.0f), farthest, std::nextafter(farthest, 2.0f),
                          static_cast<float>(random.unit())};
    };
    for (const float nearest : depths(ofBox)) {
        const bool hidden = HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, box, nearest);
        ASSERT_EQ(hidden, nearest < ofBox)
            << box.x0 << ' ' << box.y0 << ' ' << box.x1 << ' ' << box.y1 << " at " << nearest << ", farthest " << ofBox;
        ++(hidden ? answers.yes : answers.no);
    }
    if (ofShape == std::numeric_limits<float>::infinity()) return;  // it covers no pixel
    for (const float nearest : depths(ofShape)) {
        const bool hidden = HWY_DYNAMIC_DISPATCH(shapeIsHidden)(screen.pyramid, triangle.box, nearest, shape);
        ASSERT_EQ(hidden, nearest < ofShape) << "a shape at " << nearest << ", farthest " << ofShape;
        ++(hidden ? answers.yesOfShapes : answers.noOfShapes);
    }
}

/// Calls each() with one instruction set after the other.
template <class Each>
void forEachTarget(const Each& each)
{
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
        const std::int64_t target = left & -left;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(target);
        SCOPED_TRACE(hwy::TargetName(target));
        each();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(WidePyramid, AnswersExactlyAfterAnySequenceOfWritesInEverySizeStripeAndInstructionSet)
{
    forEachTarget([] {
        Answers answers;
        for (const auto& [width, height] : {std::pair{9, 8}, {67, 3}, {130, 70}, {257, 193}, {1023, 300}})
            for (const int first : {0, 8}) {
                if (first >= height) continue;
                SCOPED_TRACE(testing::Message() << width << " x " << height << " from line " << first);
                Random    random(static_cast<std::uint64_t>(width + height + first));
                Screen    screen(width, height, first, height);
                const int steps = 80;
                for (int i = 0; i < steps; ++i) {
                    const auto depth = static_cast<float>(static_cast<double>(i + 1) / steps * random.between(0.5, 1));
                    const PixelBox drawn = random.below(6) == 0 ? screen.region() : screen.anyBox(random);
                    screen.draw(drawn, depth, random.below(2) == 0);
                    for (int q = 0; q < 3; ++q) expectExact(screen, random, answers);
                    if (testing::Test::HasFatalFailure()) FAIL();
                }
                screen.expectNoCellTooNear();
                if (testing::Test::HasFatalFailure()) FAIL();
            }
        EXPECT_GT(answers.yes, 1000u);
        EXPECT_GT(answers.no, 1000u);
        EXPECT_GT(answers.yesOfShapes, 1000u);
        EXPECT_GT(answers.noOfShapes, 1000u);
    });
}

TEST(WidePyramid, OneTileThatHoldsNothingIsFoundInEveryPlaceOfEveryBlock)
{
    constexpr int kWide = 27, kHigh = 20;  // tiles: blocks at the right and below are cut
    forEachTarget([] {
        Screen screen(kTile * kWide, kTile * kHigh, 0, kTile * kHigh);
        for (int hole = 0; hole < kWide * kHigh; ++hole) {
            screen.visible.emptyRows(0, kTile * kHigh);
            screen.visible.finishRows(0, kTile * kHigh);
            screen.pyramid.reset(screen.visible, 0, kTile * kHigh, Fault::None, PyramidKind::Wide);
            const int x = hole % kWide * kTile, y = hole / kWide * kTile;
            for (const PixelBox& around : {PixelBox{0, 0, kTile * kWide, y}, PixelBox{0, y, x, y + kTile},
                                           PixelBox{x + kTile, y, kTile * kWide, y + kTile},
                                           PixelBox{0, y + kTile, kTile * kWide, kTile * kHigh}})
                if (!around.isEmpty()) screen.draw(around, 0.5f, true);
            ASSERT_FALSE(HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, screen.region(), 0.25f)) << x << ' ' << y;
            screen.draw({x, y, x + kTile, y + kTile}, 0.5f, true);
            ASSERT_TRUE(HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, screen.region(), 0.25f)) << x << ' ' << y;
        }
    });
}

TEST(WidePyramid, AHoleOfOnePixelIsFoundWhereverItIs)
{
    Screen screen(200, 150, 0, 150);
    for (const auto& [x, y] :
         {std::pair{0, 0}, {199, 149}, {63, 64}, {64, 63}, {128, 17}, {199, 0}, {0, 149}, {100, 72}}) {
        screen.visible.emptyRows(0, 150);
        screen.visible.finishRows(0, 150);
        screen.pyramid.reset(screen.visible, 0, 150, Fault::None, PyramidKind::Wide);
        if (y > 0) screen.draw({0, 0, 200, y}, 0.5f, true);
        if (y < 149) screen.draw({0, y + 1, 200, 150}, 0.5f, true);
        if (x > 0) screen.draw({0, y, x, y + 1}, 0.5f, true);
        if (x < 199) screen.draw({x + 1, y, 200, y + 1}, 0.5f, true);
        EXPECT_FALSE(HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, screen.region(), 0.25f)) << x << ' ' << y;
        EXPECT_FALSE(HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, {x, y, x + 1, y + 1}, 0.25f)) << x << ' ' << y;
        screen.draw({x, y, x + 1, y + 1}, 0.5f, false);
        EXPECT_TRUE(HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, screen.region(), 0.25f)) << x << ' ' << y;
    }
}

TEST(WidePyramid, ABlockRemembersWhatItsTilesHeldWhenSomebodyLooked)
{
    Screen screen(256, 128, 0, 128);
    screen.draw(screen.region(), 0.5f, true);
    EXPECT_EQ(screen.pyramid.blocks().at(3, 1), kEmpty);
    EXPECT_TRUE(HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, {64, 0, 256, 128}, 0.4f));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x)
            EXPECT_EQ(screen.pyramid.blocks().at(x, y), x == 0 ? kEmpty : 0.5f) << x << ' ' << y;
    screen.draw(screen.region(), 0.7f, true);
    EXPECT_TRUE(HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, screen.region(), 0.4f));
    EXPECT_EQ(screen.pyramid.blocks().at(3, 1), 0.5f) << "that was enough to know";
    EXPECT_TRUE(HWY_DYNAMIC_DISPATCH(boxIsHidden)(screen.pyramid, screen.region(), 0.6f));
    EXPECT_EQ(screen.pyramid.blocks().at(3, 1), 0.7f);
}

}  // namespace
}  // namespace zscope

#endif  // HWY_ONCE
