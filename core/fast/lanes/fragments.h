// What the depth test does with a fragment besides testing it: nothing, or shading it before or after the test.
//
// Free       kFree: a fragment has its triangle's colour, which is stored where it wins; others cost operations
// Interface  shade(u32, wanted, won, x, y): the lanes are pixels x, x + 1, ... of line y; those in `wanted` are shaded,
//            those in `won` store their colours
//            shadeAll(box): the triangle has won all pixels of the box
//            discarded(d64, x, y), if kPatterned: the lanes where the pattern has a hole
//            moves(), moved(d64, depth, x, y), likewise: whether the pattern changes depths, and the depths that come
//            out, never nearer (pattern-inl.h)
// Written    where shading is known (fragment-inl.h); scan conversion only says when
#pragma once

#include "core/scan/shading_moment.h"

namespace zscope {

struct UnshadedFragments {
    static constexpr ShadingMoment kMoment    = ShadingMoment::Never;
    static constexpr bool          kPatterned = false;
    static constexpr bool          kFree      = false;
};

}  // namespace zscope
