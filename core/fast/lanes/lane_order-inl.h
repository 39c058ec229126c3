// The order that brings chosen lanes of a vector side by side, to be found once and used for every column.
//
// Promise    the same order of the chosen lanes in every instruction set
// Cost       one instruction where the machine has it, one load from a table of 2 KB where it has not: Highway 1.0.3
//            copies its own table to the stack at each call there, because it is no static one (docs/performance.md)
#if defined(ZSCOPE_LANE_ORDER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_LANE_ORDER_INL_H
#undef ZSCOPE_LANE_ORDER_INL_H
#else
#define ZSCOPE_LANE_ORDER_INL_H
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Entry m: the numbers of the bits that are set in m, the lowest first; then zeros.
inline constexpr auto kSetBits = [] {
    std::array<std::array<std::uint8_t, 8>, 256> all{};
    for (std::size_t m = 0; m < all.size(); ++m)
        for (std::size_t bit = 0, count = 0; bit < 8; ++bit)
            if (m >> bit & 1) all[m][count++] = static_cast<std::uint8_t>(bit);
    return all;
}();

/// Which lane goes where so that those in `kept` come first, in the order that they have: lane i is the i-th of them.
/// What comes after them names lanes, too, but does not say which. `D`: int32.
template <class D>
HWY_INLINE hn::Vec<D> keptFirst(D d, hn::Mask<D> kept)
{
#if HWY_TARGET == HWY_AVX3
    return hn::Compress(hn::Iota(d, 0), kept);
#else
    static_assert(hn::MaxLanes(d) <= 8);
    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(d, kept, bits.data());
    return hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint8_t, D>(), kSetBits[bits[0]].data()));
#endif
}

/// Bit i is true of lane i, of which there are 16 at most.
template <class D>
HWY_INLINE std::uint32_t bitsOf(D d, hn::Mask<D> mask)
{
    static_assert(hn::MaxLanes(d) <= 16);
    std::array<std::uint8_t, 8> bits{};
    hn::StoreMaskBits(d, mask, bits.data());
    return bits[0] | static_cast<std::uint32_t>(bits[1]) << 8;
}

/// first, first + 1, ... Highway 1.0.3 puts such a vector together in memory, lane by lane, unless `first` is a
/// constant.
template <class D>
HWY_INLINE hn::Vec<D> countFrom(D d, hn::TFromD<D> first)
{
    return hn::Iota(d, hn::TFromD<D>{}) + hn::Set(d, first);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_LANE_ORDER_INL_H
