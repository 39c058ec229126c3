// When depth is tested and fragments are shaded: no moment changes a colour, what shading costs is really paid, and the
// counters tell what each moment spared.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/frame/renderer.h"
#include "core/lesson/replay.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

struct Seen {
    std::string                          what;
    std::shared_ptr<const PreparedScene> scene;
    Camera                               camera;

    DrawRequest request(const Pipeline& pipeline) const
    {
        return {.scene = scene, .camera = camera, .pipeline = pipeline, .threads = 1};
    }
};

Seen soup(SoupKind kind, std::uint64_t seed, int width, int height)
{
    const Soup made = makeSoup(kind, seed, width, height);
    return {made.what, std::make_shared<const PreparedScene>(made.scene), made.camera};
}

Seen builtin(const std::string& word, int width, int height)
{
    Result<Scene> loaded = loadScene("builtin:" + word);
    EXPECT_TRUE(loaded.ok()) << word;
    const auto scene = std::make_shared<const Scene>(*std::move(loaded));
    return {word, std::make_shared<const PreparedScene>(scene), cameraFor(*scene, width, height)};
}

Pipeline at(DepthMoment moment, ShadingCost cost = ShadingCost::None) { return {.depth = moment, .cost = cost}; }

Frame drawn(const DrawRequest& request)
{
    Renderer   renderer;
    Frame      frame;
    const auto report = renderer.draw(request, frame);
    EXPECT_TRUE(report.ok());
    return frame;
}

std::map<std::string, std::uint64_t> counted(const Seen& seen, DepthMoment moment)
{
    Renderer                             renderer;
    std::map<std::string, std::uint64_t> counts;
    const Result<FrameWork>              work = renderer.count(seen.request(at(moment)));
    EXPECT_TRUE(work.ok());
    for (const NamedCount& counter : work->counters) counts[counter.name] = counter.value;
    return counts;
}

constexpr std::array kCosts{ShadingCost::None, ShadingCost::Ten, ShadingCost::Hundred, ShadingCost::Thousand};
constexpr std::array kMoments{DepthMoment::Deferred, DepthMoment::Late, DepthMoment::Early, DepthMoment::ZCull,
                              DepthMoment::Prepass};

std::uint64_t covered(const Frame& frame)
{
    std::uint64_t pixels = 0;
    for (int y = 0; y < frame.visible.height(); ++y)
        for (int x = 0; x < frame.visible.width(); ++x) pixels += frame.visible.rankAt(x, y) != 0;
    return pixels;
}

TEST(Moment, EveryPresetColoursThePictureAsDeferredShadingDoes)
{
    const std::array scenes{soup(SoupKind::Loose, 3, 83, 37),          soup(SoupKind::Coplanar, 5, 33, 64),
                            soup(SoupKind::BeyondTheGuard, 7, 65, 31), soup(SoupKind::Repeated, 11, 17, 9),
                            soup(SoupKind::BeyondFar, 13, 1, 50),      builtin("layers?count=12&order=back", 61, 43)};
    for (const Seen& seen : scenes) {
        for (const ShadingCost cost : kCosts) {
            const Frame expected = drawn(seen.request(at(DepthMoment::Deferred, cost)));
            for (const Preset& preset : exactPresets()) {
                for (const Simd simd : targetsTested()) {
                    for (const int threads : {1, 3}) {
                        DrawRequest request   = seen.request(preset.pipeline);
                        request.pipeline.cost = cost;
                        request.simd          = simd;
                        request.threads       = threads;
                        if (preset.claim != Claim::Exact) continue;
                        const Frame frame = drawn(request);
                        EXPECT_EQ(frame.colour, expected.colour)
                            << seen.what << ", " << preset.name << ", " << wordOf(simd) << ", " << threads
                            << " threads, cost " << operationsOf(cost);
                    }
                }
            }
        }
    }
}

