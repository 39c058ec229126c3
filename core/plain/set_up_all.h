// Every triangle of the stripe, set up at once: for methods that need all of them before they draw.
//
// Memory     what the stripe may take; more is std::bad_alloc
#pragma once

#include <vector>

#include "core/plain/parts.h"

namespace zscope::plain {

/// Puts Scratch::triangles behind `all`.
void keepTriangles(Work& work, std::vector<ScreenTriangle>& all);

/// As submitted; the parts of a triangle that the near plane has cut keep its id.
std::vector<ScreenTriangle> setUpAll(Work& work, const Parts& parts);

}  // namespace zscope::plain
