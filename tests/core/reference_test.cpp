// The brute-force reference against pictures worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/measure/definition.h"
#include "core/measure/reference.h"
#include "core/measure/verify.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// A triangle by its corners in pixels, at one distance.
Corners flat(const Camera& camera, std::array<std::array<double, 2>, 3> xy, double z = 1)
{
    return {pointAt(camera, xy[0][0], xy[0][1], z), pointAt(camera, xy[1][0], xy[1][1], z),
            pointAt(camera, xy[2][0], xy[2][1], z)};
}

Picture draw(const Camera& camera, const std::vector<Corners>& triangles, FaceCulling culling = FaceCulling::None)
{
    auto picture = referencePicture(*sceneOf(triangles), camera, culling);
    EXPECT_TRUE(picture.ok());
    return *std::move(picture);
}

/// The ids as rows of digits, '.' for background.
std::vector<std::string> rowsOf(const Picture& picture)
{
    std::vector<std::string> rows;
    for (int y = 0; y < picture.ids.height(); ++y) {
        rows.emplace_back();
        for (const std::int64_t id : picture.ids.view().row(y))
            rows.back() += id < 0 ? '.' : static_cast<char>('0' + id);
    }
    return rows;
}

TEST(Reference, DrawsASquareOnPixelCentresAs15And10Pixels)
{
    const Camera camera  = plainCamera(8, 8);
    const auto   picture = draw(camera, {flat(camera, {{{1.5, 1.5}, {6.5, 1.5}, {6.5, 6.5}}}),
                                         flat(camera, {{{1.5, 1.5}, {6.5, 6.5}, {1.5, 6.5}}})});
    EXPECT_EQ(rowsOf(picture), (std::vector<std::string>{"........", ".00000..", ".10000..", ".11000..", ".11100..",
                                                         ".11110..", "........", "........"}));
    EXPECT_EQ(picture.depth.at(1, 1), 1.0f);
    EXPECT_EQ(picture.depth.at(0, 0), 0.0f);
}

TEST(Reference, OwnsTheLeftAndTopBorderAndLeavesTheRightAndBottomOne)
{
    const Camera camera = plainCamera(4, 4);
    // Corners on centres (1.5, 1.5), (3.5, 1.5), (1.5, 3.5): the top row and left column belong, the diagonal not.
    const std::vector<std::string> wanted{"....", ".00.", ".0..", "...."};
    EXPECT_EQ(rowsOf(draw(camera, {flat(camera, {{{1.5, 1.5}, {3.5, 1.5}, {1.5, 3.5}}})})), wanted);
    EXPECT_EQ(rowsOf(draw(camera, {flat(camera, {{{1.5, 3.5}, {3.5, 1.5}, {1.5, 1.5}}})})), wanted) << "turned round";
}

TEST(Reference, CullsTrianglesThatTurnClockwiseOnTheScreen)
{
    const Camera camera    = plainCamera(4, 4);
    const auto   clockwise = flat(camera, {{{0, 0}, {4, 0}, {0, 4}}});
    const auto   counter   = flat(camera, {{{0, 0}, {0, 4}, {4, 0}}});
    EXPECT_EQ(draw(camera, {clockwise}, FaceCulling::Back).ids.at(0, 0), -1);
    EXPECT_EQ(draw(camera, {counter}, FaceCulling::Back).ids.at(0, 0), 0);
    EXPECT_EQ(draw(camera, {clockwise}, FaceCulling::None).ids.at(0, 0), 0);
}

TEST(Reference, ShowsTheNearestAndOfEqualDepthsTheLowestId)
{
    const Camera camera  = plainCamera(4, 4);
    const auto   whole   = [&](double z) { return flat(camera, {{{-20, -20}, {40, -20}, {-20, 40}}}, z); };
    const auto   picture = draw(camera, {whole(4), whole(2), whole(2), whole(8)});
    EXPECT_EQ(picture.ids.at(2, 2), 1);
    EXPECT_EQ(picture.depth.at(2, 2), 0.5f);
}