TEST(Moment, EdgeWalksShadeWithEachFragmentToo)
{
    const Seen  seen     = soup(SoupKind::Turned, 21, 75, 41);
    const Frame expected = drawn(seen.request(at(DepthMoment::Deferred, ShadingCost::Ten)));
    for (const DepthMoment moment : {DepthMoment::Late, DepthMoment::Early, DepthMoment::Prepass}) {
        Pipeline pipeline = at(moment, ShadingCost::Ten);
        pipeline.scan     = Scan::EdgeWalk;
        EXPECT_EQ(drawn(seen.request(pipeline)).colour, expected.colour) << static_cast<int>(moment);
    }
}

TEST(Moment, WhatShadingCostsReachesTheLastBitOfBlueAndNothingElse)
{
    const Seen         seen = soup(SoupKind::Loose, 4, 64, 48);
    const Frame        free = drawn(seen.request(at(DepthMoment::Late)));
    std::vector<Frame> paid;
    for (const ShadingCost cost : {ShadingCost::Ten, ShadingCost::Hundred, ShadingCost::Thousand}) {
        paid.push_back(drawn(seen.request(at(DepthMoment::Late, cost))));
        std::uint64_t changed = 0, shown = covered(free);
        ASSERT_GT(shown, 200u);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x < 64; ++x) {
                const std::uint32_t difference = free.colour.at(x, y) ^ paid.back().colour.at(x, y);
                EXPECT_LE(difference, free.visible.rankAt(x, y) == 0 ? 0u : 1u) << x << ", " << y;
                changed += difference;
            }
        }
        EXPECT_GT(changed, shown / 4) << "the end of a chain is as good as thrown by a coin";
        EXPECT_LT(changed, shown - shown / 4);
    }
    EXPECT_NE(paid[0].colour, paid[1].colour) << "a longer chain ends elsewhere, so no operation was left out";
    EXPECT_NE(paid[1].colour, paid[2].colour);
}

TEST(Moment, CountersSayWhatEachMomentTestsAndShades)
{
    const Seen near           = builtin("layers?count=20&order=front", 96, 64),
               far            = builtin("layers?count=20&order=back", 96, 64);
    const std::uint64_t shown = covered(drawn(near.request(at(DepthMoment::Deferred))));
    ASSERT_GT(shown, 1000u);
    for (const Seen& seen : {near, far}) {
        SCOPED_TRACE(seen.what);
        auto deferred = counted(seen, DepthMoment::Deferred), late = counted(seen, DepthMoment::Late),
             early = counted(seen, DepthMoment::Early), zcull = counted(seen, DepthMoment::ZCull),
             prepass = counted(seen, DepthMoment::Prepass);
        EXPECT_EQ(deferred["fragments_shaded"], shown);
        EXPECT_EQ(late["fragments_shaded"], late["fragments_tested"]) << "late shades whatever is covered";
        EXPECT_EQ(late["fragments_tested"], deferred["fragments_tested"]);
        EXPECT_EQ(early["fragments_shaded"], early["pixels_won"]);
        EXPECT_EQ(early["fragments_tested"], deferred["fragments_tested"]);
        EXPECT_EQ(zcull["fragments_shaded"], early["fragments_shaded"])
            << "a rejected tile holds no fragment that could pass";
        EXPECT_EQ(prepass["fragments_shaded"], shown) << "no two layers are equally near";
        EXPECT_EQ(prepass["fragments_tested"], 2 * deferred["fragments_tested"]);
        for (auto* none : {&deferred, &late, &early, &prepass}) EXPECT_EQ((*none)["tiles_rejected"], 0u);
    }
    auto inOrder = counted(near, DepthMoment::Early), against = counted(far, DepthMoment::Early),
         tiles = counted(near, DepthMoment::ZCull);
    EXPECT_EQ(inOrder["fragments_shaded"], shown) << "near layers first: nothing hidden is shaded";
    EXPECT_GT(against["fragments_shaded"], 10 * shown);
    EXPECT_GT(tiles["tiles_rejected"], 0u);
    EXPECT_LT(tiles["fragments_tested"], inOrder["fragments_tested"] / 4);
}

