#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "core/scene/mesh.h"
#include "core/scene/triangulate.h"
#include "tests/core/outline_shapes.h"

namespace zscope {
namespace {

using test::GridPoint;
using test::GridPolygon;
using Triangles = std::vector<PolygonSplitter::Triangle>;

struct Cut {
    PolygonSplit how;
    Triangles    triangles;
};

Cut cut(const std::vector<dvec3>& positions)
{
    Cut             result;
    PolygonSplitter splitter;
    result.how = splitter.split(positions, test::inOrder(positions.size()), result.triangles);
    return result;
}

/// Random points of the grid's interstices: every coordinate is doubled and the points are odd.
void expectEveryPointInAsManyTrianglesAsInsideOutlines(const GridPolygon& polygon, const Triangles& triangles,
                                                       int points)
{
    std::vector<GridPoint> doubled;
    GridPoint              low{0, 0}, high{0, 0};
    for (const GridPoint& p : polygon.corners) {
        doubled.push_back({2 * p.x, 2 * p.y});
        low  = {std::min(low.x, 2 * p.x), std::min(low.y, 2 * p.y)};
        high = {std::max(high.x, 2 * p.x), std::max(high.y, 2 * p.y)};
    }
    std::mt19937_64                             random(5);
    std::uniform_int_distribution<std::int64_t> x(low.x - 4, high.x + 4), y(low.y - 4, high.y + 4);
    int                                         inside = 0;
    for (int k = 0; k < points; ++k) {
        const GridPoint p{x(random) | 1, y(random) | 1};
        bool            onAnEdge = false;
        int             holding  = 0;
        for (const auto& t : triangles) {
            if (test::sideOf(doubled[t[0]], doubled[t[1]], doubled[t[2]]) == 0) continue;  // no area
            const int s0 = test::sideOf(doubled[t[0]], doubled[t[1]], p),
                      s1 = test::sideOf(doubled[t[1]], doubled[t[2]], p),
                      s2 = test::sideOf(doubled[t[2]], doubled[t[0]], p);
            onAnEdge |= s0 * s1 >= 0 && s1 * s2 >= 0 && s0 * s2 >= 0 && s0 * s1 * s2 == 0;
            holding += s0 == s1 && s1 == s2 && s0 != 0;
        }
        if (onAnEdge) continue;
        const int winding = test::windingAround(doubled, p);
        inside += winding != 0;
        ASSERT_EQ(holding, std::abs(winding)) << polygon.name << ", seed 5, point " << p.x << "/2, " << p.y << "/2";
        ASSERT_EQ(holding, winding & 1) << polygon.name;
    }
    EXPECT_GT(inside, points / 200) << polygon.name << ": the points should meet the polygon";
}

TEST(Ears, CoverTheInsideOfEveryHardOutlineExactlyOnce)
{
    for (const GridPolygon& polygon : test::cuttablePolygons()) {
        const Cut result = cut(test::inPlane(polygon.corners));
        ASSERT_EQ(result.how, PolygonSplit::Ears) << polygon.name;
        EXPECT_GE(result.triangles.size(), polygon.corners.size() - 2) << polygon.name;
        expectEveryPointInAsManyTrianglesAsInsideOutlines(polygon, result.triangles, 4000);
    }
}

TEST(Ears, CoverTheSameWhereverTheOutlineStartsAndWhicheverWayItRuns)
{
    for (const GridPolygon& polygon : test::cuttablePolygons()) {
        if (polygon.corners.size() > 70) continue;
        for (std::size_t start = 0; start < polygon.corners.size(); ++start) {
            for (const bool reversed : {false, true}) {
                GridPolygon turned = polygon;
                std::rotate(turned.corners.begin(), turned.corners.begin() + static_cast<std::ptrdiff_t>(start),
                            turned.corners.end());
                if (reversed) std::reverse(turned.corners.begin(), turned.corners.end());
                const Cut result = cut(test::inPlane(turned.corners));
                ASSERT_EQ(result.how, PolygonSplit::Ears) << polygon.name << " from corner " << start;
                expectEveryPointInAsManyTrianglesAsInsideOutlines(turned, result.triangles, 300);
            }
        }
    }
}

TEST(Ears, NumberTwoLessThanTheCornersUnlessCornersTouchEdges)
{
    for (const GridPolygon& polygon : test::cuttablePolygons()) {
        if (polygon.name.find("touching an edge") != std::string::npos || polygon.name.find("spike") == 0) continue;
        EXPECT_EQ(cut(test::inPlane(polygon.corners)).triangles.size(), polygon.corners.size() - 2) << polygon.name;
    }
}

TEST(Ears, KeepThePolygonsSenseOfTurning)
{
    const std::vector<GridPoint> dart{{0, 0}, {100, 0}, {30, 30}, {0, 100}};
    for (const bool reversed : {false, true}) {
        std::vector<GridPoint> corners = dart;
        if (reversed) std::reverse(corners.begin(), corners.end());
        const Cut result = cut(test::inPlane(corners));
        ASSERT_EQ(result.triangles.size(), 2u);
        for (const auto& t : result.triangles)
            EXPECT_EQ(test::sideOf(corners[t[0]], corners[t[1]], corners[t[2]]), reversed ? -1 : 1);
    }
}

TEST(Ears, AreTheSameEveryTime)
{
    PolygonSplitter used;
    for (const GridPolygon& polygon : test::cuttablePolygons()) {
        Triangles  again;
        const auto positions = test::inPlane(polygon.corners);
        used.split(positions, test::inOrder(positions.size()), again);
        EXPECT_EQ(again, cut(positions).triangles) << polygon.name << ": a used splitter answers as a new one";
    }
}

TEST(Ears, OfATiltedPolygonAreThoseOfItsProjection)
{
    const GridPolygon  flat = test::star(7, 1000, 300);
    std::vector<dvec3> tilted;
    for (const GridPoint& p : flat.corners)
        tilted.push_back({static_cast<double>(p.x), static_cast<double>(p.y),
                          0.25 * static_cast<double>(p.x) - 0.5 * static_cast<double>(p.y)});
    EXPECT_EQ(cut(tilted).triangles, cut(test::inPlane(flat.corners)).triangles);
    for (dvec3& p : tilted) p = {p.z, p.x, p.y};
    EXPECT_EQ(cut(tilted).triangles, cut(test::inPlane(flat.corners)).triangles) << "the axes take turns";
}

TEST(Ears, AreCutFromCoordinatesOfAnySize)
{
    for (const double scale : {1e300, 1e-160, 1e-300, 5e-324}) {
        for (const GridPolygon& polygon : test::cuttablePolygons()) {
            std::vector<dvec3> positions = test::inPlane(polygon.corners);
            for (dvec3& p : positions) p *= scale;
            EXPECT_EQ(cut(positions).how, PolygonSplit::Ears) << polygon.name << " times " << scale;
        }
    }
}

TEST(Ears, AreFoundInRandomPolygonsOnACoarseGridWithManyContacts)
{
    std::mt19937_64 random(17);
    int             cutCount = 0;
    for (int round = 0; round < 300; ++round) {
        // Angles rise, radii jump; coarse rounding makes corners coincide and edges touch.
        GridPolygon                        polygon{"random radial", {}};
        std::uniform_int_distribution<int> radius(3, 20), corners(8, 40);
        const int                          n = corners(random);
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            const int    r     = radius(random);
            polygon.corners.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
        }
        const Cut result = cut(test::inPlane(polygon.corners));
        if (result.how != PolygonSplit::Ears) continue;  // rounding made it cross itself
        ++cutCount;
        expectEveryPointInAsManyTrianglesAsInsideOutlines(polygon, result.triangles, 400);
    }
    EXPECT_GT(cutCount, 200) << "seed 17";
}

TEST(Ears, AreFoundHoweverOftenTheOutlineMeetsItself)
{
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const GridPolygon polygon = test::grownFromSquares(static_cast<int>(3 + seed % 60), seed);
        const Cut         result  = cut(test::inPlane(polygon.corners));
        if (result.how == PolygonSplit::Fan) continue;  // a row of squares
        ASSERT_EQ(result.how, PolygonSplit::Ears) << polygon.name;
        EXPECT_EQ(result.triangles.size(), polygon.corners.size() - 2) << polygon.name;
        expectEveryPointInAsManyTrianglesAsInsideOutlines(polygon, result.triangles, 200);
    }
    const Cut large = cut(test::inPlane(test::grownFromSquares(2000, 7).corners));
    EXPECT_EQ(large.how, PolygonSplit::Ears);
}

