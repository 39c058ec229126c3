// The half-planes of a wide triangle, found anew for each tile, say of every pixel of it what 128 bits say.
#include "core/geometry/half_plane.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/scene/generators/random.h"

namespace zscope {
namespace {

__extension__ using Wide = __int128;

/// The edge from corner a to b at the centre of a pixel, lowered by one unless it owns its points.
Wide edgeAt(const ScreenTriangle& t, std::size_t a, std::size_t b, int x, int y)
{
    const auto whole = [](double value) { return static_cast<Wide>(value); };
    const Wide dx = whole(t.x[b]) - whole(t.x[a]), dy = whole(t.y[b]) - whole(t.y[a]);
    const Wide value = dx * (Wide{y} * 256 + 128 - whole(t.y[a])) - dy * (Wide{x} * 256 + 128 - whole(t.x[a]));
    return value - (dy < 0 || (dy == 0 && dx > 0) ? 0 : 1);
}

TEST(HalfPlane, OfAWideTriangleIsTrueOfEveryPixelOfTheTileItWasFoundFor)
{
    Random random(5);
    int    inside = 0, outside = 0;
    for (int i = 0; i < 4'000; ++i) {
        ScreenTriangle triangle{};
        const int      x = static_cast<int>(random.below(16384 / 64)) * 64,
                  y      = static_cast<int>(random.below(16384 / 8)) * 8;
        for (std::size_t k = 0; k < 3; ++k) {
            // Some corners in the tile's neighbourhood, some at the limit, so that edges pass through tiles at any
            // size.
            const double reach = random.below(4) == 0 ? 1e4 : std::pow(2.0, random.between(24, 36));
            triangle.x[k] =
                std::nearbyint(random.below(6) == 0 ? kWidestByTiles : x * 256.0 + random.between(-reach, reach));
            triangle.y[k] =
                std::nearbyint(random.below(6) == 0 ? -kWidestByTiles : y * 256.0 + random.between(-reach, reach));
        }
        if (!fitsTiles(triangle)) continue;
        const auto planes = wideHalfPlanesOf(triangle, x, y);
        for (std::size_t k = 0; k < 3; ++k)
            for (int down = 0; down < 8; ++down)
                for (int right = 0; right < 64; ++right) {
                    const bool isInside = edgeAt(triangle, k, (k + 1) % 3, x + right, y + down) >= 0;
                    ASSERT_EQ(planes[k].at(right, down) >= 0, isInside) << i << ": " << right << ' ' << down;
                    ++(isInside ? inside : outside);
                }
    }
    EXPECT_GT(std::min(inside, outside), 100'000);
}

TEST(HalfPlane, KnowsWhatIsTooWide)
{
    ScreenTriangle triangle{};
    triangle.x[1] = -kWidestByTiles;
    EXPECT_TRUE(fitsTiles(triangle));
    triangle.y[2] = kWidestByTiles * 2;
    EXPECT_FALSE(fitsTiles(triangle));
}

}  // namespace
}  // namespace zscope