TEST(Moment, StagesThatDidNotRunSayWhy)
{
    const Seen seen = soup(SoupKind::Loose, 4, 16, 16);
    Renderer   renderer;
    Frame      frame;
    for (const DepthMoment moment : kMoments) {
        const Result<FrameReport> report = renderer.draw(seen.request(at(moment)), frame);
        ASSERT_TRUE(report.ok());
        for (const StageTime& stage : report->stages) {
            if (stage.stage == Stage::Shade) {
                EXPECT_EQ(stage.ran, moment == DepthMoment::Deferred);
                EXPECT_EQ(stage.why.starts_with("shaded with each fragment"), moment != DepthMoment::Deferred)
                    << stage.why;
            }
            if (stage.stage == Stage::Prepass) {
                EXPECT_EQ(stage.ran, moment == DepthMoment::Prepass) << stage.why;
            }
        }
    }
}

TEST(Moment, SweepsAndEdgeWalksSayWhichMomentsTheyHaveNot)
{
    for (const DepthMoment moment : {DepthMoment::Late, DepthMoment::Early, DepthMoment::ZCull, DepthMoment::Prepass}) {
        for (const Scan scan : {Scan::SweepZLine, Scan::SweepIntervals}) {
            const auto why = explainInvalid({.scan = scan, .depth = moment});
            ASSERT_TRUE(why.has_value());
            EXPECT_NE(why->find("decides each line once and shades it once"), std::string::npos) << *why;
        }
    }
    EXPECT_TRUE(explainInvalid({.scan = Scan::EdgeWalk, .depth = DepthMoment::ZCull}).has_value());
    EXPECT_FALSE(explainInvalid({.scan = Scan::SweepIntervals, .cost = ShadingCost::Hundred}).has_value());
}

TEST(Moment, EveryStepHasTheColoursOfItsWinnersAndASentenceThatSaysWhatWasShaded)
{
    const Seen seen = builtin("layers?count=3&order=front", 12, 9);
    for (const DepthMoment moment : kMoments) {
        DrawRequest shaded = seen.request(at(moment, ShadingCost::Ten)), unshaded = shaded;
        unshaded.shade = false;
        Replay              steps(shaded), same(unshaded);
        const std::uint64_t count  = *steps.count(Grain::Pixel);
        std::uint64_t       tested = 0, vain = 0, spared = 0, rejected = 0;
        for (std::uint64_t k = 0; k < count; k += 7) {
            const Result<StepState> state = steps.at(Grain::Pixel, StepIndex{k});
            ASSERT_TRUE(state.ok());
            SCOPED_TRACE(state->sentence);
            if (state->tile) rejected += state->tile->rejected && state->sentence.find("rejected") != std::string::npos;
            if (!state->pixel || state->pixel->keep == Keep::DepthOnly) continue;
            const PixelState& pixel = *state->pixel;
            ++tested;
            EXPECT_EQ(pixel.shaded, moment == DepthMoment::Late || (moment != DepthMoment::Deferred && pixel.won));
            EXPECT_EQ(state->sentence.find("shaded although hidden") != std::string::npos, pixel.shaded && !pixel.won);
            EXPECT_EQ(state->sentence.find("only now is it shaded") != std::string::npos,
                      moment != DepthMoment::Late && pixel.shaded);
            vain += pixel.shaded && !pixel.won;
            spared += state->sentence.find("never shaded") != std::string::npos;
            const Result<StepState> known = same.at(Grain::Pixel, StepIndex{k});
            ASSERT_TRUE(known.ok());
            EXPECT_EQ(state->frame.colour, known->frame.colour) << "shaded for the lesson from the winners so far";
        }
        EXPECT_GT(tested, 0u);
        EXPECT_EQ(vain > 0, moment == DepthMoment::Late);
        EXPECT_EQ(spared > 0, moment == DepthMoment::Early || moment == DepthMoment::Prepass);
        EXPECT_EQ(rejected > 0, moment == DepthMoment::ZCull);
    }
}

}  // namespace
}  // namespace zscope::tests
