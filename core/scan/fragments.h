// What the depth test does with a fragment besides testing it: nothing, or shading it before or after the test.
//
// Free       kFree: a fragment has its triangle's colour, which is stored where it wins; others cost operations
// Interface  shade(u32, wanted, won, x, y): of the pixels x, x + 1, ... of line y those in `wanted` are shaded, and
//            those in `won` get their colours. If kPatterned: discarded(d64, x, y): those that do not exist; moves():
//            whether depth is changed; moved(d64, depth, x, y): what it becomes, which is never nearer
//            (core/scan/pattern-inl.h)
// Written    where shading is known (core/shade/fragment-inl.h); scan conversion only says when
#pragma once

namespace zscope {

enum class ShadingMoment {
    Never,       // the picture is shaded when it is finished, or not at all
    BeforeTest,  // every covered fragment, whether it will be seen or not
    AfterTest,   // those that passed the test
};

struct UnshadedFragments {
    static constexpr ShadingMoment kMoment    = ShadingMoment::Never;
    static constexpr bool          kPatterned = false;
    static constexpr bool          kFree      = false;
};

}  // namespace zscope