TEST(Fan, IsWhatAConvexPolygonGetsFromItsFirstCorner)
{
    for (const int corners : {4, 5, 12, 300}) {
        const auto positions = test::inPlane(test::circle(corners, 1e6));
        const Cut  result    = cut(positions);
        EXPECT_EQ(result.how, PolygonSplit::Fan);
        ASSERT_EQ(result.triangles.size(), positions.size() - 2);
        for (std::uint32_t i = 0; i < result.triangles.size(); ++i)
            EXPECT_EQ(result.triangles[i], (PolygonSplitter::Triangle{0, i + 1, i + 2}));
    }
}

TEST(Fan, IsWhatAConvexPolygonWithRepeatedAndFlatCornersGets)
{
    const std::vector<std::vector<GridPoint>> polygons{
        {{0, 0}, {5, 0}, {10, 0}, {10, 10}, {0, 10}},
        {{0, 0}, {0, 0}, {10, 0}, {10, 10}},
        {{0, 0}, {10, 0}, {10, 10}, {0, 0}},
        {{5, 0}, {10, 0}, {10, 5}, {10, 10}, {10, 10}, {0, 10}, {0, 5}, {0, 0}}};
    for (const auto& corners : polygons) {
        const Cut result = cut(test::inPlane(corners));
        EXPECT_EQ(result.how, PolygonSplit::Fan);
        EXPECT_EQ(result.triangles.size(), corners.size() - 2);
        EXPECT_EQ(result.triangles.front()[0], 0u);
    }
}

