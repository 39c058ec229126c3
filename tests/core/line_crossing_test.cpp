// Crossings in fixed point against one division per line, in whole numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/line_crossing_test.cpp"
#include <hwy/foreach_target.h>  // includes this file once per target

#include "core/fast/lanes/enter_edges-inl.h"
#include "core/scan/edge_stepper.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// Of the edge from (xa, ya) to (xb, yb), in 1/256 pixel, with the centres of a line.
LineCrossing crossingOf(double xa, double ya, double xb, double yb, int line, bool opens)
{
    const hn::CappedTag<double, 1> d;
    using V       = hn::Vec<hn::CappedTag<double, 1>>;
    const auto at = crossingsOf(d, Falling<V>{hn::Set(d, xa), hn::Set(d, ya), hn::Set(d, xb), hn::Set(d, yb)},
                                hn::Set(d, line), hn::Set(d, opens) > hn::Set(d, 0));
    return {hn::GetLane(at.x), hn::GetLane(at.step)};
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zscope {
namespace {

HWY_EXPORT(crossingOf);

__extension__ typedef __int128 Wide;

constexpr std::int64_t kGuard = 1 << 24;

struct CrossedEdge {
    std::int64_t xa, ya, xb, yb;  // 1/256 pixel, ya < yb
};

Wide floorOfQuotient(Wide value, Wide by) { return value / by - (value % by < 0 ? 1 : 0); }

LineCrossing crossingOf(const CrossedEdge& e, int line, bool opens = false)
{
    const auto real = [](std::int64_t value) { return static_cast<double>(value); };
    return HWY_DYNAMIC_DISPATCH(crossingOf)(real(e.xa), real(e.ya), real(e.xb), real(e.yb), line, opens);
}

/// Walks the edge over all lines of [0, height) that it crosses and compares every position; how many there were.
int expectExactCrossings(const CrossedEdge& e, int height)
{
    const int first = std::max(0, firstLineFrom(static_cast<double>(e.ya)));
    const int end   = std::min(height, firstLineFrom(static_cast<double>(e.yb)));
    if (first >= end) return 0;
    const Wide   dx = Wide{e.xb} - e.xa, dy = Wide{e.yb} - e.ya;
    LineCrossing closing = crossingOf(e, first), opening = crossingOf(e, first, true);
    for (int y = first; y < end; ++y, closing = closing.onNextLine(), opening = opening.onNextLine()) {
        const Wide run = dx * (Wide{256} * y + 128 - e.ya);
        const Wide x = e.xa + floorOfQuotient(run, dy), rest = run - floorOfQuotient(run, dy) * dy;
        const Wide pixel = -floorOfQuotient(-((x - 128) * dy + rest), 256 * dy);  // 256 i + 128 >= x + rest / dy
        for (const LineCrossing& crossing : {closing, opening}) {
            EXPECT_EQ(crossing.x(), static_cast<std::int64_t>(x));
            EXPECT_EQ(crossing.firstPixel(), static_cast<std::int64_t>(pixel));
        }
        EXPECT_TRUE(closing.isLeftOf(opening));
        if (::testing::Test::HasFailure()) {
            ADD_FAILURE() << "edge (" << e.xa << ", " << e.ya << ") to (" << e.xb << ", " << e.yb << "), line " << y;
            return end - first;
        }
    }
    return end - first;
}

std::int64_t within(std::mt19937_64& random, std::int64_t limit)
{
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * limit + 1)) - limit;
}

TEST(LineCrossing, EqualsExactDivisionOnEveryLine)
{
    std::mt19937_64 random(1);
    int             lines = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::int64_t height =
            1 + static_cast<std::int64_t>(random() % (random() % 2 ? 3000 : LineCrossing::kTallest - 1));
        const std::int64_t reach = random() % 2 ? 4000 : kGuard;
        CrossedEdge        e{within(random, reach), within(random, 400000), within(random, reach), 0};
        if (random() % 16 == 0) e.xa = random() % 2 ? kGuard : -kGuard, e.xb = -e.xa;
        e.yb = e.ya + height;
        lines += expectExactCrossings(e, 4096);
        if (HasFailure()) return;
    }
    EXPECT_GT(lines, 1000000);
}

/// Edges whose crossings come as close to a whole subpixel, from either side, as their height allows.
TEST(LineCrossing, ACrossingOneOverTheHeightFromAPixelCentreIsOnItsSide)
{
    for (const std::int64_t dy : {LineCrossing::kTallest - 1, LineCrossing::kTallest - 3, std::int64_t{262143},
                                  std::int64_t{65537}, std::int64_t{257}})
        for (const std::int64_t dx :
             {std::int64_t{1}, std::int64_t{-1}, dy - 1, 1 - dy, dy + 1, -dy - 1, kGuard - 1, 1 - kGuard})
            for (std::int64_t ya = 0; ya < 256; ya += 5) expectExactCrossings({64, ya, 64 + dx, ya + dy}, 4096);
}

TEST(LineCrossing, OrderIsThatOfCrossingsThatAreNotAllButEqual)
{
    std::mt19937_64 random(6);
    int             sameSubpixel = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto edge = [&random] {
            return CrossedEdge{static_cast<std::int64_t>(random() % 40), -static_cast<std::int64_t>(random() % 500) - 1,
                               static_cast<std::int64_t>(random() % 40),
                               129 + static_cast<std::int64_t>(random() % 300)};
        };
        const CrossedEdge a = edge(), b = edge();
        const auto numerator = [](const CrossedEdge& e) { return e.xa * (e.yb - e.ya) + (e.xb - e.xa) * (128 - e.ya); };
        const std::int64_t left = numerator(a) * (b.yb - b.ya), right = numerator(b) * (a.yb - a.ya);
        if (left == right) continue;  // both are hundredths of a millionth of a subpixel apart, or more
        EXPECT_EQ(crossingOf(a, 0).isLeftOf(crossingOf(b, 0)), left < right);
        EXPECT_EQ(crossingOf(a, 0, true).isLeftOf(crossingOf(b, 0)), left < right);
        sameSubpixel += crossingOf(a, 0).x() == crossingOf(b, 0).x();
    }
    EXPECT_GT(sameSubpixel, 100);  // fractions had to decide
}

TEST(LineCrossing, AStandingOneIsAtItsPlaceOrRightOfIt)
{
    const LineCrossing whole = LineCrossing::standing(128, 0, false), opening = LineCrossing::standing(128, 0, true);
    EXPECT_EQ(whole.firstPixel(), 0);  // the centre of pixel 0 is not left of it
    EXPECT_EQ(opening.firstPixel(), 0);
    EXPECT_TRUE(whole.isLeftOf(opening));
    for (const double fraction : {0x1p-60, 0x1p-20, 0.5, 1 - 0x1p-53}) {
        const LineCrossing right = LineCrossing::standing(128, fraction, true);
        EXPECT_EQ(right.firstPixel(), 1);
        EXPECT_EQ(right.x(), 128);
        EXPECT_TRUE(opening.isLeftOf(right));
        EXPECT_TRUE(right.isLeftOf(LineCrossing::standing(129, 0, false)));
    }
}

}  // namespace
}  // namespace zscope

#endif  // HWY_ONCE
