#include "core/fast/kernels.h"

#include <array>

#include "core/base/simd.h"

#ifndef ZSCOPE_PLAIN

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/fast/kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file once per target

#include "core/fast/drivers-inl.h"
#include "core/fast/lanes/blend-inl.h"
#include "core/fast/lanes/shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

const Kernels& kernels()
{
    static constexpr Kernels kKernels{drawStripe, storePlanes, shadeRows, blendStripe};
    return kKernels;
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <hwy/targets.h>

namespace zscope {

namespace {

/// A target is available if this file was compiled for it and the machine has it.
constexpr bool isCompiled(std::int64_t target) { return (HWY_TARGETS & target) != 0; }
bool isAvailable(std::int64_t target) { return isCompiled(target) && (hwy::SupportedTargets() & target) != 0; }

}  // namespace

const Kernels* kernelsOf(Simd target)
{
    switch (target) {
#if HWY_TARGETS & HWY_AVX3
        case Simd::Avx512:
            return &N_AVX3::kernels();
#endif
#if HWY_TARGETS & HWY_AVX2
        case Simd::Avx2:
            return &N_AVX2::kernels();
#endif
#if HWY_TARGETS & HWY_SSE4
        case Simd::Sse4:
            return &N_SSE4::kernels();
#endif
        default:
            return nullptr;
    }
}

std::span<const SimdEntry> simdTargets()
{
    static const std::array<SimdEntry, 4> kTargets{
        SimdEntry{Simd::Scalar, "scalar", "one lane: the plain text, as with --shortcuts none", true},
        SimdEntry{Simd::Sse4, "sse4", "SSE 4.1: 2 lanes of float64", isAvailable(HWY_SSE4)},
        SimdEntry{Simd::Avx2, "avx2", "AVX2: 4 lanes of float64", isAvailable(HWY_AVX2)},
        SimdEntry{Simd::Avx512, "avx512", "AVX-512: 8 lanes of float64", isAvailable(HWY_AVX3)}};
    return kTargets;
}

}  // namespace zscope

#endif  // HWY_ONCE

#else  // plain text only

namespace zscope {

const Kernels* kernelsOf(Simd) { return nullptr; }

std::span<const SimdEntry> simdTargets()
{
    static constexpr std::array<SimdEntry, 1> kTargets{
        SimdEntry{Simd::Scalar, "scalar", "one lane: the plain text, as with --shortcuts none", true}};
    return kTargets;
}

}  // namespace zscope

#endif  // ZSCOPE_PLAIN
