// Lanes filled by a load each, brought side by side: gather instructions take longer (docs/performance.md).
#if defined(ZSCOPE_LANE_LOADS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_LANE_LOADS_INL_H
#undef ZSCOPE_LANE_LOADS_INL_H
#else
#define ZSCOPE_LANE_LOADS_INL_H
#endif

#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Lane i is what stands at addressOf(first + i).
template <class D, class AddressOf>
HWY_INLINE hn::Vec<D> loadLanes(D d, const AddressOf& addressOf, std::size_t first = 0)
{
    if constexpr (hn::MaxLanes(d) > 1) {
        const hn::Half<D> half;
        return hn::Combine(d, loadLanes(half, addressOf, first + hn::MaxLanes(half)),
                           loadLanes(half, addressOf, first));
    } else {
        return hn::LoadU(d, addressOf(first));
    }
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_LANE_LOADS_INL_H
