// What a stream method asks of the pyramid, and what it tells it.
#pragma once

#include "core/depth/pyramid.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct Occlusion {
    Pyramid* pyramid       = nullptr;  // nullptr: there is none, and the rest is false
    bool     asksNodes     = false;    // is this node hidden?
    bool     asksTriangles = false;    // is this triangle hidden?
    bool     keepsFresh    = false;    // drawing changes depths that later queries must see
};

}  // namespace zscope
