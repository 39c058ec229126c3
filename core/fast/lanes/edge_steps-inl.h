// How the value of an edge grows from pixel to pixel: two differences in the halves of one lane, and what a way over
// some pixels adds up to.
//
// Steps      from a pixel to the next in the lower half of a lane, to the one below in the upper, each of 16 bits: what
//            compact triangles have (core/geometry/triangle_list.h)
// Way        so many pixels to the right in the lower half, so many lines down in the upper
//            (core/geometry/pixel_way.h). Both products and their sum are one instruction, in every instruction set
// Promise    exact: integers
#if defined(ZSCOPE_EDGE_STEPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_EDGE_STEPS_INL_H
#undef ZSCOPE_EDGE_STEPS_INL_H
#else
#define ZSCOPE_EDGE_STEPS_INL_H
#endif

#include <cstdint>

#include <hwy/highway.h>

#include "core/geometry/pixel_way.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A way or steps, lane by lane: of each part the lower 16 bits.
template <class V>
HWY_INLINE V inHalves(V lower, V upper)
{
    return hn::Or(hn::ShiftLeft<16>(upper), hn::And(lower, hn::Set(hn::DFromV<V>(), 0xFFFF)));
}
template <class V>
HWY_INLINE V lowerHalf(V both)
{
    return hn::ShiftRight<16>(hn::ShiftLeft<16>(both));
}
template <class V>
HWY_INLINE V upperHalf(V both)
{
    return hn::ShiftRight<16>(both);
}

template <class V>
using Halves = hn::Repartition<std::int16_t, hn::DFromV<V>>;
template <class V>
HWY_INLINE V minusHalves(V a, V b)
{
    return hn::BitCast(hn::DFromV<V>(), hn::BitCast(Halves<V>(), a) - hn::BitCast(Halves<V>(), b));
}
template <class V>
HWY_INLINE V leastHalves(V a, V b)
{
    return hn::BitCast(hn::DFromV<V>(), hn::Min(hn::BitCast(Halves<V>(), a), hn::BitCast(Halves<V>(), b)));
}
template <class V>
HWY_INLINE V mostHalves(V a, V b)
{
    return hn::BitCast(hn::DFromV<V>(), hn::Max(hn::BitCast(Halves<V>(), a), hn::BitCast(Halves<V>(), b)));
}

/// a + b, half by half.
template <class V>
HWY_INLINE V plusHalves(V a, V b)
{
    return hn::BitCast(hn::DFromV<V>(), hn::BitCast(Halves<V>(), a) + hn::BitCast(Halves<V>(), b));
}

/// The steps of the edge that runs that way: it grows to the right by as much as it falls, down by as much as it runs
/// to the right.
template <class V>
HWY_INLINE V acrossEdge(V way)
{
    const hn::DFromV<V> d;
    // The lower half's complement, and one more.
    const auto lower = hn::Set(d, 0xFFFF);
    return minusHalves(
        hn::Xor(hn::BitCast(d, hn::RotateRight<16>(hn::BitCast(hn::RebindToUnsigned<decltype(d)>(), way))), lower),
        lower);
}

/// By how much an edge grows over `way`.
template <class V>
HWY_INLINE V growth(V steps, V way)
{
    const hn::DFromV<V>                              d;
    const hn::Repartition<std::int16_t, decltype(d)> i16;
    auto                                             rest = hn::Zero(d);
    const auto                                       sums =
        hn::ReorderWidenMulAccumulate(d, hn::BitCast(i16, steps), hn::BitCast(i16, way), hn::Zero(d), rest);
    return hn::RearrangeToOddPlusEven(sums, rest);
}
template <class V>
HWY_INLINE V growth(V steps, int pixels, int lines)
{
    return growth(steps, hn::Set(hn::DFromV<V>(), pixelsAndLines(pixels, lines)));
}

/// Those of the steps that are above 0, 0 in place of the others.
template <class V>
HWY_INLINE V upwards(V steps)
{
    const hn::DFromV<V>                              d;
    const hn::Repartition<std::int16_t, decltype(d)> i16;
    return hn::BitCast(d, hn::Max(hn::BitCast(i16, steps), hn::Zero(i16)));
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_EDGE_STEPS_INL_H
