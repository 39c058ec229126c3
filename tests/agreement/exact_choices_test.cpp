// Choices that change the work and never the picture: each is put into the methods it fits, and every picture is the
// reference's, without a false cull.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/lesson/replay.h"
#include "core/measure/cull_audit.h"
#include "core/measure/verify.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

struct Choice {
    const char* axis;
    const char* word;
};
constexpr Choice kChoices[] = {
    {"upkeep", "pushed"}, {"upkeep", "pushed-farthest"}, {"query", "triangle"}, {"upkeep", "masked"}};

Pipeline with(const char* preset, const Choice& choice)
{
    const auto pipeline = withChoice(findPreset(preset)->pipeline, choice.axis, choice.word);
    EXPECT_TRUE(pipeline.ok());
    EXPECT_FALSE(explainInvalid(*pipeline))
        << preset << ", " << choice.word << ": " << explainInvalid(*pipeline).value_or("");
    EXPECT_EQ(claimOf(*pipeline), Claim::Exact) << choice.word;
    return *pipeline;
}

/// The names live as long as the list that they are taken from.
std::vector<std::pair<std::string, Pipeline>> methods()
{
    std::vector<std::pair<std::string, Pipeline>> all;
    for (const char* preset : {"hzb-octree", "hzb-bvh", "quadtree"})
        for (const Choice& choice : kChoices) {
            const Pipeline pipeline = with(preset, choice);
            all.emplace_back(nameOf(pipeline), pipeline);
        }
    return all;
}

std::uint64_t expectExact(const std::shared_ptr<const Scene>& scene, const Camera& camera, const std::string& what)
{
    const auto          named = methods();
    std::vector<Preset> algorithms;
    for (const auto& [name, pipeline] : named) algorithms.push_back({name, {}, pipeline, claimOf(pipeline)});
    const auto rows = verify({.scene      = std::make_shared<const PreparedScene>(scene),
                              .camera     = camera,
                              .algorithms = std::move(algorithms),
                              .threads    = {1, 3},
                              .simd       = {Simd::Scalar, resolved(Simd::Auto)}});
    EXPECT_TRUE(rows.ok());
    if (!rows) return 0;
    for (const VerifyRow& row : *rows)
        EXPECT_TRUE(row.passed()) << what << ", " << row.algorithm << ", " << row.threads
                                  << " threads: " << row.figures.holes << " holes, " << row.figures.wrongSurface()
                                  << " wrong surfaces, " << row.falseCulls << " false culls";
    return rows->front().figures.covered;
}

class ExactChoicesOnSoups : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ExactChoicesOnSoups, DrawWhatTheReferenceDraws)
{
    static constexpr std::array<std::array<int, 2>, 6> kSizes{
        {{1, 67}, {83, 1}, {64, 64}, {127, 95}, {257, 193}, {17, 130}}};
    std::uint64_t covered = 0;
    for (std::uint64_t seed = GetParam(); seed < GetParam() + shareOf(20); ++seed) {
        const SoupKind kind        = soupKinds()[seed % soupKinds().size()];
        const auto [width, height] = kSizes[seed % kSizes.size()];
        const Soup soup            = makeSoup(kind, seed, width, height, 60);
        covered += expectExact(soup.scene, soup.camera, soup.what);
    }
    if (shareOf(20) == 20) {
        EXPECT_GT(covered, 1000u);
    }
}
INSTANTIATE_TEST_SUITE_P(Seeds, ExactChoicesOnSoups,
                         testing::Range(std::uint64_t{1000}, std::uint64_t{1120}, std::uint64_t{20}));

class ExactChoicesOnScenes : public testing::TestWithParam<const char*> {};

