// Hidden squares against a look at every pixel, in every instruction set that the machine has.
#include <cstdint>
#include <vector>

#include "core/depth/visibility_buffer.h"
#include "core/fast/hidden_squares/hidden_squares.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/hidden_squares_test.cpp"
#include <hwy/foreach_target.h>  // includes this file once per target

#include "core/fast/hidden_squares/hidden_squares-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

HiddenPart findHidden(const VisibilityBuffer& visible, const PixelBox& reach, float nearest, HiddenSquares& out)
{
    return HiddenSquaresFinder::find(visible, reach, nearest, out);
}

/// Per box whether it is hidden: 1 by one square, 2 by four, else 0.
std::vector<std::int32_t> hiddenAmong(const HiddenSquares& squares, const std::vector<PixelBox>& boxes)
{
    const hn::ScalableTag<std::int32_t> d;
    const std::size_t                   padded = boxes.size() + hn::Lanes(d);
    std::vector<std::int32_t>           left(padded), above(padded), right(padded), below(padded), hidden(padded);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        left[i] = boxes[i].x0, above[i] = boxes[i].y0, right[i] = boxes[i].x1, below[i] = boxes[i].y1;
    for (std::size_t i = 0; i < boxes.size(); i += hn::Lanes(d)) {
        const auto load = [&](const std::vector<std::int32_t>& column)
                              HWY_ATTR { return hn::LoadU(d, column.data() + i); };
        const auto isThere = hn::Iota(d, 0) < hn::Set(d, static_cast<std::int32_t>(boxes.size() - i));
        const auto width = load(right) - load(left), height = load(below) - load(above);
        const auto byOne  = HiddenBoxes(squares)(isThere, load(left), load(above), width, height);
        const auto byFour = HiddenBoxes(squares).ofLarge(isThere, load(left), load(above), width, height);
        hn::StoreU(hn::IfThenElseZero(byOne, hn::Set(d, 1)) + hn::IfThenElseZero(byFour, hn::Set(d, 2)), d,
                   hidden.data() + i);
    }
    hidden.resize(boxes.size());
    return hidden;
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include <hwy/targets.h>

#include "core/scene/generators/random.h"

namespace zscope {

HWY_EXPORT(findHidden);
HWY_EXPORT(hiddenAmong);

namespace {

constexpr float kNearest = 0.5f;

/// A picture of tiles that nothing was drawn to, that are kept as planes, and of pixels; `share` of a hundred pixels in
/// groups are nearer than kNearest, the others as near or farther.
void fill(VisibilityBuffer& visible, int share, Random& random)
{
    const int width = visible.width(), height = visible.height();
    visible.emptyRows(0, height);
    for (int y = 0; y < height; y += VisibilityBuffer::kTileLines)
        for (int x = 0; x < width; x += VisibilityBuffer::kTileWidth) {
            const PixelBox tile{x, y, std::min(x + VisibilityBuffer::kTileWidth, width),
                                std::min(y + VisibilityBuffer::kTileLines, height)};
            const auto     kind = random.below(8);
            if (kind == 0) continue;
            if (kind == 1) {
                // Before kNearest everywhere, just there, or on one side of the tile's middle, where groups of pixels
                // meet.
                const double a = random.below(2) ? 0.001 * random.between(-1, 1) : 0, c = random.below(2) ? 0.7 : 0.5;
                visible.setPlane(x, y, {{a, 0, c - a * (x + 32), 0.1f, 0.9f}, 5});
                continue;
            }
            visible.open(tile);
        }
    for (int blob = 0; blob < share * width * height / 3000 + 1; ++blob) {
        const int left = static_cast<int>(random.below(static_cast<std::uint64_t>(width))),
                  top  = static_cast<int>(random.below(static_cast<std::uint64_t>(height)));
        const int side = 1 + static_cast<int>(random.below(24));
        for (int y = top; y < std::min(top + side, height); ++y)
            for (int x = left; x < std::min(left + side, width); ++x)
                if (visible.isOpen(x, y) && !visible.planeAt(x, y))
                    visible.row(y)[x] = keyOf(random.below(400) ? 0.75f : kNearest, 3);
    }
}

bool isHidden(const VisibilityBuffer& visible, int x, int y)
{
    return visible.isReadable(x, y) && depthOf(visible.keyAt(x, y)) > kNearest;
}

bool allHidden(const VisibilityBuffer& visible, const PixelBox& box)
{
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
            if (!isHidden(visible, x, y)) return false;
    return true;
}
bool noneHidden(const VisibilityBuffer& visible, const PixelBox& box)
{
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
            if (isHidden(visible, x, y)) return false;
    return true;
}

/// A box of up to `most` by `most` pixels inside `frame`.
PixelBox boxIn(const PixelBox& frame, int most, Random& random)
{
    const auto pick = [&](int first, int end) {
        return first + static_cast<int>(random.below(static_cast<std::uint64_t>(end - first)));
    };
    const int x0 = pick(frame.x0, frame.x1), y0 = pick(frame.y0, frame.y1);
    return {x0, y0, pick(x0, std::min(x0 + most, frame.x1)) + 1, pick(y0, std::min(y0 + most, frame.y1)) + 1};
}

/// What the smallest squares that are looked up for the box hold, as far as it lies in the reach.
PixelBox squareOf(const PixelBox& box, const PixelBox& reach)
{
    constexpr int kLargest = HiddenSquares::kSides.back();
    const int     longest  = std::max(box.x1 - box.x0, box.y1 - box.y0);
    if (longest > kLargest)
        return {box.x0, box.y0, std::min(std::max(box.x1, box.x0 + kLargest), reach.x1),
                std::min(std::max(box.y1, box.y0 + kLargest), reach.y1)};
    const int side = *std::ranges::lower_bound(HiddenSquares::kSides, longest);
    return {box.x0, box.y0, std::min(box.x0 + side, reach.x1), std::min(box.y0 + side, reach.y1)};
}

struct Asked {
    std::size_t yes = 0, yesByFour = 0, no = 0, nothing = 0, everything = 0;
};

void expectTrue(const VisibilityBuffer& visible, Random& random, Asked& asked)
{
    const PixelBox picture{0, 0, visible.width(), visible.height()};
    const auto     squares = std::make_unique<HiddenSquares>();
    for (int i = 0; i < 60; ++i) {
        const PixelBox   reach = boxIn(picture, i % 3 == 0 ? 200 : 40, random);
        const HiddenPart part  = HWY_DYNAMIC_DISPATCH(findHidden)(visible, reach, kNearest, *squares);
        ASSERT_EQ(part == HiddenPart::Everything, allHidden(visible, reach));
        ASSERT_EQ(part == HiddenPart::Nothing, noneHidden(visible, reach));
        asked.nothing += part == HiddenPart::Nothing, asked.everything += part == HiddenPart::Everything;
        if (part != HiddenPart::Squares) continue;
        std::vector<PixelBox> boxes(37);
        for (PixelBox& box : boxes) box = boxIn(reach, 36, random);
        const std::vector<std::int32_t> answers = HWY_DYNAMIC_DISPATCH(hiddenAmong)(*squares, boxes);
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            const PixelBox& box  = boxes[b];
            const int       side = std::max(box.x1 - box.x0, box.y1 - box.y0);
            const int wanted = side > 2 * HiddenSquares::kSides.back() || !allHidden(visible, squareOf(box, reach)) ? 0
                               : side > HiddenSquares::kSides.back()                                                ? 2
                                                                                                                    : 1;
            ++(wanted == 2 ? asked.yesByFour : wanted == 1 ? asked.yes : asked.no);
            ASSERT_EQ(answers[b], wanted) << box.x0 << ' ' << box.y0 << ' ' << box.x1 << ' ' << box.y1 << " in "
                                          << reach.x0 << ' ' << reach.y0 << ' ' << reach.x1 << ' ' << reach.y1;
        }
    }
}

TEST(HiddenSquares, AreThoseOfWhichEveryPixelIsHiddenInEveryInstructionSet)
{
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
        const std::int64_t target = left & -left;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(target);
        Random random(5);
        Asked  asked;
        for (const auto& [width, height] : {std::pair{1, 1}, {64, 8}, {97, 41}, {400, 230}})
            for (const int share : {5, 40, 100}) {
                VisibilityBuffer visible;
                visible.resize(width, height, DepthEncoding::withBackground(-1.0f));
                fill(visible, share, random);
                expectTrue(visible, random, asked);
                if (testing::Test::HasFatalFailure())
                    FAIL() << hwy::TargetName(target) << ", " << width << " x " << height << ", " << share;
            }
        EXPECT_GT(asked.yes, 1000u) << hwy::TargetName(target);
        EXPECT_GT(asked.yesByFour, 300u);
        EXPECT_GT(asked.no, 1000u);
        EXPECT_GT(asked.nothing, 10u);
        EXPECT_GT(asked.everything, 10u);
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(HiddenSquares, OnePixelThatIsNotHiddenIsSeenWhereverInALargeBoxItLies)
{
    VisibilityBuffer visible;
    visible.resize(64, 64, DepthEncoding::withBackground(-1.0f));
    visible.emptyRows(0, 64);
    visible.open({0, 0, 64, 64});
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) visible.row(y)[x] = keyOf(0.75f, 3);
    const auto                  squares = std::make_unique<HiddenSquares>();
    const std::vector<PixelBox> boxes{{8, 8, 40, 40}, {8, 8, 26, 40}, {8, 8, 40, 26}, {8, 8, 25, 25}, {8, 8, 10, 40}};
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) {
            visible.row(y)[x] = keyOf(kNearest, 3);
            ASSERT_EQ(HWY_DYNAMIC_DISPATCH(findHidden)(visible, {0, 0, 64, 64}, kNearest, *squares),
                      HiddenPart::Squares);
            const auto answers = HWY_DYNAMIC_DISPATCH(hiddenAmong)(*squares, boxes);
            for (std::size_t b = 0; b < boxes.size(); ++b)
                ASSERT_EQ(answers[b], allHidden(visible, squareOf(boxes[b], {0, 0, 64, 64})) ? 2 : 0)
                    << x << ' ' << y << " in box " << b;
            visible.row(y)[x] = keyOf(0.75f, 3);
        }
}

TEST(HiddenSquares, NobodyLooksAtAReachThatIsTooLarge)
{
    VisibilityBuffer visible;
    visible.resize(400, 300, DepthEncoding::withBackground(-1.0f));
    visible.emptyRows(0, 300);
    visible.open({0, 0, 400, 300});
    for (int y = 0; y < 300; ++y) std::fill_n(visible.row(y), 400, keyOf(0.75f, 3));
    const auto squares = std::make_unique<HiddenSquares>();
    const auto find    = [&](const PixelBox& reach) {
        return HWY_DYNAMIC_DISPATCH(findHidden)(visible, reach, kNearest, *squares);
    };
    EXPECT_EQ(find({0, 0, 256, HiddenSquares::kMostLines}), HiddenPart::Everything);
    EXPECT_EQ(find({0, 0, 257, HiddenSquares::kMostLines}), HiddenPart::Nothing);
    EXPECT_EQ(find({0, 0, 256, HiddenSquares::kMostLines + 1}), HiddenPart::Nothing);
}

}  // namespace
}  // namespace zscope

#endif  // HWY_ONCE
