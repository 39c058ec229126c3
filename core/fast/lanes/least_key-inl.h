// The farthest depth in a tile of the pyramid, in lanes: column by column, then across.
//
// Promise    the farthest of all, in any number of lanes: a minimum does not ask for an order
#if defined(ZSCOPE_LEAST_KEY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_LEAST_KEY_INL_H
#undef ZSCOPE_LEAST_KEY_INL_H
#else
#define ZSCOPE_LEAST_KEY_INL_H
#endif

#include <hwy/highway.h>

#include "core/depth/pyramid.h"
#include "core/fast/lanes/key_order-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// A LeastKey (core/depth/pyramid.h).
inline PixelKey leastKeyOfTile(const PixelKey* first, std::ptrdiff_t stride, int lines)
{
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::ScalableTag<PixelKey> keys;
    constexpr int                   kTile = 1 << Pyramid::kTileLevel;
    static_assert(kTile % hn::MaxLanes(hn::ScalableTag<PixelKey>()) == 0);
    auto least = hn::Set(keys, kNearestKey);
    for (int y = 0; y < lines; ++y, first += stride)
        for (std::size_t x = 0; x < kTile; x += hn::Lanes(keys)) least = fartherOf(least, hn::LoadU(keys, first + x));
    return hn::GetLane(hn::MinOfLanes(keys, least));
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_LEAST_KEY_INL_H
