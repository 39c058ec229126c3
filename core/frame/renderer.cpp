#include "core/frame/renderer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <new>
#include <optional>

#include <omp.h>
#include <unistd.h>

#include "core/base/memory.h"
#include "core/fast/kernels.h"
#include "core/frame/auto_choice.h"
#include "core/frame/frame_plan.h"
#include "core/frame/observed_run.h"
#include "core/frame/plain_stripe.h"
#include "core/frame/stripes.h"
#include "core/frame/work_recorder.h"
#include "core/geometry/face_batches.h"
#include "core/plain/shading.h"

namespace zscope {

namespace {

/// A measured choice, and what it was measured on.
struct Measured {
    std::weak_ptr<const PreparedScene> scene;
    int                                width = 0, height = 0;
    FramePlan                          plan;
    FaceCulling                        faceCulling = FaceCulling::None;
    Pipeline                           pipeline;
    std::optional<AutoChoice>          choice;

    bool isOf(const DrawRequest& request, const FramePlan& now) const
    {
        const bool sameScene = !scene.owner_before(request.scene) && !request.scene.owner_before(scene);
        return choice && sameScene && width == request.camera.width && height == request.camera.height
               && plan.threads == now.threads && plan.simd == now.simd && faceCulling == request.faceCulling
               && pipeline == request.pipeline;
    }
};

/// What the last frame of plain text took over from the frame before it, if it has coherence and was drawn by one
/// thread.
struct TakenOver {
    std::weak_ptr<const PreparedScene> scene;
    Camera                             camera;
    FaceCulling                        faceCulling = FaceCulling::None;
    Pipeline                           pipeline;
    Pyramid                            pyramid;
    NodeMemory                         memory;

