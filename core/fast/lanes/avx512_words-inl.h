// Three instructions of AVX-512 that Highway 1.0.3 has no word for, and so the one file of the kernels with a
// processor's own names in it.
//
// Promise    joined vectors hold the numbers that were given, none is computed; the comparisons are exact
// Cost       one instruction each, where joining takes two, joining and then ordering three, and comparing and then
//            combining two (docs/performance.md)
#if defined(ZSCOPE_AVX512_WORDS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_AVX512_WORDS_INL_H
#undef ZSCOPE_AVX512_WORDS_INL_H
#else
#define ZSCOPE_AVX512_WORDS_INL_H
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3
/// Two halves of a vector.
HWY_INLINE hwy::HWY_NAMESPACE::Vec512<float> joined(hwy::HWY_NAMESPACE::Vec256<float> lower,
                                                    hwy::HWY_NAMESPACE::Vec256<float> upper)
{
    return {_mm512_insertf32x8(_mm512_castps256_ps512(lower.raw), upper.raw, 1)};
}

/// Two halves of a vector as one whose lanes stand in any order: lane i is lane places[i] of `lower`, or lane places[i]
/// - 16 of `upper`. `places`: 16 of them, on a border of 64 bytes, none from 8 to 15 or from 24 to 31.
HWY_INLINE hwy::HWY_NAMESPACE::Vec512<float> joinedLanes(hwy::HWY_NAMESPACE::Vec256<float> lower,
                                                         hwy::HWY_NAMESPACE::Vec256<float> upper,
                                                         const std::int32_t*               places)
{
    return {_mm512_permutex2var_ps(_mm512_castps256_ps512(lower.raw), _mm512_load_si512(places),
                                   _mm512_castps256_ps512(upper.raw))};
}

/// The lanes in which a <= b; and those of `among`.
HWY_INLINE hwy::HWY_NAMESPACE::Mask512<std::int32_t> atMost(hwy::HWY_NAMESPACE::Vec512<std::int32_t> a,
                                                            hwy::HWY_NAMESPACE::Vec512<std::int32_t> b)
{
    return {_mm512_cmp_epi32_mask(a.raw, b.raw, _MM_CMPINT_LE)};
}
HWY_INLINE hwy::HWY_NAMESPACE::Mask512<std::int32_t> atMost(hwy::HWY_NAMESPACE::Mask512<std::int32_t> among,
                                                            hwy::HWY_NAMESPACE::Vec512<std::int32_t>  a,
                                                            hwy::HWY_NAMESPACE::Vec512<std::int32_t>  b)
{
    return {_mm512_mask_cmp_epi32_mask(among.raw, a.raw, b.raw, _MM_CMPINT_LE)};
}
#endif

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_AVX512_WORDS_INL_H
