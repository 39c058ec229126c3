// Stepping: the frame again, by plain text, stopped right after the wanted event.
#include "core/lesson/replay.h"

#include <algorithm>
#include <memory>
#include <new>
#include <utility>

#include "core/frame/frame_plan.h"
#include "core/frame/observed_run.h"
#include "core/lesson/checkpoints.h"
#include "core/lesson/recorders.h"
#include "core/lesson/run_state.h"
#include "core/lesson/run_telling.h"

namespace zscope {

namespace {

/// A stage begins; so many steps of each grain have happened.
struct StageBegin {
    Stage       stage;
    StepCounter before;
};

/// Notes where the stages begin; hears every event after the counter of steps.
class StageRecorder {
public:
    using Events = Wants<StageStarted>;

    explicit StageRecorder(const StepCounter& steps) : m_steps(steps) {}

    void observe(const StageStarted& e) { m_begun.push_back({e.stage, m_steps}); }

    std::vector<StageBegin> take() { return std::move(m_begun); }

private:
    const StepCounter&      m_steps;
    std::vector<StageBegin> m_begun;
};

std::optional<Error> cannotStep(const DrawRequest& request, Grain grain)
{
    const std::vector<Grain> grains = grainsOf(repeatable(request).pipeline);
    if (std::ranges::find(grains, grain) != grains.end()) return std::nullopt;
    std::string words;
    for (const Grain has : grains) words += (words.empty() ? "" : ", ") + std::string(wordOf(has));
    return Error{Trouble::Usage, nameOf(request.pipeline) + " has no steps of grain '" + std::string(wordOf(grain))
                                     + "'; its grains are " + words};
}

Error noSuchStep(Grain grain, StepIndex step, std::uint64_t count)
{
    return {Trouble::Usage, "there is no step " + std::to_string(step.value) + ": the last of grain '"
                                + std::string(wordOf(grain)) + "' is " + std::to_string(count - 1)};
}
Error tooLittleToStep() { return {Trouble::Limit, "there is not enough memory to step through this frame"}; }
Error steppingWasCancelled() { return {Trouble::Cancelled, "stepping was cancelled"}; }

/// One run with everything that observes it. It stays where it is: its parts know each other.
class Run final : public Observer {
public:
    /// Up to a step, in memory that outlives it.
    Run(const DrawRequest& request, Grain grain, std::uint64_t step, plain::Scratch& memory)
        : recorders(request.camera.width, request.camera.height), stages(recorders.steps),
          telling(request, frame, recorders.triangle), stop(grain, step, &telling), scratch(memory),
          keeper({recorders, frame, scratch, stop, grain}, drawsBatchByBatch(repeatable(request).pipeline))
    {
        scratch.pyramid = {};  // what coherence would take over
        scratch.memory  = {};
    }
    Run(const Run&)            = delete;
    Run& operator=(const Run&) = delete;

    void perform(const DrawRequest& request, const ObservedMethod* method)
    {
        try {
            drawObserved(method, request, frame, scratch, *this);
        } catch (const RunStopped&) {}
    }

    void hear(const Heard& heard) override
    {
        if (keeper.isOnTheWay()) return;
        keeper.hear(heard);
        recorders.hear(heard);
        passOn(heard, stages);
        stop.hear(heard);
    }
    bool               isOnTheWay() const override { return keeper.isOnTheWay(); }
    bool               leavesOut(Checkpoint at) override { return keeper.passesBy(at); }
    std::optional<int> knownVerdict() override
    {
        return keeper.isOnTheWay() ? std::optional(static_cast<int>(keeper.knownVerdict())) : std::nullopt;
    }

    RunRecorders     recorders;
    StageRecorder    stages;
    Frame            frame;
    RunTelling       telling;
    StopAt           stop;
    plain::Scratch&  scratch;
    CheckpointKeeper keeper;
};

}  // namespace

/// What the run from end to end found, what it left to those that begin at its checkpoints, and the last of those.
struct Replay::Survey {
    StepCounter             steps;  // of the whole run
    std::vector<StageBegin> stages;
    Checkpoints             checkpoints;
    plain::Scratch          scratch;  // with the edge table that the checkpoints go on with
    // of runs that fill an edge table themselves: they stop before the first checkpoint
    plain::Scratch       before;
    std::unique_ptr<Run> latest;  // stopped after a step

