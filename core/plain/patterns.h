// Cut-outs and reliefs at one pixel: whether the fragment lies in a hole, and how far back a relief moves it.
//
// NaN        no comparison is true of it: where a coordinate cannot be told there is no hole and no relief
// Source     docs/correctness.md, Cut-outs and Reliefs
#pragma once

#include "core/geometry/pattern_plane.h"

namespace zscope::plain {

/// False where the material has no cut-out.
bool isHole(const PatternPlane& plane, int x, int y);

/// The face's depth at the pixel, moved away from the eye; never nearer than `depth`. The material has a relief.
double movedDepth(const PatternPlane& plane, double depth, int x, int y);

}  // namespace zscope::plain
