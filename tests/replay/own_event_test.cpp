// A method that core does not know, with an event of its own: stepping and explanations say what the event says.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/frame/frame_events.h"
#include "core/frame/observed_run.h"
#include "core/lesson/explain.h"
#include "core/lesson/replay.h"
#include "tests/replay/replay_support.h"

namespace zscope::tests {
namespace {

constexpr PixelFate kPaintedOver{"painted-over", "was painted over", FateKind::Overtaken};

/// A painter lays a polygon over what a pixel shows.
struct Painted {
    static constexpr Grain grain = Grain::Pixel;
    int                    x, y;
    TriangleId             triangle, below;
    float                  depth;

    About       about() const { return {.line = y, .triangle = triangle}; }
    std::string sentence(const Telling& telling) const
    {
        return "The painter lays " + telling.nameOf(triangle) + " over " + telling.nameOf(below) + ", "
               + std::to_string(telling.triangles()) + " in all.";
    }
    void mean(Meanings& to) const
    {
        const PixelBox here{x, y, x + 1, y + 1};
        to.of(below, here, {.word = "covered-up", .effect = Effect::Overtaken}, [&](TriangleId id, PixelPosition) {
            return Meaning{.depth      = depth / 2,
                           .rival      = triangle,
                           .rivalDepth = depth,
                           .fate       = kPaintedOver,
                           .sentence   = to.telling().nameOf(id) + " is painted over."};
        });
        to.of(triangle, here, {.word = "painted", .effect = Effect::Wins, .countedAs = {"painted"}},
              [&](TriangleId id, PixelPosition at) {
                  return Meaning{.depth    = depth,
                                 .values   = {{"brush", Values{{"x", std::int64_t{at.x}}, {"wet", true}}}},
                                 .sentence = to.telling().nameOf(id) + " is painted last."};
              });
        to.remark(here, [] { return std::string("the painter uses one brush"); });
    }
};
static_assert(isStep<Painted>);

/// Whom the painter covers up wherever `id` is seen.
TriangleId belowOf(std::int64_t id) { return {id == 0 ? 1u : 0u}; }

struct Silent final : Observer {
    void hear(const Heard&) override {}
};

/// The picture of a z-buffer, of which every covered pixel is told as painted.
void paint(const DrawRequest& request, Frame& frame, plain::Scratch& scratch, Observer& observer)
{
    Silent silent;
    drawObserved(request, frame, scratch, silent);
    const auto tell = [&](const auto& event, SourceLine line = SourceLine::here()) {
        observer.hear({kEventKind<std::decay_t<decltype(event)>>, &event, line, line});
    };
    for (int y = 0; y < frame.visible.height(); ++y)
        for (int x = 0; x < frame.visible.width(); ++x)
            if (const std::int64_t id = frame.visible.idAt(x, y); id >= 0)
                tell(Painted{x, y, TriangleId{static_cast<std::uint32_t>(id)}, belowOf(id),
                             frame.visible.depthAt(x, y)});
    tell(FrameFinished{});
}

constexpr ObservedMethod kPainter{paint};

/// The first pixel of the picture that shows something, which the painter tells first.
PixelPosition firstCovered(const DrawRequest& request)
{
    Renderer renderer;
    Frame    frame;
    EXPECT_TRUE(renderer.draw(request, frame).ok());
    for (int y = 0; y < frame.visible.height(); ++y)
        for (int x = 0; x < frame.visible.width(); ++x)
            if (frame.visible.idAt(x, y) >= 0) return {x, y};
    ADD_FAILURE() << "the picture is empty";
    return {};
}

TEST(OwnEvent, AStepSaysTheSentenceOfItsEvent)
{
    const SeenScene   scene   = builtinScene("cubes", 32, 24);
    const DrawRequest request = scene.request(findPreset("zbuffer")->pipeline);
    Replay            replay(request, {}, &kPainter);
    const auto        state = replay.at(Grain::Pixel, {0});
    ASSERT_TRUE(state.ok()) << state.error().sentence;
    const PixelPosition p  = firstCovered(request);
    const std::int64_t  id = state->frame.visible.idAt(p.x, p.y);
    EXPECT_EQ(state->sentence, "The painter lays triangle " + std::to_string(id) + " over triangle "
                                   + std::to_string(belowOf(id).value) + ", "
                                   + std::to_string(scene.scene->scene().triangleCount()) + " in all.");
    EXPECT_EQ(state->event, Grain::Pixel);
    EXPECT_FALSE(state->pixel.has_value()) << "no depth test";
    EXPECT_EQ(std::string_view(state->part.function), "paint");
}

TEST(OwnEvent, AnExplanationOfAPixelSaysWhatTheEventMeans)
{
    const SeenScene     scene   = builtinScene("cubes", 32, 24);
    const DrawRequest   request = scene.request(findPreset("zbuffer")->pipeline);
    const PixelPosition p       = firstCovered(request);
    const auto          all     = explainPixels(request, std::span(&p, 1), {}, &kPainter);
    ASSERT_TRUE(all.ok()) << all.error().sentence;
    const PixelExplanation& e = all->front();
    ASSERT_GE(e.candidates.size(), 2u);
    const PixelCandidate &below = e.candidates[0], &winner = e.candidates[1];  // in the order met

    EXPECT_EQ(below.triangle, belowOf(e.winner));
    EXPECT_EQ(below.fate, kPaintedOver);
    EXPECT_EQ(below.rival, winner.triangle);
    EXPECT_EQ(below.sentence,
              "triangle " + std::to_string(below.triangle.value) + " is painted over. (the painter uses one brush.)");
    EXPECT_EQ(winner.fate, fates::kWinner);
    EXPECT_TRUE(winner.sentence.ends_with("is painted last. (the painter uses one brush.)")) << winner.sentence;
    EXPECT_NE(e.sentence.find("1 is seen, 1 was painted over"), std::string::npos) << e.sentence;

    const auto json  = nlohmann::json::parse(explanationToJson(e));
    const auto event = json["triangles"][1]["events"][0];
    EXPECT_EQ(json["triangles"][0]["fate"], "painted-over");
    EXPECT_EQ(event["event"], "painted");
    EXPECT_EQ(event["steps"]["pixel"], 0);
    EXPECT_EQ(event["brush"]["x"], p.x);
    EXPECT_EQ(event["brush"]["wet"], true);
    EXPECT_NE(explanationToText(e).find("painted         triangle"), std::string::npos) << explanationToText(e);
}

TEST(OwnEvent, AnExplanationOfATriangleCountsByTheNamesOfTheEvent)
{
    const SeenScene     scene   = builtinScene("cubes", 32, 24);
    const DrawRequest   request = scene.request(findPreset("zbuffer")->pipeline);
    const PixelPosition p       = firstCovered(request);
    const auto          pixel   = explainPixel(request, p);
    ASSERT_TRUE(pixel.ok());
    const TriangleId id{static_cast<std::uint32_t>(pixel->winner)};
    const auto       e = explainTriangle(request, id, {}, &kPainter);
    ASSERT_TRUE(e.ok()) << e.error().sentence;
    EXPECT_GT(e->tally.shown, 0u);
    EXPECT_EQ(e->tally.of("painted"), e->tally.shown);
    ASSERT_EQ(e->events.size(), 1u) << "the first of a word";
    EXPECT_EQ(e->events[0].word, "painted");
    EXPECT_EQ(e->events[0].pixel, p);
    EXPECT_EQ(nlohmann::json::parse(explanationToJson(*e))["pixels"]["painted"], e->tally.shown);
}

}  // namespace
}  // namespace zscope::tests
