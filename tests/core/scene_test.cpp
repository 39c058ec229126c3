// What assemble() and Scene promise: ids in load order, bounds, a digest of what decides the picture, and refusal of
// what cannot be drawn.
#include "core/scene/scene.h"

#include <array>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace zscope {
namespace {

std::shared_ptr<const Mesh> fan(std::uint32_t triangles)
{
    auto mesh = std::make_shared<Mesh>();
    mesh->positions.push_back({0, 0, 0});
    for (std::uint32_t i = 0; i <= triangles; ++i) mesh->positions.push_back({1, static_cast<double>(i), 0});
    for (std::uint32_t i = 0; i < triangles; ++i) mesh->addPolygon(std::array{0u, i + 1, i + 2});
    return mesh;
}

Scene parts()
{
    Scene scene;
    scene.meshes    = {fan(3), fan(0), fan(2)};
    scene.instances = {{MeshId{1}, Affine{}}, {MeshId{0}, Affine{}},
                       {MeshId{1}, Affine{}}, {MeshId{2}, Affine::translation({5, 0, -1})},
                       {MeshId{1}, Affine{}}, {MeshId{0}, Affine{}, Rgb{1, 0, 0}},
                       {MeshId{1}, Affine{}}};
    return scene;
}

TEST(Scene, TriangleIdsRunOnFromInstanceToInstance)
{
    const auto scene = assemble(parts());
    ASSERT_TRUE(scene.ok()) << scene.error().text();
    EXPECT_EQ(scene->firstTriangle, (std::vector<std::uint32_t>{0, 0, 3, 3, 5, 5, 8, 8}));
    EXPECT_EQ(scene->triangleCount(), 8u);
}

TEST(Scene, InstanceOfFindsTheOneThatHoldsTheTriangle)
{
    const auto scene = assemble(parts());
    ASSERT_TRUE(scene.ok());
    const std::array<std::uint32_t, 8> expected{1, 1, 1, 3, 3, 5, 5, 5};
    for (std::uint32_t id = 0; id < expected.size(); ++id)
        EXPECT_EQ(scene->instanceOf(TriangleId{id}).value, expected[id]) << id;
}

TEST(Scene, BoundsHoldEveryInstanceWhereItStands)
{
    const auto scene = assemble(parts());
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene->bounds.min, (dvec3{0, 0, -1}));
    EXPECT_EQ(scene->bounds.max, (dvec3{6, 3, 0}));
    Scene turned       = parts();
    turned.instances   = {{MeshId{0}, Affine{{{{0, -1, 0, 0}, {2, 0, 0, 0}, {0, 0, 1, 7}}}}}};
    const auto quarter = assemble(turned);
    ASSERT_TRUE(quarter.ok());
    EXPECT_EQ(quarter->bounds.min, (dvec3{-3, 0, 7}));
    EXPECT_EQ(quarter->bounds.max, (dvec3{0, 2, 7}));
}

TEST(Scene, EmptySceneIsAScene)
{
    const auto scene = assemble(Scene{});
    ASSERT_TRUE(scene.ok());
    EXPECT_EQ(scene->triangleCount(), 0u);
    EXPECT_TRUE(scene->bounds.isEmpty());
    EXPECT_EQ(scene->digest.size(), 16u);
}

TEST(Scene, DigestChangesWithEverythingThatDecidesThePictureAndWithNothingElse)
{
    const auto digestAfter = [](const std::function<void(Scene&)>& change) {
        Scene scene = parts();
        change(scene);
        const auto whole = assemble(std::move(scene));
        return whole.ok() ? whole->digest : whole.error().text();
    };
    const auto withMesh = [](const std::function<void(Mesh&)>& change) {
        return [change](Scene& scene) {
            auto mesh = std::make_shared<Mesh>(*scene.meshes[0]);
            change(*mesh);
            scene.meshes[0] = mesh;
        };
    };
    const std::string plain = digestAfter([](Scene&) {});
    EXPECT_EQ(plain, digestAfter([](Scene&) {}));
    EXPECT_EQ(plain, digestAfter([](Scene& s) {
                  s.name = "another";
                  s.warnings.push_back({});
                  s.views.emplace_back();
              }));
    EXPECT_EQ(plain, digestAfter(withMesh([](Mesh& m) {
                  m.groups.push_back("g");
                  m.materials[0].name = "m";
              })));

    const std::array<std::function<void(Scene&)>, 11> changes{
        [](Scene& s) { std::swap(s.instances[1], s.instances[3]); },
        [](Scene& s) { s.instances[1].toWorld.rows[2][3] = 5e-324; },
        [](Scene& s) {
            s.instances[1].colour = Rgb{0, 0, 0};
        },
        [](Scene& s) {
            s.instances[5].colour = Rgb{1, 0, 1e-7f};
        },
        [](Scene& s) { s.instances.pop_back(); },
        [](Scene& s) { s.light.direction.x += 1e-15; },
        withMesh([](Mesh& m) { m.positions[1].x += 1e-15; }),
        withMesh([](Mesh& m) { std::swap(m.triangles[0], m.triangles[1]); }),
        withMesh([](Mesh& m) { std::swap(m.triangles[0][1], m.triangles[0][2]); }),
        withMesh([](Mesh& m) { m.materials[0].diffuse.b = 0; }),
        withMesh([](Mesh& m) { m.materials[0].opacity = 0.5f; }),
    };
    std::vector<std::string> seen{plain};
    for (std::size_t i = 0; i < changes.size(); ++i) {
        seen.push_back(digestAfter(changes[i]));
        for (std::size_t k = 0; k + 1 < seen.size(); ++k)
            EXPECT_NE(seen.back(), seen[k]) << "change " << i << " and " << k;
    }
}

TEST(Scene, InstanceOfAMeshThatIsNotThereIsRefused)
{
    Scene scene             = parts();
    scene.instances[2].mesh = MeshId{3};
    const auto whole        = assemble(scene);
    ASSERT_FALSE(whole.ok());
    EXPECT_EQ(whole.error().kind, Trouble::Input);
    EXPECT_NE(whole.error().sentence.find("instance 2"), std::string::npos);
}

TEST(Scene, MatrixThatIsNotFiniteIsRefused)
{
    for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Scene scene                           = parts();
        scene.instances[4].toWorld.rows[1][2] = bad;
        const auto whole                      = assemble(scene);
        ASSERT_FALSE(whole.ok());
        EXPECT_EQ(whole.error().kind, Trouble::Input);
    }
}

TEST(Scene, InstanceThatReachesBeyondTheLargestNumberIsRefused)
{
    Scene scene                        = parts();
    scene.instances[1].toWorld.rows[0] = {1.7e308, 1.7e308, 0, 1.7e308};
    EXPECT_FALSE(assemble(scene).ok());
}

TEST(Scene, LightWithoutDirectionIsRefused)
{
    Scene scene           = parts();
    scene.light.direction = {0, 0, 0};
    EXPECT_FALSE(assemble(scene).ok());
}

TEST(Scene, MoreTrianglesThanIdsIsALimitAndNotAWrapAround)
{
    Scene scene;
    scene.meshes = {fan(1'000'000)};
    scene.instances.assign(4294, {MeshId{0}, Affine{}});
    EXPECT_TRUE(assemble(scene).ok());
    scene.instances.push_back({MeshId{0}, Affine{}});  // 4,295,000,000 > 2^32 - 2
    const auto whole = assemble(scene);
    ASSERT_FALSE(whole.ok());
    EXPECT_EQ(whole.error().kind, Trouble::Limit);
}

}  // namespace
}  // namespace zscope
