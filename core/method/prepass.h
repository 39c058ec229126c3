// When depth is tested, and with it when fragments are shaded.
//
// Deferred   the picture is shaded when it is finished: each pixel once
// Late       every covered fragment is shaded, then tested (core/plain/depth_test.cpp)
// Early      depth first: a fragment that passes is shaded (core/plain/depth_test.cpp)
// Tiles      as early; before that a whole tile of the pyramid is compared with the triangle (z-culling; zbuffer.cpp)
// Pre-pass   depth alone first, for every triangle; then the scene again, and fragments of equal depth are shaded
// Winner     with a pre-pass too: the lowest id of the nearest depth
// Source     docs/correctness.md, Depth and the winner
#pragma once

#include "core/plain/parts.h"

namespace zscope::plain {

/// Two passes through the scene; draw(pass) runs zbuffer() or hierarchical() (drawScene, core/frame/plain_stripe.cpp).
/// Between them all cells of the pyramid, if there is one, are marked stale; the first question that needs a cell
/// computes it from the depths of the first pass.
template <class Draw>
void drawAfterPrepass(Work& work, const Pass& pass, bool hasPyramid, const Draw& draw)
{
    const Pass depthOnly{.keep = Keep::DepthOnly, .walksEdges = pass.walksEdges};
    draw(depthOnly);
    if (hasPyramid) work.scratch.pyramid.allTouched();
    Pass equalDepth = pass;
    equalDepth.keep = Keep::Equal;
    draw(equalDepth);
}

}  // namespace zscope::plain
