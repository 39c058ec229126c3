// What one pass over the scene is for, and what becomes of the pyramid.
#pragma once

#include "core/cull/occlusion.h"
#include "core/scan/fragments.h"
#include "core/scan/pixel_events.h"

namespace zscope::plain {

struct Pass {
    Keep          keep          = Keep::Nearest;
    ShadingMoment shading       = ShadingMoment::Never;  // where the stripe has a painter
    bool          walksEdges    = false;                 // else half-space tests
    bool          testsTiles    = false;                 // a tile of the pyramid is compared before its fragments
    bool          asksNodes     = false;                 // is this node hidden?
    bool          asksTriangles = false;                 // is this triangle hidden?
    bool          asksByShape   = false;                 // of a triangle only what it covers, not its whole box
    AfterDrawing  afterDrawing  = AfterDrawing::Nothing;
    int           ofTwo         = 0;  // methods of two passes: 1 what the last frame saw, 2 everything
};

}  // namespace zscope::plain
