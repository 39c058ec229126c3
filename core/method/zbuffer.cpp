#include "core/method/zbuffer.h"

#include "core/geometry/half_plane.h"
#include "core/method/edge_walk.h"
#include "core/plain/batches_in_view.h"
#include "core/plain/depth_test.h"
#include "core/plain/questions.h"
#include "core/plain/tiles.h"

namespace zscope::plain {

void zbuffer(Work& work, const Parts& parts, const Pass& pass)
{
    for (const BatchPlace& batch : BatchesInView(work)) {
        if (!parts.mayBeSeen(work, batch)) continue;
        parts.setUp(work, batch);
        parts.draw(work, pass);
    }
}

DrawnTriangles drawEachTriangle(Call work, const Pass& pass)
{
    DrawnTriangles all;
    for (const ScreenTriangle& triangle : work->scratch.triangles) {
        if (work->isCancelled()) break;
        if (isHidden(*work, pass, triangle)) {  // only if the pass asks the pyramid about triangles
            all.add({.hidden = 1, .hiddenPixels = triangle.box.area()});
            continue;
        }
        work->tell(TriangleReached{triangle});
        if (pass.walksEdges || triangle.wide)  // beyond the guard band float64 does not hold the values of edges
            walkEdges(*work, pass, triangle);
        else
            fillByHalfSpaces(*work, pass, triangle);
        keepPyramidTrue(*work, pass, triangle);
        work->tell(TriangleFinished{triangle.id});
        ++all.drawn;
    }
    work->clock.lap(Stage::Raster);
    return all;
}

void fillByHalfSpaces(Work& work, const Pass& pass, const ScreenTriangle& triangle)
{
    // The top-left rule: the value of an edge that does not own its points is lowered by notOwned().
    const HalfPlanes edges{halfPlanesOf(triangle, work.rules.notOwned()), triangle.box.x0, triangle.box.y0};
    DepthTest        test(work, pass, triangle.depth, triangle.id, triangle.patterned);
    const PixelBox   box = work.rules.looked(triangle.box);       // a fault leaves out its last line and column
    for (const PixelBox& tile : tilesOf(box, pass.testsTiles)) {  // of the pyramid, 8 x 8 pixels; or the box as one
        if (pass.testsTiles && (edges.areOutside(tile) || isHiddenInTile(work, triangle, tile))) continue;
        for (int y = tile.y0; y < tile.y1; ++y) {
            test.beginLine(y, tile.x0);
            for (int x = tile.x0; x < tile.x1; ++x) {
                const int  right = x - triangle.box.x0, down = y - triangle.box.y0;
                const bool isInside = edges.planes[0].at(right, down) >= 0 && edges.planes[1].at(right, down) >= 0
                                      && edges.planes[2].at(right, down) >= 0;
                if (isInside) test.offer(x);
            }
        }
    }
}

}  // namespace zscope::plain
