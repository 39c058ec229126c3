// The transparent pass of a frame that is not listened to (core/frame/blend-inl.h).
#pragma once

#include "core/base/blend_order.h"
#include "core/geometry/transparent_surfaces.h"
#include "core/shade/colour_table.h"
#include "core/traverse/stripe.h"

namespace zscope {

/// Blends the stripe's transparent surfaces over `colour`, which holds the opaque colours and has the picture's size.
void blendStripe(const TransparentSurfaces& surfaces, const ColourTable& colours, BlendOrder order,
                 const LaneRules& rules, const Stripe& stripe, StripeScratch& scratch, StageClock& clock,
                 GridView<std::uint32_t> colour);

}  // namespace zscope
