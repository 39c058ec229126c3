// What can be chosen on each axis. A new choice adds its line here, its enumerator in pipeline.h, and its case in
// drivers-inl.h, where words become types.
#pragma once

#include <array>

#include "core/frame/pipeline.h"

namespace zscope {

/// In the order of enum Order, and so on for the others.
inline constexpr std::array kOrderChoices{
    ChoiceEntry{"submitted", "As submitted: instance after instance, triangle after triangle"},
    ChoiceEntry{"octree", "Front to back through an octree"},
    ChoiceEntry{"bvh", "Front to back through a bounding volume hierarchy"},
};

inline constexpr std::array kCullChoices{
    ChoiceEntry{"frustum", "What lies outside the view"},
    ChoiceEntry{"nodes", "Also nodes that the pyramid hides"},
    ChoiceEntry{"triangles", "Also triangles that the pyramid hides"},
    ChoiceEntry{"nodes-triangles", "Also nodes and triangles that the pyramid hides"},
};

inline constexpr std::array kUpkeepChoices{
    ChoiceEntry{"none", "There is no pyramid"},
    ChoiceEntry{"on-query", "A stale cell is recomputed when a query meets it"},
    ChoiceEntry{"after-prepass", "Built once, after a depth pre-pass"},
};

inline constexpr std::array kDepthChoices{
    ChoiceEntry{"at-once", "Every fragment is tested against the winner so far"},
    ChoiceEntry{"prepass", "Depth first; then only fragments of equal depth count"},
};

inline constexpr std::array kScanChoices{
    ChoiceEntry{"half-space", "Three edge functions over tiles"},
    ChoiceEntry{"edge-walk", "Left and right edge of each triangle, line by line"},
    ChoiceEntry{"sweep-z-line", "The scene line by line, with a one-line z-buffer"},
    ChoiceEntry{"sweep-intervals", "The scene line by line, interval by interval"},
};

}  // namespace zscope
