// The steps of a method's own structures: questions to the pyramid, cells of it written, intervals of a line decided.
// Each is held against the pixels of the very state it comes with.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "core/frame/methods.h"
#include "tests/replay/replay_support.h"

namespace zscope::tests {
namespace {

std::vector<SeenScene> seenScenes()
{
    return {soupScene(SoupKind::Loose, 41, 37, 29, 24), soupScene(SoupKind::NearCrossing, 42, 20, 35, 12),
            soupScene(SoupKind::Coplanar, 43, 33, 18, 16), builtinScene("cubes", 31, 22)};
}

/// All presets, and the complete method with every other way to keep its pyramid.
std::vector<Preset> methods()
{
    std::vector<Preset> all(presets().begin(), presets().end());
    const Preset&       complete = *findPreset("hzb-octree");
    for (const auto& [name, upkeep] :
         {std::pair("pushed", Upkeep::Pushed), std::pair("pushed-farthest", Upkeep::PushedFarthest),
          std::pair("masked", Upkeep::Masked)}) {
        all.push_back({name, {}, complete.pipeline});
        all.back().pipeline.upkeep = upkeep;
    }
    return all;
}

/// Runs `check(state)` for every step of `grain` that is an event of that very grain; how many there were.
template <class Check>
int forEveryEvent(const SeenScene& seen, const Preset& preset, Grain grain, const Check& check)
{
    SCOPED_TRACE(seen.what + ", " + std::string(preset.name));
    Replay     replay(seen.request(preset.pipeline));
    const auto count = replay.count(grain);
    EXPECT_TRUE(count.ok());
    if (!count) return 0;
    int events = 0;
    for (std::uint64_t k = 0; k < *count && !testing::Test::HasFatalFailure(); ++k) {
        const auto state = replay.at(grain, StepIndex{k});
        EXPECT_TRUE(state.ok());
        if (state->event != grain) continue;
        ++events;
        check(*state);
    }
    return events;
}

bool has(const Preset& preset, Grain grain)
{
    const auto grains = grainsOf(preset.pipeline);
    return std::ranges::find(grains, grain) != grains.end();
}

float farthestIn(const VisibilityBuffer& visible, const PixelBox& box)
{
    float farthest = 2;
    for (int y = box.y0; y < std::min(box.y1, visible.height()); ++y)
        for (int x = box.x0; x < std::min(box.x1, visible.width()); ++x)
            farthest = std::min(farthest, visible.storedAt(x, y));
    return farthest;
}

std::uint64_t counterOf(const SeenScene& seen, const Preset& preset, std::string_view name)
{
    Renderer   renderer;
    const auto work = renderer.count(seen.request(preset.pipeline));
    EXPECT_TRUE(work.ok());
    for (const NamedCount& count : work->counters)
        if (count.name == name) return count.value;
    ADD_FAILURE() << "there is no counter " << name;
    return 0;
}

TEST(StructureSteps, MethodsWithAPyramidStepThroughQueriesAndUpdatesAndTheIntervalMethodsThroughIntervals)
{
    for (const Preset& preset : methods()) {
        const auto own      = methodOf(preset.pipeline).grains;
        const bool asks     = std::ranges::find(own, Grain::Query) != own.end();
        const bool hasCells = preset.pipeline.upkeep != Upkeep::None || preset.pipeline.depth == DepthMoment::ZCull;
        EXPECT_EQ(has(preset, Grain::Query), hasCells || asks) << preset.name;
        EXPECT_EQ(has(preset, Grain::Update), hasCells) << preset.name;
        EXPECT_EQ(has(preset, Grain::Interval),
                  preset.pipeline.scan == Scan::SweepIntervals || drawsFaces(preset.pipeline))
            << preset.name;
    }
}

TEST(StructureSteps, EveryQuestionIsAStepWhoseVerdictIsThatOfEachPixelOfItsRectangle)
{
    std::map<std::string, int> nodes;  // asked about, per preset
    for (const SeenScene& seen : seenScenes()) {
        for (const Preset& preset : methods()) {
            if (preset.pipeline.upkeep == Upkeep::None || preset.claim != Claim::Exact) continue;
            std::map<std::string, int> asked;
            const int                  events = forEveryEvent(seen, preset, Grain::Query, [&](const StepState& state) {
                ASSERT_TRUE(state.hierarchy && state.hierarchy->query);
                const HierarchyState& hierarchy = *state.hierarchy;
                const PyramidQuery&   query     = *hierarchy.query;
                ++asked[hierarchy.asked];
                EXPECT_EQ(hierarchy.askedAbout.has_value(), hierarchy.asked == "triangle");
                const bool isBehind = query.nearest < farthestIn(state.frame.visible, query.box);
                if (preset.pipeline.upkeep == Upkeep::Masked)
                    EXPECT_TRUE(isBehind || !query.hidden) << "what it forgets is not culled: " << state.sentence;
                else
                    EXPECT_EQ(query.hidden, isBehind) << state.sentence;
                EXPECT_EQ(state.sentence.find("not hidden, because") == std::string::npos, query.hidden)
                    << state.sentence;
                if (hierarchy.asked == "triangle") {
                    EXPECT_NE(state.sentence.find("triangle " + std::to_string(hierarchy.askedAbout->value)),
                                               std::string::npos);
                    return;
                }
                ASSERT_GE(hierarchy.now, 0);
                const NodeVerdict verdict = hierarchy.nodes[static_cast<std::size_t>(hierarchy.now)].verdict;
                const bool        isRecalled =
                    verdict == NodeVerdict::Drawn && preset.pipeline.coherence == Coherence::TwoPass;
                EXPECT_TRUE(verdict == NodeVerdict::Waiting || isRecalled)
                    << "nothing has followed from the answer yet";
            });
            EXPECT_EQ(static_cast<std::uint64_t>(events), counterOf(seen, preset, "pyramid_queries")) << preset.name;
            // The scene stands still: a second pass may find all that is seen drawn by the first, which asks nothing.
            if (preset.pipeline.coherence == Coherence::None) {
                EXPECT_EQ(asked["triangle"] > 0, asksTriangles(preset.pipeline.cull)) << preset.name;
            }
            nodes[std::string(preset.name)] += asked["node"];
        }
    }
    for (const Preset& preset : methods())
        EXPECT_EQ(nodes[std::string(preset.name)] > 0, asksNodes(preset.pipeline.cull)) << preset.name;
}

TEST(StructureSteps, ATileIsRejectedExactlyIfAllItsPixelsAreNearerThanTheTriangleCouldBeThere)
{
    int rejected = 0, tested = 0;
    for (const SeenScene& seen :
         {soupScene(SoupKind::Repeated, 44, 37, 29, 60), builtinScene("layers?count=5&order=front", 37, 22)}) {
        const int events = forEveryEvent(seen, *findPreset("zbuffer-zcull"), Grain::Query, [&](const StepState& state) {
            ASSERT_TRUE(state.tile.has_value());
            const TileTested& tile = *state.tile;
            const int         left = tile.box.x0 / 8 * 8, top = tile.box.y0 / 8 * 8;
            const float       farthest = farthestIn(state.frame.visible, {left, top, left + 8, top + 8});
            EXPECT_EQ(tile.rejected, tile.nearest < farthest) << state.sentence;
            if (!tile.rejected) {
                EXPECT_EQ(tile.farthest, farthest) << "what lets fragments through has been looked up";
            }
            EXPECT_EQ(state.sentence.find("rejected, none") != std::string::npos, tile.rejected) << state.sentence;
            ++(tile.rejected ? rejected : tested);
        });
        EXPECT_GT(events, 0);
    }
    EXPECT_GT(rejected, 10);
    EXPECT_GT(tested, 10);
}

TEST(StructureSteps, EveryUpdateLeavesTheFarthestDepthOfTheCellAndFollowsTheOneBefore)
{
    std::set<int>              levels;
    std::map<std::string, int> updates;  // per method, over all scenes: masked tiles of a small picture are seldom full
    // What is in plain view is answered by a pixel, without an update: there has to be something behind a wall.
    std::vector<SeenScene> scenes = seenScenes();
    scenes.push_back(builtinScene("layers?count=5&order=front", 37, 22));
    scenes.push_back(builtinScene("wall-and-city?blocks=2", 37, 22));
    for (const SeenScene& seen : scenes) {
        for (const Preset& preset : methods()) {
            if (!has(preset, Grain::Update) || preset.claim != Claim::Exact) continue;
            // long, and for it alone
            if (&seen == &scenes.back() && preset.pipeline.coherence != Coherence::TwoPass) continue;
            std::map<std::tuple<int, int, int>, float> held;
            const int events = forEveryEvent(seen, preset, Grain::Update, [&](const StepState& state) {
                ASSERT_TRUE(state.hierarchy && state.hierarchy->update);
                const CellWrite&        cell    = *state.hierarchy->update;
                const VisibilityBuffer& visible = state.frame.visible;
                levels.insert(cell.level);
                const int   size = 1 << cell.level;
                const float farthest =
                    farthestIn(visible, {cell.x * size, cell.y * size, (cell.x + 1) * size, (cell.y + 1) * size});
                // On its way up a push meets cells whose pixels are drawn and whose turn has not come.
                const bool pushed =
                    preset.pipeline.upkeep == Upkeep::Pushed || preset.pipeline.upkeep == Upkeep::PushedFarthest;
                const bool masked = preset.pipeline.upkeep == Upkeep::Masked;  // bounds, never nearer
                EXPECT_TRUE(cell.after == farthest || (masked && cell.after < farthest)
                            || (pushed && cell.level > Pyramid::kTileLevel && cell.after < farthest))
                    << state.sentence;
                const auto [known, isNew] = held.try_emplace({cell.level, cell.x, cell.y}, visible.empty());
                EXPECT_EQ(cell.before, known->second) << state.sentence;
                EXPECT_GE(cell.after, cell.before) << "depths only grow";
                known->second = cell.after;
                EXPECT_NE(state.sentence.find(masked && cell.level == Pyramid::kTileLevel
                                                  ? "Tile ("
                                                  : "of level " + std::to_string(cell.level)),
                          std::string::npos)
                    << state.sentence;
                EXPECT_EQ(state.sentence.find("as before") != std::string::npos, cell.before == cell.after)
                    << state.sentence;
            });
            updates[std::string(preset.name)] += events;
        }
    }
    for (const auto& [name, count] : updates) EXPECT_GT(count, 0) << name;
    EXPECT_GT(levels.size(), 2u) << "tiles alone are no pyramid";
}

TEST(StructureSteps, EveryIntervalGivesItsPixelsToItsWinnerOrToTheNearestOfThoseOpen)
{
    std::set<IntervalReason> reasons;
    for (const SeenScene& seen : seenScenes()) {
        for (const Preset& preset : methods()) {
            if (!has(preset, Grain::Interval) || preset.claim == Claim::Approximate) continue;
            Picture decided;  // by the intervals so far
            decided.ids.reset(seen.camera.width, seen.camera.height, -1);
            const int events = forEveryEvent(seen, preset, Grain::Interval, [&](const StepState& state) {
                ASSERT_TRUE(state.interval.has_value());
                const IntervalState& interval = *state.interval;
                reasons.insert(interval.reason);
                ASSERT_LT(interval.x0, interval.x1);
                EXPECT_EQ(interval.winner.has_value(),
                          interval.reason == IntervalReason::Alone || interval.reason == IntervalReason::Leads);
                for (int x = interval.x0; x < interval.x1; ++x) {
                    const std::int64_t id = state.frame.visible.idAt(x, interval.y);
                    EXPECT_EQ(decided.ids.at(x, interval.y), -1) << "intervals do not overlap";
                    decided.ids.at(x, interval.y) = id;
                    if (interval.winner) {
                        EXPECT_EQ(id, interval.winner->value);
                    }
                    if (id >= 0) {
                        EXPECT_TRUE(
                            std::ranges::binary_search(interval.open, TriangleId{static_cast<std::uint32_t>(id)}));
                    }
                }
                EXPECT_EQ(state.sentence.find("pixel by pixel") == std::string::npos, interval.winner.has_value())
                    << state.sentence;
                EXPECT_NE(state.sentence.find("Line " + std::to_string(interval.y)), std::string::npos)
                    << state.sentence;
            });
            EXPECT_GT(events, 10) << preset.name;
            Renderer renderer;
            Frame    frame;
            ASSERT_TRUE(renderer.draw(seen.request(preset.pipeline), frame).ok());
            EXPECT_EQ(decided.ids, pictureOf(frame.visible).ids) << "between the intervals is nothing but background";
        }
    }
    for (const IntervalReason reason : {IntervalReason::Alone, IntervalReason::Leads, IntervalReason::NoClearLead})
        EXPECT_TRUE(reasons.contains(reason)) << static_cast<int>(reason);
}

}  // namespace
}  // namespace zscope::tests
