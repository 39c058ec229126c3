// Levels L0 and L1 of docs/correctness.md: every preset, at every thread count and on every vector target of this
// machine, draws the reference's picture, ids and depth bits, on soups, generated scenes and shared models.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/measure/verify.h"
#include "core/scene/load.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// A sanitizer makes every draw ten times as long. What it looks for is in the text, not in the product of targets and
/// threads, so under one the tests draw with one lane and with the widest, and with two threads; elsewhere with all.
#ifdef __SANITIZE_ADDRESS__
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

std::vector<Simd> availableTargets()
{
    if (kSanitized) return {Simd::Scalar, resolved(Simd::Auto)};
    std::vector<Simd> targets;
    for (const SimdEntry& entry : simdTargets()) {
        if (entry.available && entry.target != Simd::Auto) targets.push_back(entry.target);
    }
    return targets;
}

/// Those that promise exact pictures, to the bit or by face.
std::vector<Preset> exactPresets()
{
    std::vector<Preset> exact;
    for (const Preset& preset : presets()) {
        if (preset.claim != Claim::Approximate) exact.push_back(preset);
    }
    return exact;
}

/// Pixels that show a triangle; a test whose scenes are all empty would prove nothing.
std::uint64_t expectAgreement(const std::shared_ptr<const Scene>& scene, const Camera& camera, FaceCulling culling,
                              const std::string& what, std::vector<int> threads = {1, 2, 3})
{
    const auto rows = verify({.scene       = std::make_shared<const PreparedScene>(scene),
                              .camera      = camera,
                              .faceCulling = culling,
                              .algorithms  = exactPresets(),
                              .threads     = kSanitized ? std::vector{2} : std::move(threads),
                              .simd        = availableTargets()});
    if (!rows) {
        ADD_FAILURE() << what << ": " << rows.error().text();
        return 0;
    }
    for (const VerifyRow& row : *rows) {
        EXPECT_TRUE(row.passed()) << what << ", culling " << (culling == FaceCulling::Back ? "back" : "none") << ", "
                                  << row.algorithm << ", " << row.threads << " threads, " << wordOf(row.simd) << ": "
                                  << row.figures.holes << " holes, " << row.figures.spills << " spills, "
                                  << row.figures.wrongSurface() << " wrong surfaces, " << row.figures.depthBitsDiffer
                                  << " depths differ by up to " << row.figures.maxDepthSteps << " steps";
        EXPECT_EQ(row.figures.falseCulls, 0u) << what;
    }
    return rows->empty() ? 0 : rows->front().figures.covered;
}

Camera cameraFor(const Scene& scene, int width, int height)
{
    ViewRequest view = scene.views.empty() ? ViewRequest{} : scene.views.front().view;
    if (view.exact) {  // a scene that insists on its own camera keeps its own size
        width  = view.exact->width;
        height = view.exact->height;
    }
    view.width        = width;
    view.height       = height;
    const auto camera = makeCamera(view, scene.bounds);
    EXPECT_TRUE(camera.ok()) << (camera.ok() ? "" : camera.error().text());
    return camera.ok() ? *camera : plainCamera(width, height);
}

/// 200 soups are cut into tests of 20, so that they run side by side and a failure is found quickly.
constexpr std::uint64_t kSoups = 200, kSoupsPerTest = 20;

class AgreementOnSoups : public testing::TestWithParam<std::uint64_t> {};

TEST_P(AgreementOnSoups, EveryPresetDrawsWhatTheReferenceDraws)
{
    static constexpr std::array<std::array<int, 2>, 10> kSizes{
        {{1, 1}, {1, 67}, {83, 1}, {2, 3}, {33, 17}, {64, 64}, {127, 95}, {257, 193}, {15, 16}, {17, 130}}};
    std::uint64_t covered = 0;
    for (std::uint64_t seed = GetParam(); seed < GetParam() + kSoupsPerTest; ++seed) {
        const SoupKind kind       = soupKinds()[seed % soupKinds().size()];
        const bool     large      = seed % 50 == 49;  // four of the soups are as large as a window
        const auto [width, height] = large ? std::array{1023, 769} : kSizes[seed % kSizes.size()];
        const Soup     soup       = makeSoup(kind, seed, width, height, large ? 16 : 60);
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            covered += expectAgreement(soup.scene, soup.camera, culling, soup.what);
        }
    }
    EXPECT_GT(covered, 1000u);
}
INSTANTIATE_TEST_SUITE_P(Seeds, AgreementOnSoups, testing::Range(std::uint64_t{0}, kSoups, kSoupsPerTest));

