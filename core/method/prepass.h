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

/// The two passes of a pre-pass, each drawn by `draw`. Between them every cell of the pyramid, if there is one, is
/// marked stale: a question computes it from the depths of the first pass.
template <class Draw>
void drawAfterPrepass(Work& work, const Pass& pass, bool hasPyramid, const Draw& draw)
{
    Pass depth       = {};
    depth.keep       = Keep::DepthOnly;
    depth.walksEdges = pass.walksEdges;
    draw(depth);
    if (hasPyramid) work.scratch.pyramid.allTouched();
    Pass colour = pass;
    colour.keep = Keep::Equal;
    draw(colour);
}

}  // namespace zscope::plain
