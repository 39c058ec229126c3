// The hard cases of coverage, docs/correctness.md, A1 to A13. Every picture is first agreed upon by the reference and
// all exact algorithms; then it is held against what whole-number arithmetic says must be seen.

#include <cmath>

#include "tests/agreement/hard_support.h"

namespace zscope::hardcase {
namespace {

/// The outline that two triangles (a, b, c) and (a, c, d) leave together.
Outline outlineOfQuad(const HardCase& hard)
{
    const auto triangles = gridTriangles(hard);
    return {triangles[0].corner[0], triangles[0].corner[1], triangles[0].corner[2], triangles[1].corner[2]};
}

void expectWhole(const HardCase& hard, const Picture& picture, const Outline& outline)
{
    expectCoverage(fill(outline, hard.width(), hard.height()), coverageOf(picture), hard.word);
}

/// The picture shows exactly what the outlines of its triangles cover; returns how often each pixel is covered.
Grid<int> expectSumOfTriangles(const HardCase& hard, const Picture& picture)
{
    std::vector<Outline> outlines;
    for (const GridTriangle& triangle : gridTriangles(hard)) outlines.push_back(triangle.outline());
    Grid<int> times = fill(outlines, hard.width(), hard.height());
    Grid<int> atAll = times;
    for (int& count : atAll.values()) count = count > 0;
    expectCoverage(atAll, coverageOf(picture), hard.word);
    return times;
}

TEST(HardA, A1TwoTrianglesShareAnEdgeAndEachPixelOfTheQuadOnceIn400Directions)
{
    for (int direction = 0; direction < 400; ++direction)
        for (const std::string ends : {"centre", "corner", "elsewhere"}) {
            Grid<int> both[2];
            for (int i = 0; i < 2; ++i) {
                const HardCase hard    = hardCase("A1?direction=" + std::to_string(direction) + "&ends=" + ends
                                                  + "&diagonal=" + (i == 0 ? "long" : "short"));
                const Picture  picture = agreedPicture(hard, Effort::Some);
                expectWhole(hard, picture, outlineOfQuad(hard));
                both[i] = coverageOf(picture);
                if (i != direction % 2) continue;
                const Grid<int> first =
                    coverageOf(agreedPicture(only(hard, [](auto id) { return id == 0; }), Effort::Some));
                const Grid<int> second =
                    coverageOf(agreedPicture(only(hard, [](auto id) { return id == 1; }), Effort::Some));
                EXPECT_EQ(sum(first) + sum(second), sum(both[i]))
                    << hard.word << ": a pixel is covered twice or not at all";
            }
            EXPECT_EQ(both[0], both[1]) << "direction " << direction << ", " << ends << ": the diagonal shows";
            if (HasFailure()) return;
        }
    for (const int direction : {0, 37, 50, 100, 211, 399}) {
        const HardCase hard = hardCase("A1?direction=" + std::to_string(direction));
        expectTwins(hard, agreedPicture(hard));
        agreedPicture(hard, Effort::All, FaceCulling::Back);
        expectCounters(hard);
    }
}

TEST(HardA, A2SquareOnCentresHas25PixelsFifteenAndTen)
{
    for (const std::string diagonal : {"falling", "rising"}) {
        const HardCase hard    = hardCase("A2?diagonal=" + diagonal);
        const Picture  picture = agreedPicture(hard);
        EXPECT_EQ(sum(coverageOf(picture)), 25);
        for (int y = 2; y < 7; ++y)
            for (int x = 2; x < 7; ++x) EXPECT_GE(picture.ids.at(x, y), 0) << x << ", " << y;
        const auto one = sum(coverageOf(picture, 0)), other = sum(coverageOf(picture, 1));
        EXPECT_EQ(std::max(one, other), 15) << diagonal;
        EXPECT_EQ(std::min(one, other), 10) << diagonal;
        expectWinners(hard, picture);
        expectCoveredAtMostOnce(hard);
        expectTwins(hard, picture);
        expectCounters(hard);
    }
}

TEST(HardA, A3CentresOnLeftAndTopEdgesAreInThoseOnRightAndBottomEdgesAreOut)
{
    const HardCase rectangle = hardCase("A3?shape=rectangle");  // centres (3, 5) to (20, 11)
    const Picture  seen      = agreedPicture(rectangle);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x)
            EXPECT_EQ(seen.ids.at(x, y) >= 0, x >= 3 && x < 20 && y >= 5 && y < 11) << x << ", " << y;
    expectTwins(rectangle, seen);

