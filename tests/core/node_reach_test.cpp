// What a box could touch: never less than what its points do touch, at any scale, offset, placement and angle; and not
// much more where numbers are ordinary. Rules 1 and 4 of docs/correctness.md, section 5.
#include "core/cull/node_reach.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/scene/generators/random.h"

namespace zscope {
namespace {

constexpr PixelBox kEverywhere{-100'000'000, -100'000'000, 100'000'000, 100'000'000};

Camera turnedCamera(Random& random, const dvec3& eye, double fovDegrees, double near)
{
    const Affine turn = random.rotation();
    Camera       camera;
    camera.eye     = eye;
    camera.right   = turn({1, 0, 0});
    camera.up      = turn({0, 1, 0});
    camera.forward = turn({0, 0, 1});
    camera.focal   = 1 / std::tan(fovDegrees * 0.008726646259971648);
    camera.near    = near;
    camera.width   = 1280;
    camera.height  = 720;
    return camera;
}

double powerOfTen(Random& random, double low, double high) { return std::pow(10.0, random.between(low, high)); }

/// Points of the box: its corners, and some on its sides and inside.
std::vector<dvec3> pointsOf(const Bounds& box, Random& random)
{
    std::vector<dvec3> points;
    for (int i = 0; i < 8; ++i)
        points.push_back({i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z});
    for (int i = 0; i < 12; ++i) {
        dvec3 p = random.between(box.min, box.max);
        for (int k = 0; k < 3; ++k) {
            if (random.below(3) == 0) p[k] = random.below(2) ? box.min[k] : box.max[k];
            p[k] = std::clamp(p[k], box.min[k], box.max[k]);
        }
        points.push_back(p);
    }
    return points;
}

struct Coverage {
    int crossing = 0, inFront = 0, narrowed = 0;
};

/// A point's place on the screen, and how near it is.
void expectHolds(const NodeReach& reach, const ScreenCorner& corner)
{
    ASSERT_LE(static_cast<float>(corner.d), reach.nearest);
    if (!(std::abs(corner.xs) < kSnapLimit && std::abs(corner.ys) < kSnapLimit)) return;
    const int x = std::clamp(firstPixelCentreFrom(corner.xs), kEverywhere.x0, kEverywhere.x1);
    const int y = std::clamp(firstPixelCentreFrom(corner.ys), kEverywhere.y0, kEverywhere.y1);
    ASSERT_GE(x, reach.pixels.x0);
    ASSERT_LE(x, reach.pixels.x1);
    ASSERT_GE(y, reach.pixels.y0);
    ASSERT_LE(y, reach.pixels.y1);
}

/// What lies in the box and in a ball about its middle.
void expectBallCovers(const NodeReach& ofBox, const Bounds& box, const Affine& toWorld, const Projection& projection,
                      Random& random, Coverage& tally)
{
    const dvec3      middle = 0.5 * box.min + 0.5 * box.max, half = 0.5 * box.max - 0.5 * box.min;
    const double     radius = ballRadius(glm::dot(half, half)) * random.between(0.3, 1);
    const PlacedView view(projection, toWorld);
    const NodeReach  reach      = narrowedToBall(ofBox, view(box), radius * view.longest(), projection);
    const bool       isNarrower = reach.pixels != ofBox.pixels || reach.nearest != ofBox.nearest;
    tally.narrowed += isNarrower;
    for (int i = 0; i < 20; ++i) {
        const dvec3 aside = random.rotation()({radius * (1 - 1e-11), 0, 0});
        const dvec3 p     = glm::clamp(middle + aside, box.min, box.max);
        if (!(glm::distance(p, middle) <= radius)) continue;
        expectHolds(reach, projection.toScreen(projection.toView(toWorld(p))));
        if (testing::Test::HasFatalFailure()) return;
    }
}

void expectCovers(const Bounds& box, const Affine& toWorld, const Camera& camera, Random& random, Coverage& tally)
{
    const Projection projection(camera);
    const NodeReach  reach = reachOf(box, toWorld, projection, kEverywhere);
    const NodeReach  seen  = reachOf(box, toWorld, projection, {0, 0, camera.width, camera.height});
    ASSERT_EQ(reach.crossesNear, seen.crossesNear);
    if (reach.crossesNear) {
        ASSERT_EQ(reach.pixels, kEverywhere) << "it may cover anything";
        ASSERT_EQ(reach.nearest, 1.0f);
        ++tally.crossing;
        return;
    }
    ++tally.inFront;
    for (const dvec3& p : pointsOf(box, random)) {
        const dvec3 view = projection.toView(toWorld(p));
        ASSERT_GE(view.z, camera.near) << "it said that nothing lies before the near plane";
        expectHolds(reach, projection.toScreen(view));
        if (testing::Test::HasFatalFailure()) return;
    }
    expectBallCovers(reach, box, toWorld, projection, random, tally);
    ASSERT_EQ(seen.pixels.x0, std::max(0, reach.pixels.x0));
    ASSERT_EQ(seen.pixels.y1, std::min(camera.height, reach.pixels.y1));
}

Affine anyPlacement(Random& random, double scale)
{
    Affine place;
    for (auto& row : place.rows)
        for (std::size_t c = 0; c < 3; ++c) row[c] = random.between(-1, 1) * scale;  // turned, sheared, mirrored
    return place;
}

TEST(NodeReach, IsNeverSmallerThanWhatThePointsOfTheBoxTouch)
{
    Random   random(1);
    Coverage tally;
    for (int i = 0; i < 60'000; ++i) {
        const double scale  = powerOfTen(random, -7, 7);
        const double fov    = random.below(4) == 0 ? 0.01 : random.below(4) == 0 ? 179 : random.between(5, 150);
        const double offset = random.below(3) == 0 ? scale * 1e6 : random.below(3) == 0 ? scale * 1e9 : 0;
        const dvec3  origin{offset, -0.7 * offset, 0.3 * offset};
        Camera       camera = turnedCamera(random, origin, fov, scale * powerOfTen(random, -5, 0));
        const double far    = scale * powerOfTen(random, -1, fov < 1 ? 4 : 2);
        const dvec3  middle =
            origin + camera.forward * far + random.between(dvec3{-1, -1, -1}, dvec3{1, 1, 1}) * (far * 0.5);
        const double half = random.below(8) == 0 ? 0 : far * powerOfTen(random, -6, 0.1);
        if (random.below(4) == 0) {  // a camera file may hold axes of any length
            const double axis = powerOfTen(random, -2, 7);
            for (dvec3* each : {&camera.right, &camera.up, &camera.forward}) *each *= axis;
            camera.near *= axis;
        }
        const bool placed = random.below(2) == 0;
        Bounds     box{middle - half * random.unit(), middle + half * random.unit()};
        Affine     toWorld;
        if (placed) {  // the box about the origin of its own space, which is put at `middle`
            const double size = powerOfTen(random, -3, 3);
            toWorld           = anyPlacement(random, half / size);
            for (int k = 0; k < 3; ++k) toWorld.rows[static_cast<std::size_t>(k)][3] = middle[k];
            box = {dvec3{-size, -size, -size} * random.unit(), dvec3{size, size, size} * random.unit()};
        }
        expectCovers(box, toWorld, camera, random, tally);
        if (testing::Test::HasFatalFailure()) FAIL() << "in round " << i;
    }
    EXPECT_GT(tally.crossing, 2000);
    EXPECT_GT(tally.inFront, 20'000);
    EXPECT_GT(tally.narrowed, 10'000);
}

TEST(NodeReach, E8ABoxAboutTheNearPlaneOrTheEyeCrossesIt)
{
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        const Camera camera = turnedCamera(random, random.between(dvec3{-9, -9, -9}, dvec3{9, 9, 9}), 60, 0.5);
        const auto   box    = [&](double z, double half) {
            const dvec3 middle = camera.eye + camera.forward * z;
            return Bounds{middle - half, middle + half};
        };
        const auto reach = [&](const Bounds& b) { return reachOf(b, Affine{}, Projection(camera), {0, 0, 1280, 720}); };
        EXPECT_TRUE(reach(box(0, 1)).crossesNear) << "the eye inside";
        EXPECT_TRUE(reach(box(0, 0)).crossesNear) << "the eye itself";
        EXPECT_TRUE(reach(box(0.5, 0.01)).crossesNear);
        EXPECT_TRUE(reach(box(-5, 1)).crossesNear) << "wholly behind: no bounds either";
        EXPECT_FALSE(reach(box(0.6, 0.01)).crossesNear);
        // Touching the plane up to rounding may be called either way, but then must be right.
        Coverage tally;
        expectCovers(box(0.5 + 0x1p-52, 0), Affine{}, camera, random, tally);
    }
}

TEST(NodeReach, IsNotMuchLargerThanTheBoxWhereNumbersAreOrdinary)
{
    Random random(3);
    int    checked = 0;
    for (int i = 0; i < 5000; ++i) {
        const Camera     camera = turnedCamera(random, {1, 2, 3}, random.between(20, 90), 0.1);
        const Projection projection(camera);
        const dvec3      middle = camera.eye + camera.forward * random.between(5, 50);
        const Bounds     box{middle - random.between(0, 1), middle + random.between(0, 1)};
        const NodeReach  reach = reachOf(box, Affine{}, projection, kEverywhere);
        ASSERT_FALSE(reach.crossesNear);
        double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9, nearest = 0;
        for (int k = 0; k < 8; ++k) {
            const auto c = projection.toScreen(projection.toView(
                {k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z}));
            x0 = std::min(x0, c.x), x1 = std::max(x1, c.x), y0 = std::min(y0, c.y), y1 = std::max(y1, c.y);
            nearest = std::max(nearest, c.d);
        }
        EXPECT_LE(x0 - 1, reach.pixels.x0);
        EXPECT_GE(x1 + 1, reach.pixels.x1);
        EXPECT_LE(y0 - 1, reach.pixels.y0);
        EXPECT_GE(y1 + 1, reach.pixels.y1);
        EXPECT_LE(reach.nearest, static_cast<float>(nearest) * 1.000001f);
        ++checked;
    }
    EXPECT_EQ(checked, 5000);
}

TEST(NodeReach, OfABallThatIsTurnedIsTheBallsOwn)
{
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        Camera      camera = turnedCamera(random, {1, 2, 3}, 60, 0.1);
        Affine      turned = random.rotation();
        const dvec3 middle = camera.eye + camera.forward * 10.0;
        for (int k = 0; k < 3; ++k) turned.rows[static_cast<std::size_t>(k)][3] = middle[k];
        const Projection projection(camera);
        const PlacedView view(projection, turned);
        const ViewBox    box   = view(Bounds{{-1, -1, -1}, {1, 1, 1}});
        const NodeReach  reach = narrowedToBall(reachOf(box, projection, kEverywhere), box, view.longest(), projection);
        const double     most  = 2 * projection.pixelsPerSlope() / 9 + 2;  // its near side is 9 away
        EXPECT_LE(reach.pixels.x1 - reach.pixels.x0, most);
        EXPECT_LE(reach.pixels.y1 - reach.pixels.y0, most);
        EXPECT_LE(reach.nearest, 1.000001 * projection.depthAtOne / 9);
    }
}

TEST(NodeReach, D6ABoxBetweenPixelCentresOrBesideThePictureTouchesNothing)
{
    Camera camera;  // at z = 1 one unit is one pixel
    camera.width = camera.height = 64;
    camera.focal = 2.0 / 64, camera.near = 0.25;
    const Projection projection(camera);
    const PixelBox   picture{0, 0, 64, 64};
    const auto       reach = [&](double x0, double y0, double x1, double y1) {  // in pixels
        return reachOf({{x0 - 32, 32 - y1, -1}, {x1 - 32, 32 - y0, -1}}, Affine{}, projection, picture).pixels;
    };
    EXPECT_TRUE(reach(10.6, 10.6, 11.4, 11.4).isEmpty()) << "no centre";
    EXPECT_FALSE(reach(10.6, 10.6, 11.6, 11.6).isEmpty());
    EXPECT_FALSE(reach(10.501, 10.501, 11.4, 11.4).isEmpty()) << "may snap onto a centre";
    EXPECT_TRUE(reach(70, 10, 90, 20).isEmpty());
    EXPECT_TRUE(reach(10, -20, 20, -1).isEmpty());
    EXPECT_EQ(reach(-5, -5, 8, 8), (PixelBox{0, 0, 8, 8})) << "partly outside: the inside part";
    EXPECT_EQ(reach(60, 60, 80, 80), (PixelBox{60, 60, 64, 64}));
}

}  // namespace
}  // namespace zscope
