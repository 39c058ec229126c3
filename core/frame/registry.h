// What can be chosen on each axis. A new choice adds its line here, its enumerator in pipeline.h, and its case in
// drivers-inl.h, where words become types.
#pragma once

#include <array>

#include "core/frame/pipeline.h"

namespace zscope {

/// In the order of enum Scan.
inline constexpr std::array kScanChoices{
    ChoiceEntry{"half-space", "Three edge functions over tiles"},
    ChoiceEntry{"edge-walk", "Left and right edge of each triangle, line by line"},
    ChoiceEntry{"sweep-z-line", "The scene line by line, with a one-line z-buffer"},
    ChoiceEntry{"sweep-intervals", "The scene line by line, interval by interval"},
};

}  // namespace zscope
