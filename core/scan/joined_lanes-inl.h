// Two halves of a vector become one whose lanes stand in any order: the one thing of the kernels that Highway 1.0.3 has no word for, and so the one
// file with an instruction of a processor in it.
//
// Promise    lane i is lane places[i] of `lower` if that is below 16, else lane places[i] - 16 of `upper`: moves numbers and computes none
// Cost       one instruction of AVX-512, where joining and then ordering takes three (docs/performance.md)
#if defined(ZSCOPE_JOINED_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_JOINED_LANES_INL_H
#undef ZSCOPE_JOINED_LANES_INL_H
#else
#define ZSCOPE_JOINED_LANES_INL_H
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3
/// `places`: 16 of them, on a border of 64 bytes; none names one of the eight lanes that neither half has (8 to 15, 24 to 31).
HWY_INLINE hwy::HWY_NAMESPACE::Vec512<float> joinedLanes(hwy::HWY_NAMESPACE::Vec256<float> lower, hwy::HWY_NAMESPACE::Vec256<float> upper, const std::int32_t* places)
{
    return {_mm512_permutex2var_ps(_mm512_castps256_ps512(lower.raw), _mm512_load_si512(places), _mm512_castps256_ps512(upper.raw))};
}
#endif

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_JOINED_LANES_INL_H