TEST(Agreement, EveryPresetDrawsWhatTheReferenceDrawsOnEveryGeneratedScene)
{
    // By default these are as large as a benchmark wants them.
    const auto wordOfScene = [](const SceneEntry& entry) {
        std::string word = "builtin:" + std::string(entry.name);
        if (entry.name == "soccer-field") word += "?count=40";
        if (entry.name == "city" || entry.name == "wall-and-city") word += "?blocks=3";
        if (entry.name == "rows") word += "?nx=3&ny=2&nz=4";
        if (entry.name == "office-tower") word += "?n=3";
        if (entry.name == "million") word += "?faces=50000";
        return word;
    };
    std::uint64_t covered = 0;
    for (const SceneEntry& entry : builtinScenes()) {
        const std::string word  = wordOfScene(entry);
        auto              scene = loadScene(word);
        ASSERT_TRUE(scene.ok()) << word << ": " << scene.error().text();
        const auto   shared = std::make_shared<const Scene>(*std::move(scene));
        const Camera camera = cameraFor(*shared, 241, 163);
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            covered += expectAgreement(shared, camera, culling, word, {1, 3});
        }
    }
    EXPECT_GT(covered, 100'000u);
}

TEST(Agreement, EveryPresetDrawsWhatTheReferenceDrawsOnTheSharedModels)
{
    const auto folder = std::filesystem::path(ZSCOPE_SOURCE_DIR) / ".." / "shared" / "models";
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no folder of shared models";
    int models = 0;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        if (file.path().extension() != ".obj") continue;
        auto scene = loadScene(file.path().string());
        ASSERT_TRUE(scene.ok()) << scene.error().text();
        const auto   shared  = std::make_shared<const Scene>(*std::move(scene));
        const bool   isBunny = file.path().stem() == "stanford-bunny";
        const Camera camera  = isBunny ? cameraFor(*shared, 1600, 900) : cameraFor(*shared, 321, 243);
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            EXPECT_GT(expectAgreement(shared, camera, culling, file.path().filename().string(), {1, 2}), 0u);
        }
        ++models;
    }
    EXPECT_GT(models, 0);
}

TEST(Agreement, SampledVerificationFindsTheSamePictures)
{
    const Soup soup = makeSoup(SoupKind::Turned, 5, 301, 203);
    const auto rows = verify({.scene      = std::make_shared<const PreparedScene>(soup.scene),
                              .camera     = soup.camera,
                              .algorithms = exactPresets(),
                              .samples    = 500});
    ASSERT_TRUE(rows.ok());
    ASSERT_EQ(rows->size(), exactPresets().size());
    for (const VerifyRow& row : *rows) {
        EXPECT_EQ(row.figures.pixels, 500u);
        EXPECT_GT(row.figures.covered, 50u);
        EXPECT_TRUE(row.passed()) << row.algorithm;
    }
}

TEST(Agreement, VerificationSeesAPictureThatIsWrongInOnePixel)
{
    const Soup soup    = makeSoup(SoupKind::Grid, 5, 61, 43);
    const auto picture = referencePicture(*soup.scene, soup.camera, FaceCulling::None);
    ASSERT_TRUE(picture.ok());
    Picture wrong = *picture;
    auto&   id    = *std::ranges::find_if(wrong.ids.values(), [](std::int64_t i) { return i >= 0; });
    id            = id + 1;
    VerifyRow row{.algorithm = "zbuffer", .figures = compare(*picture, wrong)};
    EXPECT_FALSE(row.passed());
    row.claim = Claim::Approximate;
    EXPECT_TRUE(row.passed()) << "an approximate method publishes its figures; it is not judged";
}

TEST(Soups, AreDecidedByTheirKindAndSeed)
{
    for (const SoupKind kind : soupKinds()) {
        EXPECT_EQ(makeSoup(kind, 7, 40, 30).scene->digest, makeSoup(kind, 7, 40, 30).scene->digest);
        EXPECT_NE(makeSoup(kind, 7, 40, 30).scene->digest, makeSoup(kind, 8, 40, 30).scene->digest) << nameOf(kind);
    }
}

}  // namespace
}  // namespace zscope::tests
