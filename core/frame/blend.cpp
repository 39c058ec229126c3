// The transparent pass at full speed. One lane: it is bound by sorting, and the bits would be the same with more.
#define HWY_COMPILE_ONLY_SCALAR

#include "core/frame/blend.h"

#include "core/frame/blend-inl.h"

namespace zscope {

void blendStripe(const TransparentSurfaces& surfaces, const ColourTable& colours, BlendOrder order,
                 const LaneRules& rules, const Stripe& stripe, StripeScratch& scratch, StageClock& clock,
                 GridView<std::uint32_t> colour)
{
    HWY_STATIC_DISPATCH(blendStripe)(surfaces, colours, order, rules, stripe, scratch, clock, colour);
}

}  // namespace zscope
