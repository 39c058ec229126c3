// Pixels in passes: as many at once as a vector has lanes of float32, though depths are found in float64 and keys have
// 64 bits.
//
// Lanes      are in the order in which halves of keys have to stand to be interleaved to whole ones, so that no lane
//            moves after that
// Used by    windows-inl.h, whose lines are kWindowSide pixels long, and part-inl.h, whose lines are those of a tile of
//            the pyramid
#if defined(ZSCOPE_PASS_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_PASS_LANES_INL_H
#undef ZSCOPE_PASS_LANES_INL_H
#else
#define ZSCOPE_PASS_LANES_INL_H
#endif

#include <array>
#include <cstdint>

#include "core/fast/lanes/avx512_words-inl.h"
#include "core/fast/lanes/depth_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// So many: as many edges and depths in float32 as there are lanes of it, and so two vectors each of float64 and of
/// keys.
inline constexpr int kLanes      = static_cast<int>(hn::MaxLanes(F64()));
inline constexpr int kPassPixels = 2 * kLanes;

using Pass32 = hn::Twice<F32>;
#if HWY_TARGET == HWY_AVX3
inline hn::Vec<Pass32> together(hn::Vec<F32> upper, hn::Vec<F32> lower) { return joined(lower, upper); }
#else
inline hn::Vec<Pass32> together(hn::Vec<F32> upper, hn::Vec<F32> lower) { return hn::Combine(Pass32(), upper, lower); }
#endif
HWY_INLINE std::array<Keys, 2> keysOf(hn::Vec<Pass32> uppers, hn::Vec<Pass32> lowers)
{
    return {hn::BitCast(I64(), hn::InterleaveLower(Pass32(), lowers, uppers)),
            hn::BitCast(I64(), hn::InterleaveUpper(Pass32(), lowers, uppers))};
}
/// Which pixel of its pass, line by line, a lane of float32 is. Interleaved with another vector, the first and second
/// lane of every four go to the first vector of keys, the third and fourth to the second; those two are the upper and
/// the lower half.
constexpr int pixelOfLane(int lane) { return lane % 4 / 2 * kLanes + lane / 4 * 2 + lane % 2; }

/// lowerHalf() of a triangle's fragments in every lane: the complement of its rank, or 0.
template <Keep kKeep>
HWY_INLINE hn::Vec<Pass32> lowerHalves(std::uint32_t notRank)
{
    return hn::BitCast(Pass32(), hn::Set(hn::RebindToUnsigned<Pass32>(), kKeep == Keep::DepthOnly ? 0 : notRank));
}

/// Which of these keys are those of covered pixels: the others hold a key that is smaller than any of a fragment.
template <bool kMayBeNegative>
HWY_INLINE hn::Mask<I64> areCovered(Keys offered)
{
    constexpr std::uint64_t kUncovered = kMayBeNegative ? 0x8000'0000'FFFF'FFFF : 0xFFFF'FFFF'FFFF'FFFF;
    return offered > hn::Set(I64(), static_cast<PixelKey>(kUncovered));
}

/// First lane of the second vector of float64.
inline constexpr std::size_t kOtherHalf = kLanes;

/// pixelOfLane() of each of them.
HWY_ALIGN inline constexpr auto kPassPixelsOfLanes = [] {
    std::array<std::int32_t, kPassPixels> all{};
    for (int lane = 0; lane < kPassPixels; ++lane) all[static_cast<std::size_t>(lane)] = pixelOfLane(lane);
    return all;
}();

/// Where the lanes of a pass lie in it, whose lines are kWidth pixels long, or the pass is but a piece of one.
template <class T, int kWidth>
struct PassLanes {
    HWY_ALIGN std::array<T, kPassPixels> right{}, down{};

    constexpr PassLanes()
    {
        for (int lane = 0; lane < kPassPixels; ++lane) {
            right[static_cast<std::size_t>(lane)] = static_cast<T>(pixelOfLane(lane) % kWidth);
            down[static_cast<std::size_t>(lane)]  = static_cast<T>(pixelOfLane(lane) / kWidth);
        }
    }
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_PASS_LANES_INL_H
