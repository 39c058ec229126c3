// What the recorders of a run hold after its last step, as a lesson shows it; the picture and the words apart.
#pragma once

#include "core/lesson/checkpoints.h"
#include "core/lesson/step_state.h"

namespace zscope {

/// `last`: the kind of the last step. `pyramid`: nullptr leaves out what its cells hold.
StepState stateOf(const RunRecorders& recorders, const EventKind* last, const DrawRequest& request,
                  const Pyramid* pyramid);

}  // namespace zscope
