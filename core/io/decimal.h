// What a decimal means for which std::from_chars gives no float64.
#pragma once

#include <string_view>

namespace zscope {

/// For a decimal that from_chars calls out of range: whether it rounds to zero rather than to infinity. Decided by the
/// power of ten of its first digit other than 0; both limits are hundreds of powers away from 1.
bool roundsToZero(std::string_view decimal);

}  // namespace zscope
