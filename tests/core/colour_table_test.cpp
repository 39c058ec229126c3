// Colours: opaque, from material or instance, lit by a light of any length, the same with a table and without.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "core/scene/scene.h"
#include "core/shade/colour_table.h"

namespace zscope {
namespace {

Scene oneTriangle(const dvec3& light, std::optional<Rgb> colour = {})
{
    auto mesh                  = std::make_shared<Mesh>();
    mesh->positions            = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
    mesh->materials[0].diffuse = {1, 0.5f, 0};
    const std::array<std::uint32_t, 3> face{0, 1, 2}, point{3, 3, 3};
    mesh->addPolygon(face);
    mesh->addPolygon(point);
    Scene scene;
    scene.meshes          = {mesh};
    scene.instances       = {{.mesh = {}, .toWorld = {}, .colour = colour}, {.mesh = {}, .toWorld = {}, .colour = {}}};
    scene.light.direction = light;
    return *assemble(std::move(scene));
}

TEST(ColourTable, HoldsTheColourOfEveryTriangleBehindTheBackground)
{
    const Scene       scene = oneTriangle({0, 0, -1}, Rgb{0, 0, 1});
    const ColourTable table(scene);
    ASSERT_TRUE(table.isComplete());
    EXPECT_EQ(table.data()[0], kBackgroundColour);
    EXPECT_EQ(table.data()[1], colourOf(scene, InstanceId{0}, 0));
    EXPECT_EQ(table.data()[3], colourOf(scene, InstanceId{1}, 0));
    EXPECT_EQ(table.data()[1], 0xFF0000FFu) << "the instance's colour, facing the light";
    EXPECT_EQ(table.data()[3], 0xFFFF8000u) << "the material's";
}

/// Triangles of a wavy sheet that share their corners, `spare` corners that none of them names, and as many instances.
Scene sheets(std::uint32_t side, std::uint32_t spare, int instances)
{
    auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t y = 0; y <= side; ++y)
        for (std::uint32_t x = 0; x <= side; ++x)
            mesh->positions.push_back({x * 0.37, y * 0.41, std::sin(x * 0.9) + std::cos(y * 1.7)});
    for (std::uint32_t i = 0; i < spare; ++i) mesh->positions.push_back({i * 1.0, 7, 7});
    mesh->materials[0].diffuse = {0.3f, 0.6f, 0.9f};
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t at = y * (side + 1) + x;
            mesh->addPolygon(std::array<std::uint32_t, 3>{at, at + 1, at + side + 1});
            mesh->addPolygon(std::array<std::uint32_t, 3>{at + 1, at + side + 2, at + side + 1});
        }
    Scene scene;
    scene.meshes = {mesh};
    for (int i = 0; i < instances; ++i)
        scene.instances.push_back({.mesh = {}, .toWorld = Affine::translation({i * 3.0, i * 0.1, 0}), .colour = {}});
    scene.light.direction = {0.3, -0.7, -1.1};
    return *assemble(std::move(scene));
}

TEST(ColourTable, IsTheSameForLargeMeshesManyInstancesAndMeshesWithUnusedCorners)
{
    for (const auto& [side, spare, instances] :
         {std::array{3u, 0u, 40u}, {200u, 0u, 2u}, {4u, 500u, 7u}, {190u, 300'000u, 1u}}) {
        const Scene       scene = sheets(side, spare, static_cast<int>(instances));
        const ColourTable table(scene);
        for (std::uint32_t i = 0; i < instances; ++i)
            for (std::uint32_t t = 0; t < 2 * side * side; ++t)
                ASSERT_EQ(table.data()[scene.firstTriangle[i] + t + 1], colourOf(scene, InstanceId{i}, t))
                    << side << ' ' << spare << ' ' << i << ' ' << t;
    }
}

TEST(ColourTable, ALightMayHaveAnyLengthButNought)
{
    const std::uint32_t lit = colourOf(oneTriangle({0, 0, -1}), InstanceId{0}, 0);
    for (const double length : {1e-320, 1e-200, 1e-10, 3.0, 1e10, 1e200, 1.7e308})
        EXPECT_EQ(colourOf(oneTriangle({0, 0, -length}), InstanceId{0}, 0), lit) << length;
}

TEST(ColourTable, TheFarSideIsDarkerAndNotBlackAndAPointIsBetween)
{
    const auto red = [](const dvec3& light, std::uint32_t triangle) {
        return colourOf(oneTriangle(light), InstanceId{0}, triangle) >> 16 & 255;
    };
    EXPECT_GT(red({0, 0, 1}, 0), 40u);  // of 255
    EXPECT_LT(red({0, 0, 1}, 0), red({1, 0, 0}, 0));
    EXPECT_LT(red({1, 0, 0}, 0), red({0, 0, -1}, 0));
    EXPECT_EQ(red({0, 0, 1}, 1), red({1, 0, 0}, 0)) << "without a normal: half lit";
}

}  // namespace
}  // namespace zscope
