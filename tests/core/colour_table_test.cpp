// Colours: opaque, from material or instance, lit by a light of any length, the same with a table and without.
#include <gtest/gtest.h>

#include <memory>

#include "core/scene/scene.h"
#include "core/shade/colour_table.h"

namespace zscope {
namespace {

Scene oneTriangle(const dvec3& light, std::optional<Rgb> colour = {})
{
    auto mesh       = std::make_shared<Mesh>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
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
