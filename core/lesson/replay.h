// Stepping forwards and backwards: the state after step k is made by running the algorithm again from an empty
// frame and stopping right after event k. Nothing is logged, so nothing can drift from what is drawn.
//
// Steps      counted from 0 within a grain; state K is the state right after event K of the grain or a coarser one;
//            K = count - 1 is the finished picture
// Promise    the state at K is the same however K was reached; the picture at count - 1 is the one draw() makes
// Cost       one serial one-lane run up to the event
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/lesson/step_state.h"

namespace zscope {

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

class Replay {
public:
    explicit Replay(DrawRequest request);

    const DrawRequest& request() const { return m_request; }

    /// Number of steps at a grain; counted once. Errors: Usage if the algorithm has no such grain, Cancelled.
    Result<std::uint64_t> count(Grain grain);
    /// In the order of the run; found with the number of steps. A stage without a step of this grain is left out. Errors as
    /// count().
    Result<std::vector<StageMark>> stages(Grain grain);
    /// Errors: Usage (no such grain, step beyond the last), Limit, Cancelled.
    Result<StepState> at(Grain grain, StepIndex step);
    /// How many events of grain `other` or a coarser one have happened in the state at (grain, step): the way from a
    /// step of one grain to the same moment in another. Errors as at().
    Result<std::uint64_t> eventsBy(Grain other, Grain grain, StepIndex step);

private:
    struct Length {
        std::uint64_t          steps = 0;
        std::vector<StageMark> stages;
    };

    DrawRequest                                       m_request;
    std::array<std::optional<Length>, kGrains.size()> m_lengths{};
};

}  // namespace zscope