TEST(Reference, InterpolatesDepthOverTheUnsnappedPlane)
{
    const Camera camera = plainCamera(4, 4);
    // Depth 1 at x = 0, 1/2 at x = 4, whatever y: affine in x, so 1 - x/8.
    const Corners tilted{pointAt(camera, 0, 0, 1), pointAt(camera, 4, 0, 2), pointAt(camera, 0, 4, 1)};
    const auto    picture = draw(camera, {tilted});
    EXPECT_EQ(picture.depth.at(0, 0), 1 - 0.5f / 8);
    EXPECT_EQ(picture.depth.at(2, 0), 1 - 2.5f / 8);
    EXPECT_EQ(picture.depth.at(0, 2), 1 - 0.5f / 8);
}

TEST(Reference, KeepsASampleExactlyOnTheFarPlane)
{
    Camera     camera = plainCamera(4, 4);
    const auto seen   = [&](double far) {
        camera.far = far;
        return draw(camera, {flat(camera, {{{-20, -20}, {40, -20}, {-20, 40}}}, 4)}).ids.at(1, 1) == 0;
    };
    EXPECT_TRUE(seen(4));
    EXPECT_TRUE(seen(4 * (1 + 0x1p-22)));
    EXPECT_FALSE(seen(4 * (1 - 0x1p-22)));
    EXPECT_TRUE(seen(std::numeric_limits<double>::infinity()));
}

TEST(Reference, CutsAtTheNearPlaneAndJoinsThePartsWithoutAGap)
{
    const Camera camera = plainCamera(8, 8);
    const auto   below  = [](double z) { return dvec3{0, -1, z}; };
    // A floor strip one unit below the eye, from behind it to far in front: everything under the horizon's wedge.
    const Corners oneInside{below(9), dvec3{-40, -1, -9}, dvec3{40, -1, -9}};
    const Corners twoInside{dvec3{-40, -1, 9}, dvec3{40, -1, 9}, below(-9)};
    for (const Corners& corners : {oneInside, twoInside}) {
        std::vector<definition::Part> parts;
        const definition::View        view(camera, FaceCulling::None);
        const auto                    scene = sceneOf(std::vector<Corners>{corners});
        EXPECT_EQ(definition::partsOf(*scene, InstanceId{0}, 0, view, parts), definition::Fate::Drawn);
        EXPECT_EQ(parts.size(), corners == oneInside ? 1u : 2u);
        int covered = 0;
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) {
                int times = 0;
                for (const auto& part : parts) times += part.covers(x, y);
                EXPECT_LE(times, 1);
                covered += times;
                if (times > 0) {
                    EXPECT_GE(y, 4) << "above the horizon";
                }
            }
        }
        EXPECT_GT(covered, 0);
    }
}

TEST(Reference, CountsWhatBecameOfEveryTriangle)
{
    const Camera camera = plainCamera(8, 8);
    const auto   scene  = sceneOf(std::vector<Corners>{
           flat(camera, {{{0, 0}, {0, 4}, {4, 0}}}),                                             // drawn
           flat(camera, {{{0, 0}, {4, 0}, {0, 4}}}),                                             // back
           flat(camera, {{{0, 0}, {4, 0}, {8, 0}}}),                                             // no area
           {dvec3{0, 0, 0.5}, dvec3{1, 0, 0.5}, dvec3{0, 1, -4}},                                // behind
           {dvec3{1e300, 0, 1}, dvec3{0, 1, 1}, dvec3{0, 0, 1}},                                 // beyond the grid
           {dvec3{1e308, 1e308, 1e308}, dvec3{-1e308, 1e308, 1e308}, dvec3{0, -1e308, -1e308}},  // overflows on the way
    });
    const auto   fates  = referenceFates(*scene, camera, FaceCulling::Back);
    ASSERT_TRUE(fates.ok());
    EXPECT_EQ(*fates, (TriangleFates{.drawn = 1, .culled = 1, .degenerate = 1, .outOfRange = 2, .behindNear = 1}));
    const auto picture = referencePicture(*scene, camera, FaceCulling::Back);
    for (const std::int64_t id : picture->ids.values()) EXPECT_LE(id, 0);
}

