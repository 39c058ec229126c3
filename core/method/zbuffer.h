// The z-buffer: every triangle, every pixel that it covers; the nearest fragment keeps the pixel.
//
// Depth      near/z: a larger depth is nearer, and an empty pixel holds the smallest
// Order      as submitted; any order gives the same picture, because the winner is a maximum
// Cost       three edge tests for every pixel of every triangle's box, and a depth test for every one that is covered,
//            hidden or not. With tiles or a pyramid (zbuffer-zcull, quadtree) whole tiles and triangles are left out
// Presets    zbuffer, edge-walk, zbuffer-late, -early, -zcull, -prepass, quadtree, hzb-simple (two passes: prepass.h)
// Source     Catmull: A Subdivision Algorithm for Computer Display of Curved Surfaces, 1974; Pineda: A Parallel
//            Algorithm for Polygon Rasterization, SIGGRAPH 1988
#pragma once

#include "core/plain/parts.h"

namespace zscope::plain {

void zbuffer(Work& work, const Parts& parts, const Pass& pass);

/// The plain part `draw`: triangle by triangle, unless the pyramid says that one is hidden.
DrawnTriangles drawEachTriangle(Call work, const Pass& pass);

/// Tests each pixel of the triangle's box against the three edges.
void fillByHalfSpaces(Work& work, const Pass& pass, const ScreenTriangle& triangle);

}  // namespace zscope::plain