TEST_P(ExactChoicesOnScenes, DrawWhatTheReferenceDraws)
{
    auto loaded = loadScene(std::string("builtin:") + GetParam());
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    const auto scene = std::make_shared<const Scene>(*std::move(loaded));
    EXPECT_GT(expectExact(scene, cameraFor(*scene, 241, 163), GetParam()), 0u);
}
INSTANTIATE_TEST_SUITE_P(Builtin, ExactChoicesOnScenes,
                         testing::Values("soccer-field?count=12", "wall-and-city?blocks=3", "layers?count=20", "cubes",
                                         "cutouts", "reliefs", "hard/A11", "hard/B5", "hard/C4", "hard/D1", "hard/D2",
                                         "hard/D4", "hard/D6", "hard/D7", "hard/D9"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::ranges::replace_if(
                                 name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
                             return name;
                         });

/// Lines that are crowded on their right only, between lines that are not: the interval method finds it out in the
/// middle of a line.
std::shared_ptr<const Scene> crowdedOnTheRight(const Camera& camera)
{
    std::vector<Corners> triangles;
    const auto           add = [&](double z, double x, double y, double width, double height) {
        triangles.push_back({pointAt(camera, x, y, z), pointAt(camera, x + width, y + height / 2, z + 1),
                             pointAt(camera, x, y + height, z)});
    };
    // a few on the left, on most lines
    for (int i = 0; i < 20; ++i) add(3 + 0.25 * i, 2 + i, 3 + 2 * i, 30, 40);
    // 400 one upon the other, on some
    for (int i = 0; i < 400; ++i) add(20 - 0.03125 * i, 50 + 0.1 * i, 20 + 0.05 * i, 60, 50);
    return sceneOf(triangles);
}

TEST(ExactChoices, CrowdsThatBeginInTheMiddleOfALineAreDrawnLikeTheReference)
{
    const Camera        camera = plainCamera(128, 96);
    std::vector<Preset> algorithms;
    for (const char* name : {"interval", "interval-polygon", "scanline"}) algorithms.push_back(*findPreset(name));
    const auto rows = verify({.scene      = std::make_shared<const PreparedScene>(crowdedOnTheRight(camera)),
                              .camera     = camera,
                              .algorithms = std::move(algorithms),
                              .threads    = {1, 2},
                              .simd       = {Simd::Scalar, resolved(Simd::Auto)}});
    ASSERT_TRUE(rows.ok());
    for (const VerifyRow& row : *rows) EXPECT_TRUE(row.passed()) << row.algorithm << ", " << row.threads << " threads";
    EXPECT_GT(rows->front().figures.covered, 3000u);
}

TEST(ExactChoices, CrowdsByWrongRulesAreDrawnAsTheyAreStepped)
{
    const Camera camera = plainCamera(320, 200);
    for (const Fault fault : {Fault::EdgesUnsorted, Fault::OneTestPerInterval}) {
        DrawRequest request{.scene    = std::make_shared<const PreparedScene>(crowdedOnTheRight(camera)),
                            .camera   = camera,
                            .pipeline = findPreset("interval")->pipeline,
                            .threads  = 1};
        request.pipeline.fault = fault;
        Frame drawn;
        ASSERT_TRUE(Renderer().draw(request, drawn).ok());
        Replay     replay(request);
        const auto count = replay.count(Grain::Line);
        ASSERT_TRUE(count.ok());
        const auto last = replay.at(Grain::Line, StepIndex{*count - 1});
        ASSERT_TRUE(last.ok());
        EXPECT_TRUE(pictureOf(drawn.visible) == pictureOf(last->frame.visible)) << static_cast<int>(fault);
    }
}

DrawRequest requestOf(const std::string& word, const Pipeline& pipeline)
{
    auto loaded = loadScene("builtin:" + word);
    EXPECT_TRUE(loaded.ok());
    const auto scene = std::make_shared<const Scene>(*std::move(loaded));
    return {.scene    = std::make_shared<const PreparedScene>(scene),
            .camera   = cameraFor(*scene, 241, 163),
            .pipeline = pipeline,
            .threads  = 1};
}

/// What the counting run of a scene says.
struct Counted {
    FrameWork                            work;
    std::map<std::string, std::uint64_t> counters;
};

Counted countedOn(const std::string& word, const Pipeline& pipeline)
{
    Renderer   renderer;
    const auto work = renderer.count(requestOf(word, pipeline));
    EXPECT_TRUE(work.ok());
    Counted counted{*work, {}};
    for (const NamedCount& count : work->counters) counted.counters[std::string(count.name)] = count.value;
    return counted;
}

TEST(Upkeep, WritesAndLevelsUpdatedAddUpOverTheLevels)
{
    for (const char* upkeep : {"on-query", "pushed", "pushed-farthest"}) {
        SCOPED_TRACE(upkeep);
        Counted       counted = countedOn("soccer-field?count=12", with("hzb-octree", {"upkeep", upkeep}));
        std::uint64_t written = 0, changed = 0;
        for (const LevelWork& level : counted.work.levels) {
            written += level.cellsWritten;
            changed += level.cellsChanged;
            EXPECT_LE(level.cellsChanged, level.cellsWritten);
        }
        EXPECT_GT(changed, 100u);
        EXPECT_EQ(counted.counters["pyramid_writes"], written);
        EXPECT_EQ(counted.counters["pyramid_levels_updated"], changed);
        EXPECT_EQ(counted.counters["updates"], counted.work.levels.front().cellsWritten);
    }
}

TEST(Upkeep, PushingStopsAtTheFirstLevelThatDoesNotChange)
{
    for (const char* word : {"hard/D9", "soccer-field?count=12"})
        for (const char* upkeep : {"pushed", "pushed-farthest"}) {
            const Counted counted = countedOn(word, with("quadtree", {"upkeep", upkeep}));
            const auto&   levels  = counted.work.levels;
            ASSERT_GT(levels.size(), 2u);
            std::uint64_t stopped = 0;
            for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
                EXPECT_EQ(levels[i + 1].cellsWritten, levels[i].cellsChanged)
                    << word << ", " << upkeep << ", level " << levels[i + 1].level;
                stopped += levels[i].cellsWritten - levels[i].cellsChanged;
            }
            EXPECT_GT(stopped, counted.counters.at("updates") / 4) << word << ", " << upkeep;
        }
}