std::vector<definition::Part> partsOf(const Camera& camera, const Corners& corners)
{
    std::vector<definition::Part> parts;
    definition::partsOf(*sceneOf(std::vector<Corners>{corners}), InstanceId{0}, 0,
                        definition::View(camera, FaceCulling::None), parts);
    return parts;
}

TEST(Reference, SnapsTiesToTheEvenGridPoint)
{
    const Camera camera = plainCamera(4, 4);
    const auto   parts  = partsOf(camera, flat(camera, {{{2.5 / 256, 3.5 / 256}, {4, 0}, {-2.5 / 256, 4}}}));
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].corners()[0].xs, 2);
    EXPECT_EQ(parts[0].corners()[0].ys, 4);
    EXPECT_EQ(parts[0].corners()[2].xs, -2);
}

TEST(Reference, ProjectsInTheWrittenOrder)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Camera camera   = plainCamera(1023, 769);
        camera.focal    = 1 + 0.1 / static_cast<double>(seed);  // not a power of two: another order rounds elsewhere
        camera.near     = 0.3;
        const double  s = 1 / static_cast<double>(2 * seed + 1);
        const Corners corners{dvec3{s, 0.7, 1.1}, dvec3{-0.3, s, 1.3}, dvec3{0.2, -0.4, 1.7 + s}};
        const auto    parts = partsOf(camera, corners);
        ASSERT_EQ(parts.size(), 1u);
        const double k = ((769 * 0.5) * camera.focal) / camera.near;
        for (std::size_t i = 0; i < 3; ++i) {
            const double depth = camera.near / corners[i].z;
            EXPECT_EQ(parts[0].corners()[i].depth, depth);
            EXPECT_EQ(parts[0].corners()[i].x, 1023 * 0.5 + (corners[i].x * depth) * k);
            EXPECT_EQ(parts[0].corners()[i].y, 769 * 0.5 - (corners[i].y * depth) * k);
        }
    }
}

TEST(Reference, CutsAnEdgeAtTheSamePointWhicheverWayItIsListed)
{
    Camera camera = plainCamera(640, 480);
    camera.near   = 0.3;
    for (int i = 1; i <= 50; ++i) {
        const double s = 1.0 / (2 * i + 1);
        const dvec3  inside{s, 0.2, 0.9 + s}, left{-0.4, s, 0.1 - s}, right{0.7 - s, -0.1, -0.2};
        const auto   cutsOf = [&](const Corners& corners) {
            std::vector<std::array<double, 2>> cuts;
            for (const auto& part : partsOf(camera, corners)) {
                for (const auto& c : part.corners()) {
                    if (c.depth == 1) cuts.push_back({c.x, c.y});
                }
            }
            std::ranges::sort(cuts);
            return cuts;
        };
        const auto cuts = cutsOf({inside, left, right});
        ASSERT_EQ(cuts.size(), 2u);
        EXPECT_EQ(cutsOf({right, left, inside}), cuts);
    }
}

TEST(Reference, TakesTheSnappedPlaneOfPartsTooThinToHaveTheirOwn)
{
    const Camera             camera = plainCamera(1024, 1024);
    const definition::Corner a{.x = 0, .y = 0, .depth = 0.25, .xs = 0, .ys = 0};
    const definition::Corner b{.x = 0, .y = 4, .depth = 0.5, .xs = 0, .ys = 1024};
    const auto apex = [](double x) { return definition::Corner{.x = x, .y = 2, .depth = 0.75, .xs = 256, .ys = 512}; };
    // Thinner than 4 / 1024 per 4 pixels: the plane through (0, 0), (0, 4) and the snapped (1, 2).
    EXPECT_EQ(definition::Part({a, b, apex(0x1p-10)}, -1, camera).depth(0, 1), 0.53125f);
    // Just thicker: its own plane is far too steep for a pixel's width, so the limit answers.
    EXPECT_EQ(definition::Part({a, b, apex(0x1.1p-10)}, -1, camera).depth(0, 1), 0.75f);
}

