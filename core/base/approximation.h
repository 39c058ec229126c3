// What a pipeline may do less exactly than the definition, each a choice of its own. The first choice of every kind is
// the definition's; a frame in which all are first is exact.
//
// Use        to report speed against error, and to see what an error looks like: none of the others is ever called
//            exact
// Source     docs/correctness.md, sections 2 to 4: what each of them costs in accuracy was measured there
#pragma once

#include "core/base/depth_format.h"

namespace zscope {

/// How finely corners are snapped: fractional bits of a pixel.
enum class SnapBits { Eight, Four, Twelve };
/// In which numbers vertices go from the model to the screen.
enum class VertexNumbers { Float64, Float32 };
/// How a fragment's depth is found: evaluated at the pixel, in float64 or float32, or carried along the span in
/// float32.
enum class DepthNumbers { Float64, Float32, Accumulated };
/// How an edge moves from line to line: exact integers with remainder, or a float32 that is added to.
enum class EdgeSteps { Exact, Accumulated };
/// What happens to a triangle that crosses the near plane.
enum class NearPlane { Clip, Drop };

/// How far down the pyramid a question goes.
enum class CellDescent { Descend, OneLevel };
/// What becomes of a node whose whole rectangle on the screen has fewer pixels.
enum class SmallNodes { Keep, DropBelow4, DropBelow16 };

/// Pixels: what smaller nodes are dropped.
constexpr double smallestNodeOf(SmallNodes which)
{
    return which == SmallNodes::DropBelow4 ? 4 : which == SmallNodes::DropBelow16 ? 16 : 0;
}

struct Approximation {
    SnapBits      snap   = SnapBits::Eight;
    VertexNumbers vertex = VertexNumbers::Float64;
    DepthNumbers  depth  = DepthNumbers::Float64;
    DepthFormat   format = DepthFormat::ReversedFloat32;
    EdgeSteps     edges  = EdgeSteps::Exact;
    NearPlane     near   = NearPlane::Clip;
    CellDescent   cells  = CellDescent::Descend;
    SmallNodes    small  = SmallNodes::Keep;

    /// True if each lane can find its own numbers (LaneRules in core/geometry/rules.h): nothing is carried from pixel
    /// to pixel, from line to line or from question to question, and corners lie on whole subpixels.
    bool suitsLanes() const
    {
        return snap != SnapBits::Twelve && cells == CellDescent::Descend && depth != DepthNumbers::Accumulated
               && edges == EdgeSteps::Exact;
    }
    bool        isAny() const { return *this != Approximation{}; }
    friend bool operator==(const Approximation&, const Approximation&) = default;
};

}  // namespace zscope
