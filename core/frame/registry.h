// What can be chosen on each axis; on the axis "scan" that is the table of methods.h. A new choice adds its line here,
// its enumerator in pipeline.h, and its case in drivers-inl.h, where words become types.
#pragma once

#include <array>

#include "core/frame/pipeline.h"

namespace zscope {

/// In the order of enum Chooser, and so on for the others.
inline constexpr std::array kChooserChoices{
    ChoiceEntry{"composed", "The choices on the other axes"},
    ChoiceEntry{"measured", "Whichever of several presets drew earlier frames fastest"},
};

inline constexpr std::array kOrderChoices{
    ChoiceEntry{"submitted", "As submitted: instance after instance, triangle after triangle"},
    ChoiceEntry{"octree", "Front to back through an octree"},
    ChoiceEntry{"bvh", "Front to back through a bounding volume hierarchy"},
};

inline constexpr std::array kCullChoices{
    ChoiceEntry{"frustum", "What lies outside the view"},
    ChoiceEntry{"nodes", "Also nodes that the pyramid hides"},
    ChoiceEntry{"triangles", "Also triangles that the pyramid hides"},
    ChoiceEntry{"nodes-triangles", "Also nodes that the pyramid hides, and triangles that are not small"},
};

inline constexpr std::array kUpkeepChoices{
    ChoiceEntry{"none", "There is no pyramid"},
    ChoiceEntry{"on-query", "A stale cell is recomputed when a query meets it"},
    ChoiceEntry{"after-prepass", "Built once, after a depth pre-pass"},
    ChoiceEntry{"pushed", "Pushed to the ancestors per write, tile by tile, with early stop"},
    ChoiceEntry{"pushed-farthest",
                "Pushed to the ancestors once all tiles are right, from the triangle's farthest corner on"},
    ChoiceEntry{
        "masked",
        "Two depths and a mask per tile, updated by coverage; it forgets, so it misses culls and makes no false ones"},
};

inline constexpr std::array kQueryChoices{
    ChoiceEntry{"box", "A triangle is asked about by its rectangle"},
    ChoiceEntry{"triangle", "Only cells that the triangle itself overlaps are asked, and pixels that it covers"},
};

inline constexpr std::array kDepthChoices{
    ChoiceEntry{"deferred", "Every fragment is tested; each pixel is shaded once, when the picture is finished"},
    ChoiceEntry{"late", "Every covered fragment is shaded, then tested"},
    ChoiceEntry{"early", "Every fragment is tested; those that pass are shaded"},
    ChoiceEntry{"zcull", "A tile's farthest depth is read before its fragments; then early"},
    ChoiceEntry{"prepass", "Depth first; then only fragments of equal depth count and are shaded"},
};

inline constexpr std::array kShadingCostChoices{
    ChoiceEntry{"0-operations", "A fragment has its triangle's colour"},
    ChoiceEntry{"10-operations", "A chain of 10 dependent operations per fragment"},
    ChoiceEntry{"100-operations", "A chain of 100 dependent operations per fragment"},
    ChoiceEntry{"1000-operations", "A chain of 1000 dependent operations per fragment"},
};

inline constexpr std::array kCoherenceChoices{
    ChoiceEntry{"none", "Every frame begins from nothing"},
    ChoiceEntry{"two-pass", "Last frame's visible nodes first, then the rest against the pyramid they left"},
    ChoiceEntry{"last-pyramid", "Everything against the last frame's pyramid, whatever has moved since: approximate"},
};

inline constexpr std::array kTransparencyChoices{
    ChoiceEntry{"sorted", "Transparent surfaces of a pixel from far to near"},
    ChoiceEntry{"back-then-front", "Back faces, then front faces, each as submitted: wrong where bodies overlap"},
};

// The first choice of each of the following is the definition's; the others are approximations.

inline constexpr std::array kSnapChoices{
    ChoiceEntry{"8-bits", "Corners snapped to 1/256 pixel"},
    ChoiceEntry{"4-bits", "Corners snapped to 1/16 pixel"},
    ChoiceEntry{"12-bits", "Corners snapped to 1/4096 pixel"},
};

inline constexpr std::array kVertexChoices{
    ChoiceEntry{"float64", "Vertices transformed in float64"},
    ChoiceEntry{"float32", "Vertices transformed in float32"},
};

inline constexpr std::array kDepthNumberChoices{
    ChoiceEntry{"float64", "A fragment's depth evaluated in float64"},
    ChoiceEntry{"float32", "A fragment's depth evaluated in float32"},
    ChoiceEntry{"accumulated", "A fragment's depth carried along the span, a constant added per pixel, in float32"},
};

inline constexpr std::array kDepthFormatChoices{
    ChoiceEntry{"float32-reversed", "near/z as float32: 1 is near, 0 infinitely far"},
    ChoiceEntry{"float32-standard", "Depth that grows towards 1 with distance, as float32"},
    ChoiceEntry{"fixed-24", "The same rounded to 24 bits"},
    ChoiceEntry{"fixed-16", "The same rounded to 16 bits"},
};

inline constexpr std::array kEdgeChoices{
    ChoiceEntry{"exact", "Edges step by integers with remainder"},
    ChoiceEntry{"accumulated", "Edges step by a float32 that is added to"},
};

inline constexpr std::array kNearChoices{
    ChoiceEntry{"clip", "Triangles are cut at the near plane"},
    ChoiceEntry{"drop", "Triangles that cross the near plane are left out"},
};

inline constexpr std::array kCellChoices{
    ChoiceEntry{"descend", "The pyramid is asked down to the pixels where it is undecided"},
    ChoiceEntry{
        "one-level",
        "Only the cells under a rectangle's corners on one coarse level: a third cell between them goes unseen"},
};

inline constexpr std::array kSmallNodeChoices{
    ChoiceEntry{"keep", "Nodes are visited however small they are on the screen"},
    ChoiceEntry{"drop-below-4", "Nodes whose rectangle has fewer than 4 pixels are left out"},
    ChoiceEntry{"drop-below-16", "Nodes whose rectangle has fewer than 16 pixels are left out"},
};

}  // namespace zscope
