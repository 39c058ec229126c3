// The nearer of two keys and the farther of two depths, lane by lane.
//
// Idea       the bits of two positive float64 numbers compare as the numbers do. Not every processor knows the larger
//            of two integers of 64 bits, but each knows the larger of two such numbers
// Farther    who looks for a farthest depth need not know whose it is: the upper halves say it, integers of 32 bits
// Normal     keys of depths above 0 are the bits of normal numbers above 0. Those of depths below 0 are the bits of no
//            number: where a buffer may hold such, as that of background where there is no far plane, integers are
//            compared
// Source     core/depth/pixel_key.h; IEEE 754-2019, 5.10
#if defined(ZSCOPE_KEY_ORDER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_KEY_ORDER_INL_H
#undef ZSCOPE_KEY_ORDER_INL_H
#else
#define ZSCOPE_KEY_ORDER_INL_H
#endif

#include <bit>
#include <cstdint>
#include <limits>

#include <hwy/highway.h>

#include "core/depth/pixel_key.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// True if all keys are normal that a buffer with this background may hold, by exact rules.
inline bool areNormal(float empty) { return empty >= std::numeric_limits<float>::min(); }

/// No pixel's key is larger; normal.
inline constexpr PixelKey kNearestKey = std::bit_cast<PixelKey>(std::numeric_limits<double>::max());

/// The float64 numbers with the same bits.
template <class Keys>
HWY_INLINE auto asNumbers(Keys keys)
{
    return hn::BitCast(hn::RebindToFloat<hn::DFromV<Keys>>(), keys);
}

/// `kNormal`: the second key is, and the first, too, or it is smaller than all normal ones, with the bits of a number.
template <bool kNormal, class Keys>
HWY_INLINE Keys nearerOf(Keys a, Keys b)
{
    if constexpr (kNormal) return hn::BitCast(hn::DFromV<Keys>(), hn::Max(asNumbers(a), asNumbers(b)));
    return hn::Max(a, b);
}
/// Keys with the farther of both depths; whose they are means nothing.
template <class Keys>
HWY_INLINE Keys fartherOf(Keys a, Keys b)
{
    const hn::DFromV<Keys>                              keys;
    const hn::Repartition<std::int32_t, decltype(keys)> halves;
    return hn::BitCast(keys, hn::Min(hn::BitCast(halves, a), hn::BitCast(halves, b)));
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_KEY_ORDER_INL_H
