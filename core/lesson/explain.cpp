// Explanations: one observed run, and the definition's list of who meets the pixels.
#include "core/lesson/explain.h"

#include <algorithm>
#include <map>
#include <new>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/frame/frame_plan.h"
#include "core/frame/observed_run.h"
#include "core/lesson/explain_recorders.h"
#include "core/lesson/explain_sentences.h"
#include "core/probe/recorders.h"
#include "core/scene/opacity.h"

namespace zscope {

namespace {

Error wasCancelled() { return {Trouble::Cancelled, "the explanation was cancelled"}; }
Error outOfMemory() { return {Trouble::Limit, "there is not enough memory to explain this frame"}; }

/// Looks at how a run is told, before it costs anything.
std::optional<Error> cannotExplain(const DrawRequest& request, std::span<const PixelPosition> pixels)
{
    if (const auto plan = planFrame(request); !plan) return plan.error();
    for (const PixelPosition p : pixels)
        if (p.x < 0 || p.y < 0 || p.x >= request.camera.width || p.y >= request.camera.height)
            return Error{Trouble::Usage, "there is no pixel " + std::to_string(p.x) + "," + std::to_string(p.y)
                                             + " in a picture of " + std::to_string(request.camera.width) + "x"
                                             + std::to_string(request.camera.height)};
    return std::nullopt;
}

/// The run that the recorder observes; the picture stays in `frame`.
template <class Recorder>
Result<Done> runWith(const DrawRequest& request, Frame& frame, StepCounter& steps, Recorder& recorder)
{
    plain::Scratch scratch;
    Listening      listening(steps, recorder);
    drawObserved(request, frame, scratch, listening);
    if (request.cancel && request.cancel->load()) return wasCancelled();
    return Done{};
}

bool isTest(const Event& event)
{
    switch (event.happening) {
        case Happening::Discarded:
        case Happening::Won:
        case Happening::Lost:
        case Happening::Overtaken:
        case Happening::IntervalWon:
        case Happening::IntervalLost:
            return !event.isPrepass;
        default:
            return false;
    }
}

/// The last event of which `wanted` is true.
template <class Wanted>
std::optional<std::size_t> lastOf(const std::vector<Event>& events, const Wanted& wanted)
{
    for (std::size_t i = events.size(); i > 0; --i)
        if (wanted(events[i - 1])) return i - 1;
    return std::nullopt;
}

std::optional<std::size_t> lastOf(const std::vector<Event>& events, Happening happening)
{
    return lastOf(events, [happening](const Event& e) { return e.happening == happening && !e.isPrepass; });
}

PixelFate fateOf(const Event& event, float background)
{
    switch (event.happening) {
        case Happening::SetUp:
            return event.setUp == SetUp::BackFacing    ? PixelFate::BackFace
                   : event.setUp == SetUp::ClippedAway ? PixelFate::NearClip
                                                       : PixelFate::NotFilled;
        case Happening::NodeOutside:
            return PixelFate::NodeOutside;
        case Happening::NodeHidden:
            return PixelFate::NodeHidden;
        case Happening::NodeSmall:
            return PixelFate::NodeSmall;
        case Happening::TriangleHidden:
            return PixelFate::TriangleHidden;
        case Happening::TileRejected:
            return PixelFate::TileRejected;
        case Happening::Discarded:
            return PixelFate::Hole;
        case Happening::Overtaken:
            return PixelFate::Overwritten;
        case Happening::IntervalLost:
            return PixelFate::IntervalLost;
        case Happening::Lost:
            if (event.depth > event.rivalDepth) return PixelFate::Hole;  // after a pre-pass that left it out
            if (!event.rival && event.rivalDepth <= background) return PixelFate::BeyondFar;
            return event.depth == event.rivalDepth ? PixelFate::LostTie : PixelFate::Farther;
        default:
            return PixelFate::NotFilled;
    }
}

/// A set-up that went well decides nothing.
bool endsIt(const Event& event)
{
    if (event.isPrepass || event.happening == Happening::TrianglePassed) return false;
    return event.happening != Happening::SetUp || event.setUp != SetUp::Drawn;
}

/// What the events of a triangle at a pixel come to.
void decide(PixelCandidate& c, const PixelExplanation& pixel, float background)
{
    if (pixel.winner == std::int64_t{c.drawnAs.value}) {
        c.fate     = PixelFate::Winner;
        c.decisive = lastOf(c.events, [](const Event& e) {
            return !e.isPrepass && (e.happening == Happening::Won || e.happening == Happening::IntervalWon);
        });
        return;
    }
    c.decisive = lastOf(c.events, Happening::Overtaken);
    if (!c.decisive) c.decisive = lastOf(c.events, isTest);
    if (!c.decisive && c.cover != Cover::BeforeNear) c.decisive = lastOf(c.events, endsIt);
    if (c.decisive) {
        const Event& event = c.events[*c.decisive];
        c.fate             = fateOf(event, background);
        if (isTest(event) && c.fate != PixelFate::Hole && c.fate != PixelFate::BeyondFar) {
            c.rival = event.rival;
            // whose depth a pre-pass kept
            if (!c.rival && pixel.winner >= 0) c.rival = TriangleId{static_cast<std::uint32_t>(pixel.winner)};
            c.stepsBehind = float32StepsBetween(event.depth, event.rivalDepth);
        }
        return;
    }
    const bool wasSetUp = !c.events.empty();
    if (c.cover == Cover::Transparent)
        c.fate = c.depth > pixel.depth ? PixelFate::Blended : PixelFate::BehindOpaque;
    else if (c.cover == Cover::BeforeNear)
        c.fate = PixelFate::NearClip;
    else if (c.cover == Cover::BackFace)
        c.fate = PixelFate::BackFace;
    else
        c.fate = wasSetUp ? PixelFate::NotFilled : PixelFate::BatchOutside;
}

/// The candidates in the order in which the run met them.
std::vector<PixelCandidate> inOrderMet(PixelHistories::History& history)
{
    std::vector<std::size_t> order(history.candidates.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return std::pair(history.met[a], history.candidates[a].triangle)
               < std::pair(history.met[b], history.candidates[b].triangle);
    });
    std::vector<PixelCandidate> candidates;
    candidates.reserve(order.size());
    for (const std::size_t i : order) candidates.push_back(std::move(history.candidates[i]));
    return candidates;
}

const Material& materialOf(const Scene& scene, InstanceId instance, TriangleId triangle)
{
    const Mesh& mesh = scene.meshOf(instance);
    return mesh.materialOf(mesh.trianglePolygon[triangle.value - scene.firstTriangle[instance.value]]);
}

/// For a candidate, or a triangle's explanation.
template <class Explained>
void stateOpacity(Explained& e, const Scene& scene)
{
    const Material& material = materialOf(scene, e.instance, e.triangle);
    e.opacity                = material.opacity;
    if (material.opacity < 1) e.opacityText = opacityText(material);
}

/// A relief's depth is known only after the triangle's own has passed; what a test saw before that is a bound.
std::string reliefOf(const PixelCandidate& c, const DrawRequest& request)
{
    if (!materialOf(request.scene->scene(), c.instance, c.triangle).relief || !c.decisive) return "";
    const Event& event = c.events[*c.decisive];
    if (!isTest(event) || c.fate == PixelFate::Hole) return "";
    if (event.unmovedDepth)
        return fmt::format(" (Its material's relief moved it back from {:.9g} to {:.9g}.)", *event.unmovedDepth,
                           event.depth);
    if (event.depth <= c.depth) return "";
    return fmt::format(" (That is where its triangle is; its relief would have been at {:.9g}, but nobody had to ask.)",
                       c.depth);
}

PixelExplanation explained(PixelHistories::History& history, PixelPosition p, const DrawRequest& request,
                           const Frame& frame)
{
    const Pipeline&  pipeline   = request.pipeline;
    const float      background = frame.visible.empty();
    PixelExplanation explanation{.pixel = p, .algorithm = nameOf(pipeline), .grains = grainsOf(pipeline)};
    explanation.winner     = frame.visible.idAt(p.x, p.y);
    explanation.depth      = frame.visible.depthAt(p.x, p.y);
    explanation.candidates = inOrderMet(history);
    for (PixelCandidate& c : explanation.candidates) {
        const Scene& scene = request.scene->scene();
        for (Event& event : c.events) {
            event.isMirrored = scene.instances[scene.instanceOf(c.triangle).value].toWorld.isMirrored();
            event.sentence   = sentenceOf(event, c.drawnAs, pipeline, background);
            if (event.node) c.node = event.node;
        }
        decide(c, explanation, background);
        stateOpacity(c, request.scene->scene());
        c.sentence = sentenceOf(c, explanation, pipeline, request.shade);
        c.sentence += reliefOf(c, request);
        if (history.comparedBecause && c.decisive && isTest(c.events[*c.decisive]))
            c.sentence += " (" + sentenceOf(*history.comparedBecause) + ".)";
    }
    explanation.sentence = sentenceOf(explanation, pipeline);
    return explanation;
}

}  // namespace

