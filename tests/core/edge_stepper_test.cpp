// Edge steppers against one division per line, in whole numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/scan/edge_stepper.h"

namespace zscope {
namespace {

__extension__ typedef __int128 Wide;

struct Edge {
    std::int64_t xa, ya, xb, yb;  // 1/256 pixel, ya < yb
};

Wide floorOf(Wide value, Wide by) { return value / by - (value % by < 0 ? 1 : 0); }

/// Walks the edge over all lines of [0, height) that it crosses and compares every position.
template <class Integer>
void expectExact(const Edge& e, int height)
{
    const int first = std::max(0, firstLineFrom(static_cast<double>(e.ya)));
    const int end   = std::min(height, firstLineFrom(static_cast<double>(e.yb)));
    if (first >= end) return;
    EdgeStepper<Integer> stepper(static_cast<double>(e.xa), static_cast<double>(e.ya), static_cast<double>(e.xb),
                                 static_cast<double>(e.yb), first, end - 1);
    const Wide           dx = Wide{e.xb} - e.xa, dy = Wide{e.yb} - e.ya;
    for (int y = first; y < end; ++y, stepper.nextLine()) {
        const Wide run = dx * (Wide{256} * y + 128 - e.ya);
        const Wide x = e.xa + floorOf(run, dy), rest = run - floorOf(run, dy) * dy;
        ASSERT_TRUE(x == Wide{stepper.x()} && rest == Wide{stepper.fraction()} && dy == Wide{stepper.dy()})
            << "edge (" << e.xa << ", " << e.ya << ") to (" << e.xb << ", " << e.yb << "), line " << y << ": x is "
            << stepper.x() << " + " << stepper.fraction() << " / " << stepper.dy() << ", and should be "
            << static_cast<std::int64_t>(x);
        // First pixel: 256 i + 128 >= x + rest / dy, so i = ceil((x + rest / dy - 128) / 256).
        const Wide pixel = -floorOf(-((x - 128) * dy + rest), 256 * dy);
        ASSERT_EQ(stepper.firstPixel(), static_cast<std::int64_t>(std::clamp<Wide>(pixel, -(1 << 30), 1 << 30)))
            << "edge (" << e.xa << ", " << e.ya << ") to (" << e.xb << ", " << e.yb << "), line " << y;
    }
}

/// Magnitudes of every order up to `limit`, so that short and long edges both occur.
std::int64_t anyCoordinate(std::mt19937_64& random, int bits)
{
    const int  order = 1 + static_cast<int>(random() % static_cast<unsigned>(bits));
    const auto value = static_cast<std::int64_t>(random() >> (64 - order));
    return random() % 2 ? value : -value;
}

template <class Integer>
void expectRandomEdgesExact(int bits, std::int64_t limit, int edges, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    for (int i = 0; i < edges; ++i) {
        Edge                e{anyCoordinate(random, bits), anyCoordinate(random, bits), anyCoordinate(random, bits),
               anyCoordinate(random, bits)};
        const std::uint64_t corner = random() % 8;  // some corners at the very limit
        if (corner & 1) e.xa = random() % 2 ? limit : -limit;
        if (corner & 2) e.xb = random() % 2 ? limit : -limit;
        if (corner == 4) e.ya = -limit, e.yb = limit;
        if (e.yb < e.ya) std::swap(e.ya, e.yb), std::swap(e.xa, e.xb);
        if (e.ya == e.yb) continue;
        expectExact<Integer>(e, 16384);
        if (::testing::Test::HasFatalFailure()) return;
    }
}

TEST(EdgeStepper, In32BitsEqualsExactDivisionInsideTheGuardBand)
{
    expectRandomEdgesExact<std::int32_t>(24, 1 << 24, 4000, 1);
}

TEST(EdgeStepper, In64BitsEqualsExactDivisionUpToTheSnapLimit)
{
    // The largest float64 below 2^61 is the farthest corner there is; coordinates are float64 integers.
    const auto limit = static_cast<std::int64_t>(std::nextafter(0x1p61, 0.0));
    expectRandomEdgesExact<std::int64_t>(53, limit, 2000, 2);
    expectRandomEdgesExact<std::int64_t>(24, 1 << 24, 1000, 3);
}

TEST(EdgeStepper, ExtremesAreExact)
{
    constexpr std::int64_t g = 1 << 24;
    for (const Edge& e : {Edge{-g, -g, g, g}, Edge{g, -g, -g, g}, Edge{-g, 0, g, 256 * 3}, Edge{g, 0, -g, 256 * 3},
                          Edge{-g, 127, g, 129}, Edge{g, 128, -g, 129}, Edge{-g, 128, g, 128 + 257},
                          Edge{g, 127, -g, 127 + 258}, Edge{0, -g, 1, g}, Edge{g, -g, g, g}, Edge{-g, g - 1, g, g}}) {
        expectExact<std::int32_t>(e, 16384);
        expectExact<std::int64_t>(e, 16384);
    }
    const auto l = static_cast<std::int64_t>(std::nextafter(0x1p61, 0.0));
    for (const Edge& e : {Edge{-l, -l, l, l}, Edge{l, -l, -l, l}, Edge{-l, 0, l, 600}, Edge{l, 0, -l, 600},
                          Edge{0, -l, 0, l}, Edge{l, -l, l, l}})
        expectExact<std::int64_t>(e, 16384);
}

TEST(EdgeStepper, AnEdgeCrossesTheLinesOfTheHalfOpenRule)
{
    std::mt19937_64 random(5);
    for (int i = 0; i < 2000; ++i) {
        const std::int64_t y    = anyCoordinate(random, 22);
        const int          line = firstLineFrom(static_cast<double>(y));
        EXPECT_GE(centreOfLine(line), y);
        EXPECT_LT(centreOfLine(line - 1), y);
    }
}

}  // namespace
}  // namespace zscope
