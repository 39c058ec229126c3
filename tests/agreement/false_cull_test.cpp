// Conservative culling never leaves out what can be seen: no triangle below a node that was called hidden or outside, and
// none that was called hidden itself, owns a pixel of the reference. Checked against the finished picture, for every preset.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "core/measure/reference.h"
#include "core/scene/generators/random.h"
#include "core/scene/load.h"
#include "tests/agreement/hidden_listener.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

struct Total {
    std::uint64_t nodesHidden = 0, nodesOutside = 0, trianglesHidden = 0;
};

void expectNoFalseCulls(const std::shared_ptr<const PreparedScene>& scene, const Camera& camera, const std::string& what, Total& total)
{
    const auto reference = referencePicture(scene->scene(), camera, FaceCulling::None);
    ASSERT_TRUE(reference.ok());
    for (const Preset& preset : presets()) {
        if (preset.pipeline.order == Order::Submitted && !asksTriangles(preset.pipeline.cull)) continue;  // culls no node
        DrawRequest request;
        request.scene       = scene;
        request.camera      = camera;
        request.pipeline    = preset.pipeline;
        const Culled culled = culledBy(request);
        total.nodesHidden += culled.nodesHidden;
        total.nodesOutside += culled.nodesOutside;
        total.trianglesHidden += culled.trianglesHidden;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                const std::int64_t id = reference->ids.at(x, y);
                if (id < 0) continue;
                const auto triangle = static_cast<std::size_t>(id);
                ASSERT_FALSE(culled.byNode[triangle]) << what << " by " << preset.name << ": triangle " << id << " owns " << x << ", " << y;
                ASSERT_FALSE(culled.byTriangle[triangle]) << what << " by " << preset.name << ": triangle " << id << " owns " << x << ", " << y;
            }
    }
}

TEST(FalseCulls, ThereAreNoneInAnyKindOfSoup)
{
    Total total;
    for (const SoupKind kind : soupKinds())
        for (std::uint64_t seed = 0; seed < 3; ++seed) {
            // Enough triangles that a mesh tree has nodes below its root.
            const Soup soup = makeSoup(kind, seed, seed == 0 ? 127 : 64, seed == 0 ? 95 : 64, seed == 2 ? 60 : 1500);
            expectNoFalseCulls(std::make_shared<const PreparedScene>(soup.scene), soup.camera, soup.what, total);
            if (testing::Test::HasFatalFailure()) return;
        }
    EXPECT_GT(total.nodesHidden, 30u);
    EXPECT_GT(total.nodesOutside, 30u);
    EXPECT_GT(total.trianglesHidden, 10'000u);
}

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
            const double low = bounds.min.y + lowest * (bounds.max.y - bounds.min.y), high = bounds.min.y + highest * (bounds.max.y - bounds.min.y);
            view             = {};
            view.eye         = random.between(dvec3{bounds.min.x, low, bounds.min.z}, dvec3{bounds.max.x, high, bounds.max.z});
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
    const auto shared = std::make_shared<const Scene>(*std::move(loaded));
    ViewRequest view  = shared->views.front().view;
    view.width = 321, view.height = 243;
    Total total;
    expectNoFalseCulls(std::make_shared<const PreparedScene>(shared), *makeCamera(view, shared->bounds), "cubes", total);
    EXPECT_GT(total.trianglesHidden, 0u);
}

}  // namespace
}  // namespace zscope::tests
