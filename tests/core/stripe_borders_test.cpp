// Stripes cover every line once whatever was measured, and move towards equal times.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/frame/stripes.h"

namespace zscope {
namespace {

void expectCover(const StripeBorders& borders, int height)
{
    int next = 0;
    for (int i = 0; i < borders.count(); ++i) {
        const auto [first, end] = borders.stripe(i);
        ASSERT_EQ(first, next) << "stripe " << i;
        ASSERT_LE(first, end) << "stripe " << i;
        ASSERT_EQ(first % kStripeGrid, 0) << "stripe " << i << ", of a picture " << height << " high";
        next = end;
    }
    ASSERT_EQ(next, height);
}

TEST(StripeBorders, CoverEveryLineOnceInOrderWhateverTheTimes)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 300; ++i) {
        const int     height = 1 + static_cast<int>(random() % 2000), stripes = 1 + static_cast<int>(random() % 16);
        StripeBorders borders;
        borders.prepare(height, stripes);
        expectCover(borders, height);
        for (int frame = 0; frame < 30; ++frame) {
            std::vector<double> ms;
            for (int s = 0; s < stripes; ++s)
                ms.push_back(random() % 4 == 0 ? 0.0 : std::pow(10.0, static_cast<double>(random() % 18) - 12));
            if (random() % 8 == 0) ms.back() = 0;  // all of it is wanted by the others
            borders.rebalance(ms);
            expectCover(borders, height);
            if (HasFatalFailure()) return;
        }
    }
}

TEST(StripeBorders, BeginEvenAndBeginAnewWhenTheShapeChanges)
{
    StripeBorders borders;
    borders.prepare(128, 4);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(borders.stripe(i).end - borders.stripe(i).first, 32);
    borders.rebalance(std::vector<double>{9, 1, 1, 1});
    EXPECT_LT(borders.stripe(0).end, 32);
    const int kept = borders.stripe(0).end;
    borders.prepare(128, 4);
    EXPECT_EQ(borders.stripe(0).end, kept) << "the same shape keeps what was learned";
    borders.prepare(128, 2);
    EXPECT_EQ(borders.stripe(0).end, 64);
    borders.prepare(80, 2);
    EXPECT_EQ(borders.stripe(0).end, 40);
}

/// A load per line that is 50 times as heavy in the lower third; a fixed cost for every stripe besides.
TEST(StripeBorders, SettleWhereAllStripesTakeTheSameTime)
{
    constexpr int kHeight = 900;
    const auto    costOf  = [](int line) { return line < 600 ? 0.001 : 0.05; };
    for (const int stripes : {2, 3, 8}) {
        StripeBorders borders;
        borders.prepare(kHeight, stripes);
        const auto times = [&] {
            std::vector<double> ms;
            for (int i = 0; i < stripes; ++i) {
                const auto [first, end] = borders.stripe(i);
                double one              = 0.01;
                for (int y = first; y < end; ++y) one += costOf(y);
                ms.push_back(one);
            }
            return ms;
        };
        const std::vector<double> before = times();
        for (int frame = 0; frame < 40; ++frame) borders.rebalance(times());
        const std::vector<double> after = times();
        const auto                worst = [](const std::vector<double>& ms) {
            return *std::ranges::max_element(ms)
                   / (std::accumulate(ms.begin(), ms.end(), 0.0) / static_cast<double>(ms.size()));
        };
        EXPECT_GT(worst(before), 1.5) << stripes;
        EXPECT_LT(worst(after), 1.1) << stripes;
    }
}

/// A thread that is held up once every few frames: nothing of it is seen in the borders of the frames between.
TEST(StripeBorders, StayWhereTheyAreWhenOneFrameIsHeldUp)
{
    StripeBorders borders;
    borders.prepare(768, 2);
    const auto times = [&](double heldUp) {
        const auto [first, end] = borders.stripe(0);
        return std::vector<double>{(end - first) * heldUp, 3.0 * (768 - end)};  // equal at line 576
    };
    for (int frame = 0; frame < 40; ++frame) borders.rebalance(times(1));
    const int settled = borders.stripe(0).end;
    EXPECT_NEAR(settled, 576, kStripeGrid);
    for (int frame = 0; frame < 40; ++frame) {
        borders.rebalance(times(frame % 4 == 0 ? 2 : 1));
        EXPECT_EQ(borders.stripe(0).end, settled) << frame;
    }
    for (int frame = 0; frame < 40; ++frame) borders.rebalance(times(2));  // always: then it is the lines
    EXPECT_NEAR(borders.stripe(0).end, 460.8, kStripeGrid);
}

TEST(StripeBorders, FewerLinesThanStripesLeaveSomeEmpty)
{
    for (int height = 1; height <= 40; ++height)
        for (int stripes = 1; stripes <= 9; ++stripes) {
            StripeBorders borders;
            borders.prepare(height, stripes);
            expectCover(borders, height);
            borders.rebalance(std::vector<double>(static_cast<std::size_t>(stripes), 1.0));
            expectCover(borders, height);
            if (HasFatalFailure()) return;
        }
}

}  // namespace
}  // namespace zscope