Result<std::vector<PixelExplanation>> explainPixels(const DrawRequest& asked, std::span<const PixelPosition> pixels,
                                                    const Progress& progress)
try {
    if (const auto error = cannotExplain(asked, pixels)) return *error;
    const DrawRequest request = repeatable(asked);
    const Scene&      scene   = request.scene->scene();
    const auto        covers  = coversOf(scene, request.camera, request.faceCulling, pixels, progress);
    if (!covers) return covers.error();

    Frame          frame;
    StepCounter    steps;
    PixelHistories histories(scene, request.camera.width, request.camera.height, pixels, *covers,
                             drawsFaces(request.pipeline), steps);
    if (const auto done = runWith(request, frame, steps, histories); !done) return done.error();

    std::vector<PixelExplanation>      all;
    std::map<std::size_t, std::size_t> first;  // which answer explains a history
    for (const PixelPosition p : pixels) {
        const auto [known, isNew] = first.try_emplace(histories.of(p), all.size());
        if (isNew)
            all.push_back(explained(histories.histories()[known->first], p, request, frame));
        else
            all.push_back(PixelExplanation(all[known->second]));
    }
    return all;
} catch (const std::bad_alloc&) {
    return outOfMemory();
}

Result<PixelExplanation> explainPixel(const DrawRequest& request, PixelPosition pixel, const Progress& progress)
{
    auto all = explainPixels(request, std::span(&pixel, 1), progress);
    if (!all) return all.error();
    return std::move(all->front());
}

