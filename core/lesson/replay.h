// Stepping forwards and backwards: the state after step k is made by running the algorithm again and stopping right
// after event k. Nothing that happened is logged, so nothing can drift from what is drawn.
//
// Steps      counted from 0 within a grain; state K is the state right after event K of the grain or a coarser one;
//            K = count - 1 is the finished picture
// Promise    the state at K is the same however K was reached; the picture at count - 1 is the one draw() makes
// Cost       the first question of all: one run of plain text, which counts the steps of every grain and keeps copies
//            of the structures at checkpoints. Then a run from the last checkpoint before the event
//            (core/lesson/checkpoints.h)
// Memory     at most CheckpointSpacing::bytes of copies, and the edge table of sweep methods: one for the steps before
//            the first checkpoint, one for those after it
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/lesson/step_state.h"

namespace zscope {

struct ObservedMethod;  // core/frame/observed_run.h

/// Whether the JSON of a step holds the value of every stored cell of the pyramid, or only the sizes of its levels.
enum class PyramidCells { Left, Written };
/// The JSON of `zscope-cli step --state`.
std::string stateToJson(const StepState& state, PyramidCells cells = PyramidCells::Left);

/// Where a stage begins in a timeline: its steps go on to the next one's first, or to the end.
struct StageMark {
    Stage         stage = Stage::Other;
    std::uint64_t first = 0;  // the first step whose state lies in it

    friend bool operator==(const StageMark&, const StageMark&) = default;
};

/// How far apart the checkpoints of a run are kept.
struct CheckpointSpacing {
    std::uint64_t events = 500'000;  // heard by the recorders: 10 to 40 ms of a run
    // of all of them; where they are more, the checkpoints are farther apart
    std::size_t bytes = std::size_t{256} << 20;
};

class Replay {
public:
    /// `method` is stepped through in place of the pipeline's; it outlives this.
    explicit Replay(DrawRequest request, CheckpointSpacing spacing = {}, const ObservedMethod* method = nullptr);
    Replay(Replay&&) noexcept;
    Replay& operator=(Replay&&) noexcept;
    ~Replay();

    const DrawRequest& request() const { return m_request; }

    /// Number of steps at a grain. Errors: Usage if the algorithm has no such grain, Limit, Cancelled.
    Result<std::uint64_t> count(Grain grain);
    /// In the order of the run. A stage without a step of this grain is left out. Errors as count().
    Result<std::vector<StageMark>> stages(Grain grain);
    /// Errors: Usage (no such grain, step beyond the last), Limit, Cancelled.
    Result<StepState> at(Grain grain, StepIndex step);
    /// Those that the first question has left; it must have been answered.
    std::size_t checkpoints() const;
    /// How many events of grain `other` or a coarser one have happened in the state at (grain, step): the way from a
    /// step of one grain to the same moment in another. Errors as at().
    Result<std::uint64_t> eventsBy(Grain other, Grain grain, StepIndex step);

private:
    struct Survey;

    /// Makes sure of m_survey. Errors as count().
    std::optional<Error> survey(Grain grain);
    /// Makes sure that its last run stands at this step. Errors as at().
    std::optional<Error> runTo(Grain grain, StepIndex step);
    bool                 isCancelled() const;

    DrawRequest             m_request;
    CheckpointSpacing       m_spacing;
    const ObservedMethod*   m_method;
    std::unique_ptr<Survey> m_survey;  // nullptr: the run has not been seen from end to end
};

}  // namespace zscope
