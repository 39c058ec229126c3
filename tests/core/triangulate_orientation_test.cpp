#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include <gmpxx.h>

#include "core/scene/orientation.h"

namespace zscope {
namespace {

int rationalOrientation(const Point2& a, const Point2& b, const Point2& c)
{
    const mpq_class ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
    return sgn((ax - cx) * (by - cy) - (ay - cy) * (bx - cx));
}

TEST(Orientation, ToldRightWhateverTheBitsOfTheCoordinatesAre)
{
    std::mt19937_64 random(11);
    const auto      anyFinite = [&] {
        while (true) {
            const double value = std::bit_cast<double>(random());
            if (std::isfinite(value)) return value;
        }
    };
    for (int i = 0; i < 20'000; ++i) {
        const Point2 a{anyFinite(), anyFinite()}, b{anyFinite(), anyFinite()}, c{anyFinite(), anyFinite()};
        ASSERT_EQ(orientation(a, b, c), rationalOrientation(a, b, c)) << "seed 11, case " << i;
    }
}

TEST(Orientation, ToldRightForPointsAFewLastPlacesFromALine)
{
    std::mt19937_64                        random(12);
    std::uniform_real_distribution<double> any(-1, 1);
    std::uniform_int_distribution<int>     places(-3, 2), power(-1040, 1000);
    int                                    zeros = 0;
    for (int i = 0; i < 100'000; ++i) {
        // Every other case on a coarse grid, where the point can lie on the line.
        const auto   coordinate = [&] { return i % 2 == 0 ? any(random) : std::round(any(random) * 1000) / 256; };
        const Point2 a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
        const double t = i % 2 == 0 ? any(random) * 2 : std::round(any(random) * 8) / 4;
        Point2       c{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
        for (int step = places(random); step > 0; --step) c.x = std::nextafter(c.x, 9.0);
        for (int step = places(random); step > 0; --step) c.y = std::nextafter(c.y, -9.0);
        const int  scale    = power(random);
        const auto scaled   = [&](const Point2& p) { return Point2{std::ldexp(p.x, scale), std::ldexp(p.y, scale)}; };
        const int  expected = rationalOrientation(scaled(a), scaled(b), scaled(c));
        zeros += expected == 0;
        ASSERT_EQ(orientation(scaled(a), scaled(b), scaled(c)), expected) << "seed 12, case " << i;
    }
    EXPECT_GT(zeros, 0) << "the cases should hold points exactly on the line";
}

TEST(Orientation, ZeroOnTheLineNotBesideIt)
{
    EXPECT_EQ(orientation({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}), 0);
    EXPECT_EQ(orientation({0, 0}, {3, 1}, {1, 1.0 / 3}), rationalOrientation({0, 0}, {3, 1}, {1, 1.0 / 3}));
    EXPECT_NE(orientation({0, 0}, {3, 1}, {1, 1.0 / 3}), 0) << "1/3 is rounded, so the point is not on the line";
    EXPECT_EQ(orientation({1e308, -1e308}, {-1e308, 1e308}, {0, 0}), 0);
    EXPECT_EQ(orientation({0, 0}, {5e-324, 0}, {0, 5e-324}), 1);
    EXPECT_EQ(orientation({1e308, 0}, {5e-324, 0}, {0, 5e-324}),
              rationalOrientation({1e308, 0}, {5e-324, 0}, {0, 5e-324}));
}

}  // namespace
}  // namespace zscope
