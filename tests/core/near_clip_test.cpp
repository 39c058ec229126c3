// Cutting at the near plane: the same point from both sides, and parts that fit together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/geometry/near_clip.h"

namespace zscope {
namespace {

double between(std::mt19937_64& random, double lo, double hi)
{
    return lo + (hi - lo) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

dvec3 anyPoint(std::mt19937_64& random, double near, bool inFront)
{
    const double size = std::pow(10.0, between(random, -6, 6));
    const double away = std::pow(10.0, between(random, -9, 6));
    return {between(random, -size, size), between(random, -size, size), inFront ? near + away : near - away};
}

TEST(NearClip, ASharedEdgeIsCutInTheSamePointWhicheverWayRoundItIsListed)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const double near = std::pow(10.0, between(random, -4, 2));
        const dvec3  a = anyPoint(random, near, true), b = anyPoint(random, near, false);
        const dvec3  c = anyPoint(random, near, i % 2), d = anyPoint(random, near, i % 3);
        // a-b in one triangle, b-a in its neighbour, each started at any of its corners.
        const auto cutsOf = [&](std::array<dvec3, 3> view, int turn) {
            std::rotate(view.begin(), view.begin() + turn, view.end());
            const ClippedTriangle kept = clipNear(view, near);
            return std::vector(kept.corner.begin(), kept.corner.begin() + static_cast<std::ptrdiff_t>(kept.count));
        };
        const dvec3 shared = nearCrossing(a, b, near);
        EXPECT_EQ(shared.z, near);
        for (int turn = 0; turn < 3; ++turn) {
            const auto one = cutsOf({a, b, c}, turn), other = cutsOf({b, a, d}, turn);
            EXPECT_NE(std::ranges::find(one, shared), one.end());
            EXPECT_NE(std::ranges::find(other, shared), other.end());
        }
    }
}

TEST(NearClip, OneTwoOrThreeCornersBehindLeaveTwoPartsOneOrNone)
{
    std::mt19937_64 random(2);
    for (int i = 0; i < 4000; ++i) {
        const double         near = 0.5;
        std::array<dvec3, 3> view;
        std::size_t          behind = 0;
        for (dvec3& corner : view) {
            const bool inFront = random() % 2;
            corner             = anyPoint(random, near, inFront);
            behind += !inFront;
        }
        const ClippedTriangle                kept = clipNear(view, near);
        constexpr std::array<std::size_t, 4> parts{1, 2, 1, 0};
        EXPECT_EQ(kept.parts(), parts[behind]);
        for (std::size_t c = 0; c < kept.count; ++c) EXPECT_GE(kept.corner[c].z, near);
        if (behind == 0) {
            EXPECT_EQ(kept.part(0), view);
        }
    }
}

TEST(NearClip, TwoPartsShareTheirDiagonalInOppositeSense)
{
    const ClippedTriangle kept = clipNear({dvec3{0, 0, 4}, dvec3{3, 0, 2}, dvec3{1, 2, -1}}, 1);
    ASSERT_EQ(kept.parts(), 2u);
    EXPECT_EQ(kept.part(0)[0], kept.part(1)[0]);
    EXPECT_EQ(kept.part(0)[2], kept.part(1)[1]);
}

TEST(NearClip, ACornerOnThePlaneIsKeptAndAnotherPlaneNeedsNoCut)
{
    EXPECT_EQ(clipNear({dvec3{0, 0, 1}, dvec3{1, 0, 1}, dvec3{0, 1, 1}}, 1).parts(), 1u);
    EXPECT_EQ(clipNear({dvec3{0, 0, 1}, dvec3{1, 0, 0}, dvec3{0, 1, 0}}, 1).parts(), 1u);
    EXPECT_EQ(clipNear({dvec3{0, 0, std::nextafter(1, 0)}, dvec3{1, 0, 0}, dvec3{0, 1, 0}}, 1).parts(), 0u);
}

TEST(NearClip, NumbersThatAreNoneAreBehind)
{
    const double nan = std::nan("");
    EXPECT_EQ(clipNear({dvec3{0, 0, nan}, dvec3{1, 0, nan}, dvec3{0, 1, nan}}, 1).parts(), 0u);
    EXPECT_LE(clipNear({dvec3{0, 0, nan}, dvec3{1, 0, 5}, dvec3{0, 1, 5}}, 1).count, 4u);
}

}  // namespace
}  // namespace zscope