TEST(Reference, LeavesTransparentFacesOutAndKeepsTheirIds)
{
    const Camera camera = plainCamera(4, 4);
    Mesh         mesh;
    mesh.materials.push_back({.name = "glass", .opacity = 0.5f});
    for (const double z : {1.0, 2.0}) {
        for (const auto& p : flat(camera, {{{-20, -20}, {40, -20}, {-20, 40}}}, z)) mesh.positions.push_back(p);
    }
    addFan(mesh, std::array<std::uint32_t, 3>{0, 1, 2});
    addFan(mesh, std::array<std::uint32_t, 3>{3, 4, 5});
    mesh.polygonMaterial[0] = MaterialId{1};
    const auto scene        = sceneOf(std::move(mesh), std::array{Affine{}});
    const auto picture      = referencePicture(*scene, camera, FaceCulling::None);
    EXPECT_EQ(picture->ids.at(1, 1), 1);
    EXPECT_EQ(referenceFates(*scene, camera, FaceCulling::None)->transparent, 1u);
}

TEST(Reference, RunsIdsOnFromInstanceToInstance)
{
    const Camera camera = plainCamera(8, 8);
    Mesh         mesh;
    for (const auto& p : flat(camera, {{{0, 0}, {4, 0}, {0, 8}}})) mesh.positions.push_back(p);
    addFan(mesh, std::array<std::uint32_t, 3>{0, 1, 2});
    const auto scene = sceneOf(std::move(mesh), std::array{Affine{}, Affine::translation({1, 0, 0})});
    const auto rows  = rowsOf(*referencePicture(*scene, camera, FaceCulling::None));
    EXPECT_EQ(rows[0], "00001111") << "the hypotenuse passes x = 3.75, 7.75 on the first row";
}

TEST(Reference, EdgeOnPartsTakeTheirNearestCorner)
{
    // The triangle is a line to float64, but its corners snap to a triangle: no plane, so the depth is the nearest.
    const Camera             camera = plainCamera(1024, 1024);
    const definition::Corner a{.x = 0, .y = 0, .depth = 0.25, .xs = 0, .ys = 0};
    const definition::Corner b{.x = 0, .y = 4, .depth = 0.5, .xs = 0, .ys = 1024};
    const definition::Corner c{.x = 4, .y = 4, .depth = 0.75, .xs = 0, .ys = 1024};
    const definition::Part   part({a, b, c}, 1, camera);
    EXPECT_NE(part.depth(0, 0), 0.75f) << "this one has a plane";
    const definition::Corner d{.x = 0, .y = 2, .depth = 0.75, .xs = 0, .ys = 512};
    EXPECT_EQ(definition::Part({a, b, d}, 1, camera).depth(0, 0), 0.75f);
}

