// The same drivers by chosen rules: approximations and faults, at the speed of lanes too, so that what an approximation
// gains is measured on equal terms.
#include "core/frame/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/frame/chosen_kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file once per target

#include "core/frame/drivers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

void drawStripeByChosenRules(const Pipeline& pipeline, const ChosenRules& rules, const Stripe& stripe,
                             StripeScratch& scratch, StageClock& clock)
{
    drawStripe(pipeline, stripe, scratch, clock, rules);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace zscope {

DrawStripeByRules drawStripeByRulesOf(Simd target)
{
    switch (target) {
#if HWY_TARGETS & HWY_AVX3
        case Simd::Avx512:
            return N_AVX3::drawStripeByChosenRules;
#endif
#if HWY_TARGETS & HWY_AVX2
        case Simd::Avx2:
            return N_AVX2::drawStripeByChosenRules;
#endif
#if HWY_TARGETS & HWY_SSE4
        case Simd::Sse4:
            return N_SSE4::drawStripeByChosenRules;
#endif
        default:
            return N_SCALAR::drawStripeByChosenRules;
    }
}

}  // namespace zscope

#endif  // HWY_ONCE
