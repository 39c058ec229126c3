// Transparent surfaces are blended over the finished opaque picture, line by line, by a sweep of their own.
//
// Fragments  those that are nearer than the opaque depth are put in order at each pixel. Each lies "over" the colour
//            that is there
// Order      Sorted: from far to near by (depth, -id), right wherever surfaces cross. BackThenFront: back faces first,
//            as submitted; right for one convex body, wrong where bodies overlap: what renderers do that keep no list
// Over       per channel c += (source - c) * opacity, in float32, from the opaque colour; rounded once at the end
// Memory     of the fragments of a part of a line: a part with more than kMostFragments is halved
// Source     Porter, Duff: Compositing Digital Images, SIGGRAPH 1984; Carpenter: The A-buffer, SIGGRAPH 1984
#pragma once

#include "core/base/blend_order.h"
#include "core/base/grid.h"
#include "core/geometry/transparent_surfaces.h"
#include "core/plain/parts.h"

namespace zscope {
class ColourTable;
}

namespace zscope::plain {

/// `colour` holds the opaque picture's colours and gets the blended ones. `work` must have rules without a fault:
/// faults belong to the opaque picture.
void blendTransparent(Work& work, const Parts& parts, const TransparentSurfaces& surfaces, const ColourTable& colours,
                      BlendOrder order, GridView<std::uint32_t> colour);

}  // namespace zscope::plain
