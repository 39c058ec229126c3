#include "core/base/simd.h"

#include <algorithm>

namespace zscope {

Simd resolved(Simd simd)
{
    if (simd != Simd::Auto) return simd;
    for (auto entry = simdTargets().rbegin(); entry != simdTargets().rend(); ++entry)
        if (entry->available) return entry->target;
    return Simd::Scalar;
}

std::string_view wordOf(Simd simd)
{
    const auto entry = std::ranges::find(simdTargets(), simd, &SimdEntry::target);
    return entry == simdTargets().end() ? "auto" : entry->word;
}

}  // namespace zscope
