// Conservative culling never leaves out what can be seen: no triangle below a node that was called hidden or outside,
// and none that was called hidden itself, owns a pixel of the reference. For every exact preset; and the audit that
// says so is held to scenes whose answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "core/measure/cull_audit.h"
#include "core/measure/reference.h"
#include "core/scene/generators/random.h"
#include "core/scene/load.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// What was culled in all frames of a test; one in which nothing is would prove nothing.
struct Total {
    std::uint64_t nodesHidden = 0, nodesOutside = 0, trianglesHidden = 0;
};

void expectNoFalseCulls(const std::shared_ptr<const PreparedScene>& scene, const Camera& camera,
                        const std::string& what, Total& total)
{
    const auto reference = referencePicture(scene->scene(), camera, FaceCulling::None);
    ASSERT_TRUE(reference.ok());
    Renderer renderer;
    for (const Preset& preset : presets()) {
        if (!preset.isExact() || !canAuditCulls(preset.pipeline)) continue;
        DrawRequest request;
        request.scene    = scene;
        request.camera   = camera;
        request.pipeline = preset.pipeline;
        request.shade    = false;
        Frame frame;
        ASSERT_TRUE(renderer.draw(request, frame));
        const auto audit = auditCulls(request, frame.visible, reference->ids.values());
        ASSERT_TRUE(audit.ok()) << audit.error().text();
        total.nodesHidden += audit->nodesHidden;
        total.nodesOutside += audit->nodesOutside;
        total.trianglesHidden += audit->trianglesHidden;
        SCOPED_TRACE(what + " by " + std::string(preset.name));
        ASSERT_EQ(audit->falseCulls.byBatch, 0u);
        ASSERT_EQ(audit->falseCulls.byNodeOutside, 0u);
        ASSERT_EQ(audit->falseCulls.byNodeHidden, 0u);
        ASSERT_EQ(audit->falseCulls.byTriangle, 0u);
        EXPECT_LE(audit->missedNodes, audit->nodesEntered);
        EXPECT_LE(audit->missedTriangles, audit->trianglesDrawn);
    }
}

/// Each seed is a test of its own, so that they run side by side.
class FalseCullsInSoups : public testing::TestWithParam<std::uint64_t> {};

TEST_P(FalseCullsInSoups, ThereAreNoneOfAnyKind)
{
    const std::uint64_t seed     = GetParam();
    const bool          hasNodes = seed != 2;  // enough triangles that a mesh tree has nodes below its root
    Total               total;
    for (const SoupKind kind : soupKinds()) {
        const Soup soup = makeSoup(kind, seed, seed == 0 ? 127 : 64, seed == 0 ? 95 : 64, hasNodes ? 1500 : 60);
        expectNoFalseCulls(std::make_shared<const PreparedScene>(soup.scene), soup.camera, soup.what, total);
        if (testing::Test::HasFatalFailure()) return;
    }
    if (hasNodes) {
        EXPECT_GT(total.nodesHidden, 5u);
        EXPECT_GT(total.nodesOutside, 5u);
    }
    EXPECT_GT(total.trianglesHidden, 100u);
}
INSTANTIATE_TEST_SUITE_P(Seeds, FalseCullsInSoups, testing::Range(std::uint64_t{0}, std::uint64_t{3}));

