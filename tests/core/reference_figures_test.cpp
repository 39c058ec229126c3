// The error figures on pictures small enough to count by hand.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "core/measure/error_figures.h"

namespace zscope::tests {
namespace {

struct Sample {
    std::int64_t id;
    float        depth;
};

Picture row(const std::vector<Sample>& samples)
{
    const int width = static_cast<int>(samples.size());
    Picture   picture{.ids = Grid<std::int64_t>(width, 1, -1), .depth = Grid<float>(width, 1, 0)};
    for (int x = 0; x < width; ++x) {
        picture.ids.at(x, 0)   = samples[static_cast<std::size_t>(x)].id;
        picture.depth.at(x, 0) = samples[static_cast<std::size_t>(x)].depth;
    }
    return picture;
}

float stepsAbove(float depth, std::uint32_t steps)
{
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(depth) + steps);
}

constexpr Sample kNothing{-1, 0};

TEST(ErrorFigures, OfEqualPicturesAreZero)
{
    const Picture picture = row({{3, 0.5f}, kNothing, {4, 0.25f}});
    const auto    figures = compare(picture, picture);
    EXPECT_TRUE(figures.isExact());
    EXPECT_EQ(figures.pixels, 3u);
    EXPECT_EQ(figures.covered, 2u);
    EXPECT_EQ(figures.exactShare, 1);
    EXPECT_EQ(figures.lostTriangles, 0u);
    EXPECT_EQ(figures.distanceOnSameSurface.max, 0);
}

TEST(ErrorFigures, OfEmptyPicturesAreDefined)
{
    for (const Picture& picture : {row({}), row({kNothing, kNothing})}) {
        const auto figures = compare(picture, picture);
        EXPECT_TRUE(figures.isExact());
        EXPECT_EQ(figures.covered, 0u);
        EXPECT_EQ(figures.exactShare, 1);
        EXPECT_EQ(figures.distanceOnSameSurface.rms, 0);
        EXPECT_EQ(figures.distanceOnWrongSurface.p99, 0);
    }
}

TEST(ErrorFigures, TellHolesSpillsAndWrongSurfacesApart)
{
    const Picture reference = row({{0, 0.5f}, kNothing, {1, 0.5f}, {2, 0.5f}, {3, 0.5f}, {4, 0.5f}});
    const Picture test =
        row({kNothing, {9, 0.1f}, {8, stepsAbove(0.5f, 2)}, {8, stepsAbove(0.5f, 3)}, {3, 0.5f}, {8, 0.25f}});
    const auto figures = compare(reference, test);
    EXPECT_EQ(figures.covered, 5u);
    EXPECT_EQ(figures.holes, 1u);
    EXPECT_EQ(figures.spills, 1u);
    EXPECT_EQ(figures.wrongCoverage(), 2u);
    EXPECT_EQ(figures.nearTies, 1u);
    EXPECT_EQ(figures.realWrongSurface, 2u);
    EXPECT_EQ(figures.wrongPixels(), 5u);
    EXPECT_EQ(figures.depthBitsDiffer, 5u);
    EXPECT_EQ(figures.distanceOnWrongSurface.max, 1) << "0.5 shown at 0.25";
    EXPECT_FALSE(figures.isExact());
}

TEST(ErrorFigures, MeasureDepthOnTheRightSurfaceOnly)
{
    std::vector<Sample> right(200, {1, 0.5f}), shown(200, {1, 0.5f});
    shown[7].depth     = stepsAbove(0.5f, 5);
    shown[8].depth     = stepsAbove(0.5f, 40);
    shown[9].depth     = stepsAbove(0.5f, 90);
    shown[10]          = {2, 0.125f};  // another surface: its distance is not this figure's
    const auto figures = compare(row(right), row(shown));
    EXPECT_EQ(figures.maxDepthSteps, 90u);
    EXPECT_EQ(figures.p99DepthSteps, 40u) << "of 199 values the 198th in order";
    EXPECT_DOUBLE_EQ(figures.exactShare, 196.0 / 199.0);
    const double relative = std::abs(0.5 / stepsAbove(0.5f, 90) - 1);
    EXPECT_DOUBLE_EQ(figures.distanceOnSameSurface.max, relative);
    EXPECT_DOUBLE_EQ(figures.distanceOnWrongSurface.rms, 3);
}

TEST(ErrorFigures, CountDepthBitsWithoutASurfaceDifference)
{
    const auto figures = compare(row({{1, 0.5f}}), row({{1, stepsAbove(0.5f, 1)}}));
    EXPECT_EQ(figures.wrongPixels(), 0u);
    EXPECT_EQ(figures.depthBitsDiffer, 1u);
    EXPECT_FALSE(figures.isExact());
}

TEST(ErrorFigures, ATriangleIsLostIfItIsNowhereAndFalselyCulledIfOnlyFartherOnesStandInItsPlace)
{
    //                             seen elsewhere  background   farther      tie, higher id  nearer
    const Picture reference = row({{0, 0.5f}, {0, 0.5f}, {1, 0.5f}, {2, 0.5f}, {3, 0.5f}, {5, 0.5f}});
    const Picture test      = row({{0, 0.5f}, {7, 0.1f}, kNothing, {7, 0.1f}, {7, 0.5f}, {7, 0.9f}});
    const auto    figures   = compare(reference, test);
    EXPECT_EQ(figures.lostTriangles, 4u) << "1, 2, 3 and 5; 0 is seen in one place";
    EXPECT_EQ(figures.falseCulls, 3u) << "5 was hidden by something nearer, not culled";
}

TEST(ErrorFigures, OfSamplesLookForLostTrianglesInTheWholePicture)
{
    const std::array<PixelPair, 2> pixels{{{.referenceId = 4, .testId = 5, .referenceDepth = 0.5f, .testDepth = 0.5f},
                                           {.referenceId = 6, .testId = 5, .referenceDepth = 0.5f, .testDepth = 0.5f}}};
    const std::array<std::int64_t, 3> shown{5, -1, 4};
    EXPECT_EQ(compare(pixels, shown).lostTriangles, 1u) << "4 is shown at a pixel that was not sampled";
}

}  // namespace
}  // namespace zscope::tests
