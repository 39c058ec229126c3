// What a stream method asks of the pyramid, and what it tells it.
#pragma once

#include "core/cull/cull_events.h"
#include "core/depth/pyramid_told.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct Occlusion {
    Pyramid* pyramid       = nullptr;  // nullptr: there is none, and the rest is false
    bool     asksNodes     = false;    // is this node hidden?
    bool     asksTriangles = false;    // is this triangle hidden?
    bool     keepsFresh    = false;    // drawing changes depths that later queries must see
};

/// Tells a probe of the cells that the pyramid writes.
template <class Probe>
auto tellingOfCells(const Probe& probe)
{
    if constexpr (Probe::listens)
        return [&probe](const CellWrite& write) { probe(CellUpdated{write}); };
    else
        return Untold{};
}

}  // namespace zscope
