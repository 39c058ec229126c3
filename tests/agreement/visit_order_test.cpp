// Front to back, exactly: of two children of an octree node, the later one never lies between the eye and the earlier
// one. A ray from the eye crosses each splitting plane at most once, from the eye's side to the other: the later child
// can hide the earlier one only if it is on the eye's side of every plane between them. Hard case E7 of
// docs/correctness.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include <glm/geometric.hpp>

#include "core/hierarchy/scene_trees.h"
#include "core/scene/generators/random.h"
#include "core/scene/load.h"
#include "tests/agreement/soups.h"
#include "tests/agreement/visit_listener.h"

namespace zscope::tests {
namespace {

/// On which side of each splitting plane the eye is: +1 the upper, -1 the lower, 0 in the plane (up to rounding).
/// Judged in world space, by volumes, without turning the placement round.
std::array<int, 3> sidesOf(const dvec3& eye, const Bounds& cell, const Affine& toWorld)
{
    const dvec3          centre = 0.5 * cell.min + 0.5 * cell.max;
    const dvec3          origin = toWorld(centre);
    std::array<dvec3, 3> axis;
    for (int k = 0; k < 3; ++k) {
        const auto column = static_cast<std::size_t>(k);
        axis[column]      = {toWorld.rows[0][column], toWorld.rows[1][column], toWorld.rows[2][column]};
    }
    const dvec3        away = eye - origin;
    std::array<int, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k) {
        const dvec3  normal = glm::cross(axis[(k + 1) % 3], axis[(k + 2) % 3]);
        const double reach = glm::dot(normal, away), upper = glm::dot(normal, axis[k]);
        const double doubt =
            1e-9 * glm::length(normal) * (glm::length(away) + 1e-6 * (glm::length(eye) + glm::length(origin)));
        sides[k] = std::abs(reach) <= doubt ? 0 : (reach > 0) == (upper > 0) ? 1 : -1;
    }
    return sides;
}

bool mayHide(unsigned front, unsigned behind, const std::array<int, 3>& eye)
{
    for (unsigned k = 0; k < 3; ++k) {
        const int a = front >> k & 1 ? 1 : -1, b = behind >> k & 1 ? 1 : -1;
        if (a != b && a != eye[k]) return false;
    }
    return true;
}

std::uint64_t expectFrontToBack(const std::shared_ptr<const PreparedScene>& scene, const Camera& camera,
                                const std::string& what)
{
    std::uint64_t pairs = 0;
    for (const char* name : {"octree-frustum", "hzb-octree"}) {
        DrawRequest request;
        request.scene    = scene;
        request.camera   = camera;
        request.pipeline = findPreset(name)->pipeline;
        for (const OpenedNode& opened : visitOf(request)) {
            EXPECT_TRUE(std::ranges::is_sorted(opened.judgedWhen)) << "visited as announced";
            const Affine toWorld =
                opened.place.isInstanceTree ? Affine{} : scene->scene().instances[opened.place.instance.value].toWorld;
            const auto eye = sidesOf(camera.eye, opened.place.node.cell, toWorld);
            for (std::size_t i = 0; i < opened.children.size(); ++i)
                for (std::size_t j = i + 1; j < opened.children.size(); ++j) {
                    // no place is exact for them
                    if (opened.children[i]->straddles || opened.children[j]->straddles) continue;
                    const auto earlier = static_cast<unsigned>(opened.children[i]->slot),
                               later   = static_cast<unsigned>(opened.children[j]->slot);
                    EXPECT_FALSE(mayHide(later, earlier, eye))
                        << what << " by " << name << ": octant " << later << " before " << earlier;
                    ++pairs;
                }
        }
    }
    return pairs;
}

Camera cameraAt(const dvec3& eye, const dvec3& target)
{
    ViewRequest view;
    view.eye = eye, view.target = target;
    view.near = 0.01, view.far = 1e4, view.verticalFov = 100;
    view.up    = {0.1, 1, 0.2};
    view.width = 96, view.height = 72;
    return *makeCamera(view, Bounds{{-1, -1, -1}, {1, 1, 1}});
}

/// Eyes far away, inside, in one, two and three of the root's splitting planes, and in those of one octant.
std::vector<dvec3> eyesAbout(const Bounds& cell)
{
    const dvec3        centre = 0.5 * cell.min + 0.5 * cell.max, size = cell.max - cell.min;
    std::vector<dvec3> eyes{centre, cell.min, cell.max};
    Random             random(3);
    for (int i = 0; i < 6; ++i) {
        eyes.push_back(random.between(cell.min, cell.max));
        eyes.push_back(centre + random.between(-2.0 * size, 2.0 * size));
    }
    for (int k = 0; k < 3; ++k) {
        dvec3 face = random.between(cell.min, cell.max), edge = centre, quarter = centre;
        face[k] = centre[k];
        edge[k] = random.between(cell.min[k], cell.max[k]);
        quarter[k] -= 0.25 * size[k];
        eyes.insert(eyes.end(), {face, edge, quarter});
    }
    return eyes;
}

TEST(VisitOrder, OfAnOctreeIsFrontToBackWhereverTheEyeIsAndHoweverTheMeshIsPlaced)
{
    auto ball = loadScene("builtin:soccer-ball");
    ASSERT_TRUE(ball.ok());
    Random              random(8);
    std::vector<Affine> places{Affine{}, Affine::translation({1e5, -2e5, 3e5}), random.rotation()};
    Affine              mirrored = random.rotation(), sheared;
    for (double& m : mirrored.rows[1]) m = -m;
    sheared.rows = {{{1, 2.5, 0.3, 4}, {0, 0.2, -1.5, 1}, {0.7, 0, 3, -2}}};
    places.push_back(mirrored);
    places.push_back(sheared);
    std::uint64_t pairs = 0;
    for (std::size_t p = 0; p < places.size(); ++p) {
        const auto   prepared = std::make_shared<const PreparedScene>(sceneOf(*ball->meshes[0], std::array{places[p]}));
        const Bounds cell     = treesOf(*prepared, TreeKind::Octree).mesh(MeshId{0}).root().cell;
        for (const dvec3& eye : eyesAbout(cell)) {
            const dvec3 world = places[p](eye);
            pairs += expectFrontToBack(prepared, cameraAt(world, world + dvec3{0.3, -0.2, 1}),
                                       "placement " + std::to_string(p));
            pairs += expectFrontToBack(prepared, cameraAt(world, places[p]({0.01, 0.02, 0.03})),
                                       "placement " + std::to_string(p));
        }
    }
    EXPECT_GT(pairs, 10'000u);
}

TEST(VisitOrder, OfTheInstancesIsFrontToBackToo)
{
    auto loaded = loadScene("builtin:soccer-field?count=200");
    ASSERT_TRUE(loaded.ok());
    const auto    shared   = std::make_shared<const Scene>(*std::move(loaded));
    const auto    prepared = std::make_shared<const PreparedScene>(shared);
    std::uint64_t pairs    = 0;
    for (const dvec3& eye : eyesAbout(treesOf(*prepared, TreeKind::Octree).instances().root().cell))
        pairs += expectFrontToBack(prepared, cameraAt(eye, eye + dvec3{-1, 0.1, -0.4}), "field");
    EXPECT_GT(pairs, 1000u);
}

TEST(VisitOrder, OfTheBatchesOfANodeIsFrontToBackToo)
{
    // Quads that cover the picture, in one node of several batches: the nearest batch comes first, so no pixel of
    // another one is tested, whatever the order in the file.
    for (const bool fromBack : {false, true}) {
        auto loaded = loadScene(fromBack ? "builtin:layers?count=200&order=back" : "builtin:layers?count=200");
        ASSERT_TRUE(loaded.ok());
        DrawRequest request;
        request.scene    = std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(loaded)));
        request.camera   = cameraAt({0, 0, 0}, {0, 0, -1});
        request.pipeline = findPreset("hzb-octree")->pipeline;
        Renderer                renderer;
        const Result<FrameWork> work = renderer.count(request);
        ASSERT_TRUE(work.ok());
        std::uint64_t tested = 0;
        for (const NamedCount& count : work->counters)
            if (count.name == "pixels_tested") tested = count.value;
        const Tree&        tree    = treesOf(*request.scene, TreeKind::Octree).mesh(MeshId{0});
        const MeshBatches& batches = tree.batchesOf(tree.root(), *request.scene->scene().meshes[0]);
        ASSERT_GT(batches.batches.size(), 1u);
        const auto quads  = std::uint64_t{batches.batches.front().triangleCount} / 2;
        const auto pixels = static_cast<std::uint64_t>(request.camera.width * request.camera.height);
        EXPECT_GT(tested, 0u);
        EXPECT_LE(tested, quads * pixels) << (fromBack ? "from the back" : "from the front");
    }
}

