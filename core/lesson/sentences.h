// One sentence per step, with live numbers and the rule that was applied.
#pragma once

#include <string>

#include "core/frame/pipeline.h"
#include "core/lesson/recorders.h"
#include "core/lesson/step_state.h"

namespace zscope {

/// What happened at `moment`, from the rest of the state.
std::string sentenceFor(const StepState& state, const Pipeline& pipeline, MomentRecorder::Moment moment,
                        std::uint64_t trianglesInScene);

}  // namespace zscope