TEST(Upkeep, PushingCullsWhatRefreshingOnQueryCulls)
{
    // Triangles where nobody asks about nodes: else questions that refresh are not asked about small ones.
    const auto hidden = [](const char* upkeep) {
        const std::string scene = "soccer-field?count=12";
        const Counted     nodes = countedOn(scene, with("hzb-octree", {"upkeep", upkeep})),
                      triangles = countedOn(scene, with("octree-order", {"upkeep", upkeep}));
        EXPECT_GT(nodes.counters.at("triangles_hidden_by_node"), 0u);
        EXPECT_GT(triangles.counters.at("triangles_hidden"), 0u);
        return std::pair(nodes.counters.at("triangles_hidden_by_node"), triangles.counters.at("triangles_hidden"));
    };
    EXPECT_EQ(hidden("pushed"), hidden("on-query"));
    EXPECT_EQ(hidden("pushed-farthest"), hidden("on-query"));
}

TEST(Upkeep, BeginningAtTheFarthestCornerChangesFewerAncestors)
{
    const auto aboveTiles = [](const char* upkeep) {
        const Counted counted = countedOn("wall-and-city?blocks=3", with("quadtree", {"upkeep", upkeep}));
        return counted.counters.at("pyramid_levels_updated") - counted.work.levels.front().cellsChanged;
    };
    EXPECT_LT(aboveTiles("pushed-farthest"), aboveTiles("pushed"));
}

/// Triangles hidden one by one, and those drawn although a perfect test of their box would have hidden them.
struct Culled {
    std::uint64_t hidden, missed;
};

Culled culledOn(const std::string& word, const Pipeline& pipeline)
{
    const DrawRequest request = requestOf(word, pipeline);
    Renderer          renderer;
    Frame             frame;
    EXPECT_TRUE(renderer.draw(request, frame).ok());
    const Picture picture = pictureOf(frame.visible);
    const auto    audit   = auditCulls(request, frame.visible, picture.ids.values());
    EXPECT_TRUE(audit.ok());
    EXPECT_EQ(audit->falseCulls.total(), 0u) << word;
    return {audit->trianglesHidden, audit->missedTriangles};
}

TEST(TriangleQuery, HidesMoreThanTheBoxDoesAndMissesLess)
{
    for (const char* word : {"city?blocks=3", "soccer-field?count=40"}) {
        const Culled box      = culledOn(word, findPreset("hzb-octree")->pipeline);
        const Culled triangle = culledOn(word, with("hzb-octree", {"query", "triangle"}));
        EXPECT_GT(triangle.hidden, box.hidden) << word;
        EXPECT_LT(triangle.missed, box.missed) << word;
    }
}

TEST(Upkeep, MaskedForgetsAndSoMissesCullsButMakesNoFalseOnes)
{
    for (const char* word : {"wall-and-city?blocks=3", "soccer-field?count=40"}) {
        const Culled kept   = culledOn(word, findPreset("quadtree")->pipeline);
        const Culled masked = culledOn(word, with("quadtree", {"upkeep", "masked"}));
        EXPECT_GT(masked.hidden, 0u) << word;
        EXPECT_LT(masked.hidden, kept.hidden) << word;
        EXPECT_GT(masked.missed, kept.missed) << word;
    }
}

TEST(TriangleQuery, IsRefusedWhereNobodyAsksAboutTriangles)
{
    for (const Preset& preset : presets()) {
        Pipeline pipeline = preset.pipeline;
        pipeline.query    = TriangleQuery::Triangle;
        EXPECT_EQ(explainInvalid(pipeline).has_value(), !asksTriangles(pipeline.cull)) << preset.name;
    }
}

}  // namespace
}  // namespace zscope::tests
