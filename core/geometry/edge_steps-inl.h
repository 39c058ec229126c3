// How the value of an edge grows from pixel to pixel: two differences in the halves of one lane, and what a way over some pixels adds up to.
//
// Steps      from a pixel to the next in the lower half of a lane, to the one below in the upper, each of 16 bits: what compact triangles have
//            (core/geometry/triangle_list.h)
// Way        so many pixels to the right in the lower half, so many lines down in the upper. Both products and their sum are one instruction, in
//            every instruction set
// Promise    exact: integers
#if defined(ZSCOPE_EDGE_STEPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_EDGE_STEPS_INL_H
#undef ZSCOPE_EDGE_STEPS_INL_H
#else
#define ZSCOPE_EDGE_STEPS_INL_H
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A way, or steps that are known beforehand; each part fits in 16 bits.
constexpr std::int32_t pixelsAndLines(int pixels, int lines)
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(lines) << 16 | (static_cast<std::uint32_t>(pixels) & 0xFFFF));
}

/// The same, lane by lane.
template <class V>
HWY_INLINE V stepsOf(V perPixel, V perLine)
{
    return hn::Or(hn::ShiftLeft<16>(perLine), hn::And(perPixel, hn::Set(hn::DFromV<V>(), 0xFFFF)));
}

#if HWY_TARGET == HWY_SCALAR
inline std::int32_t lowerStep(std::int32_t both) { return static_cast<std::int16_t>(both); }
inline std::int32_t upperStep(std::int32_t both) { return both >> 16; }
#endif

/// By how much an edge grows over `way`.
template <class V>
HWY_INLINE V growth(V steps, V way)
{
    const hn::DFromV<V> d;
#if HWY_TARGET == HWY_SCALAR
    const std::int32_t s = hn::GetLane(steps), w = hn::GetLane(way);
    return hn::Set(d, lowerStep(s) * lowerStep(w) + upperStep(s) * upperStep(w));
#else
    const hn::Repartition<std::int16_t, decltype(d)> i16;
    auto       rest = hn::Zero(d);
    const auto sums = hn::ReorderWidenMulAccumulate(d, hn::BitCast(i16, steps), hn::BitCast(i16, way), hn::Zero(d), rest);
    return hn::RearrangeToOddPlusEven(sums, rest);
#endif
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
    const hn::DFromV<V> d;
#if HWY_TARGET == HWY_SCALAR
    const std::int32_t s = hn::GetLane(steps);
    return hn::Set(d, pixelsAndLines(HWY_MAX(lowerStep(s), 0), HWY_MAX(upperStep(s), 0)));
#else
    const hn::Repartition<std::int16_t, decltype(d)> i16;
    return hn::BitCast(d, hn::Max(hn::BitCast(i16, steps), hn::Zero(i16)));
#endif
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_EDGE_STEPS_INL_H
