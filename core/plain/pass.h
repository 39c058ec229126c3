// What one pass over the scene is for, and what becomes of the pyramid.
//
// Filled     by passOf(), core/frame/plain_stripe.cpp, from the pipeline; prepass.h and two_pass.cpp in core/method
//            change copies of it. The comments name the presets that set each
#pragma once

#include "core/cull/occlusion.h"
#include "core/scan/pixel_events.h"
#include "core/scan/shading_moment.h"

namespace zscope::plain {

struct Pass {
    Keep keep = Keep::Nearest;  // DepthOnly, then Equal: zbuffer-prepass, hzb-simple, hzb-bvh-prepass
    // zbuffer-late: BeforeTest; zbuffer-early, zbuffer-zcull and those with a pre-pass: AfterTest. Only where the
    // stripe has a painter
    ShadingMoment shading       = ShadingMoment::Never;
    bool          walksEdges    = false;  // edge-walk; else half-space tests
    bool          testsTiles    = false;  // zbuffer-zcull: a tile of the pyramid is compared before its fragments
    bool          asksNodes     = false;  // is this node hidden? hzb-octree, hzb-bvh, hzb-bvh-prepass, two-pass
    bool          asksTriangles = false;  // is this triangle hidden? The same, and quadtree, octree-order, hzb-simple
    bool          asksByShape   = false;  // query=triangle: of a triangle only what it covers, not its whole box
    AfterDrawing  afterDrawing  = AfterDrawing::Nothing;  // by the axis upkeep
    int           number        = 0;  // two-pass: 1 draws what the last frame saw, 2 visits everything; else 0
};

}  // namespace zscope::plain