TEST(Reference, SamplesAndCoveringTrianglesAgreeWithThePicture)
{
    for (const SoupKind kind : soupKinds()) {
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            const Soup soup = makeSoup(kind, 11, 67, 41);
            SCOPED_TRACE(soup.what);
            const auto                 picture = referencePicture(*soup.scene, soup.camera, culling);
            std::vector<PixelPosition> points;
            for (int y = 0; y < 41; ++y) {
                for (int x = 0; x < 67; ++x) points.push_back({x, y});
            }
            std::swap(points.front(), points.back());  // the order is the caller's
            points.push_back(points[100]);             // and a point may come twice
            const auto samples = referenceSamples(*soup.scene, soup.camera, culling, points);
            ASSERT_TRUE(picture.ok() && samples.ok());
            for (std::size_t i = 0; i < points.size(); ++i) {
                const auto [x, y] = points[i];
                ASSERT_EQ(samples.value()[i], (SampleTruth{picture->ids.at(x, y), picture->depth.at(x, y)}));
            }
            for (const PixelPosition p : randomPixels(soup.camera, 40, 3)) {
                const auto covering = coveringTriangles(*soup.scene, soup.camera, culling, p);
                ASSERT_TRUE(covering.ok());
                SampleTruth winner;
                for (std::size_t i = 0; i < covering->size(); ++i) {
                    const CoveringTriangle& c = covering.value()[i];
                    if (c.kept && winner.id < 0) winner = {c.triangle.value, c.depth};
                    if (i > 0) {
                        const CoveringTriangle& before = covering.value()[i - 1];
                        EXPECT_TRUE(before.depth > c.depth
                                    || (before.depth == c.depth && before.triangle < c.triangle));
                    }
                }
                ASSERT_EQ(winner, (SampleTruth{picture->ids.at(p.x, p.y), picture->depth.at(p.x, p.y)}));
            }
        }
    }
}

TEST(Reference, ReachOfAnInstanceHoldsTheBoxesOfAllItsParts)
{
    for (const SoupKind kind : {SoupKind::Turned, SoupKind::Dust, SoupKind::Slivers, SoupKind::BeyondTheGuard}) {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Soup  soup = makeSoup(kind, seed, 640, 480, 20);
            const Mesh& mesh = *soup.scene->meshes[0];
            // A mesh of one triangle each, so that the reach is tight and off by one would show.
            const definition::View        view(soup.camera, FaceCulling::None);
            std::vector<definition::Part> parts;
            for (std::uint32_t i = 0; i < soup.scene->instances.size(); ++i) {
                for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
                    Bounds box;
                    for (const std::uint32_t v : mesh.triangles[t]) box.include(mesh.positions[v]);
                    const auto reach = definition::reachOf(box, soup.scene->instances[i].toWorld, view);
                    definition::partsOf(*soup.scene, InstanceId{i}, t, view, parts);
                    for (const auto& part : parts) {
                        if (part.box().isEmpty()) continue;
                        EXPECT_TRUE(reach.holds(part.box().x0, part.box().y0)) << soup.what;
                        EXPECT_TRUE(reach.holds(part.box().x1, part.box().y1)) << soup.what;
                    }
                }
            }
        }
    }
}

TEST(Reference, SkipsInstancesThatCannotReachAPixel)
{
    const Camera           camera = plainCamera(64, 64);
    const Bounds           ball{.min = {-0.1, -0.1, 3.9}, .max = {0.1, 0.1, 4.1}};
    const definition::View view(camera, FaceCulling::None);
    const auto             reach = definition::reachOf(ball, Affine{}, view);
    EXPECT_GE(reach.x0, 30);
    EXPECT_LE(reach.x1, 33);
    EXPECT_TRUE(definition::reachOf(ball, Affine::translation({0, 0, -8}), view).isEmpty()) << "behind the eye";
    EXPECT_TRUE(definition::reachOf(ball, Affine::translation({9, 0, 0}), view).isEmpty()) << "beside the picture";
    EXPECT_TRUE(definition::reachOf(ball, Affine::translation({0, 0, -3}), view).holds(0, 63)) << "cuts the near plane";
}

TEST(Reference, CanBeCancelled)
{
    const Soup              soup = makeSoup(SoupKind::Loose, 1, 16, 16);
    const std::atomic<bool> cancel{true};
    const auto picture = referencePicture(*soup.scene, soup.camera, FaceCulling::None, {.cancel = &cancel});
    ASSERT_FALSE(picture.ok());
    EXPECT_EQ(picture.error().kind, Trouble::Cancelled);
}

}  // namespace
}  // namespace zscope::tests
