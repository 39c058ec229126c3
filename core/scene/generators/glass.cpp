// builtin:glass: transparent things that no order of drawing gets right: panes that cross each other, balls of glass
// that overlap, panes in one plane, and opaque balls among them.

#include <array>

#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"
#include "core/scene/generators/soccer_ball.h"

namespace zscope::generated {

namespace {

Affine ballAt(const dvec3& at, double radius)
{
    Affine toWorld;
    for (std::size_t i = 0; i < 3; ++i) {
        toWorld.rows[i]    = {0, 0, 0, at[static_cast<int>(i)]};
        toWorld.rows[i][i] = radius;
    }
    return toWorld;
}

/// Upright panes through the origin, turned about the vertical axis, and a table for all to stand on.
std::shared_ptr<const Mesh> panes()
{
    auto mesh       = std::make_shared<Mesh>();
    mesh->name      = "panes";
    mesh->materials = {{"table", {0.55f, 0.48f, 0.40f}},
                       {"red glass", {0.85f, 0.10f, 0.12f}, 0.4f},
                       {"green glass", {0.10f, 0.70f, 0.25f}, 0.35f},
                       {"blue glass", {0.12f, 0.25f, 0.90f}, 0.5f},
                       {"smoked glass", {0.05f, 0.05f, 0.05f}, 0.7f}};
    const auto quad = [&mesh](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d, std::uint32_t material) {
        const auto first = static_cast<std::uint32_t>(mesh->positions.size());
        mesh->positions.insert(mesh->positions.end(), {a, b, c, d});
        mesh->addPolygon(std::array{first, first + 1, first + 2, first + 3}, MaterialId{material});
    };
    quad({-5, -1, 4}, {5, -1, 4}, {5, -1, -5}, {-5, -1, -5}, 0);
    // half a pane's length in x, z
    constexpr std::array<std::array<double, 2>, 3> kAlong{{{3, 0.5}, {-1.5, 2.5}, {1.75, 2.25}}};
    for (std::uint32_t i = 0; i < kAlong.size(); ++i) {
        const auto [x, z] = kAlong[i];
        quad({-x, -1, -z}, {x, -1, z}, {x, 2, z}, {-x, 2, -z}, i + 1);
    }
    // Two in one plane: equal depths, the lower id lies in front.
    quad({-4, 0, 1.5}, {-1, 0, 1.5}, {-1, 2.5, 1.5}, {-4, 2.5, 1.5}, 4);
    quad({-3, -0.5, 1.5}, {-0.5, -0.5, 1.5}, {-0.5, 1.5, 1.5}, {-3, 1.5, 1.5}, 1);
    return mesh;
}

Result<Scene> make(const Arguments&)
{
    auto glass  = std::make_shared<Mesh>(*makeSoccerBall());
    glass->name = "ball of glass";
    for (Material& material : glass->materials) material.opacity = 0.3f;

    Scene scene;
    scene.meshes = {panes(), makeSoccerBall(), std::move(glass)};
    scene.instances.push_back({MeshId{0}, Affine{}});
    scene.instances.push_back({MeshId{1}, ballAt({1.2, -0.4, -0.8}, 0.6), palette::colourOfNumber(1)});
    scene.instances.push_back({MeshId{1}, ballAt({-2, -0.5, 0.4}, 0.5), palette::colourOfNumber(2)});
    scene.instances.push_back({MeshId{2}, ballAt({0.4, 0, 1.6}, 0.9), palette::colourOfNumber(3)});
    scene.instances.push_back({MeshId{2}, ballAt({1.1, 0.3, 1.1}, 0.8), palette::colourOfNumber(4)});
    scene.instances.push_back({MeshId{2}, ballAt({0.4, 0, 1.6}, 0.5), palette::colourOfNumber(5)});  // inside another
    ViewRequest view;
    view.eye    = dvec3{0.6, 1.6, 7};
    view.target = dvec3{0, 0.3, 0};
    view.near   = 0.1;
    view.far    = 100;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> glass()
{
    return {{.name  = "glass",
             .title = "Panes and balls of glass that cross each other, opaque balls among them",
             .make  = make}};
}

}  // namespace zscope::generated
