// The drivers of the engine with their probe statements taken out of the text, to compare NoProbe with.
#pragma once

#include "core/base/stage_clock.h"
#include "core/frame/pipeline.h"
#include "core/traverse/stripe.h"

namespace zscope::bench {

/// What Kernels::drawStripe of the widest available target does, compiled without a single probe statement (those of
/// the tree walk excepted: one or two per node).
void drawStripeWithoutProbes(const Pipeline& pipeline, const Stripe& stripe, StripeScratch& scratch, StageClock& clock);

}  // namespace zscope::bench