    /// Whether `latest` stands right after this step.
    bool standsAt(Grain grain, StepIndex step) const
    {
        return latest && latest->stop.lastGrain() <= grain && latest->recorders.steps.seen(grain) == step.value + 1;
    }
};

Replay::Replay(DrawRequest request, CheckpointSpacing spacing, const ObservedMethod* method)
    : m_request(std::move(request)), m_spacing(spacing), m_method(method)
{}
Replay::Replay(Replay&&) noexcept            = default;
Replay& Replay::operator=(Replay&&) noexcept = default;
Replay::~Replay()                            = default;

bool Replay::isCancelled() const { return m_request.cancel && m_request.cancel->load(); }

std::optional<Error> Replay::survey(Grain grain)
{
    if (const auto error = cannotStep(m_request, grain)) return error;
    if (m_survey) return std::nullopt;
    if (const auto plan = planFrame(m_request); !plan) return plan.error();
    auto survey = std::make_unique<Survey>();
    Run  run(m_request, Grain::Frame, StopAt::kNever, survey->scratch);
    run.keeper.keepIn(survey->checkpoints, m_spacing.events, m_spacing.bytes);
    run.perform(m_request, m_method);
    if (isCancelled()) return steppingWasCancelled();
    survey->steps  = run.recorders.steps;
    survey->stages = run.stages.take();
    m_survey       = std::move(survey);
    return std::nullopt;
}

std::optional<Error> Replay::runTo(Grain grain, StepIndex step)
{
    if (auto error = survey(grain)) return error;
    if (const std::uint64_t count = m_survey->steps.seen(grain); step.value >= count)
        return noSuchStep(grain, step, count);
    if (m_survey->standsAt(grain, step)) return std::nullopt;

    const KeptState* from = m_survey->checkpoints.lastBefore(grain, step.value);
    m_survey->latest.reset();
    auto run = std::make_unique<Run>(m_request, grain, step.value, from ? m_survey->scratch : m_survey->before);
    if (from) run->keeper.beginAt(*from, m_survey->checkpoints);
    run->perform(m_request, m_method);
    if (isCancelled()) return steppingWasCancelled();
    if (run->frame.colour.height() == 0) shadePicture(m_request, run->frame);
    m_survey->latest = std::move(run);
    return std::nullopt;
}

Result<std::uint64_t> Replay::count(Grain grain)
{
    try {
        if (const auto error = survey(grain)) return *error;
        return m_survey->steps.seen(grain);
    } catch (const std::bad_alloc&) {
        return tooLittleToStep();
    }
}

Result<std::vector<StageMark>> Replay::stages(Grain grain)
{
    const Result<std::uint64_t> count = this->count(grain);
    if (!count) return count.error();
    std::vector<StageMark> marks;
    for (std::size_t i = 0; i < m_survey->stages.size(); ++i) {
        const std::uint64_t first = m_survey->stages[i].before.seen(grain);
        const std::uint64_t end = i + 1 < m_survey->stages.size() ? m_survey->stages[i + 1].before.seen(grain) : *count;
        if (first < end) marks.push_back({m_survey->stages[i].stage, first});
    }
    return marks;
}

std::size_t Replay::checkpoints() const { return m_survey->checkpoints.kept.size(); }

Result<std::uint64_t> Replay::eventsBy(Grain other, Grain grain, StepIndex step)
{
    try {
        if (const auto error = runTo(grain, step)) return *error;
        if (const auto error = cannotStep(m_request, other)) return *error;
        return m_survey->latest->recorders.steps.seen(other);
    } catch (const std::bad_alloc&) {
        return tooLittleToStep();
    }
}

Result<StepState> Replay::at(Grain grain, StepIndex step)
{
    try {
        if (const auto error = runTo(grain, step)) return *error;
        const Run&          run       = *m_survey->latest;
        const RunRecorders& recorders = run.recorders;
        const Pipeline      pipeline  = repeatable(m_request).pipeline;

        StepState state = stateOf(recorders, run.stop.last(), m_request, &run.scratch.pyramid);
        state.frame     = run.frame;
        state.grain     = grain;
        state.step      = step;
        state.count     = m_survey->steps.seen(grain);
        state.event     = run.stop.lastGrain();
        state.method    = run.stop.method();
        state.part      = run.stop.part();
        state.tests     = recorders.tests.tests();
        state.sentence  = run.stop.sentence();
        if (m_request.pipeline.chooser == Chooser::Measured)
            state.sentence +=
                " (auto has measured nothing here: its steps are those of " + nameOf(pipeline) + ", its first choice.)";
        return state;
    } catch (const std::bad_alloc&) {
        return tooLittleToStep();
    }
}

}  // namespace zscope