/// Nothing here is timed: looking at all corners for each of a million would take hours, and CTest ends a test long
/// before.
TEST(Fan, OfAMillionCornersIsFoundAtAll)
{
    constexpr int      kCorners = 1'000'000;
    std::vector<dvec3> positions;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCorners;
        positions.push_back({1e6 * std::cos(angle), 1e6 * std::sin(angle), 0});
    }
    const Cut result = cut(positions);
    EXPECT_EQ(result.how, PolygonSplit::Fan);
    EXPECT_EQ(result.triangles.size(), positions.size() - 2);
}

/// Outlines of about `corners` corners that make a search among all of them slow.
std::vector<GridPolygon> longOutlines(int corners)
{
    GridPolygon     rough{"rough circle", test::circle(corners, 1e8)};
    std::mt19937_64 random(3);
    for (GridPoint& p : rough.corners) {
        const double shrink = 0.9 + 0.1 * static_cast<double>(random() % 1000) / 1000;
        p = {std::llround(static_cast<double>(p.x) * shrink), std::llround(static_cast<double>(p.y) * shrink)};
    }
    return {test::comb(corners / 4, 100'000),
            test::comb(corners / 4, 100'000, 90'000),
            test::spiral(corners / 2, 40, 100'000),
            test::star(corners / 2, 100'000'000, 10'000'000),
            test::bridgedRing(corners / 2, 100'000'000, 70'000'000),
            rough};
}

/// As many corners as a concave outline may have. Nothing here is timed either.
TEST(Ears, OfTheLongestOutlinesAreCut)
{
    for (const GridPolygon& polygon : longOutlines(static_cast<int>(kMaxConcaveCorners) - 10)) {
        const Cut result = cut(test::inPlane(polygon.corners));
        EXPECT_EQ(result.how, PolygonSplit::Ears) << polygon.name;
        EXPECT_EQ(result.triangles.size(), polygon.corners.size() - 2) << polygon.name;
        expectEveryPointInAsManyTrianglesAsInsideOutlines(polygon, result.triangles, 100);
    }
}

TEST(SelfIntersecting, OutlinesGetAFanAndAreReported)
{
    const std::vector<GridPolygon> polygons{
        {"pentagram", {{1000, 0}, {-809, 588}, {309, -951}, {309, 951}, {-809, -588}}},
        {"bow-tie", {{0, 0}, {10, 10}, {10, 0}, {0, 10}}},
        {"uneven bow-tie", {{0, 0}, {10, 10}, {10, 0}, {0, 7}}},
        {"bow-tie through a corner", {{0, 0}, {5, 5}, {10, 10}, {10, 0}, {5, 5}, {0, 10}}},
        {"walked twice", {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {10, 0}, {10, 10}, {0, 10}}},
        {"loop inside walked the same way", {{0, 0}, {90, 0}, {90, 90}, {0, 90}, {0, 0}, {30, 10}, {60, 60}, {10, 30}}},
        {"band over itself",
         {{0, 0}, {100, 0}, {100, 60}, {40, 60}, {40, -30}, {60, -30}, {60, 40}, {80, 40}, {80, 20}, {0, 20}}},
        {"hole reaching outside", {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {0, 0}, {50, 150}, {60, 20}}},
    };
    for (const GridPolygon& polygon : polygons) {
        const Cut result = cut(test::inPlane(polygon.corners));
        EXPECT_EQ(result.how, PolygonSplit::MendedFan) << polygon.name;
        ASSERT_EQ(result.triangles.size(), polygon.corners.size() - 2) << polygon.name;
        for (std::uint32_t i = 0; i < result.triangles.size(); ++i)
            EXPECT_EQ(result.triangles[i], (PolygonSplitter::Triangle{0, i + 1, i + 2})) << polygon.name;
    }
}

TEST(Degenerate, OutlinesGetAFanAndAreReported)
{
    const std::vector<std::vector<GridPoint>> polygons{{{0, 0}, {1, 1}, {2, 2}, {3, 3}},
                                                       {{5, 5}, {5, 5}, {5, 5}, {5, 5}},
                                                       {{0, 0}, {9, 0}, {3, 0}, {6, 0}, {1, 0}},
                                                       {{0, 0}, {1, 0}, {0, 0}, {1, 0}}};
    for (const auto& corners : polygons) {
        const Cut result = cut(test::inPlane(corners));
        EXPECT_EQ(result.how, PolygonSplit::MendedFan);
        EXPECT_EQ(result.triangles.size(), corners.size() - 2);
    }
}

TEST(Limit, OfConcaveCornersIsKeptAndConvexOnesHaveNone)
{
    static_assert(kMaxConcaveCorners >= 10'000);
    const int above   = static_cast<int>(kMaxConcaveCorners) / 4 + 1;
    const Cut refused = cut(test::inPlane(test::comb(above, 1000).corners));
    EXPECT_EQ(refused.how, PolygonSplit::Refused);
    EXPECT_TRUE(refused.triangles.empty());
}

TEST(NonPlanarQuad, IsCutInItsProjectionAndKeepsAllItsCorners)
{
    const Cut result = cut({{0, 0, 0}, {10, 0, 4}, {3, 3, 0}, {0, 10, 4}});
    EXPECT_EQ(result.how, PolygonSplit::Ears);
    ASSERT_EQ(result.triangles.size(), 2u);
    for (const auto& t : result.triangles)
        EXPECT_NE(std::ranges::find(t, 2u), t.end()) << "the diagonal starts in the dent";
}

TEST(MeshPolygons, TileTheListsOfCornersAndTriangles)
{
    Mesh mesh;
    mesh.materials.push_back({"red", {1, 0, 0}, 1});
    mesh.groups.push_back("wheel");
    mesh.positions = {{0, 0, 0}, {10, 0, 0}, {3, 3, 0}, {0, 10, 0}, {10, 10, 0}, {50, 50, 50}};
    EXPECT_TRUE(mesh.addPolygon(std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_TRUE(mesh.addPolygon(std::array<std::uint32_t, 4>{0, 1, 2, 3}, MaterialId{1}, GroupId{1}));
    EXPECT_FALSE(mesh.addPolygon(std::array<std::uint32_t, 4>{0, 4, 1, 3})) << "a bow-tie is reported";
    EXPECT_EQ(mesh.polygonCount(), 3u);
    EXPECT_EQ(mesh.firstCorner, (std::vector<std::uint32_t>{0, 3, 7, 11}));
    EXPECT_EQ(mesh.firstTriangle, (std::vector<std::uint32_t>{0, 1, 3, 5}));
    EXPECT_EQ(mesh.trianglePolygon, (std::vector<PolygonId>{{0}, {1}, {1}, {2}, {2}}));
    EXPECT_EQ(mesh.mendedFaces, (std::vector<PolygonId>{{2}}));
    EXPECT_TRUE(mesh.isMended(PolygonId{2}) && !mesh.isMended(PolygonId{1}));
    EXPECT_EQ(mesh.materialOf(PolygonId{1}).name, "red");
    EXPECT_EQ(mesh.polygonGroup[1], GroupId{1});
    EXPECT_EQ(mesh.splitFaces, 2u);
    EXPECT_EQ(mesh.polygon(PolygonId{1}).size(), 4u);
    EXPECT_EQ(mesh.bounds().max, dvec3(10, 10, 0)) << "of the positions that a triangle uses";
}

}  // namespace
}  // namespace zscope