namespace {

/// Of the covered pixels that do not show the triangle: who shows them, most pixels first.
void findTakers(TriangleExplanation& e, const TriangleCovers& covers, const VisibilityBuffer& visible)
{
    std::map<std::int64_t, std::uint64_t> pixels;
    for (const PixelPosition p : covers.opaque) {
        const std::int64_t id = visible.idAt(p.x, p.y);
        if (id == std::int64_t{e.drawnAs.value})
            ++e.tally.shown;
        else
            ++pixels[id];
    }
    for (const auto& [id, count] : pixels) e.takers.push_back({id, count});
    std::ranges::stable_sort(e.takers, std::greater{}, &Taker::pixels);
    if (e.takers.size() <= TriangleExplanation::kMostTakers) return;
    e.otherTakers = e.takers.size() - TriangleExplanation::kMostTakers;
    e.takers.resize(TriangleExplanation::kMostTakers);
}

PixelFate fateOf(const TriangleExplanation& e, const TriangleCovers& covers, float background)
{
    const TriangleTally& t = e.tally;
    if (covers.isTransparent) return t.covered > 0 ? PixelFate::Blended : PixelFate::NotFilled;
    if (t.shown > 0) return PixelFate::Winner;
    if (t.passed > 0 || t.intervalWon > 0) return PixelFate::Overwritten;
    if (const auto last = lastOf(e.events, isTest)) return fateOf(e.events[*last], background);
    const auto isEnd = [](const Event& event) {
        return endsIt(event) && event.happening != Happening::NodeEntered && event.happening != Happening::NodeRecalled;
    };
    if (const auto last = lastOf(e.events, isEnd)) return fateOf(e.events[*last], background);
    if (covers.isBehindNear) return PixelFate::NearClip;
    if (t.backFacing > 0) return PixelFate::BackFace;
    if (covers.parts > 0 && e.events.empty()) return PixelFate::BatchOutside;
    return PixelFate::NotFilled;
}

}  // namespace

Result<TriangleExplanation> explainTriangle(const DrawRequest& asked, TriangleId triangle, const Progress& progress)
try {
    if (const auto error = cannotExplain(asked, {})) return *error;
    const DrawRequest request = repeatable(asked);
    const Scene&      scene   = request.scene->scene();
    if (triangle.value >= scene.triangleCount())
        return Error{Trouble::Usage, "there is no triangle " + std::to_string(triangle.value) + ": the scene has "
                                         + std::to_string(scene.triangleCount())};
    progress.at(0, "explaining");
    const TriangleCovers covers = coversOf(scene, request.camera, request.faceCulling, triangle);

    Frame           frame;
    StepCounter     steps;
    const bool      byFace = drawsFaces(request.pipeline);
    TriangleHistory history(scene, triangle, byFace, steps);
    if (const auto done = runWith(request, frame, steps, history); !done) return done.error();

    TriangleExplanation e;
    e.triangle      = triangle;
    e.drawnAs       = byFace ? scene.firstOfFace(triangle) : triangle;
    e.instance      = scene.instanceOf(triangle);
    e.mesh          = scene.meshOf(e.instance).name;
    e.material      = materialOf(scene, e.instance, triangle).name;
    e.algorithm     = nameOf(request.pipeline);
    e.grains        = grainsOf(request.pipeline);
    e.isTransparent = covers.isTransparent;
    stateOpacity(e, scene);
    e.tally         = history.tally();
    e.tally.covered = covers.opaque.size();
    e.tally.inHoles = covers.holes, e.tally.beyondFar = covers.beyondFar, e.tally.backFacing = covers.backFacing;
    e.events  = std::move(history.events());
    e.leftOut = history.leftOut();
    findTakers(e, covers, frame.visible);
    for (Event& event : e.events) {
        event.isMirrored = scene.instances[e.instance.value].toWorld.isMirrored();
        event.sentence   = sentenceOf(event, e.drawnAs, request.pipeline, frame.visible.empty());
    }
    e.fate     = fateOf(e, covers, frame.visible.empty());
    e.sentence = sentenceOf(e, request.pipeline);
    return e;
} catch (const std::bad_alloc&) {
    return outOfMemory();
}

}  // namespace zscope
