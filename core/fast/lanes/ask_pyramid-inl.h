// A question to the pyramid, by the rules: of a wide one in lanes, of the others cell by cell.
#if defined(ZSCOPE_ASK_PYRAMID_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_ASK_PYRAMID_INL_H
#undef ZSCOPE_ASK_PYRAMID_INL_H
#else
#define ZSCOPE_ASK_PYRAMID_INL_H
#endif

#include "core/cull/occlusion.h"
#include "core/fast/two_level_pyramid/wide_pyramid-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// Of a wide pyramid the answer says nothing but whether the box, or the shape inside it, is hidden.
template <class Shape>
PyramidQuery askPyramid(Pyramid& pyramid, const PixelBox& box, double nearest, const Shape& shape,
                        const LaneRules& rules)
{
    if (pyramid.isWide()) return {.box = box, .hidden = WidePyramid(pyramid).hides(box, rules.stored(nearest), shape)};
    return pyramid.ask(box, rules.stored(nearest), shape, Untold{});
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_ASK_PYRAMID_INL_H
