// A batch that is called back-facing has no triangle that the exact arithmetic would draw or drop for another reason,
// however thin its triangles, however they are placed and however near to edge-on they are seen.
#include "core/geometry/normal_cone.h"
#include "core/geometry/facing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/geometry/screen_triangle.h"
#include "core/scene/generators/random.h"

namespace zscope {
namespace {

using Corners = std::array<dvec3, 3>;

struct Patch {
    std::vector<Corners> triangles;
    Bounds               bounds;
    NormalCone           cone;
};

/// A sheet of cells x cells squares over [-1, 1]^2, whose heights vary by up to `rough` and whose lines move by up to
/// `crooked` of a cell, stretched along x and turned.
Patch anyPatch(Random& random, int cells, double rough, double crooked, double stretch)
{
    const Affine       turn = random.rotation();
    std::vector<dvec3> points;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            const double side = 2.0 / cells, shiftX = crooked * random.between(-0.5, 0.5),
                         shiftY = crooked * random.between(-0.5, 0.5);
            points.push_back(
                turn({stretch * ((i + shiftX) * side - 1), (j + shiftY) * side - 1, rough * random.between(-1, 1)}));
        }
    Patch patch;
    for (const dvec3& p : points) patch.bounds.include(p);
    const auto at = [&](int i, int j) { return points[static_cast<std::size_t>(j * (cells + 1) + i)]; };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            patch.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            patch.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    patch.cone = normalConeOf(patch.triangles, 0.5 * patch.bounds.min + 0.5 * patch.bounds.max);
    return patch;
}

Camera lookingAt(const dvec3& eye, const dvec3& target, Random& random)
{
    ViewRequest request;
    request.eye         = eye;
    request.target      = target;
    request.up          = random.rotation()({0, 1, 0});
    request.verticalFov = random.between(5, 120);
    request.width = 1280, request.height = 720;
    request.near = 1e-3, request.far = 1e6;
    return makeCamera(request, Bounds{{-1, -1, -1}, {1, 1, 1}}).value();
}

int turnOf(const Corners& corners, const Affine& toWorld, const Projection& projection)
{
    std::array<ScreenCorner, 3> screen;
    for (std::size_t i = 0; i < 3; ++i) screen[i] = projection.toScreen(projection.toView(toWorld(corners[i])));
    return zscope::turnOf(screen[0], screen[1], screen[2], true);
}

Affine anyPlacement(Random& random, bool mirrors)
{
    Affine       place = random.rotation();
    const double scale = std::pow(10.0, random.between(-2, 2));
    for (auto& row : place.rows) {
        for (std::size_t c = 0; c < 3; ++c)
            row[c] *= scale * (c == 0 ? (mirrors ? -1 : 1) * random.between(0.5, 2) : 1);
        row[3] = random.between(-5, 5);
    }
    return place;
}

struct ConeVerdicts {
    int asked = 0, called = 0, missed = 0;
};

void expectAllBackWhereCalled(const Patch& patch, const Affine& toWorld, const Camera& camera, ConeVerdicts& tally)
{
    const Projection projection(camera);
    const PlacedView view(projection, toWorld);
    const Facing     facing{FaceCulling::Back, toWorld.isMirrored()};
    const bool       called  = BackFaces(view, projection, facing.isMirrored).hold(patch.cone, view(patch.bounds));
    const bool       areBack = std::ranges::all_of(
              patch.triangles, [&](const Corners& t) { return facing.isCulled(turnOf(t, toWorld, projection)); });
    ASSERT_TRUE(areBack || !called);
    ++tally.asked;
    tally.called += called;
    tally.missed += areBack && !called;
}

TEST(NormalCone, ABatchIsCalledBackFacingOnlyIfEveryTriangleIsAfterSnapping)
{
    Random       random(11);
    ConeVerdicts all;
    for (int i = 0; i < 30'000; ++i) {
        const double rough   = random.below(3) == 0 ? 0 : std::pow(10.0, random.between(-6, -0.5));
        const double stretch = random.below(3) == 0 ? std::pow(10.0, random.between(-5, 2)) : 1;
        const Patch  patch   = anyPatch(random, 1 + static_cast<int>(random.below(6)), rough, random.unit(), stretch);
        const Affine toWorld = anyPlacement(random, i % 3 == 0);
        // Behind the sheet, from straight behind to all but edge-on.
        const dvec3  axis   = patch.cone.promises() ? patch.cone.axis : random.rotation()({1, 0, 0});
        const dvec3  middle = toWorld({0, 0, 0}), back = toWorld(-1.0 * axis) - middle;
        const dvec3  aside = random.rotation()({1, 0, 0});
        const double away  = std::pow(10.0, random.between(0.3, 3)),
                     slant = random.below(2) == 0 ? std::pow(10.0, random.between(-4, 0)) : 1;
        const dvec3 eye =
            middle + back * (away * slant)
            + aside * (away * random.unit() * std::sqrt(back.x * back.x + back.y * back.y + back.z * back.z));
        expectAllBackWhereCalled(patch, toWorld, lookingAt(eye, middle, random), all);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(all.called, 3'000) << "of " << all.asked << ", missed " << all.missed;
    EXPECT_GT(all.missed, 100) << "where snapping might turn one over it says no, as of any that it is not sure of";
}

TEST(NormalCone, SaysYesOfMostThatAreSeenFromWellBehind)
{
    Random       random(12);
    ConeVerdicts all;
    for (int i = 0; i < 2'000; ++i) {
        const Patch patch = anyPatch(random, 8, 0.02, 0.3, 1);
        const dvec3 eye   = patch.cone.axis * -10.0 + random.between(dvec3{-4, -4, -4}, dvec3{4, 4, 4});
        Affine      placement;
        if (i % 2 == 0) placement.rows[1][1] = -1;
        expectAllBackWhereCalled(patch, placement, lookingAt(placement(eye), {0, 0, 0}, random), all);
    }
    EXPECT_GT(all.called, 1'800);
}

TEST(NormalCone, PromisesNothingOfWhatHasNoAreaReachesBeforeTheNearPlaneOrIsSeenByAMirroredCamera)
{
    Random       random(13);
    const Patch  flat   = anyPatch(random, 3, 0, 0, 1);
    const Camera behind = lookingAt(flat.cone.axis * -10.0, {0, 0, 0}, random);
    ConeVerdicts tally;
    expectAllBackWhereCalled(flat, Affine{}, behind, tally);
    EXPECT_EQ(tally.called, 1) << "the plain case";

    const Corners line{dvec3{0, 0, 0}, dvec3{1, 0, 0}, dvec3{2, 0, 0}};
    EXPECT_TRUE(normalConeOf(flat.triangles, {0, 0, 0}).promises());
    EXPECT_FALSE(normalConeOf(std::vector{flat.triangles[0], line}, {0, 0, 0}).promises());

    Camera mirror = behind;
    mirror.right  = -behind.right;
    const Projection through(mirror);
    const PlacedView mirrored(through, Affine{});
    EXPECT_FALSE(BackFaces(mirrored, through, false).hold(flat.cone, mirrored(flat.bounds)));

    const Projection projection(behind);
    const PlacedView around(projection, Affine::translation(behind.eye));
    EXPECT_FALSE(BackFaces(around, projection, false).hold(flat.cone, around(flat.bounds)));
}

}  // namespace
}  // namespace zscope
