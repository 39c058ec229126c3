// What a lesson draws of the structures of a step: the pyramid level by level, the boxes of the hierarchy, the
// observer's view from outside. Each is held against the pixels of the very state it is made from.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/lesson/colour_maps.h"
#include "core/lesson/node_boxes.h"
#include "core/lesson/outside_view.h"
#include "core/lesson/pyramid_levels.h"
#include "tests/replay/replay_support.h"

namespace zscope::tests {
namespace {

std::vector<Pipeline> pyramidPipelines()
{
    std::vector<Pipeline> all;
    for (const Upkeep upkeep : {Upkeep::OnQuery, Upkeep::Pushed, Upkeep::PushedFarthest, Upkeep::Masked}) {
        all.push_back(findPreset("hzb-octree")->pipeline);
        all.back().upkeep = upkeep;
    }
    all.push_back(findPreset("hzb-simple")->pipeline);
    all.push_back(findPreset("zbuffer-zcull")->pipeline);
    return all;
}

/// Some steps of a run, the first and the last among them.
template <class Check>
void forSomeSteps(const SeenScene& seen, const Pipeline& pipeline, Grain grain, const Check& check)
{
    SCOPED_TRACE(seen.what + ", " + nameOf(pipeline));
    Replay     replay(seen.request(pipeline));
    const auto count = replay.count(grain);
    ASSERT_TRUE(count.ok());
    for (std::uint64_t i = 0; i < 12; ++i) {
        const auto state = replay.at(grain, StepIndex{(*count - 1) * i / 11});
        ASSERT_TRUE(state.ok());
        check(*state);
    }
}

float farthestOf(const VisibilityBuffer& visible, int level, int cellX, int cellY)
{
    const int size     = 1 << level;
    float     farthest = 2;
    for (int y = cellY * size; y < std::min((cellY + 1) * size, visible.height()); ++y)
        for (int x = cellX * size; x < std::min((cellX + 1) * size, visible.width()); ++x)
            farthest = std::min(farthest, visible.storedAt(x, y));
    return farthest;
}

TEST(PyramidPicture, EveryCellIsThePixelsFarthestOrIsMarkedAsLagging)
{
    int lagging = 0;
    for (const Pipeline& pipeline : pyramidPipelines()) {
        forSomeSteps(builtinScene("cubes", 45, 30), pipeline, Grain::Triangle, [&](const StepState& state) {
            const PyramidPicture picture = pyramidOf(state);
            if (!state.hierarchy || state.hierarchy->cells.empty()) return;
            ASSERT_EQ(picture.levels.size(), state.hierarchy->levels.size());
            for (const PyramidLevel& level : picture.levels) {
                const auto& size = state.hierarchy->levels[static_cast<std::size_t>(level.level)];
                ASSERT_EQ(level.width(), size[0]);
                ASSERT_EQ(level.height(), size[1]);
                int marked = 0;
                for (int y = 0; y < level.height(); ++y) {
                    for (int x = 0; x < level.width(); ++x) {
                        const float truth = farthestOf(state.frame.visible, level.level, x, y),
                                    held  = level.farthest.at(x, y);
                        const bool lags   = level.isStored && level.lags.at(x, y) != 0;
                        ASSERT_EQ(lags, held < truth);
                        ASSERT_TRUE(lags || held == truth);
                        ASSERT_EQ(level.colours.at(x, y) == kEmptyCell, held <= picture.empty);
                        marked += lags;
                    }
                }
                ASSERT_EQ(marked, level.lagging);
                lagging += marked;
            }
        });
    }
    EXPECT_GT(lagging, 0);
}

TEST(PyramidPicture, TheWayUpGoesOneLevelAtATimeAndEndsWithTheLastUpdate)
{
    int climbs = 0;
    for (const Pipeline& pipeline : pyramidPipelines()) {
        if (pipeline.upkeep == Upkeep::None) continue;
        forSomeSteps(builtinScene("cubes", 45, 30), pipeline, Grain::Update, [&](const StepState& state) {
            if (!state.hierarchy || !state.hierarchy->update) return;
            const auto& climb = state.hierarchy->climb;
            ASSERT_FALSE(climb.empty());
            EXPECT_EQ(climb.back().level, state.hierarchy->update->level);
            EXPECT_EQ(climb.back().x, state.hierarchy->update->x);
            for (std::size_t i = 1; i < climb.size(); ++i) EXPECT_EQ(climb[i].level, climb[i - 1].level + 1);
            climbs += climb.size() > 1;
        });
    }
    EXPECT_GT(climbs, 0);
}

TEST(PyramidPicture, MethodsWithoutAPyramidHaveNoLevels)
{
    forSomeSteps(builtinScene("cubes", 45, 30), findPreset("octree-frustum")->pipeline, Grain::Triangle,
                 [](const StepState& state) { EXPECT_TRUE(pyramidOf(state).levels.empty()); });
}

TEST(CellsUnder, AreThoseThatShareAPixelWithTheBox)
{
    EXPECT_EQ(cellsUnder({0, 0, 8, 8}, 3), (PixelBox{0, 0, 1, 1}));
    EXPECT_EQ(cellsUnder({7, 8, 9, 9}, 3), (PixelBox{0, 1, 2, 2}));
}

TEST(ColourMaps, GrowLighterEvenlyAndStayWithinTheirEnds)
{
    const auto grey = [](std::uint32_t c) {
        return 0.299 * ((c >> 16) & 255) + 0.587 * ((c >> 8) & 255) + 0.114 * (c & 255);
    };
    double last = -1;
    for (int i = 0; i <= 100; ++i) {
        const double light = grey(cividis(i / 100.0));
        EXPECT_GT(light, last);
        last = light;
    }
    EXPECT_EQ(cividis(-3), cividis(0));
    EXPECT_EQ(cividis(7), cividis(1));
    EXPECT_EQ(diverging(0), 0xFFFFFFFFu);
    EXPECT_LT(grey(heat(1)), grey(heat(0.5)));
    EXPECT_LT(grey(heat(0.5)), grey(heat(0)));
}

TEST(TestsPerPixel, AddUpToTheDepthTestsOfTheFrame)
{
    const SeenScene seen = builtinScene("cubes", 45, 30);
    for (const Preset& preset : presets()) {
        SCOPED_TRACE(preset.name);
        Replay     replay(seen.request(preset.pipeline));
        const auto last = replay.count(Grain::Frame);
        ASSERT_TRUE(last.ok());
        const auto state = replay.at(Grain::Frame, StepIndex{*last - 1});
        ASSERT_TRUE(state.ok());
        std::uint64_t sum = 0;
        for (const std::uint32_t tests : state->tests.values()) sum += tests;
        Renderer   renderer;
        const auto work = renderer.count(seen.request(preset.pipeline));
        ASSERT_TRUE(work.ok());
        const auto counter = std::ranges::find(work->counters, "fragments_tested", &NamedCount::name);
        ASSERT_NE(counter, work->counters.end());
        EXPECT_EQ(sum, counter->value);
    }
}

class Trees : public testing::TestWithParam<std::string_view> {};

TEST_P(Trees, NoTriangleThatOwnsAPixelLiesInANodeThatWasCulled)
{
    const Pipeline& pipeline = findPreset(GetParam())->pipeline;
    for (const SeenScene& seen : {builtinScene("wall-and-city?blocks=3", 64, 36), builtinScene("cubes", 45, 30)}) {
        SCOPED_TRACE(seen.what);
        Replay     replay(seen.request(pipeline));
        const auto count = replay.count(Grain::Node);
        ASSERT_TRUE(count.ok());
        const auto state = replay.at(Grain::Node, StepIndex{*count - 1});
        ASSERT_TRUE(state.ok());
        ASSERT_TRUE(state->hierarchy && state->hierarchy->tree);
        const auto& nodes = state->hierarchy->nodes;
        for (int y = 0; y < state->frame.visible.height(); ++y) {
            for (int x = 0; x < state->frame.visible.width(); ++x) {
                const std::int64_t id = state->frame.visible.idAt(x, y);
                if (id < 0) continue;
                const int node = nodeHolding(TriangleId{static_cast<std::uint32_t>(id)}, nodes, *seen.scene,
                                             *state->hierarchy->tree);
                ASSERT_GE(node, 0);
                ASSERT_EQ(nodes[static_cast<std::size_t>(node)].verdict, NodeVerdict::Drawn);
            }
        }
    }
}

TEST_P(Trees, TheObserverShowsEveryTriangleWithTheVerdictOfItsNode)
{
    const SeenScene seen = builtinScene("cubes", 45, 30);
    Replay          replay(seen.request(findPreset(GetParam())->pipeline));
    const auto      count = replay.count(Grain::Node);
    ASSERT_TRUE(count.ok());
    const auto state = replay.at(Grain::Node, StepIndex{*count - 1});
    ASSERT_TRUE(state.ok() && state->hierarchy);
    const auto observer = OutsideView::make(seen.scene, seen.camera, *state->hierarchy);
    ASSERT_TRUE(observer.ok());
    EXPECT_EQ((*observer)->trianglesShown() + (*observer)->trianglesLeftOut(), seen.scene->scene().triangleCount());

    const Camera from    = (*observer)->firstView(160, 120);
    const auto   picture = (*observer)->draw(from, {}, -1, 1);
    ASSERT_TRUE(picture.ok());
    std::set<NodeVerdict> seenVerdicts;
    for (const int node : picture->nodes.values()) {
        if (node < 0) continue;
        const NodeVerdict verdict = state->hierarchy->nodes[static_cast<std::size_t>(node)].verdict;
        EXPECT_NE(verdict, NodeVerdict::Entered);  // its triangles belong to nodes below it
        seenVerdicts.insert(verdict);
    }
    EXPECT_TRUE(seenVerdicts.contains(NodeVerdict::Drawn));

    // With the boxes, nodes without a triangle of their own are seen too; the selected one in the accent colour.
    const auto boxed = (*observer)->draw(from, everyVerdict(), 0, 1);
    ASSERT_TRUE(boxed.ok());
    EXPECT_TRUE(std::ranges::count(boxed->nodes.values(), 0) > 0);
    EXPECT_TRUE(std::ranges::count(boxed->colours.values(), 0xFFE69F00u) > 0);
    EXPECT_EQ(std::ranges::count(picture->colours.values(), 0xFFE69F00u), 0);
}

INSTANTIATE_TEST_SUITE_P(Presets, Trees, testing::Values("octree-frustum", "hzb-octree", "hzb-bvh", "two-pass"),
                         [](const auto& tested) {
                             std::string name(tested.param);
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

TEST(NodeBoxes, TheOutlineOfABoxInViewStaysWithinTheRectangleThatCullingAsksAbout)
{
    const SeenScene seen = builtinScene("cubes", 200, 150);
    Replay          replay(seen.request(findPreset("hzb-octree")->pipeline));
    const auto      count = replay.count(Grain::Node);
    ASSERT_TRUE(count.ok());
    const auto state = replay.at(Grain::Node, StepIndex{*count - 1});
    ASSERT_TRUE(state.ok() && state->hierarchy);
    int checked = 0;
    for (const NodeRow& node : state->hierarchy->nodes) {
        EXPECT_EQ(rowOf(state->hierarchy->nodes, nameOf(node)), node.id);
        const NodeOnScreen at    = onScreen(node, seen.scene->scene(), seen.camera);
        const auto         lines = outlineOf(node, seen.scene->scene(), seen.camera);
        if (at.crossesNear) continue;
        ASSERT_EQ(lines.size(), kBoxEdges.size());
        double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;
        for (const ScreenLine& line : lines) {
            x0 = std::min({x0, line.x0, line.x1}), x1 = std::max({x1, line.x0, line.x1});
            y0 = std::min({y0, line.y0, line.y1}), y1 = std::max({y1, line.y0, line.y1});
        }
        const auto within = [](double low, double high, int size) {
            return std::max(0.0, std::min(high, double(size)) - std::max(low, 0.0));
        };
        EXPECT_GE(static_cast<double>(at.pixels) + 2 * (200 + 150), within(x0, x1, 200) * within(y0, y1, 150));
        EXPECT_LE(static_cast<double>(at.pixels), (within(x0, x1, 200) + 2) * (within(y0, y1, 150) + 2));
        ++checked;
    }
    EXPECT_GT(checked, 3);
}

}  // namespace
}  // namespace zscope::tests
