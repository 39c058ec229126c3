// Levels L0 and L1 of docs/correctness.md: every preset, at every thread count and on every vector target of this
// machine, draws the reference's picture, ids and depth bits, on soups, generated scenes and shared models.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/measure/verify.h"
#include "core/scene/generators/random.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// 500 soups are cut into tests of 20, so that they run side by side and a failure is found quickly.
constexpr std::uint64_t kSoups = 500, kSoupsPerTest = 20;

class AgreementOnSoups : public testing::TestWithParam<std::uint64_t> {};

TEST_P(AgreementOnSoups, EveryPresetDrawsWhatTheReferenceDraws)
{
    static constexpr std::array<std::array<int, 2>, 10> kSizes{
        {{1, 1}, {1, 67}, {83, 1}, {2, 3}, {33, 17}, {64, 64}, {127, 95}, {257, 193}, {15, 16}, {17, 130}}};
    std::uint64_t covered = 0;
    for (std::uint64_t seed = GetParam(); seed < GetParam() + shareOf(kSoupsPerTest); ++seed) {
        const SoupKind kind        = soupKinds()[seed % soupKinds().size()];
        const bool     large       = seed % 125 == 99;  // four of the soups are as large as a window
        const auto [width, height] = large ? std::array{1023, 769} : kSizes[seed % kSizes.size()];
        const Soup soup            = makeSoup(kind, seed, width, height, large ? 16 : 60);
        const auto scene           = prepared(soup.scene);
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            covered += expectAgreement(scene, soup.camera, culling, soup.what);
        }
    }
    if (shareOf(kSoupsPerTest) == kSoupsPerTest) {
        EXPECT_GT(covered, 1000u);
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, AgreementOnSoups, testing::Range(std::uint64_t{0}, kSoups, kSoupsPerTest));

/// Triangles whose planes the eye looks along, a few pixels long and through a pixel's centre: without area before they
/// snap, so that their depths come from where they snap to.
TEST(Agreement, OfTrianglesWithoutAreaBeforeTheySnapTheSnappedPlaneCounts)
{
    const Camera         camera = plainCamera(128, 96);
    Random               random(21);
    std::vector<Corners> triangles(shareOf(5000));
    for (Corners& corners : triangles) {
        const double x  = 0.5 + static_cast<double>(4 + random.below(120)),
                     y  = 0.5 + static_cast<double>(4 + random.below(88));
        const double dx = random.between(-4, 4), dy = random.between(-4, 4);
        const double along[] = {random.between(-1, -0.2), random.between(0.2, 1), random.between(-1, 1)};
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = pointAt(camera, x + along[i] * dx, y + along[i] * dy, random.between(2, 40));
    }
    const std::uint64_t covered =
        expectAgreement(prepared(sceneOf(triangles)), camera, FaceCulling::None, "seen edge on");
    EXPECT_GT(covered, triangles.size() / 20);
}

/// One test per generated scene.
class AgreementOnGenerated : public testing::TestWithParam<std::string> {};

/// By default some are as large as a benchmark wants them.
std::string smallWordOf(const std::string& name)
{
    static const std::map<std::string, std::string> kSmaller{
        {"soccer-field", "?count=15"},   {"city", "?blocks=3"},
        {"wall-and-city", "?blocks=3"},  {"rows", "?nx=3&ny=2&nz=4&model=teapot"},
        {"office-tower", "?n=2"},        {"million", "?faces=50000"},
        {"hard/A6", "?triangles=60000"}, {"hard/F9", "?polygons=8000"}};
    const auto smaller = kSmaller.find(name);
    return "builtin:" + name + (smaller == kSmaller.end() ? "" : smaller->second);
}

TEST_P(AgreementOnGenerated, EveryPresetDrawsWhatTheReferenceDraws)
{
    const std::string word   = smallWordOf(GetParam());
    auto              loaded = loadScene(word);
    ASSERT_TRUE(loaded.ok()) << word << ": " << loaded.error().text();
    const auto   shared = std::make_shared<const Scene>(*std::move(loaded));
    const auto   scene  = prepared(shared);
    const Camera camera = cameraFor(*shared, 241, 163);
    for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
        const std::uint64_t covered = expectAgreement(scene, camera, culling, word, {.threads = {1, 3}});
        if (culling == FaceCulling::None && GetParam().find('/') == std::string::npos) {
            EXPECT_GT(covered, 5000u) << word;
        }
    }
}

std::vector<std::string> namesOfGenerated()
{
    std::vector<std::string> names;
    for (const SceneEntry& entry : builtinScenes()) names.emplace_back(entry.name);
    return names;
}
INSTANTIATE_TEST_SUITE_P(Builtin, AgreementOnGenerated, testing::ValuesIn(namesOfGenerated()), [](const auto& test) {
    std::string name = test.param;
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '-'; }, '_');
    return name;
});

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
        const auto   ready   = prepared(shared);
        const bool   isBunny = file.path().stem() == "stanford-bunny";
        const Camera camera  = isBunny ? cameraFor(*shared, 1600, 900) : cameraFor(*shared, 321, 243);
        for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
            EXPECT_GT(expectAgreement(ready, camera, culling, file.path().filename().string(), {.threads = {1, 2}}),
                      0u);
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