    // Inside a diamond of radius 6 lie 2*6*5 + 1 centres; its two left edges hold 11 more without top and bottom.
    const HardCase diamond = hardCase("A3?shape=diamond");
    const Picture  facet   = agreedPicture(diamond);
    EXPECT_EQ(sum(coverageOf(facet)), 72);
    EXPECT_GE(facet.ids.at(10, 16), 0) << "the left corner belongs";
    EXPECT_EQ(facet.ids.at(16, 10), -1) << "the top corner ends a right edge";
    EXPECT_EQ(facet.ids.at(22, 16), -1) << "the right corner does not belong";
    EXPECT_EQ(facet.ids.at(16, 22), -1) << "the bottom corner does not belong";
    expectTwins(diamond, facet);

    const HardCase triangles = hardCase("A3?shape=triangles");
    const Picture  halves    = agreedPicture(triangles);
    EXPECT_EQ(sum(coverageOf(halves, 0)), 36) << "left and top, diagonal out: 8 + 7 + .. + 1";
    EXPECT_EQ(sum(coverageOf(halves, 1)), 36) << "top in, right out, diagonal in as a left edge";
    EXPECT_EQ(sum(coverageOf(halves, 2)), 28) << "left in, bottom and diagonal out: 7 + 6 + .. + 1";
    EXPECT_EQ(sum(coverageOf(halves, 3)), 28) << "right and bottom out, diagonal in as a left edge";
    expectWinners(triangles, halves);
    expectTwins(triangles, halves);
    expectCounters(triangles);
}

TEST(HardA, A4FanCoversItsDiscExactlyOnceAndTheCentrePixelOnce)
{
    for (const int triangles : {1000, 10'000})
        for (const std::string centre : {"centre", "corner", "elsewhere"}) {
            const HardCase hard    = hardCase("A4?triangles=" + std::to_string(triangles) + "&centre=" + centre);
            const Picture  picture = agreedPicture(hard, triangles == 1000 ? Effort::All : Effort::EachPreset);
            Outline        rim;
            for (const GridTriangle& triangle : gridTriangles(hard)) rim.push_back(triangle.corner[1]);
            expectWhole(hard, picture, rim);
            EXPECT_EQ(coverageOf(picture).at(64, 63), 1);
            const auto counters = expectCounters(hard);
            EXPECT_EQ(counters.at("pixels_tested"), static_cast<std::uint64_t>(sum(coverageOf(picture))))
                << "one test per covered pixel: no pixel is covered twice";
            expectShuffledTwin(hard, picture);
            if (triangles > 1000) continue;
            expectCoveredAtMostOnce(hard);
            expectTwins(hard, picture);
        }
}

TEST(HardA, A5SliversEqualTheExactSetAndZeroWidthDrawsNothing)
{
    for (const std::string run : {"horizontal", "vertical", "shallow", "steep"})
        for (const std::string width : {"256", "2", "1", "0.75", "0.5", "0.25", "0"}) {
            const HardCase hard    = hardCase("A5?run=" + run + "&width=" + width);
            const Picture  picture = agreedPicture(hard, width == "1" ? Effort::All : Effort::EachPreset);
            expectSumOfTriangles(hard, picture);
            const auto counters = expectCounters(hard);
            if (width == "0") {
                EXPECT_EQ(sum(coverageOf(picture)), 0) << hard.word;
                EXPECT_EQ(counters.at("triangles_degenerate"), 3u) << hard.word;
            }
            if (width == "1") {
                expectReversedTwin(hard, picture);
                expectShuffledTwin(hard, picture);
                expectScaledTwin(hard, picture, 9);
            }
            // The first horizontal sliver's top side runs through row 10, from the corner itself to 1012.5.
            if (run == "horizontal" && width == "1") {
                EXPECT_EQ(sum(coverageOf(picture, 0)), 1000);
            }
        }
}

TEST(HardA, A6SphereOfAMillionTinyTrianglesHasNoHoleInsideItsSilhouette)
{
    const HardCase hard    = hardCase("A6");
    const Picture  picture = agreedPicture(hard, Effort::EachPreset);
    EXPECT_NEAR(static_cast<double>(hard.scene->triangleCount()), 1e6, 3000);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x) {
            const double radius = std::hypot(x + 0.5 - 64, y + 0.5 - 64);
            if (radius < 49.98) {
                ASSERT_GE(picture.ids.at(x, y), 0) << "a hole at " << x << ", " << y;
            }
            if (radius > 50.02) {
                ASSERT_EQ(picture.ids.at(x, y), -1) << "a spill at " << x << ", " << y;
            }
        }
    const auto counters = expectCounters(hard);
    EXPECT_GT(counters.at("triangles_no_pixel_centre") + counters.at("triangles_degenerate"), 950'000u);
    EXPECT_LT(counters.at("triangles_drawn"), 50'000u);
    // Seen from outside the back faces are hidden: culling them changes nothing.
    const Picture front = agreedPicture(hard, Effort::EachPreset, FaceCulling::Back);
    EXPECT_EQ(front.ids, picture.ids);
}

TEST(HardA, A6SmallerSpheresAreClosedToo)
{
    for (const int triangles : {200, 5000, 40'000}) {
        const HardCase hard    = hardCase("A6?triangles=" + std::to_string(triangles));
        const Picture  picture = agreedPicture(hard);
        const double   rings   = std::sqrt(triangles / 2.0);
        const double   inner   = 50 * std::pow(std::cos(3.15 / rings), 2) - 1;  // inside every facet
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x)
                if (std::hypot(x + 0.5 - 64, y + 0.5 - 64) < inner) {
                    ASSERT_GE(picture.ids.at(x, y), 0) << x << ", " << y;
                }
        expectTwins(hard, picture, TwinDepth::WithinOneStep);
        expectCounters(hard);
        expectCounters(hard, FaceCulling::Back);
        // Front and back halves each cover the silhouette exactly once.
        const auto counters = expectCounters(hard, FaceCulling::Back);
        EXPECT_EQ(counters.at("pixels_tested"), static_cast<std::uint64_t>(sum(coverageOf(picture))));
    }
}

TEST(HardA, A7JunctionOnTheGridHasNoGap)
{
    const HardCase hard    = hardCase("A7?midpoint=grid");
    const Picture  picture = agreedPicture(hard);
    const auto     all     = gridTriangles(hard);
    expectWhole(hard, picture, {all[0].corner[0], all[1].corner[1], all[0].corner[1], all[0].corner[2]});
    expectCoveredAtMostOnce(hard);
    expectTwins(hard, picture);
}

TEST(HardA, A7JunctionOffTheGridHasThePredictedGapPixelForPixel)
{
    // The long edge runs from centre (8, 8) to one unit right of centre (48, 48). Its midpoint is snapped half a
    // unit to the left, onto centre (28, 28), so the upper short edge passes exactly through the centres (j, j) of
    // rows 8 to 28, as a right edge that leaves them out, while the long edge passes right of them from row 9 on.
    const HardCase  hard    = hardCase("A7?midpoint=gap");
    const Picture   picture = agreedPicture(hard);
    const auto      all     = gridTriangles(hard);
    const Grid<int> whole   = fill({all[0].corner[0], all[1].corner[1], all[0].corner[1], all[0].corner[2]}, 64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool isGap = x == y && y >= 9 && y <= 28;
            EXPECT_EQ(picture.ids.at(x, y) >= 0, whole.at(x, y) == 1 && !isGap) << x << ", " << y;
            if (isGap) {
                EXPECT_EQ(whole.at(x, y), 1);
            }
        }
    expectSumOfTriangles(hard, picture);
    expectTwins(hard, picture);
}

TEST(HardA, A7JunctionMovedTheOtherWayOverlapsWhereThePredictionSays)
{
    const HardCase  hard    = hardCase("A7?midpoint=overlap");
    const Picture   picture = agreedPicture(hard);
    const Grid<int> times   = expectSumOfTriangles(hard, picture);
    // Centres (j, j) lie right of the long edge from row 9 on, and left of the short one from row 29 to 48, on it
    // before.
    std::int64_t twice = 0;
    for (const int count : times.values()) twice += count > 1;
    const auto counters = expectCounters(hard);
    EXPECT_EQ(counters.at("pixels_tested"), static_cast<std::uint64_t>(sum(coverageOf(picture)) + twice));
    expectTwins(hard, picture);
}

TEST(HardA, A8TrianglesOfZeroAreaDrawNothingAndAreCounted)
{
    for (const std::string kind : {"repeated", "collinear", "equal", "snapped"}) {
        const HardCase hard    = hardCase("A8?kind=" + kind);
        const Picture  picture = agreedPicture(hard);
        EXPECT_EQ(sum(coverageOf(picture)), 0) << kind;
        EXPECT_EQ(expectCounters(hard).at("triangles_degenerate"), 1u) << kind;
    }
    const HardCase hard = hardCase("A8?kind=among");
    EXPECT_EQ(hard.scene->triangleCount(), 6u) << "a triangle of zero area keeps its id";
    const Picture picture = agreedPicture(hard);
    EXPECT_EQ(expectCounters(hard).at("triangles_degenerate"), 4u);
    const auto all = gridTriangles(hard);
    expectCoverage(fill(all[0].outline(), 32, 32), coverageOf(picture, 0), hard.word);
    expectCoverage(fill(all[5].outline(), 32, 32), coverageOf(picture, 5), hard.word);
    expectTwins(hard, picture);
}

TEST(HardA, A9CornersAtTheSnappingMidpointGoToTheEvenUnitForAllUsersOfTheVertex)
{
    for (const int units : {-128, -3, -2, -1, 0, 1, 2, 3, 127}) {
        const HardCase hard    = hardCase("A9?units=" + std::to_string(units));
        const Picture  picture = agreedPicture(hard);
        // The hub lies at 256 * 32 + 128 + units + 1/2 units; the even neighbour is the one below iff units is even.
        const std::int64_t even = 256 * 32 + 128 + (units % 2 == 0 ? units : units + 1);
        const auto         all  = gridTriangles(hard);
        Outline            rim;
        for (const GridTriangle& triangle : all) {
            EXPECT_EQ(triangle.corner[0], (GridPoint{even, even}));
            rim.push_back(triangle.corner[1]);
        }
        expectWhole(hard, picture, rim);
        expectCoveredAtMostOnce(hard);
        expectWinners(hard, picture);
        expectTwins(hard, picture);

        // The same corners given on the even units themselves: the same picture.
        const HardCase rounded = changed(hard, "rounded beforehand", hard.camera, [&](auto& positions, auto&) {
            for (dvec3& p : positions) {
                const GridPoint g = snapped(32 + p.x / -p.z, 32 - p.y / -p.z);
                p.x               = (static_cast<double>(g.x) / 256 - 32) * -p.z;
                p.y               = (32 - static_cast<double>(g.y) / 256) * -p.z;
            }
        });
        EXPECT_EQ(agreedPicture(rounded, Effort::EachPreset).ids, picture.ids) << hard.word;
    }
}

TEST(HardA, A10TriangleTenThousandTimesThePictureCoversAllOfIt)
{
    for (const std::string times : {"1", "100", "10000", "1e7", "1e12"}) {
        const HardCase hard    = hardCase("A10?times=" + times);
        const Picture  picture = agreedPicture(hard);
        EXPECT_EQ(sum(coverageOf(picture, 0)), 64 * 64) << times;
        for (const float depth : picture.depth.values()) EXPECT_EQ(depth, 0.25f) << times;
        expectTwins(hard, picture);
        expectCounters(hard);
    }
}

TEST(HardA, A11CornerFarBeyondTheGuardBandTakesTheWidePathToTheSamePixels)
{
    for (const int exponent : {8, 15, 22, 23, 31, 40, 52}) {
        const HardCase hard    = hardCase("A11?exponent=" + std::to_string(exponent));
        const Picture  picture = agreedPicture(hard);
        expectSumOfTriangles(hard, picture);
        EXPECT_GT(sum(coverageOf(picture)), 64 * 20) << hard.word;
        expectTwins(hard, picture);
        const auto counters = expectCounters(hard);
        EXPECT_EQ(counters.at("triangles_drawn"), 1u) << hard.word;
        if (exponent >= 31) {
            EXPECT_EQ(counters.at("triangles_wide"), 1u) << hard.word;
        }
        if (exponent <= 8) {
            EXPECT_EQ(counters.at("triangles_wide"), 0u) << hard.word;
        }
    }
}

TEST(HardA, A11CornerBeyondTheGridIsNotDrawnAndCounted)
{
    for (const int exponent : {53, 54, 60, 100, 1000}) {  // 2^53 pixels are 2^61 units
        const HardCase hard = hardCase("A11?exponent=" + std::to_string(exponent));
        EXPECT_EQ(sum(coverageOf(agreedPicture(hard))), 0) << hard.word;
        EXPECT_EQ(expectCounters(hard).at("triangles_out_of_range"), 1u) << hard.word;
    }
}

TEST(HardA, A12PictureBorderIsDrawnIffTheRuleSaysSo)
{
    const auto pixels = [](const std::string& shape) {
        const HardCase hard    = hardCase("A12?shape=" + shape);
        const Picture  picture = agreedPicture(hard);
        expectWinners(hard, picture);
        expectTwins(hard, picture);
        expectCounters(hard);
        return coverageOf(picture);
    };
    const Grid<int> lastIn = pixels("last-in");
    EXPECT_EQ(sum(lastIn), 1);
    EXPECT_EQ(lastIn.at(47, 31), 1);
    EXPECT_EQ(sum(pixels("last-out")), 0);
    const Grid<int> firstIn = pixels("first-in");
    EXPECT_EQ(sum(firstIn), 1);
    EXPECT_EQ(firstIn.at(0, 0), 1);
    EXPECT_EQ(sum(pixels("first-out")), 0);
    EXPECT_EQ(sum(pixels("whole")), 48 * 32);
    EXPECT_EQ(sum(pixels("beyond")), 48 * 32);
    const Grid<int> centres = pixels("centres");
    EXPECT_EQ(sum(centres), 47 * 31);
    for (int x = 0; x < 48; ++x) EXPECT_EQ(centres.at(x, 31), 0) << "the last row";
    for (int y = 0; y < 32; ++y) EXPECT_EQ(centres.at(47, y), 0) << "the last column";
}

TEST(HardA, A13TriangleTurnedOverBySnappingIsDrawnAndCulledByItsSnappedSign)
{
    for (const std::string facing : {"front", "back"}) {
        const HardCase hard    = hardCase("A13?facing=" + facing);
        const Picture  picture = agreedPicture(hard);
        // Snapped: left one unit below row 10's centres, middle and right on them. Pixels 32 to 55 are on the top side.
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 64; ++x)
                EXPECT_EQ(picture.ids.at(x, y) >= 0, y == 10 && x >= 32 && x < 56) << x << ", " << y;
        expectTwins(hard, picture);

        // Facing the viewer before snapping is facing away afterwards.
        const Picture culled = agreedPicture(hard, Effort::All, FaceCulling::Back);
        EXPECT_EQ(sum(coverageOf(culled)), facing == "front" ? 0 : 24) << facing;
        EXPECT_EQ(expectCounters(hard, FaceCulling::Back).at("triangles_back_facing"), facing == "front" ? 1u : 0u);
    }
}

}  // namespace
}  // namespace zscope::hardcase
