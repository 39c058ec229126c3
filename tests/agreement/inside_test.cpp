// Level L1 from within: eyes at random places inside a scene, looking anywhere, so that triangles cross the near plane
// and nodes hold the eye. Every exact preset, every pixel.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>

#include "core/scene/generators/random.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"

namespace zscope::tests {
namespace {

/// 100 cameras are cut into tests of 10, so that they run side by side.
constexpr std::uint64_t kCameras = 100, kCamerasPerTest = 10;

/// Seeded; near planes from hardly anything to a hundredth of the scene, now and then no far plane.
Camera cameraInside(const Bounds& bounds, std::uint64_t seed)
{
    Random       random(seed * 7919 + 5);
    const dvec3  size     = bounds.max - bounds.min;
    const double diagonal = std::sqrt(size.x * size.x + size.y * size.y + size.z * size.z);
    ViewRequest  view;
    view.eye          = random.between(bounds.min + 0.02 * size, bounds.max - 0.02 * size);
    const dvec3 ahead = random.between(dvec3{-1, -0.6, -1}, dvec3{1, 0.6, 1});
    view.target       = *view.eye + ahead;
    view.up           = std::abs(ahead.x) + std::abs(ahead.z) > 0.05 ? dvec3{0, 1, 0} : dvec3{1, 0, 0};
    view.verticalFov  = random.between(30, 120);
    view.near         = diagonal * random.between(1e-5, 1e-2);
    view.far          = seed % 3 == 0 ? std::numeric_limits<double>::infinity() : 2 * diagonal;
    view.width        = static_cast<int>(40 + random.below(60));
    view.height       = static_cast<int>(30 + random.below(40));
    const auto camera = makeCamera(view, bounds);
    EXPECT_TRUE(camera.ok()) << (camera.ok() ? "" : camera.error().text());
    return *camera;
}

/// Threads and targets take turns, so that all have been there after a few cameras.
void expectAgreementInside(const std::string& word, std::uint64_t first)
{
    auto loaded = loadScene(word);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    const auto    scene   = std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(loaded)));
    const auto    targets = targetsTested();
    std::uint64_t covered = 0;
    for (std::uint64_t seed = first; seed < first + shareOf(kCamerasPerTest); ++seed) {
        const Camera camera = cameraInside(scene->scene().bounds, seed);
        covered +=
            expectAgreement(scene, camera, seed % 2 == 0 ? FaceCulling::None : FaceCulling::Back,
                            word + ", camera " + std::to_string(seed),
                            {.threads = {static_cast<int>(1 + seed % 3)}, .targets = {targets[seed % targets.size()]}});
    }
    EXPECT_GT(covered, 100u);
}

class AgreementInside : public testing::TestWithParam<std::uint64_t> {};

TEST_P(AgreementInside, TheCity) { expectAgreementInside("builtin:city", GetParam()); }

TEST_P(AgreementInside, TheSponzaOnTheSharedModels)
{
    const auto model = std::filesystem::path(ZSCOPE_SOURCE_DIR) / ".." / "shared" / "models" / "crytek-sponza.obj";
    if (!std::filesystem::exists(model)) GTEST_SKIP() << "no such model";
    expectAgreementInside(model.string(), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Cameras, AgreementInside, testing::Range(std::uint64_t{0}, kCameras, kCamerasPerTest));

}  // namespace
}  // namespace zscope::tests
