// Everything that is compiled once per instruction set, behind plain function pointers.
//
// Stripe     drawStripe() may leave tiles as planes (core/depth/visibility_buffer.h); storePlanes() is for whoever
//            reads pixels next, shadeRows() knows of them unless shading has a cost
// Promise    every target gives the same bits; they differ in how many pixels or vertices they work on side by side
#pragma once

#include "core/base/blend_order.h"
#include "core/base/simd.h"
#include "core/fast/stripe_scratch.h"
#include "core/frame/pipeline.h"
#include "core/geometry/transparent_surfaces.h"
#include "core/shade/painter.h"

namespace zscope {

struct Kernels {
    void (*drawStripe)(const Pipeline&, const LaneRules&, const Stripe&, StripeScratch&, StageClock&);
    void (*storePlanes)(VisibilityBuffer&, int firstRow, int endRow);
    void (*shadeRows)(const Painter&, const VisibilityBuffer&, int firstRow, int endRow);
    /// Blends the stripe's transparent surfaces over the picture, which holds the opaque colours.
    void (*blendStripe)(const TransparentSurfaces&, const ColourTable&, BlendOrder, const LaneRules&, const Stripe&,
                        StripeScratch&, StageClock&, GridView<std::uint32_t> colour);
};

/// The kernels of an available target (not Simd::Auto); nullptr of one lane, which is the plain text's.
const Kernels* kernelsOf(Simd target);

}  // namespace zscope
