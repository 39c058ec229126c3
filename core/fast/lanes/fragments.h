// What the depth test does with a fragment besides testing it: nothing, or shading it before or after the test.
//
// Free       kFree: a fragment has its triangle's colour, which is stored where it wins; others cost operations
// Interface  shade(u32, wanted, won, x, y): of the pixels x, x + 1, ... of line y those in `wanted` are shaded, and
//            those in `won` get their colours; shadeAll(box): all pixels of it are won. If kPatterned:
//            discarded(d64, x, y): those that do not exist; moves(): whether depth is changed; moved(d64, depth, x, y):
//            what it becomes, which is never nearer (pattern-inl.h)
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