TEST(VisitOrder, TheCriterionSeesAWrongOrder)
{
    // The eye beyond the upper corner: octant 7 may hide octant 0, and not the other way round.
    EXPECT_TRUE(mayHide(7, 0, {1, 1, 1}));
    EXPECT_FALSE(mayHide(0, 7, {1, 1, 1}));
    EXPECT_FALSE(mayHide(1, 2, {1, 1, 1})) << "side by side";
    EXPECT_FALSE(mayHide(7, 6, {0, 1, 1})) << "the eye in the plane between them";
    EXPECT_EQ(sidesOf({3, -2, 0}, {{-1, -1, -1}, {1, 1, 1}}, Affine{}), (std::array{1, -1, 0}));
}

TEST(VisitOrder, ThePlainMethodAsksAboutEveryTriangleThatItDraws)
{
    auto loaded = loadScene("builtin:soccer-field?count=8");
    ASSERT_TRUE(loaded.ok());
    DrawRequest request;
    request.scene = std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(loaded)));
    ViewRequest view;
    view.width = 320, view.height = 240;
    request.camera = *makeCamera(view, request.scene->scene().bounds);
    for (const char* preset : {"hzb-octree", "hzb-bvh", "hzb-simple"}) {
        request.pipeline               = findPreset(preset)->pipeline;
        const AskedTriangles triangles = askedBy(request);
        EXPECT_GT(triangles.asked.size(), 1000u) << preset;
        // A pre-pass asks nothing: it reaches every triangle once.
        const bool hasPrepass = request.pipeline.depth == DepthMoment::Prepass;
        EXPECT_EQ(triangles.unasked.size(), hasPrepass ? triangles.asked.size() : 0) << preset;
    }
}

}  // namespace
}  // namespace zscope::tests
