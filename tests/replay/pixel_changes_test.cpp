// Steps that change a pixel and breakpoints, against the states that stepping shows.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/lesson/explain.h"
#include "core/lesson/pixel_changes.h"
#include "core/measure/verify.h"
#include "tests/replay/replay_support.h"

namespace zscope::tests {
namespace {

std::vector<Preset> exactPresets()
{
    std::vector<Preset> exact;
    for (const Preset& preset : presets())
        if (preset.claim != Claim::Approximate) exact.push_back(preset);
    return exact;
}

struct Shown {
    std::int64_t id     = -1;
    float        stored = 0;
};

/// What every step of a grain shows at a pixel.
std::vector<Shown> shownAt(Replay& replay, Grain grain, PixelPosition p)
{
    std::vector<Shown> all;
    const auto         count = *replay.count(grain);
    for (std::uint64_t k = 0; k < count; ++k) {
        const auto              state   = replay.at(grain, StepIndex{k});
        const VisibilityBuffer& visible = state->frame.visible;
        all.push_back({visible.idAt(p.x, p.y), visible.storedAt(p.x, p.y)});
    }
    return all;
}

TEST(PixelChanges, AreTheStepsWhosePictureDiffersFromTheOneBefore)
{
    const SeenScene scene = soupScene(SoupKind::EyeInside, 5, 24, 16, 60);
    for (const Preset& preset : exactPresets()) {
        Replay replay(scene.request(preset.pipeline));
        for (const Grain grain : grainsOf(preset.pipeline)) {
            if (*replay.count(grain) > 400) continue;
            for (const PixelPosition p : {PixelPosition{12, 8}, PixelPosition{3, 14}}) {
                SCOPED_TRACE(std::string(preset.name) + ' ' + std::string(wordOf(grain)));
                const auto changes = changesOfPixel(scene.request(preset.pipeline), grain, p);
                ASSERT_TRUE(changes.ok());
                const auto  shown = shownAt(replay, grain, p);
                std::size_t next  = 0;
                for (std::size_t k = 0; k < shown.size(); ++k) {
                    const bool first   = k == 0;
                    const bool differs = first
                                             ? shown[k].id >= 0
                                             : shown[k].id != shown[k - 1].id || shown[k].stored != shown[k - 1].stored;
                    const bool told    = next < changes->size() && (*changes)[next].step.value == k;
                    ASSERT_EQ(told, differs) << "step " << k;
                    if (!told) continue;
                    EXPECT_EQ((*changes)[next].id, shown[k].id);
                    EXPECT_EQ((*changes)[next].idBefore, first ? -1 : shown[k - 1].id);
                    ++next;
                }
                EXPECT_EQ(next, changes->size());
            }
        }
    }
}

TEST(PixelChanges, TellWhenTransparentSurfacesAreBlended)
{
    const SeenScene scene   = builtinScene("glass", 32, 24);
    const auto      request = scene.request(findPreset("zbuffer")->pipeline);
    int             blended = 0;
    for (const PixelPosition p : randomPixels(scene.camera, 40, 2)) {
        const auto e       = explainPixel(request, p);
        const auto changes = changesOfPixel(request, Grain::Pixel, p);
        ASSERT_TRUE(e.ok() && changes.ok());
        const bool lies =
            std::ranges::any_of(e->candidates, [](const PixelCandidate& c) { return c.fate == fates::kBlended; });
        const auto told = std::ranges::count(*changes, true, &PixelChange::isBlended);
        EXPECT_LE(told, lies ? 1 : 0);
        blended += static_cast<int>(told);
    }
    EXPECT_GT(blended, 5);
}

/// All steps that hit, found one after another.
std::vector<Stop> stopsOf(const DrawRequest& request, Grain grain, std::span<const Breakpoint> breakpoints,
                          Direction direction)
{
    std::vector<Stop>        stops;
    std::optional<StepIndex> from;
    while (stops.size() < 500) {
        const auto stop = nextStop(request, grain, from, breakpoints, direction);
        EXPECT_TRUE(stop.ok());
        if (!stop.ok() || !*stop) break;
        stops.push_back(**stop);
        from = (*stop)->step;
    }
    return stops;
}

TEST(Breakpoints, BackwardsMeetsTheSameStepsAsForwards)
{
    const SeenScene scene = soupScene(SoupKind::EyeInside, 5, 24, 16, 60);
    for (const Preset& preset : exactPresets()) {
        const DrawRequest request = scene.request(preset.pipeline);
        const auto        e       = explainPixel(request, {12, 8});
        ASSERT_TRUE(e.ok() && e->winner >= 0);
        const auto                    winner = static_cast<std::uint32_t>(e->winner);
        const std::vector<Breakpoint> breakpoints{
            {.on = Breakpoint::On::Pixel, .line = 0, .pixel = {12, 8}, .node = {}, .triangle = {}},
            {.on = Breakpoint::On::Triangle, .line = 0, .pixel = {}, .node = {}, .triangle = {winner}},
            {.on = Breakpoint::On::Line, .line = 3, .pixel = {}, .node = {}, .triangle = {}}};
        for (const Grain grain : grainsOf(preset.pipeline)) {
            SCOPED_TRACE(std::string(preset.name) + ' ' + std::string(wordOf(grain)));
            for (const Breakpoint& one : breakpoints) {
                const auto forward = stopsOf(request, grain, std::span(&one, 1), Direction::Forward);
                auto       back    = stopsOf(request, grain, std::span(&one, 1), Direction::Back);
                std::ranges::reverse(back);
                EXPECT_EQ(forward, back);
                EXPECT_FALSE(forward.empty());
                EXPECT_TRUE(std::ranges::is_sorted(forward, {}, [](const Stop& s) { return s.step; }));
            }
        }
    }
}

TEST(Breakpoints, OnAPixelStopWhereItIsTestedOrFilled)
{
    const SeenScene     scene = soupScene(SoupKind::EyeInside, 5, 24, 16, 60);
    const PixelPosition p{12, 8};
    const Breakpoint    onPixel{.on = Breakpoint::On::Pixel, .line = 0, .pixel = p, .node = {}, .triangle = {}};
    for (const Preset& preset : exactPresets()) {
        SCOPED_TRACE(preset.name);
        const DrawRequest request = scene.request(preset.pipeline);
        Replay            replay(request);
        const auto        stops = stopsOf(request, Grain::Pixel, std::span(&onPixel, 1), Direction::Forward);
        for (const Stop& stop : stops) {
            const auto state = replay.at(Grain::Pixel, stop.step);
            ASSERT_TRUE(state.ok());
            const bool tested = state->pixel && state->pixel->x == p.x && state->pixel->y == p.y;
            const bool filled =
                state->interval && state->interval->y == p.y && state->interval->x0 <= p.x && p.x < state->interval->x1;
            EXPECT_TRUE(tested || filled || state->event == Grain::Query) << state->sentence;  // or a method's own
        }
        const auto changes = changesOfPixel(request, Grain::Pixel, p);
        ASSERT_TRUE(changes.ok());
        EXPECT_GE(stops.size(), changes->size());
        EXPECT_FALSE(changes->empty());
    }
}

TEST(Breakpoints, OnANodeStopWhereItIsJudged)
{
    const SeenScene   scene   = builtinScene("wall-and-city?blocks=3", 48, 32);
    const DrawRequest request = scene.request(findPreset("octree-frustum")->pipeline);
    Replay            replay(request);
    const auto        last = replay.at(Grain::Node, StepIndex{*replay.count(Grain::Node) - 1});
    ASSERT_TRUE(last.ok() && last->hierarchy);
    int looked = 0;
    for (std::size_t i = 0; i < last->hierarchy->nodes.size() && looked < 12; i += 7) {
        const NodeRow& node = last->hierarchy->nodes[i];
        if (node.verdict == NodeVerdict::Waiting) continue;
        const Breakpoint onNode{
            .on = Breakpoint::On::Node, .line = 0, .pixel = {}, .node = {node.instance, node.path}, .triangle = {}};
        const auto stop = nextStop(request, Grain::Node, std::nullopt, std::span(&onNode, 1), Direction::Forward);
        ASSERT_TRUE(stop.ok());
        ASSERT_TRUE(stop->has_value()) << node.path;
        const auto state = replay.at(Grain::Node, (*stop)->step);
        ASSERT_TRUE(state.ok() && state->hierarchy);
        const NodeRow& now = state->hierarchy->nodes[static_cast<std::size_t>(state->hierarchy->now)];
        EXPECT_EQ(now.path, node.path);
        EXPECT_EQ(now.instance, node.instance);
        ++looked;
    }
    EXPECT_EQ(looked, 12);
}

TEST(Breakpoints, NamesTheFirstOfSeveralAndRefusesAGrainThatTheMethodLacks)
{
    const SeenScene               scene   = builtinScene("wall-and-city?blocks=2", 24, 16);
    const DrawRequest             request = scene.request(findPreset("scanline")->pipeline);
    const std::vector<Breakpoint> lines{
        {.on = Breakpoint::On::Line, .line = 9, .pixel = {}, .node = {}, .triangle = {}},
        {.on = Breakpoint::On::Line, .line = 4, .pixel = {}, .node = {}, .triangle = {}}};
    const auto stops = stopsOf(request, Grain::Line, lines, Direction::Forward);
    ASSERT_EQ(stops.size(), 2u);
    EXPECT_EQ(stops[0].breakpoint, 1u);
    EXPECT_EQ(stops[1].breakpoint, 0u);
    Replay     replay(request);
    const auto state = replay.at(Grain::Line, stops[0].step);
    ASSERT_TRUE(state.ok() && state->sweep);
    EXPECT_EQ(state->sweep->y, 4);
    EXPECT_EQ(nextStop(request, Grain::Node, std::nullopt, lines, Direction::Forward).error().kind, Trouble::Usage);
    EXPECT_FALSE(nextStop(request, Grain::Line, std::nullopt, {}, Direction::Forward)->has_value());
}

}  // namespace
}  // namespace zscope::tests
