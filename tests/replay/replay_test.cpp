// Stepping is re-execution: any step, reached in any order, is the same state, and the last one is the picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include <malloc.h>
#include <unistd.h>

#include "tests/replay/replay_support.h"

namespace zscope::tests {
namespace {

/// The cubes with every other face of glass.
SeenScene cubesOfGlass(int width, int height)
{
    SeenScene seen  = builtinScene("cubes", width, height);
    Scene     scene = seen.scene->scene();
    for (auto& mesh : scene.meshes) {
        auto glass = std::make_shared<Mesh>(*mesh);
        glass->materials.push_back({"glass", {0.2f, 0.4f, 0.9f}, 0.5f});
        const MaterialId added{static_cast<std::uint32_t>(glass->materials.size() - 1)};
        for (std::size_t p = 0; p < glass->polygonMaterial.size(); p += 2) glass->polygonMaterial[p] = added;
        mesh = std::move(glass);
    }
    seen.what  = "cubes of glass";
    seen.scene = std::make_shared<const PreparedScene>(std::make_shared<const Scene>(std::move(scene)));
    return seen;
}

std::vector<SeenScene> smallScenes()
{
    return {soupScene(SoupKind::Loose, 11, 24, 17, 10),
            soupScene(SoupKind::NearCrossing, 12, 19, 23, 12),
            soupScene(SoupKind::Turned, 13, 21, 16, 8),
            soupScene(SoupKind::BeyondTheGuard, 14, 16, 16, 10),
            soupScene(SoupKind::BeyondFar, 15, 20, 15, 10),
            soupScene(SoupKind::Loose, 16, 1, 33, 10),
            soupScene(SoupKind::OnTheGrid, 17, 33, 1, 12),
            builtinScene("cubes", 31, 22),
            cubesOfGlass(23, 17)};
}

std::string where(const SeenScene& seen, const Preset& preset, Grain grain)
{
    return seen.what + ", " + std::string(preset.name) + ", grain " + std::string(wordOf(grain));
}

/// Runs `check(seen, preset, grain, replay, count)` for every preset and every grain it has.
template <class Check>
void forEveryGrain(const std::vector<SeenScene>& scenes, const Check& check)
{
    for (const SeenScene& seen : scenes) {
        for (const Preset& preset : presets()) {
            Replay replay(seen.request(preset.pipeline));
            for (const Grain grain : grainsOf(preset.pipeline)) {
                SCOPED_TRACE(where(seen, preset, grain));
                const Result<std::uint64_t> count = replay.count(grain);
                ASSERT_TRUE(count.ok()) << count.error().text();
                check(seen, preset, grain, replay, *count);
            }
        }
    }
}

StepState stateAt(Replay& replay, Grain grain, std::uint64_t step)
{
    Result<StepState> state = replay.at(grain, StepIndex{step});
    EXPECT_TRUE(state.ok()) << state.error().text();
    return state ? std::move(*state) : StepState{};
}

TEST(Replay, EveryGrainOfEveryPresetHasAStepAndAFrameHasExactlyOne)
{
    forEveryGrain(smallScenes(), [](const SeenScene&, const Preset&, Grain grain, Replay&, std::uint64_t count) {
        EXPECT_GE(count, 1u);
        if (grain == Grain::Frame) {
            EXPECT_EQ(count, 1u);
        }
    });
}

TEST(Replay, EveryStepLiesInTheStageWhoseMarkPrecedesIt)
{
    forEveryGrain(smallScenes(), [](const SeenScene&, const Preset&, Grain grain, Replay& replay, std::uint64_t count) {
        const Result<std::vector<StageMark>> stages = replay.stages(grain);
        ASSERT_TRUE(stages.ok()) << stages.error().text();
        ASSERT_FALSE(stages->empty());
        EXPECT_EQ(stages->front().first, 0u);
        for (std::size_t i = 0; i < stages->size(); ++i) {
            const std::uint64_t end = i + 1 < stages->size() ? (*stages)[i + 1].first : count;
            ASSERT_LT((*stages)[i].first, end);
            for (const std::uint64_t step : {(*stages)[i].first, end - 1})
                EXPECT_EQ(stateAt(replay, grain, step).stage, (*stages)[i].stage) << step;
        }
    });
}

TEST(Replay, TheLastStepIsThePictureThatDrawMakes)
{
    forEveryGrain(smallScenes(),
                  [](const SeenScene& seen, const Preset& preset, Grain grain, Replay& replay, std::uint64_t count) {
                      Renderer                  renderer;
                      Frame                     frame;
                      const Result<FrameReport> drawn = renderer.draw(seen.request(preset.pipeline), frame);
                      ASSERT_TRUE(drawn.ok()) << drawn.error().text();
                      const StepState last = stateAt(replay, grain, count - 1);
                      EXPECT_EQ(pictureOf(last.frame.visible), pictureOf(frame.visible));
                      EXPECT_EQ(last.frame.colour, frame.colour);
                      EXPECT_EQ(last.event, Grain::Frame);
                      EXPECT_EQ(last.count, count);
                      EXPECT_EQ(last.step.value, count - 1);
                  });
}

TEST(Replay, AStepIsTheSameWhetherReachedForwardsBackwardsOrAtRandom)
{
    forEveryGrain(smallScenes(), [](const SeenScene& seen, const Preset& preset, Grain grain, Replay&,
                                    std::uint64_t count) {
        std::mt19937_64            random(count * 31 + static_cast<std::uint64_t>(grain));
        std::vector<std::uint64_t> steps{0, count - 1};
        for (int i = 0; i < 20; ++i) steps.push_back(random() % count);
        std::ranges::sort(steps);
        Replay                 forwards(seen.request(preset.pipeline));
        std::vector<StepState> states;
        for (const std::uint64_t step : steps) states.push_back(stateAt(forwards, grain, step));

        Replay backwards(seen.request(preset.pipeline));
        for (std::size_t i = steps.size(); i-- > 0;)
            EXPECT_TRUE(areIdentical(stateAt(backwards, grain, steps[i]), states[i])) << "backwards, step " << steps[i];
        for (int i = 0; i < 20; ++i) {
            const std::size_t at = random() % steps.size();
            EXPECT_TRUE(areIdentical(stateAt(forwards, grain, steps[at]), states[at]))
                << "at random, step " << steps[at];
        }
        Replay straight(seen.request(preset.pipeline));  // without having counted first
        EXPECT_TRUE(areIdentical(stateAt(straight, grain, steps[5]), states[5])) << "straight, step " << steps[5];
    });
}

/// The same steps with and without checkpoints to begin at.
void expectTheSameFromCheckpoints(const DrawRequest& request, std::uint64_t& kept)
{
    for (const Grain grain : grainsOf(request.pipeline)) {
        SCOPED_TRACE(std::string(wordOf(grain)));
        Replay fromCheckpoints(request, {.events = 12}),
            fromTheStart(request, {.events = ~std::uint64_t{0}, .bytes = 0});
        const std::uint64_t count = *fromTheStart.count(grain);
        ASSERT_EQ(*fromCheckpoints.count(grain), count);
        ASSERT_EQ(*fromCheckpoints.stages(grain), *fromTheStart.stages(grain));
        ASSERT_EQ(fromTheStart.checkpoints(), 0u);
        kept += fromCheckpoints.checkpoints();
        std::mt19937_64            random(count);
        std::vector<std::uint64_t> steps{count - 1, 0};
        for (int i = 0; i < 16; ++i) steps.push_back(random() % count);
        for (const std::uint64_t step : steps) {
            const StepState straight = stateAt(fromTheStart, grain, step);
            EXPECT_TRUE(areIdentical(stateAt(fromCheckpoints, grain, step), straight)) << "step " << step;
            EXPECT_EQ(contentsOf(stateAt(fromCheckpoints, grain, step)), contentsOf(straight))
                << "step " << step << ", asked again";
        }
    }
}

TEST(Replay, AStepIsTheSameFromACheckpointAsFromTheStart)
{
    std::vector<SeenScene> scenes = smallScenes();
    scenes.push_back(builtinScene("city?blocks=1", 48, 32));
    scenes.push_back(builtinScene("city?blocks=1&seed=3", 40, 30));
    for (const Preset& preset : presets()) {
        std::uint64_t kept = 0;
        for (const SeenScene& seen : scenes) {
            SCOPED_TRACE(seen.what + ", " + std::string(preset.name));
            expectTheSameFromCheckpoints(seen.request(preset.pipeline), kept);
        }
        EXPECT_GT(kept, 0u) << preset.name;
    }
}

TEST(Replay, AStepOfAFaultOrAnApproximationIsTheSameFromACheckpoint)
{
    const SeenScene seen = builtinScene("city?blocks=1&seed=3", 40, 30);
    for (const char* name : {"zbuffer", "scanline", "interval-polygon", "hzb-octree", "two-pass"}) {
        DrawRequest   request               = seen.request(findPreset(name)->pipeline);
        std::uint64_t kept                  = 0;
        request.pipeline.approximation.snap = SnapBits::Four;
        SCOPED_TRACE(name);
        expectTheSameFromCheckpoints(request, kept);
        EXPECT_GT(kept, 0u);
    }
}

TEST(Replay, CheckpointsThatDoNotFitAreKeptFartherApart)
{
    const SeenScene   seen    = builtinScene("city?blocks=1&seed=3", 40, 30);
    const DrawRequest request = seen.request(findPreset("zbuffer")->pipeline);
    Replay            many(request, {.events = 12}), few(request, {.events = 12, .bytes = 200'000}),
        none(request, {.events = 12, .bytes = 1});
    const auto count = *many.count(Grain::Pixel);
    ASSERT_EQ(*few.count(Grain::Pixel), count);
    ASSERT_EQ(*none.count(Grain::Pixel), count);
    EXPECT_GT(many.checkpoints(), few.checkpoints());
    EXPECT_GT(few.checkpoints(), 0u);
    EXPECT_EQ(none.checkpoints(), 0u);
    for (const std::uint64_t step : {count / 3, count - 2}) {
        const StepState state = stateAt(many, Grain::Pixel, step);
        EXPECT_TRUE(areIdentical(stateAt(few, Grain::Pixel, step), state));
        EXPECT_TRUE(areIdentical(stateAt(none, Grain::Pixel, step), state));
    }
}

TEST(Replay, EveryPixelThatIsBlendedIsAStepThatSaysHowManySurfacesItHas)
{
    const SeenScene   seen    = cubesOfGlass(23, 17);
    const DrawRequest request = seen.request(findPreset("zbuffer")->pipeline);
    Renderer          renderer;
    const auto        work = renderer.count(request);
    ASSERT_TRUE(work.ok());
    const auto blended = std::ranges::find(work->counters, "pixels_blended", &NamedCount::name)->value;
    ASSERT_GT(blended, 20u);

    Replay                      replay(request);
    const Result<std::uint64_t> count = replay.count(Grain::Pixel);
    ASSERT_TRUE(count.ok());
    // The last ones are the pixels blended, then the stage and the frame.
    const StepState before = stateAt(replay, Grain::Pixel, *count - 2 - blended - 1);
    EXPECT_FALSE(before.blend);
    for (const std::uint64_t i : {std::uint64_t{0}, blended / 2, blended - 1}) {
        const StepState state = stateAt(replay, Grain::Pixel, *count - 2 - blended + i);
        ASSERT_TRUE(state.blend) << i;
        EXPECT_EQ(state.frame.colour.at(state.blend->x, state.blend->y), state.blend->after);
        EXPECT_NE(state.sentence.find("transparent surface"), std::string::npos) << state.sentence;
    }
}

TEST(Replay, AStepBeyondTheLastIsAUsageError)
{
    forEveryGrain({smallScenes().front()},
                  [](const SeenScene&, const Preset&, Grain grain, Replay& replay, std::uint64_t count) {
                      for (const std::uint64_t step : {count, count + 1, ~std::uint64_t{0}}) {
                          const Result<StepState> state = replay.at(grain, StepIndex{step});
                          ASSERT_FALSE(state.ok()) << step;
                          EXPECT_EQ(state.error().kind, Trouble::Usage);
                          EXPECT_NE(state.error().sentence.find(std::to_string(count - 1)), std::string::npos)
                              << state.error().sentence;
                          EXPECT_FALSE(replay.eventsBy(Grain::Frame, grain, StepIndex{step}).ok());
                      }
                  });
}

TEST(Replay, AGrainThatTheAlgorithmLacksIsAUsageErrorThatNamesItsGrains)
{
    const SeenScene seen = smallScenes().front();
    for (const Preset& preset : presets()) {
        const std::vector<Grain> has = grainsOf(preset.pipeline);
        EXPECT_TRUE(std::ranges::is_sorted(has)) << preset.name;
        Replay replay(seen.request(preset.pipeline));
        for (const Grain grain : kGrains) {
            if (std::ranges::find(has, grain) != has.end()) continue;
            SCOPED_TRACE(where(seen, preset, grain));
            const Result<std::uint64_t> count = replay.count(grain);
            ASSERT_FALSE(count.ok());
            EXPECT_EQ(count.error().kind, Trouble::Usage);
            for (const Grain each : has)
                EXPECT_NE(count.error().sentence.find(wordOf(each)), std::string::npos) << count.error().sentence;
            EXPECT_EQ(replay.at(grain, StepIndex{0}).error().kind, Trouble::Usage);
            EXPECT_EQ(replay.eventsBy(grain, Grain::Frame, StepIndex{0}).error().kind, Trouble::Usage);
        }
    }
}

/// Every step of every grain, so the scene is tiny.
TEST(Replay, StepsOfACoarserGrainAreStepsOfEveryFinerOne)
{
    const std::vector<SeenScene> scenes{soupScene(SoupKind::Loose, 21, 9, 7, 5),
                                        soupScene(SoupKind::NearCrossing, 22, 8, 9, 5)};
    for (const SeenScene& seen : scenes) {
        for (const Preset& preset : presets()) {
            Replay                   replay(seen.request(preset.pipeline));
            const std::vector<Grain> grains = grainsOf(preset.pipeline);
            for (std::size_t f = 1; f < grains.size(); ++f) {
                std::vector<StepState> fine;
                const std::uint64_t    fineCount = *replay.count(grains[f]);
                for (std::uint64_t k = 0; k < fineCount; ++k) fine.push_back(stateAt(replay, grains[f], k));
                for (std::size_t c = 0; c < f; ++c) {
                    SCOPED_TRACE(where(seen, preset, grains[c]) + " in " + std::string(wordOf(grains[f])));
                    std::vector<std::uint64_t> coarseInFine;
                    for (std::uint64_t k = 0; k < fineCount; ++k)
                        if (fine[k].event <= grains[c]) coarseInFine.push_back(k);
                    ASSERT_EQ(coarseInFine.size(), *replay.count(grains[c]));
                    for (std::uint64_t k = 0; k < coarseInFine.size(); ++k) {
                        const StepState  coarse = stateAt(replay, grains[c], k);
                        const StepState& same   = fine[coarseInFine[k]];
                        EXPECT_EQ(contentsOf(coarse), contentsOf(same)) << k;
                        EXPECT_EQ(pictureOf(coarse.frame.visible), pictureOf(same.frame.visible)) << k;
                        EXPECT_EQ(coarse.frame.colour, same.frame.colour) << k;
                        const Result<std::uint64_t> way = replay.eventsBy(grains[f], grains[c], StepIndex{k});
                        ASSERT_TRUE(way.ok()) << way.error().text();
                        EXPECT_EQ(*way, coarseInFine[k] + 1) << k;
                    }
                }
            }
        }
    }
}

TEST(Replay, EveryStepChangesAtMostWhatItsEventSays)
{
    const SeenScene seen = soupScene(SoupKind::Coplanar, 23, 12, 9, 20);  // ties: no method can do without a test
    for (const Preset& preset : presets()) {
        if (preset.pipeline.depth == DepthMoment::Prepass) continue;  // a pre-pass wins depths without showing ids
        Replay              replay(seen.request(preset.pipeline));
        const std::uint64_t count  = *replay.count(Grain::Pixel);
        StepState           before = stateAt(replay, Grain::Pixel, 0);
        std::uint64_t       pixels = 0;
        for (std::uint64_t k = 1; k < count; ++k) {
            StepState after = stateAt(replay, Grain::Pixel, k);
            SCOPED_TRACE(std::string(preset.name) + ", step " + std::to_string(k));
            EXPECT_EQ(after.pixel.has_value(), after.event == Grain::Pixel);
            if (after.pixel) {
                ++pixels;
                const PixelState& p        = *after.pixel;
                Picture           expected = pictureOf(before.frame.visible);
                EXPECT_EQ(expected.ids.at(p.x, p.y), p.rival ? std::int64_t{p.rival->value} : -1);
                EXPECT_EQ(expected.depth.at(p.x, p.y), p.rivalDepth);
                if (p.won) {
                    expected.ids.at(p.x, p.y)   = p.triangle.value;
                    expected.depth.at(p.x, p.y) = p.depth;
                }
                EXPECT_EQ(pictureOf(after.frame.visible), expected);
            }
            before = std::move(after);
        }
        EXPECT_GT(pixels, 0u) << preset.name;
    }
}

TEST(Replay, AfterALineOfTheScanlineMethodItsLinesAreFinishedAndThoseBelowAreBackground)
{
    for (const SeenScene& seen :
         {builtinScene("teapot?tessellation=3", 64, 40), soupScene(SoupKind::NearCrossing, 31, 40, 33, 40)}) {
        Replay        replay(seen.request(findPreset("scanline")->pipeline));
        const auto    count    = *replay.count(Grain::Line);
        const Picture finished = pictureOf(stateAt(replay, Grain::Line, count - 1).frame.visible);
        int           line     = 0;
        for (std::uint64_t k = 0; k < count; ++k) {
            const StepState state = stateAt(replay, Grain::Line, k);
            if (state.event != Grain::Line) continue;
            SCOPED_TRACE(seen.what + ", step " + std::to_string(k));
            ASSERT_TRUE(state.sweep.has_value());
            EXPECT_EQ(state.sweep->y, line);
            const Picture now = pictureOf(state.frame.visible);
            for (int y = 0; y < seen.camera.height; ++y) {
                for (int x = 0; x < seen.camera.width; ++x) {
                    ASSERT_EQ(now.ids.at(x, y), y <= line ? finished.ids.at(x, y) : -1) << x << ", " << y;
                    ASSERT_EQ(now.depth.at(x, y), y <= line ? finished.depth.at(x, y) : 0.0f) << x << ", " << y;
                }
            }
            ++line;
        }
        EXPECT_EQ(line, seen.camera.height);
    }
}

TEST(Replay, TheStepsOfTwoPassesSayInWhichPassANodeWasDrawn)
{
    const SeenScene seen = builtinScene("city?blocks=2", 64, 48);
    Replay          replay(seen.request(findPreset("two-pass")->pipeline));
    const auto      count    = *replay.count(Grain::Node);
    int             recalled = 0, again = 0;
    for (std::uint64_t k = 0; k < count; ++k) {
        const StepState state = stateAt(replay, Grain::Node, k);
        if (state.event != Grain::Node) continue;
        SCOPED_TRACE("step " + std::to_string(k) + ": " + state.sentence);
        ASSERT_TRUE(state.hierarchy.has_value());
        const NodeRow& now = state.hierarchy->nodes[static_cast<std::size_t>(state.hierarchy->now)];
        if (state.hierarchy->pass == 1) {
            ++recalled;
            EXPECT_EQ(again, 0) << "the first pass comes first";
            EXPECT_EQ(now.verdict, NodeVerdict::Drawn);
            EXPECT_EQ(now.pass, 1);
            EXPECT_TRUE(now.instance.has_value());
            EXPECT_FALSE(state.hierarchy->query.has_value()) << "nobody is asked";
            EXPECT_NE(state.sentence.find("was visible in the last frame"), std::string::npos);
        } else {
            EXPECT_EQ(state.hierarchy->pass, 2);
            again += now.pass == 1;
            EXPECT_EQ(state.sentence.find("The first pass has drawn it") != std::string::npos, now.pass == 1);
        }
    }
    EXPECT_GT(recalled, 0);
    EXPECT_GT(again, 0) << "what the first pass drew is judged by the second";
    EXPECT_LE(again, recalled);
    const std::string json = stateToJson(stateAt(replay, Grain::Node, count - 1));
    for (const char* part : {"\"pass\": 1", "\"pass\": 2"}) EXPECT_NE(json.find(part), std::string::npos) << part;
    EXPECT_EQ(stateToJson(stateAt(replay, Grain::Stage, 0)).find("\"pass\""), std::string::npos);
}

TEST(Replay, AMeasuredChoiceIsSteppedThroughAsItsFirstAndSaysSo)
{
    const SeenScene seen = smallScenes().front();
    Replay measured(seen.request(findPreset("auto")->pipeline)), first(seen.request(findPreset("zbuffer")->pipeline));
    ASSERT_EQ(*measured.count(Grain::Pixel), *first.count(Grain::Pixel));
    const StepState state = stateAt(measured, Grain::Pixel, 3), same = stateAt(first, Grain::Pixel, 3);
    EXPECT_EQ(pictureOf(state.frame.visible), pictureOf(same.frame.visible));
    EXPECT_EQ(state.algorithm, "auto");
    EXPECT_EQ(state.sentence,
              same.sentence + " (auto has measured nothing here: its steps are those of zbuffer, its first choice.)");
}

TEST(Replay, WithoutShadingAskedForAStepIsShadedForTheLessonAllTheSame)
{
    const SeenScene seen    = smallScenes().front();
    DrawRequest     request = seen.request(presets().front().pipeline);
    Replay          shaded(request);
    request.shade = false;
    Replay unshaded(request);
    EXPECT_EQ(*unshaded.count(Grain::Stage) + 1, *shaded.count(Grain::Stage)) << "no shading, no such stage";
    EXPECT_EQ(stateAt(unshaded, Grain::Frame, 0).frame.colour, stateAt(shaded, Grain::Frame, 0).frame.colour);
}

TEST(Replay, StepsOfAnEmptySceneExist)
{
    const auto      empty = std::make_shared<const Scene>(*assemble(Scene{}));
    const SeenScene seen{"no instances", std::make_shared<PreparedScene>(empty), plainCamera(5, 4)};
    forEveryGrain({seen}, [](const SeenScene&, const Preset&, Grain grain, Replay& replay, std::uint64_t count) {
        for (std::uint64_t k = 0; k < count; ++k) {
            const Picture picture = pictureOf(stateAt(replay, grain, k).frame.visible);
            EXPECT_TRUE(std::ranges::all_of(picture.ids.values(), [](std::int64_t id) { return id == -1; }));
        }
    });
}

TEST(Replay, CancellingIsAnAnswerOfItsOwn)
{
    const std::atomic<bool> cancel = true;
    for (const Preset& preset : presets()) {
        DrawRequest request = smallScenes().front().request(preset.pipeline);
        request.cancel      = &cancel;
        Replay replay(request);
        EXPECT_EQ(replay.count(Grain::Pixel).error().kind, Trouble::Cancelled) << preset.name;
        EXPECT_EQ(replay.at(Grain::Pixel, StepIndex{0}).error().kind, Trouble::Cancelled) << preset.name;
        EXPECT_EQ(replay.eventsBy(Grain::Frame, Grain::Pixel, StepIndex{0}).error().kind, Trouble::Cancelled)
            << preset.name;
    }
}

/// The whole run would take long: 20,000 triangles, each as large as the picture, all of one mesh.
TEST(Replay, CancellingEndsARunOfOneLargeMeshSoon)
{
    std::vector<Corners> corners;
    const Camera         camera = plainCamera(512, 512);
    for (int i = 0; i < 20000; ++i) {
        const double z = 2 + i * 1e-3;
        corners.push_back(
            {pointAt(camera, -600, -10, z), pointAt(camera, 1100, -10, z), pointAt(camera, 256, 1300, z)});
    }
    const SeenScene seen{"a pile of large triangles", std::make_shared<PreparedScene>(sceneOf(corners)), camera};
    for (const Preset& preset : presets()) {
        if (preset.pipeline.upkeep != Upkeep::None) continue;  // the pyramid hides all but the first triangles
        std::atomic<bool> cancel  = false;
        DrawRequest       request = seen.request(preset.pipeline);
        request.cancel            = &cancel;
        Replay                              replay(request);
        std::thread                         owner([&cancel] {
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            cancel = true;
        });
        const auto                          start = std::chrono::steady_clock::now();
        const Result<std::uint64_t>         count = replay.count(Grain::Pixel);
        const std::chrono::duration<double> took  = std::chrono::steady_clock::now() - start;
        owner.join();
        if (count.ok()) {  // one triangle decided the whole picture: it was over before
            EXPECT_LT(took.count(), 1.0) << preset.name;
            continue;
        }
        EXPECT_EQ(count.error().kind, Trouble::Cancelled) << preset.name;
        EXPECT_LT(took.count(), 30.0) << preset.name;
    }
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMemoryIsWatched = true;  // freed memory is kept aside by the sanitizer
#else
constexpr bool kMemoryIsWatched = false;
#endif

/// Bytes of this process that are in memory.
std::uint64_t residentBytes()
{
    std::ifstream statm("/proc/self/statm");
    std::uint64_t total = 0, resident = 0;
    statm >> total >> resident;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Bytes that somebody has asked for and not given back.
std::uint64_t allocatedBytes()
{
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

TEST(Replay, MemoryStaysFlatOverThousandsOfSteps)
{
    if (kMemoryIsWatched) GTEST_SKIP() << "the sanitizer keeps freed memory and looks for leaks itself";
    const SeenScene seen = builtinScene("cubes", 64, 48);
    for (const Preset& preset : presets()) {
        Replay              replay(seen.request(preset.pipeline));
        const std::uint64_t count = *replay.count(Grain::Pixel);
        const auto          walk  = [&](int steps) {
            for (int i = 0; i < steps; ++i)
                ASSERT_TRUE(replay.at(Grain::Pixel, StepIndex{static_cast<std::uint64_t>(i) * 7919 % count}).ok());
        };
        walk(200);
        const std::uint64_t resident = residentBytes(), allocated = allocatedBytes();
        walk(3000);
        EXPECT_LT(allocatedBytes(), allocated + (64u << 10)) << preset.name;
        EXPECT_LT(residentBytes(), resident + (2u << 20)) << preset.name;  // a kept picture per step would be 100 MB
    }
}

}  // namespace
}  // namespace zscope::tests
