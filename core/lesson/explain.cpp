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
#include "core/lesson/run_telling.h"
#include "core/probe/recorders.h"
#include "core/probe/words.h"
#include "core/scene/opacity.h"

namespace zscope {

namespace {

Error explainingWasCancelled() { return {Trouble::Cancelled, "the explanation was cancelled"}; }
Error tooLittleToExplain() { return {Trouble::Limit, "there is not enough memory to explain this frame"}; }

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

/// A run and what is always kept of it.
struct Observed {
    explicit Observed(const DrawRequest& request) : telling(request, frame, triangle) {}

    Frame            frame;
    StepCounter      steps;
    TriangleRecorder triangle;
    RunTelling       telling;
};

/// The run that the recorder observes; the picture stays in `run`.
template <class Recorder>
Result<Done> runWith(const ObservedMethod* method, const DrawRequest& request, Observed& run, Recorder& recorder)
{
    plain::Scratch scratch;
    Listening      listening(run.steps, run.triangle, recorder);
    drawObserved(method, request, run.frame, scratch, listening);
    if (request.cancel && request.cancel->load()) return explainingWasCancelled();
    return Done{};
}

/// A pre-pass decides nothing.
bool isTest(const Event& event) { return !event.isPrepass && isTest(event.effect); }
bool has(const Event& event, Effect effect) { return !event.isPrepass && event.effect == effect; }

/// The last event of which `wanted` is true.
template <class Wanted>
std::optional<std::size_t> lastOf(const std::vector<Event>& events, const Wanted& wanted)
{
    for (std::size_t i = events.size(); i > 0; --i)
        if (wanted(events[i - 1])) return i - 1;
    return std::nullopt;
}

std::optional<std::size_t> lastOf(const std::vector<Event>& events, Effect effect)
{
    return lastOf(events, [effect](const Event& e) { return has(e, effect); });
}

/// What the events of a triangle at a pixel come to.
void decide(PixelCandidate& c, const PixelExplanation& pixel)
{
    if (pixel.winner == std::int64_t{c.drawnAs.value}) {
        c.fate     = fates::kWinner;
        c.decisive = lastOf(c.events, Effect::Wins);
        return;
    }
    c.decisive = lastOf(c.events, Effect::Overtaken);
    if (!c.decisive) c.decisive = lastOf(c.events, [](const Event& e) { return isTest(e); });
    if (!c.decisive && c.cover != Cover::BeforeNear) c.decisive = lastOf(c.events, Effect::Ends);
    if (c.decisive) {
        const Event& event = c.events[*c.decisive];
        c.fate             = event.fate;
        if (isTest(event) && c.fate.kind != FateKind::Absent && c.fate.kind != FateKind::NotKept) {
            c.rival = event.rival;
            // whose depth a pre-pass kept
            if (!c.rival && pixel.winner >= 0) c.rival = TriangleId{static_cast<std::uint32_t>(pixel.winner)};
            c.stepsBehind = float32StepsBetween(event.depth, event.rivalDepth.value_or(0));
        }
        return;
    }
    const bool wasSetUp = !c.events.empty();
    if (c.cover == Cover::Transparent)
        c.fate = c.depth > pixel.depth ? fates::kBlended : fates::kBehindOpaque;
    else if (c.cover == Cover::BeforeNear)
        c.fate = fates::kNearClip;
    else if (c.cover == Cover::BackFace)
        c.fate = fates::kBackFace;
    else
        c.fate = wasSetUp ? fates::kNotFilled : fates::kBatchOutside;
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
    if (!isTest(event) || c.fate.kind == FateKind::Absent) return "";
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
    const Pipeline&  pipeline = request.pipeline;
    PixelExplanation explanation{.pixel = p, .algorithm = nameOf(pipeline), .grains = grainsOf(pipeline)};
    explanation.winner     = frame.visible.idAt(p.x, p.y);
    explanation.depth      = frame.visible.depthAt(p.x, p.y);
    explanation.candidates = inOrderMet(history);
    for (PixelCandidate& c : explanation.candidates) {
        for (const Event& event : c.events)
            if (event.node) c.node = event.node;
        decide(c, explanation);
        stateOpacity(c, request.scene->scene());
        c.sentence = sentenceOf(c, explanation, pipeline, request.shade);
        c.sentence += reliefOf(c, request);
        if (!history.remark.empty() && c.decisive && isTest(c.events[*c.decisive]))
            c.sentence += " (" + history.remark + ".)";
    }
    explanation.sentence = sentenceOf(explanation, pipeline);
    return explanation;
}

}  // namespace

Result<std::vector<PixelExplanation>> explainPixels(const DrawRequest& asked, std::span<const PixelPosition> pixels,
                                                    const Progress& progress, const ObservedMethod* method)
try {
    if (const auto error = cannotExplain(asked, pixels)) return *error;
    const DrawRequest request = repeatable(asked);
    const Scene&      scene   = request.scene->scene();
    const auto        covers  = coversOf(scene, request.camera, request.faceCulling, pixels, progress);
    if (!covers) return covers.error();

    Observed       run(request);
    PixelHistories histories(scene, request.camera.width, request.camera.height, pixels, *covers,
                             drawsFaces(request.pipeline), run.steps, run.telling);
    if (const auto done = runWith(method, request, run, histories); !done) return done.error();

    std::vector<PixelExplanation>      all;
    std::map<std::size_t, std::size_t> first;  // which answer explains a history
    for (const PixelPosition p : pixels) {
        const auto [known, isNew] = first.try_emplace(histories.of(p), all.size());
        if (isNew)
            all.push_back(explained(histories.histories()[known->first], p, request, run.frame));
        else
            all.push_back(PixelExplanation(all[known->second]));
    }
    return all;
} catch (const std::bad_alloc&) {
    return tooLittleToExplain();
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

PixelFate fateOf(const TriangleExplanation& e, const TriangleCovers& covers)
{
    const TriangleTally& t = e.tally;
    if (covers.isTransparent) return t.covered > 0 ? fates::kBlended : fates::kNotFilled;
    if (t.shown > 0) return fates::kWinner;
    if (t.won > 0) return fates::kOverwritten;
    if (const auto last = lastOf(e.events, [](const Event& event) { return isTest(event); }))
        return e.events[*last].fate;
    if (const auto last = lastOf(e.events, Effect::Ends)) return e.events[*last].fate;
    if (covers.isBehindNear) return fates::kNearClip;
    if (t.backFacing > 0) return fates::kBackFace;
    if (covers.parts > 0 && e.events.empty()) return fates::kBatchOutside;
    return fates::kNotFilled;
}

}  // namespace

Result<TriangleExplanation> explainTriangle(const DrawRequest& asked, TriangleId triangle, const Progress& progress,
                                            const ObservedMethod* method)
try {
    if (const auto error = cannotExplain(asked, {})) return *error;
    const DrawRequest request = repeatable(asked);
    const Scene&      scene   = request.scene->scene();
    if (triangle.value >= scene.triangleCount())
        return Error{Trouble::Usage, "there is no triangle " + std::to_string(triangle.value) + ": the scene has "
                                         + std::to_string(scene.triangleCount())};
    progress.at(0, "explaining");
    const TriangleCovers covers = coversOf(scene, request.camera, request.faceCulling, triangle);

    Observed        run(request);
    const bool      byFace = drawsFaces(request.pipeline);
    TriangleHistory history(scene, triangle, byFace, run.steps, run.telling);
    if (const auto done = runWith(method, request, run, history); !done) return done.error();

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
    findTakers(e, covers, run.frame.visible);
    e.fate     = fateOf(e, covers);
    e.sentence = sentenceOf(e, request.pipeline);
    return e;
} catch (const std::bad_alloc&) {
    return tooLittleToExplain();
}

}  // namespace zscope