/// The scene's own view, and seeded eyes inside its bounds that look anywhere.
void expectNoneWithin(const char* word, int eyes, double lowest, double highest)
{
    auto loaded = loadScene(word);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    const auto   shared   = std::make_shared<const Scene>(*std::move(loaded));
    const auto   prepared = std::make_shared<const PreparedScene>(shared);
    const Bounds bounds   = shared->bounds;
    Random       random(17);
    Total        total;
    for (int i = 0; i <= eyes; ++i) {
        ViewRequest view = shared->views.front().view;
        if (i > 0) {
            const double low  = bounds.min.y + lowest * (bounds.max.y - bounds.min.y),
                         high = bounds.min.y + highest * (bounds.max.y - bounds.min.y);
            view              = {};
            view.eye = random.between(dvec3{bounds.min.x, low, bounds.min.z}, dvec3{bounds.max.x, high, bounds.max.z});
            view.target      = *view.eye + random.between(dvec3{-1, -0.3, -1}, dvec3{1, 0.3, 1});
            view.verticalFov = random.between(30, 110);
            view.near        = 0.05;
        }
        view.width = 201, view.height = 133;
        const auto camera = makeCamera(view, bounds);
        ASSERT_TRUE(camera.ok()) << camera.error().text();
        expectNoFalseCulls(prepared, *camera, std::string(word) + ", eye " + std::to_string(i), total);
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(total.nodesHidden, 30u) << word;
    EXPECT_GT(total.nodesOutside, 30u) << word;
    EXPECT_GT(total.trianglesHidden, 100u) << word;
}

TEST(FalseCulls, ThereAreNoneOnTheSoccerFieldWithEyesAmongTheBalls)
{
    expectNoneWithin("builtin:soccer-field?count=150", 8, 0.1, 0.9);
}
TEST(FalseCulls, ThereAreNoneInTheStreetsOfTheCity) { expectNoneWithin("builtin:city?blocks=3", 12, 0.01, 0.4); }
TEST(FalseCulls, ThereAreNoneInADenseSoup) { expectNoneWithin("builtin:soup?count=20000&size=1", 6, 0.1, 0.9); }

TEST(FalseCulls, ThereAreNoneAmongTheBoxes)
{
    auto loaded = loadScene("builtin:cubes");
    ASSERT_TRUE(loaded.ok());
    const auto  shared = std::make_shared<const Scene>(*std::move(loaded));
    ViewRequest view   = shared->views.front().view;
    view.width = 321, view.height = 243;
    Total total;
    expectNoFalseCulls(std::make_shared<const PreparedScene>(shared), *makeCamera(view, shared->bounds), "cubes",
                       total);
    EXPECT_GT(total.trianglesHidden, 0u);
}

/// A wall of two triangles at distance 2, and `count` small triangles in a row behind it, in this order or the other.
std::shared_ptr<const Scene> wallAnd(const Camera& camera, int count, bool wallFirst)
{
    const auto                 at = [&camera](double x, double y, double z) { return pointAt(camera, x, y, z); };
    const std::vector<Corners> wall{{at(-8, -8, 2), at(72, -8, 2), at(72, 72, 2)},
                                    {at(-8, -8, 2), at(72, 72, 2), at(-8, 72, 2)}};
    std::vector<Corners>       triangles = wallFirst ? wall : std::vector<Corners>{};
    for (int i = 0; i < count; ++i) {
        const double x = 4 + 60.0 * i / count;
        triangles.push_back({at(x, 10, 5), at(x + 8, 10, 5), at(x, 30, 6)});
    }
    if (!wallFirst) triangles.insert(triangles.end(), wall.begin(), wall.end());
    return sceneOf(triangles);
}

TEST(MissedCulls, AreTheTrianglesThatAPerfectTestWouldHaveHidden)
{
    const Camera camera = plainCamera(64, 64);
    for (const bool wallFirst : {true, false}) {
        DrawRequest request;
        request.scene  = std::make_shared<const PreparedScene>(wallAnd(camera, 10, wallFirst));
        request.camera = camera;
        request.shade  = false;
        for (const char* name : {"zbuffer", "quadtree", "hzb-simple"}) {
            SCOPED_TRACE(std::string(name) + (wallFirst ? ", wall first" : ", wall last"));
            request.pipeline = findPreset(name)->pipeline;
            Frame frame;
            ASSERT_TRUE(Renderer().draw(request, frame));
            const auto audit = auditCulls(request, frame.visible, std::vector<std::int64_t>{-1});
            ASSERT_TRUE(audit.ok());
            const bool sees =
                std::string_view(name) == "hzb-simple" || (std::string_view(name) == "quadtree" && wallFirst);
            EXPECT_EQ(audit->trianglesHidden, sees ? 10u : 0u);
            EXPECT_EQ(audit->trianglesDrawn, sees ? 2u : 12u);
            EXPECT_EQ(audit->missedTriangles, sees ? 0u : 10u)
                << "what is drawn before the wall could not be hidden, and a perfect test would have";
            EXPECT_EQ(audit->missedNodes, 0u);
        }
    }
}

TEST(FalseCulls, AreSeenWhereThePictureIsNotTheTruth)
{
    // Told that a triangle behind the wall owns a pixel, the audit must find that it was culled, and by what.
    const Camera camera = plainCamera(64, 64);
    DrawRequest  request;
    request.scene  = std::make_shared<const PreparedScene>(wallAnd(camera, 1000, true));
    request.camera = camera;
    request.shade  = false;
    const std::vector<std::int64_t> visible{0, 1, 5, 700, 700, -1};
    for (const char* name : {"zbuffer", "quadtree", "hzb-octree", "hzb-bvh"}) {
        SCOPED_TRACE(name);
        request.pipeline = findPreset(name)->pipeline;
        Frame frame;
        ASSERT_TRUE(Renderer().draw(request, frame));
        const auto audit = auditCulls(request, frame.visible, visible);
        ASSERT_TRUE(audit.ok());
        EXPECT_EQ(audit->falseCulls.total(), asksTriangles(request.pipeline.cull) ? 2u : 0u);
        if (std::string_view(name) == "quadtree") {
            EXPECT_EQ(audit->falseCulls.byTriangle, 2u);
        }
    }

    request.camera.forward = -request.camera.forward;  // looks away: everything lies in batches and nodes outside
    request.camera.right   = -request.camera.right;
    for (const char* name : {"zbuffer", "octree-frustum"}) {
        request.pipeline = findPreset(name)->pipeline;
        Frame frame;
        ASSERT_TRUE(Renderer().draw(request, frame));
        const auto audit = auditCulls(request, frame.visible, visible);
        ASSERT_TRUE(audit.ok());
        EXPECT_EQ(audit->falseCulls.byBatch, request.pipeline.order == Order::Submitted ? 4u : 0u) << name;
        EXPECT_EQ(audit->falseCulls.byNodeOutside, request.pipeline.order == Order::Submitted ? 0u : 4u) << name;
    }
}

}  // namespace
}  // namespace zscope::tests
