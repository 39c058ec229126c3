// builtin:cubes: a few boxes on a floor, some of them cutting into each other, all faces polygons of four corners;
// builtin:cube: the one they are made of.

#include <cmath>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"

namespace zscope::generated {

namespace {

/// The cube from -1 to 1; faces turn counter-clockwise when seen from outside.
std::shared_ptr<const Mesh> unitCube()
{
    auto cube  = std::make_shared<Mesh>();
    cube->name = "cube";
    for (double z : {-1.0, 1.0})
        for (double y : {-1.0, 1.0})
            for (double x : {-1.0, 1.0}) cube->positions.push_back({x, y, z});
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
        {{4, 5, 7, 6}, {1, 0, 2, 3}, {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}}};
    for (const auto& face : kFaces) cube->addPolygon(face);
    return cube;
}

/// Half sides, then a turn about the vertical and a lean about x (in full turns), then the place.
Affine placed(const dvec3& half, double turn, double lean, const dvec3& at)
{
    const auto [ct, st] = pointOnCircle(turn);
    const auto [cl, sl] = pointOnCircle(lean);
    Affine size, turned, leaned;
    size.rows[0][0] = half.x;
    size.rows[1][1] = half.y;
    size.rows[2][2] = half.z;
    turned.rows[0]  = {ct, 0, st, 0};
    turned.rows[2]  = {-st, 0, ct, 0};
    leaned.rows[1]  = {0, cl, -sl, 0};
    leaned.rows[2]  = {0, sl, cl, 0};
    return compose(Affine::translation(at), compose(turned, compose(leaned, size)));
}

Result<Scene> makeGroup(const Arguments&)
{
    Scene scene;
    scene.meshes.push_back(unitCube());
    const auto add = [&scene](const Affine& where, const Rgb& colour) {
        scene.instances.push_back({MeshId{0}, where, colour});
    };
    add(placed({5.0, 0.1, 3.6}, 0, 0, {0, -0.1, 0}), palette::kGrey);
    add(placed({1, 1, 1}, 0.06, 0, {-1.1, 1, -0.6}), palette::kSky);
    add(placed({0.8, 0.8, 0.8}, 0.15, 0.09, {-0.1, 1.25, 0.2}), palette::kAmber);  // cuts into the blue one
    add(placed({0.6, 1.7, 0.6}, 0.02, 0, {2.1, 1.7, -0.9}), palette::kGreen);
    add(placed({1.5, 0.22, 0.22}, 0.09, 0.03, {2.0, 1.6, -0.5}), palette::kYellow);  // runs through the tower
    add(placed({0.45, 0.45, 0.45}, 0.11, 0, {2.5, 0.45, 1.3}), palette::kVermilion);
    add(placed({0.5, 0.5, 0.5}, 0.03, 0, {-2.9, 0.5, 1.1}), palette::kRose);
    add(placed({0.5, 0.5, 0.5}, 0.03, 0, {-2.5, 0.9, 0.9}), palette::kWhite);  // overlaps, faces parallel

    ViewRequest view;
    view.eye         = dvec3{-4.6, 6.2, 12.2};
    view.target      = dvec3{0, 0.6, 0.2};
    view.verticalFov = 36;
    view.near        = 0.5;
    view.far         = 100;
    scene.views.push_back({"default", view});
    return scene;
}

Result<Scene> makeOne(const Arguments&)
{
    Scene scene;
    scene.meshes.push_back(unitCube());
    scene.instances.push_back({MeshId{0}, Affine{}});
    ViewRequest view;
    view.eye         = dvec3{2.6, 2.4, 4.4};
    view.target      = dvec3{0, 0, 0};
    view.verticalFov = 36;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> cubes()
{
    return {{"cubes", "Boxes on a floor, some cutting into each other", {}, makeGroup},
            {"cube", "One cube, six quads", {}, makeOne}};
}

}  // namespace zscope::generated
