// Stepping: the frame again, serially and with one lane, stopped right after the wanted event.
#define HWY_COMPILE_ONLY_SCALAR

#include "core/lesson/replay.h"

#include <algorithm>
#include <new>
#include <utility>

#include "core/frame/serial_run-inl.h"
#include "core/lesson/recorders.h"
#include "core/lesson/sentences.h"

namespace zscope {

namespace {

/// The stored levels of the pyramid as the run left them.
std::vector<Grid<float>> cellsOf(const Pyramid& pyramid)
{
    std::vector<Grid<float>> cells;
    for (int level = Pyramid::kTileLevel; level < pyramid.levels(); ++level) {
        const GridView<const float> stored = pyramid.stored(level);
        Grid<float>& copy = cells.emplace_back(stored.width, stored.height);
        for (int y = 0; y < stored.height; ++y) std::ranges::copy(stored.row(y), copy.view().row(y).begin());
    }
    return cells;
}

/// Notes at which step of a grain each stage begins.
class StageRecorder {
public:
    explicit StageRecorder(Grain grain) : m_grain(grain) {}

    void observe(const StageStarted& e)
    {
        dropEmpty();
        m_stages.push_back({e.stage, m_seen});
    }
    template <isStep Event>
    void observe(const Event&)
    {
        if (Event::grain <= m_grain) ++m_seen;
    }

    std::vector<StageMark> take()
    {
        dropEmpty();
        return std::move(m_stages);
    }

private:
    void dropEmpty()
    {
        if (!m_stages.empty() && m_stages.back().first == m_seen) m_stages.pop_back();
    }

    Grain                  m_grain;
    std::uint64_t          m_seen = 0;
    std::vector<StageMark> m_stages;
};
static_assert(observes<StageRecorder, StageStarted> && observes<StageRecorder, FrameFinished>);

std::optional<Error> cannotStep(const DrawRequest& request, Grain grain)
{
    const std::vector<Grain> grains = grainsOf(repeatable(request).pipeline);
    if (std::ranges::find(grains, grain) != grains.end()) return std::nullopt;
    std::string words;
    for (const Grain has : grains) words += (words.empty() ? "" : ", ") + std::string(wordOf(has));
    return Error{Trouble::Usage, nameOf(request.pipeline) + " has no steps of grain '" + std::string(wordOf(grain)) +
                                     "'; its grains are " + words};
}

/// Runs until `probe` stops it; tells whether it did.
template <class Probe>
bool runUntilStopped(const DrawRequest& request, Frame& frame, StripeScratch& scratch, const Probe& probe)
{
    try {
        HWY_STATIC_DISPATCH(runSerially)(request, frame, scratch, probe);
        return false;
    } catch (const RunStopped&) {
        return true;
    }
}

Error noSuchStep(Grain grain, StepIndex step, std::uint64_t count)
{
    return {Trouble::Usage, "there is no step " + std::to_string(step.value) + ": the last of grain '" +
                                std::string(wordOf(grain)) + "' is " + std::to_string(count - 1)};
}
Error outOfMemory() { return {Trouble::Limit, "there is not enough memory to step through this frame"}; }
Error wasCancelled() { return {Trouble::Cancelled, "stepping was cancelled"}; }

}  // namespace

Replay::Replay(DrawRequest request) : m_request(std::move(request)) {}

Result<std::uint64_t> Replay::count(Grain grain)
{
    std::optional<Length>& known = m_lengths[static_cast<std::size_t>(grain)];
    if (known) return known->steps;
    if (const auto plan = planFrame(m_request); !plan) return plan.error();
    if (const auto error = cannotStep(m_request, grain)) return *error;
    try {
        Frame         frame;
        StripeScratch scratch;
        StopAt        steps(grain);
        StageRecorder stages(grain);
        runUntilStopped(m_request, frame, scratch, Listening(stages, steps));
        if (m_request.cancel && m_request.cancel->load()) return wasCancelled();
        known = Length{steps.seen(), stages.take()};
        return known->steps;
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

Result<std::vector<StageMark>> Replay::stages(Grain grain)
{
    if (const auto steps = count(grain); !steps) return steps.error();
    return m_lengths[static_cast<std::size_t>(grain)]->stages;
}

Result<std::uint64_t> Replay::eventsBy(Grain other, Grain grain, StepIndex step)
{
    const Result<std::uint64_t> steps = count(grain);
    if (!steps) return steps.error();
    if (step.value >= *steps) return noSuchStep(grain, step, *steps);
    if (const auto error = cannotStep(m_request, other)) return *error;
    try {
        Frame         frame;
        StripeScratch scratch;
        StopAt        heard(other);
        StopAt        stop(grain, step.value);
        runUntilStopped(m_request, frame, scratch, Listening(heard, stop));
        if (m_request.cancel && m_request.cancel->load()) return wasCancelled();
        return heard.seen();
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

Result<StepState> Replay::at(Grain grain, StepIndex step)
{
    const Result<std::uint64_t> steps = count(grain);
    if (!steps) return steps.error();
    if (step.value >= *steps) return noSuchStep(grain, step, *steps);
    try {
        StepState        state;
        StripeScratch    scratch;
        SweepRecorder    sweep;
        TriangleRecorder triangle;
        PixelRecorder    pixel;
        IntervalRecorder interval;
        HierarchyRecorder hierarchy;
        MomentRecorder   moment;
        TestCounter      tests(m_request.camera.width, m_request.camera.height);
        StopAt           stop(grain, step.value);
        runUntilStopped(m_request, state.frame, scratch, Listening(sweep, interval, hierarchy, triangle, pixel, tests, moment, stop));
        if (m_request.cancel && m_request.cancel->load()) return wasCancelled();
        if (state.frame.colour.height() == 0) HWY_STATIC_DISPATCH(shadeWhole)(m_request, state.frame);

        state.algorithm = nameOf(m_request.pipeline);
        state.grain     = grain;
        state.step      = step;
        state.count     = *steps;
        state.event     = stop.lastGrain();
        state.stage     = moment.stage();
        state.sweep     = sweep.state();
        const Pipeline pipeline = repeatable(m_request).pipeline;
        const bool hasCells = pipeline.upkeep != Upkeep::None || pipeline.depth == DepthMoment::ZCull;
        state.hierarchy = hierarchy.state(m_request.camera.width, m_request.camera.height, hasCells);
        if (state.hierarchy && pipeline.order != Order::Submitted)
            state.hierarchy->tree = pipeline.order == Order::Octree ? TreeKind::Octree : TreeKind::Bvh;
        if (state.hierarchy && hasCells) state.hierarchy->cells = cellsOf(scratch.pyramid);
        state.tests     = tests.take();
        state.triangle  = triangle.state();
        state.span      = pixel.span();
        state.interval  = interval.state();
        if (moment.moment() == MomentRecorder::Moment::PixelOver) state.pixel = pixel.pixel();
        if (moment.moment() == MomentRecorder::Moment::TileOver) state.tile = pixel.tile();
        state.blend     = moment.blend();
        state.sentence  = sentenceFor(state, pipeline, moment.moment(), m_request.scene->scene().triangleCount());
        if (m_request.pipeline.chooser == Chooser::Measured)
            state.sentence += " (auto has measured nothing here: its steps are those of " + nameOf(pipeline) + ", its first choice.)";
        return state;
    } catch (const std::bad_alloc&) {
        return outOfMemory();
    }
}

}  // namespace zscope
