// Triangles about the size up to which edges are kept as short integers, slivers of that length, and tiny ones whose
// edges pass through pixel centres: all of them give the reference's picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/triangle_list.h"
#include "core/scene/generators/random.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// Where the second and third corner lie, seen from the first.
enum class Shape {
    AtLimit,  // as far as a compact triangle's may, or a subpixel more or less, along one axis or both
    Slivers,  // that far along one axis, some subpixels along the other
    Windows,  // up to 40 pixels away
    Tiny,     // less than two pixels away, mostly on a pixel centre or a subpixel beside it
};

class CompactTriangles : public testing::TestWithParam<Shape> {
protected:
    using Subpixels = std::array<int, 2>;

    static int between(Random& random, int least, int most)
    {
        return least + static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1)));
    }

    static Subpixels wayTo(Shape shape, Random& random)
    {
        const auto sign  = [&random] { return random.below(2) == 0 ? 1 : -1; };
        const auto most  = kCompactSide;
        const auto limit = [&] { return sign() * ((random.below(4) == 0 ? 64 * 256 : most) + between(random, -2, 1)); };
        const bool swaps = random.below(2) == 0;
        Subpixels  way{};
        switch (shape) {
            case Shape::AtLimit:
                way = {limit(), random.below(2) == 0 ? limit() : between(random, -most, most)};
                break;
            case Shape::Slivers:
                way = {limit(), between(random, -300, 300)};
                break;
            case Shape::Windows:
                way = {between(random, -40 * 256, 40 * 256), between(random, -40 * 256, 40 * 256)};
                break;
            case Shape::Tiny:
                way = {256 * between(random, -1, 1) + between(random, -1, 1), between(random, -511, 511)};
                break;
        }
        if (swaps) std::swap(way[0], way[1]);
        return way;
    }

    static std::shared_ptr<const PreparedScene> triangles(Shape shape, Random& random, const Camera& camera, int count)
    {
        std::vector<Corners> all;
        const bool           isLevel = random.below(2) == 0;  // depths that tie
        while (static_cast<int>(all.size()) < count) {
            const bool isCentred = random.below(2) == 0;
            const auto start     = [&](int pixels) {
                return isCentred ? 256 * between(random, 0, pixels - 1) + 128 : between(random, 0, 256 * pixels);
            };
            const int       x = start(camera.width);
            const Subpixels first{x, start(camera.height)};
            Corners         corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const Subpixels way = k == 0 ? Subpixels{} : wayTo(shape, random);
                corners[k]          = pointAt(camera, (first[0] + way[0]) / 256.0, (first[1] + way[1]) / 256.0,
                                     isLevel ? 2 : random.between(1.5, 5));
            }
            all.push_back(corners);
        }
        return std::make_shared<const PreparedScene>(sceneOf(all));
    }
};

TEST_P(CompactTriangles, EveryPresetDrawsWhatTheReferenceDraws)
{
    Random        random(11 + static_cast<std::uint64_t>(GetParam()));
    std::uint64_t covered = 0;
    for (const auto& [width, height] : {std::pair{192, 128}, {131, 64}, {61, 256}}) {
        const Camera camera = plainCamera(width, height);
        for (std::uint64_t i = 0; i < shareOf(8); ++i) {
            const int  many  = GetParam() == Shape::Tiny ? 2'000 : 150;
            const auto scene = triangles(GetParam(), random, camera, i % 2 == 0 ? many : 5);
            const auto what =
                "scene " + std::to_string(i) + " in " + std::to_string(width) + " x " + std::to_string(height);
            covered += expectAgreement(scene, camera, FaceCulling::None, what, {.threads = {1, 2}});
        }
    }
    EXPECT_GT(covered, shareOf(8) * (GetParam() == Shape::Slivers || GetParam() == Shape::Tiny ? 1'500 : 10'000));
}

/// Edges are counted from the picture's first pixel.
TEST_P(CompactTriangles, AreTheSameAtTheFarEndOfTheLargestPictures)
{
    Random        random(31 + static_cast<std::uint64_t>(GetParam()));
    std::uint64_t covered = 0;
    for (const auto& [width, height] : {std::pair{kMaxPictureSide, 8}, {8, kMaxPictureSide}}) {
        const Camera camera = plainCamera(width, height);
        const auto   scene  = triangles(GetParam(), random, camera, 1'000);
        covered += expectAgreement(scene, camera, FaceCulling::None,
                                   std::to_string(width) + " x " + std::to_string(height), {.threads = {1, 2}});
    }
    EXPECT_GT(covered, GetParam() == Shape::Tiny ? 500 : 2'000);
}

/// Batches about as wide as the halves of a lane hold, and about at the edges of the picture and of stripes: which of
/// the sieves works them off must not be seen.
TEST(TrianglesThatLieTogether, EveryPresetDrawsWhatTheReferenceDraws)
{
    constexpr int kMost = 0x8000 - 256 - 128;
    Random        random(53);
    const auto    between = [&random](int least, int most) {
        return least + static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1)));
    };
    std::uint64_t covered = 0;
    for (const auto& [width, height] : {std::pair{160, 256}, {131, 140}, {400, 64}}) {
        const Camera camera = plainCamera(width, height);
        for (std::uint64_t i = 0; i < shareOf(24); ++i) {
            std::array<int, 2> first{}, side{};
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const int pixels = axis == 0 ? width : height;
                side[axis]       = random.below(2) == 0 ? kMost + between(-2, 300) : between(3 * 256, kMost);
                const int last   = 256 * pixels - side[axis];  // there it ends where the picture does
                switch (random.below(4)) {
                    case 0:
                        first[axis] = between(-3 * 256, 2 * 256);
                        break;
                    case 1:
                        first[axis] = last + between(-5 * 256, 256);
                        break;
                    // two stripes may meet there
                    case 2:
                        first[axis] =
                            256 * (pixels / 2) - (random.below(2) == 0 ? 0 : side[axis]) + between(-5 * 256, 256);
                        break;
                    default:
                        first[axis] = between(0, std::max(1, last));
                        break;
                }
            }
            std::vector<Corners> all(40);
            for (std::size_t t = 0; t < all.size(); ++t)
                for (std::size_t k = 0; k < 3; ++k) {
                    const bool isEnd = k == 0 && t < 2;  // the least of all, and the most
                    const auto at    = [&](std::size_t axis) {
                        return (first[axis] + (isEnd ? static_cast<int>(t) * side[axis] : between(0, side[axis])))
                               / 256.0;
                    };
                    const double x = at(0), y = at(1);
                    all[t][k] = pointAt(camera, x, y, i % 3 == 0 ? 2 : random.between(1.5, 5));
                }
            const auto what = std::to_string(i) + " in " + std::to_string(width) + " x " + std::to_string(height);
            covered += expectAgreement(std::make_shared<const PreparedScene>(sceneOf(all)), camera,
                                       i % 2 == 0 ? FaceCulling::None : FaceCulling::Back, what, {.threads = {1, 2}});
        }
    }
    EXPECT_GT(covered, shareOf(24) * 10'000);
}

INSTANTIATE_TEST_SUITE_P(Shapes, CompactTriangles,
                         testing::Values(Shape::AtLimit, Shape::Slivers, Shape::Windows, Shape::Tiny));

}  // namespace
}  // namespace zscope::tests
