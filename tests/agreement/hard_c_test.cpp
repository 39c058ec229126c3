// The hard cases of depth, docs/correctness.md, C1 to C8.

#include <cmath>

#include "tests/agreement/hard_support.h"

namespace zscope::hardcase {
namespace {

/// What each triangle shows when it is alone in the picture, by its id.
std::vector<Picture> eachAlone(const HardCase& hard)
{
    std::vector<Picture> alone;
    for (std::uint32_t id = 0; id < hard.scene->triangleCount(); ++id)
        alone.push_back(agreedPicture(only(hard, [id](std::uint32_t other) { return other == id; }), Effort::Some));
    return alone;
}

/// At every pixel the picture is the maximum of (depth, -id) over the pictures of the single triangles.
void expectMaximumOf(const std::vector<Picture>& alone, const Picture& picture, const std::string& what)
{
    for (int y = 0; y < picture.ids.height(); ++y)
        for (int x = 0; x < picture.ids.width(); ++x) {
            std::int64_t best  = -1;
            float        depth = 0;
            for (std::size_t id = 0; id < alone.size(); ++id)
                if (alone[id].depth.at(x, y) > depth) {
                    best  = static_cast<std::int64_t>(id);
                    depth = alone[id].depth.at(x, y);
                }
            ASSERT_EQ(picture.ids.at(x, y), best) << what << " at " << x << ", " << y;
            ASSERT_EQ(picture.depth.at(x, y), depth) << what << " at " << x << ", " << y;
        }
}

TEST(HardC, C1OfIdenticalTrianglesTheLowestIdWinsEverywhere)
{
    for (const int copies : {5, 300}) {
        const HardCase hard    = hardCase("C1?copies=" + std::to_string(copies));
        const Picture  picture = agreedPicture(hard);
        expectCoverage(fill(gridTriangles(hard)[0].outline(), 64, 64), coverageOf(picture, 0), hard.word);
        for (const std::int64_t id : picture.ids.values()) EXPECT_LE(id, 0);
        expectWinners(hard, picture);
        expectTwins(hard, picture);
        EXPECT_EQ(expectCounters(hard).at("pixels_tested"),
                  static_cast<std::uint64_t>(copies * sum(coverageOf(picture))));

        // Turned round, one by one: identical when two-sided.
        const HardCase mixed = changed(hard, "every other one turned round", hard.camera, [](auto&, auto& triangles) {
            for (std::size_t i = 0; i < triangles.size(); i += 2) std::swap(triangles[i][1], triangles[i][2]);
        });
        EXPECT_EQ(agreedPicture(mixed), picture);
        // Culled, the lowest one that faces the eye wins.
        const Picture front = agreedPicture(mixed, Effort::All, FaceCulling::Back);
        EXPECT_EQ(sum(coverageOf(front, 1)), sum(coverageOf(picture)));
    }
}

TEST(HardC, C2CoplanarOverlapIsTheSamePictureInAnyOrderAndDisagreesOnlyAtNearTies)
{
    for (int seed = 0; seed < 12; ++seed) {
        const HardCase hard    = hardCase("C2?triangles=12&seed=" + std::to_string(seed));
        const Picture  picture = agreedPicture(hard);
        const auto     alone   = eachAlone(hard);
        expectMaximumOf(alone, picture, hard.word);
        // In one plane whoever covers a pixel is within a step or two of the winner, unless limited to its corners.
        std::int64_t beaten = 0, farther = 0;
        for (const Picture& one : alone)
            for (std::size_t i = 0; i < one.ids.values().size(); ++i) {
                if (one.ids.values()[i] < 0) continue;
                ++beaten;
                farther += depthSteps(one.depth.values()[i], picture.depth.values()[i]) > 2;
            }
        EXPECT_LE(farther, beaten / 100) << hard.word;
        for (std::uint64_t order = 1; order <= 3; ++order) expectShuffledTwin(hard, picture, order);
        expectTwins(hard, picture, TwinDepth::WithinOneStep);
        expectCounters(hard);
    }
}

TEST(HardC, C3SymmetricCrossingHasItsBoundaryOnTheExactLineAndTiesGoToTheLowestId)
{
    for (const std::string first : {"left", "right"}) {
        const HardCase hard    = hardCase("C3?first=" + first);
        const Picture  picture = agreedPicture(hard);
        // Columns 0 to 63 hold samples; in column 32 both sheets are at 3/16 exactly.
        for (int y = 4; y < 60; ++y)
            for (int x = 0; x < 64; ++x) {
                const bool isFirstSheet = picture.ids.at(x, y) < 2;
                EXPECT_GE(picture.ids.at(x, y), 0);
                EXPECT_EQ(isFirstSheet, first == "left" ? x <= 32 : x >= 32) << first << " at " << x << ", " << y;
                EXPECT_EQ(picture.depth.at(x, y), 0.1875f + static_cast<float>(std::abs(x - 32)) / 512)
                    << first << " at " << x << ", " << y;
            }
        expectWinners(hard, picture);
        expectTwins(hard, picture);
        expectCounters(hard);
    }
}

TEST(HardC, C4ThreeTrianglesOverlappingInACircleAreRightWithoutSplitting)
{
    const HardCase hard    = hardCase("C4");
    const Picture  picture = agreedPicture(hard, Effort::All);
    agreedPicture(hard, Effort::All, FaceCulling::Back);
    expectWinners(hard, picture);
    expectMaximumOf(eachAlone(hard), picture, hard.word);
    const auto all = gridTriangles(hard);
    for (std::size_t i = 0; i < 3; ++i) {  // each hides a part of the one before it: no order would do
        const std::size_t before = (i + 2) % 3;
        const Grid<int>   mine = fill(all[i].outline(), 128, 128), its = fill(all[before].outline(), 128, 128);
        std::int64_t      hidden = 0, shared = 0;
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                if (!mine.at(x, y) || !its.at(x, y)) continue;
                ++shared;
                hidden += picture.ids.at(x, y) == static_cast<std::int64_t>(i);
            }
        EXPECT_GT(shared, 20) << "triangle " << i;
        EXPECT_GT(hidden, shared / 2) << "triangle " << i << " lies above triangle " << before;
    }
    for (std::uint64_t order = 1; order <= 6; ++order) expectShuffledTwin(hard, picture, order);
    expectTwins(hard, picture, TwinDepth::WithinOneStep);
}

TEST(HardC, C5ConvergingSheetsChangeWhereDepthsFirstDifferWithoutNoiseBeyondTies)
{
    for (const int apart : {2, 12, 18, 22, 24, 30, 52}) {
        const HardCase hard    = hardCase("C5?apart=" + std::to_string(apart));
        const Picture  picture = agreedPicture(hard);
        const auto     alone   = eachAlone(hard);
        expectMaximumOf(alone, picture, hard.word);
        expectTwins(hard, picture, TwinDepth::WithinOneStep);
        for (int y = 0; y < 64; ++y) {
            bool isClear = false;  // the lead has been more than two steps
            for (int x = 0; x < 256; ++x) {
                if (picture.ids.at(x, y) < 0) continue;
                const float far  = std::max(alone[0].depth.at(x, y), alone[1].depth.at(x, y));
                const float near = std::max(alone[2].depth.at(x, y), alone[3].depth.at(x, y));
                ASSERT_GE(depthSteps(far, near), -1) << "the nearer sheet is never more than a rounding behind";
                isClear = isClear || depthSteps(far, near) > 2;
                if (isClear) {
                    ASSERT_GE(picture.ids.at(x, y), 2) << hard.word << " at " << x << ", " << y;
                }
            }
            if (apart <= 18 && y >= 4 && y < 60) {
                EXPECT_TRUE(isClear) << hard.word << ", row " << y;
            }
        }
    }
}

TEST(HardC, C6NearlyEdgeOnFaceKeepsItsDepthWithinItsCorners)
{
    for (const std::string angle : {"89.999", "89.9", "89.99999", "89.5"}) {
        const HardCase hard    = hardCase("C6?angle=" + angle);
        const Picture  picture = agreedPicture(hard);
        const auto     alone   = eachAlone(hard);
        expectMaximumOf(alone, picture, hard.word);
        const auto   all   = gridTriangles(hard);
        std::int64_t drawn = 0;
        for (std::size_t id = 2; id < 4; ++id) {  // the wall
            const auto [lo, hi] = std::minmax({all[id].depth[0], all[id].depth[1], all[id].depth[2]});
            expectCoverage(fill(all[id].outline(), 256, 256), coverageOf(alone[id]), hard.word);
            drawn += sum(coverageOf(alone[id]));
            for (int y = 0; y < 256; ++y)
                for (int x = 0; x < 256; ++x) {
                    if (alone[id].ids.at(x, y) < 0) continue;
                    EXPECT_GE(alone[id].depth.at(x, y), static_cast<float>(lo)) << hard.word;
                    EXPECT_LE(alone[id].depth.at(x, y), static_cast<float>(hi)) << hard.word;
                }
        }
        if (angle != "89.99999") {
            EXPECT_GT(drawn, 50) << hard.word << ": the wall is seen";
        }
        // The sheet in front of it at 1/2 and the one behind it at 1/64 are beyond its reach.
        for (int y = 100; y < 120; ++y)
            for (int x = 150; x < 250; ++x) EXPECT_GE(picture.ids.at(x, y), 4) << hard.word << " at " << x << ", " << y;
        expectScaledTwin(hard, picture, 12);
        expectReversedTwin(hard, picture);
        expectShuffledTwin(hard, picture);
        expectCounters(hard);
    }
}

TEST(HardC, C7ClippedPartsAtTheNearPlaneNeverExceedDepthOne)
{
    const HardCase hard    = hardCase("C7");
    const Picture  picture = agreedPicture(hard);
    agreedPicture(hard, Effort::All, FaceCulling::Back);
    expectMaximumOf(eachAlone(hard), picture, hard.word);
    float nearest = 0;
    for (const float depth : picture.depth.values()) {
        EXPECT_LE(depth, 1.0f);
        if (depth < 1) nearest = std::max(nearest, depth);
    }
    for (std::int64_t id = 0; id < 3; ++id)
        EXPECT_GT(sum(coverageOf(picture, id)), 0) << "triangle " << id << " is seen";
    EXPECT_EQ(nearest, std::nextafter(1.0f, 0.0f)) << "one step behind the near plane lies the third triangle";
    // Where the triangle on the near plane is, only what reaches the near plane too, with a lower id, may hide it.
    const Grid<int> onPlane = fill(gridTriangles(hard)[1].outline(), 64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (onPlane.at(x, y)) {
                EXPECT_EQ(picture.depth.at(x, y), 1.0f);
                EXPECT_LE(picture.ids.at(x, y), 1);
            }
    expectTwins(hard, picture, TwinDepth::WithinOneStep);
    expectCounters(hard);
}

TEST(HardC, C8OneStepApartTheNearerWinsHalfAStepIsDecidedAfterRounding)
{
    struct Claim {
        const char* base;
        const char* step;
        bool        nearerWins;
        int         storedSteps;  // above 1/4, where the nearer sheet is seen
    };
    for (const Claim& claim : {Claim{"even", "1", true, 1},
                               {"odd", "1", true, 2},
                               // a tie of rounding goes down to the even 1/4: equal, lowest id
                               {"even", "0.5", false, 0},
                               {"odd", "0.5", true, 2},  // and here up to the even one: nearer
                               {"even", "0.25", false, 0},
                               {"odd", "0.25", false, 1},
                               {"even", "0.75", true, 1},
                               {"odd", "0.75", true, 2},
                               {"even", "0", false, 0},
                               {"odd", "0", false, 1}}) {
        const HardCase hard    = hardCase(std::string("C8?base=") + claim.base + "&step=" + claim.step);
        const Picture  picture = agreedPicture(hard);
        const float    quarter = 0.25f;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const bool inFar  = x >= 4 && x < 44 && y >= 4 && y < 44,
                           inNear = x >= 20 && x < 60 && y >= 20 && y < 60;
                const bool isNear = inNear && (!inFar || claim.nearerWins);
                ASSERT_EQ(picture.ids.at(x, y) >= 0, inFar || inNear) << hard.word;
                if (!inFar && !inNear) continue;
                ASSERT_EQ(picture.ids.at(x, y) >= 2, isNear) << hard.word << " at " << x << ", " << y;
                const int expected = isNear ? claim.storedSteps : (std::string(claim.base) == "odd" ? 1 : 0);
                ASSERT_EQ(depthSteps(quarter, picture.depth.at(x, y)), expected)
                    << hard.word << " at " << x << ", " << y;
            }
        expectScaledTwin(hard, picture, 30);
        expectShiftedTwin(hard, picture);
        expectReversedTwin(hard, picture);
        expectShuffledTwin(hard, picture);
        expectCounters(hard);
    }
}

}  // namespace
}  // namespace zscope::hardcase