    bool isOf(const DrawRequest& request) const
    {
        return !scene.expired() && !scene.owner_before(request.scene) && !request.scene.owner_before(scene)
               && camera == request.camera && faceCulling == request.faceCulling && pipeline == request.pipeline;
    }
};

}  // namespace

struct Renderer::Workspace {
    std::vector<StripeScratch>  scratch;  // one per thread
    std::vector<plain::Scratch> plain;    // likewise, of plain text
    std::optional<TakenOver>    takenOver;
    StripeBorders               borders;
    Measured                    measured;
};

Renderer::Renderer() : m_workspace(std::make_unique<Workspace>()) {}
Renderer::~Renderer()                              = default;
Renderer::Renderer(Renderer&&) noexcept            = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

namespace {

using Clock = std::chrono::steady_clock;

double msSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The stages of a report: mean over the threads, and what was built before they began; what nobody accounts for is
/// Other.
std::vector<StageTime> stageTimes(const DrawRequest& request, const std::vector<StageMs>& perThread, double builtMs,
                                  double frameMs)
{
    std::vector<StageTime> times;
    double                 accounted = 0;
    for (const Stage stage : kStages) {
        const StageReason reason = reasonFor(stage, request);
        StageTime         time{stage, 0, reason.runs, reason.why};
        for (const StageMs& ms : perThread) time.ms += ms[static_cast<std::size_t>(stage)];
        time.ms /= static_cast<double>(perThread.size());
        if (stage == Stage::Build) time.ms += builtMs;
        accounted += time.ms;
        times.push_back(std::move(time));
    }
    times.back().ms += frameMs - accounted;
    return times;
}

/// What the picture alone needs is refused before anything is made, by planFrame(); this is for all of it together.
std::optional<Error> whyTooLarge(const std::vector<NamedCount>& bytes, const DrawRequest& request)
{
    constexpr std::uint64_t kMebibyte = 1 << 20;
    const std::uint64_t     limit     = effectiveMemoryLimit(request.memoryLimit);
    std::uint64_t           taken     = 0;
    for (const NamedCount& each : bytes) taken += each.value;
    if (taken <= limit) return std::nullopt;
    return Error{Trouble::Limit, "drawing this scene with " + nameOf(request.pipeline) + " takes "
                                     + std::to_string((taken + kMebibyte - 1) / kMebibyte)
                                     + " MiB, more than the limit of " + std::to_string(limit / kMebibyte) + " MiB"};
}

/// A frame that nobody got need not keep what the next one may want: gigabytes of edges, for example.
void giveBackLarge(std::vector<StripeScratch>& scratch)
{
    constexpr std::uint64_t kLarge = std::uint64_t{256} << 20;
    for (StripeScratch& each : scratch)
        if (each.bytes() > kLarge) each = {};
}

FrameCost costOf(const FrameReport& report)
{
    const auto ms = [&report](Stage stage) { return report.stages[static_cast<std::size_t>(stage)].ms; };
    return {.whole    = report.frameMs - ms(Stage::Build),
            .geometry = ms(Stage::Transform) + ms(Stage::Setup),
            .culling  = ms(Stage::Cull) + ms(Stage::Upkeep),
            .raster   = ms(Stage::Raster)};
}

}  // namespace

Result<FrameReport> Renderer::draw(const DrawRequest& request, Frame& frame)
{
    return request.pipeline.chooser == Chooser::Measured ? drawMeasured(request, frame) : drawComposed(request, frame);
}

Result<FrameReport> Renderer::drawMeasured(const DrawRequest& request, Frame& frame)
{
    const Result<FramePlan> plan = planFrame(request);
    if (!plan) return plan.error();
    Measured& measured = m_workspace->measured;
    if (!measured.isOf(request, *plan)) {
        measured = {request.scene,
                    request.camera.width,
                    request.camera.height,
                    *plan,
                    request.faceCulling,
                    request.pipeline,
                    AutoChoice(numbersOf(*request.scene, request.camera, plan->threads))};
    }
    AutoChoice& choice         = *measured.choice;
    DrawRequest composed       = request;
    composed.pipeline          = chosenInstead(request.pipeline, choice.preset());
    Result<FrameReport> report = drawComposed(composed, frame);
    if (!report) return report;
    report->chosen  = choice.preset().name;
    report->why     = choice.why();
    report->isTrial = choice.isTrial();
    choice.drawn(costOf(*report));
    return report;
}

Result<FrameReport> Renderer::drawComposed(const DrawRequest& request, Frame& frame)
{
    const Result<FramePlan> plan = planFrame(request);
    if (!plan) return plan.error();

    const Clock::time_point    start   = Clock::now();
    const Camera&              camera  = request.camera;
    const Kernels*             kernels = kernelsOf(plan->simd);
    const bool                 isPlain = zscope::isPlain(request);
    const ChosenRules          rules(request.pipeline.approximation, request.pipeline.fault, camera);
    const LaneRules            laneRules(request.pipeline.approximation, camera);  // of what is not plain
    std::vector<StageMs>       stageMs(static_cast<std::size_t>(plan->threads));
    std::vector<double>        stripeMs(static_cast<std::size_t>(plan->threads));
    std::vector<Tally>         tallies(static_cast<std::size_t>(plan->threads));
    std::atomic<bool>          outOfMemory  = false;
    const ColourTable*         colours      = nullptr;
    bool                       knowsPainted = false;  // which tiles have colours
    const TransparentSurfaces* transparent  = nullptr;
    const PatchedBatches*      patched      = nullptr;
    double                     builtMs      = 0;
    const ChosenRules          blendRules   = rulesOfBlending(request);
    DepthEncoding              encoding;
    try {
        transparent  = toBeBlended(request);
        knowsPainted = !transparent && !isPlain;
        if (request.shade) colours = &coloursOf(*request.scene);
        const Clock::time_point asked = Clock::now();
        if (drawsPatchedBatches(request)) patched = &patchedBatchesOf(*request.scene);
        if (patched || drawsFaces(request.pipeline)) builtMs = msSince(asked);
        encoding = encodingOf(request, frame.visible);
        frame.visible.resize(camera.width, camera.height, encoding);
        if (!request.shade)
            frame.colour = {};
        else if (frame.colour.width() != camera.width || frame.colour.height() != camera.height) {
            frame.colour.reset(camera.width, camera.height);
            frame.painted.reset(frame.visible.tileColumns(), frame.visible.tileRows(), 1);
        }
        // Who blends colours pixels whatever tile they lie in.
        if (!knowsPainted) std::ranges::fill(frame.painted.values(), std::uint8_t{1});
        if (isPlain) m_workspace->plain.resize(std::max(m_workspace->plain.size(), stageMs.size()));
        m_workspace->scratch.resize(std::max(m_workspace->scratch.size(), stageMs.size()));
        for (StripeScratch& scratch : m_workspace->scratch) scratch.memory.allowWholeNodes();
        m_workspace->takenOver.reset();
        if (isPlain && plan->threads == 1 && request.pipeline.coherence != Coherence::None) {
            const plain::Scratch& before = m_workspace->plain.front();
            m_workspace->takenOver.emplace(
                TakenOver{request.scene, camera, request.faceCulling, request.pipeline, before.pyramid, before.memory});
        }
    } catch (const std::bad_alloc&) {
        frame.colour = {};  // it may have its size and not its values
        return Error{Trouble::Limit, "there is not enough memory for this picture"};
    }
    const Projection       projection = projectionOf(request, rules, encoding.scale);
    std::optional<Painter> painter;
    if (colours)
        painter.emplace(Painter{request.scene->scene(), *colours, frame.colour.view(),
                                operationsOf(request.pipeline.cost),
                                knowsPainted ? frame.painted.view() : GridView<std::uint8_t>{}});
    const bool defers = painter && !shadesFragments(request.pipeline.depth);
    // A picture that is asked for by its colours leaves planes planes: depths and triangles are told when somebody asks
    // for them.
    const bool needsPixels = !painter || (defers && painter->operations != 0) || transparent;
    if (knowsPainted && painter && !defers) frame.visible.colourOpened(frame.colour.view(), kBackgroundColour);
    m_workspace->borders.prepare(camera.height, plan->threads);

#pragma omp parallel for num_threads(plan->threads) schedule(static, 1)
    for (int i = 0; i < plan->threads; ++i) {
        const auto              index       = static_cast<std::size_t>(i);
        Tally&                  tally       = tallies[index];
        const Clock::time_point stripeStart = Clock::now();
        StageClock              clock;
        const auto [first, end] = m_workspace->borders.stripe(i);
        const Stripe stripe{*request.scene,
                            projection,
                            request.faceCulling,
                            frame.visible,
                            first,
                            end,
                            {.cancel = request.cancel},
                            shadesFragments(request.pipeline.depth) && painter ? &*painter : nullptr,
                            effectiveMemoryLimit(request.memoryLimit) / static_cast<std::uint64_t>(plan->threads),
                            request.shortcuts};
        try {
            StripeScratch& scratch = m_workspace->scratch[index];
            scratch.tally          = {};
            if (isPlain) {
                plain::Work work{stripe, rules, m_workspace->plain[index], clock, tally};
                drawPlainly(request.pipeline, work);
                clock.lap(Stage::Raster);
                if (defers) plain::shadeLines(*painter, frame.visible, first, end, tally);
                clock.lap(defers ? Stage::Shade : Stage::Other);
                if (transparent) {
                    plain::Work blending{stripe, blendRules, m_workspace->plain[index], clock, tally};
                    blendPlainly(*transparent, *colours, request.pipeline.transparency, blending, frame.colour.view());
                }
            } else {
                kernels->drawStripe(request.pipeline, laneRules, stripe, scratch, clock);
                if (needsPixels) kernels->storePlanes(frame.visible, first, end);
                clock.lap(Stage::Raster);
                if (defers) {
                    kernels->shadeRows(*painter, frame.visible, first, end);
                    tally.add(Unit::PicturePixels, static_cast<std::uint64_t>(end - first)
                                                       * static_cast<std::uint64_t>(frame.visible.width()));
                }
                clock.lap(defers ? Stage::Shade : Stage::Other);
                if (transparent)
                    kernels->blendStripe(*transparent, *colours, request.pipeline.transparency, laneRules, stripe,
                                         scratch, clock, frame.colour.view());
            }
        } catch (const std::bad_alloc&) {
            outOfMemory = true;
        }
        clock.lap(defers ? Stage::Shade : Stage::Other);
        tally.add(m_workspace->scratch[index].tally);
        stageMs[index]  = clock.ms();
        stripeMs[index] = msSince(stripeStart);
    }
    frame.visible.colourOpened({}, 0);
    const bool isCancelled = request.cancel && request.cancel->load();
    if (isCancelled || outOfMemory) {
        giveBackLarge(m_workspace->scratch);
        std::ranges::fill(frame.painted.values(), std::uint8_t{1});  // some tiles have colours that were not noted
    }
    if (isCancelled) return Error{Trouble::Cancelled, "the frame was cancelled"};
    if (outOfMemory)
        return Error{Trouble::Limit, "drawing this scene with " + nameOf(request.pipeline)
                                         + " takes more memory than there is, or than the limit of "
                                         + std::to_string(effectiveMemoryLimit(request.memoryLimit) >> 20) + " MiB"};
    m_workspace->borders.rebalance(stripeMs);

    FrameReport report;
    report.frameMs   = msSince(start);
    report.stages    = stageTimes(request, stageMs, builtMs, report.frameMs);
    report.threads   = plan->threads;
    report.simd      = plan->simd;
    report.shortcuts = plan->simd == Simd::Scalar ? ShortcutSet() : request.shortcuts;
    report.pipeline  = request.pipeline;
    for (const Tally& each : tallies) report.tally.add(each);
    std::uint64_t scratchBytes = 0;
    for (const StripeScratch& scratch : m_workspace->scratch) scratchBytes += scratch.bytes();
    report.bytes = {{"visibility_buffer", frame.visible.bytes()},
                    {"colours", frame.colour.values().size_bytes()},
                    {"colour_table", colours ? colours->bytes() : 0},
                    {"batches", request.scene->bytes() + (patched ? patched->bytes() : 0)},
                    {"faces", drawsFaces(request.pipeline) ? facesOf(*request.scene).bytes() : 0},
                    {"transparent_batches", transparent ? transparent->bytes() : 0},
                    {"scratch", scratchBytes}};
    if (auto tooLarge = whyTooLarge(report.bytes, request)) return *std::move(tooLarge);
    return report;
}

Result<FrameWork> Renderer::count(const DrawRequest& request)
{
    const Result<FramePlan> plan = planFrame(request);
    if (!plan) return plan.error();
    try {
        Frame          frame;
        plain::Scratch scratch;
        WorkRecorder   work(request.scene->scene());
        DrawRequest    cheaply = request;  // which fragments are shaded does not depend on what that costs
        cheaply.pipeline.cost  = ShadingCost::None;
        cheaply.shade          = shadesFragments(request.pipeline.depth) || toBeBlended(request);
        const auto& before     = m_workspace->takenOver;
        const bool  isKnown    = before && before->isOf(request);
        if (isKnown) {
            scratch.pyramid = before->pyramid;
            scratch.memory  = before->memory;
        }
        Listening listening(work);
        drawObserved(cheaply, frame, scratch, listening, isKnown ? FrameBefore::InScratch : FrameBefore::Drawn);
        if (request.cancel && request.cancel->load()) return Error{Trouble::Cancelled, "counting was cancelled"};
        if (!shadesFragments(request.pipeline.depth)) work.shadedOnce(frame.visible);
        return work.work();
    } catch (const std::bad_alloc&) {
        return Error{Trouble::Limit, "there is not enough memory to count this frame"};
    }
}

}  // namespace zscope
