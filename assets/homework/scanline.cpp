// The scanline method: line after line, with an edge table and an active edge table.
//
// What each function must do is in methods.h. Remove its line stillEmpty(...) when you fill a gap.
// depthTest() in zbuffer.cpp has to be filled first.
#include "methods.h"

EdgeTable makeEdgeTable(const std::vector<ScreenTriangle>& triangles, int height)
{
    // GAP 4: for each edge of each triangle: the first and last line whose centre it crosses, and x on the first one.
    (void)triangles;
    stillEmpty(__FILE__, __func__);
    return EdgeTable{std::size_t(height)};
}

void updateActiveEdges(std::vector<Edge>& active, const std::vector<Edge>& entering, int j)
{
    // GAP 5: remove, move on, add, sort.
    (void)active, (void)entering, (void)j;
    stillEmpty(__FILE__, __func__);
}

void drawLine(const std::vector<ScreenTriangle>& triangles, const std::vector<Edge>& active, int j, Picture& picture)
{
    // GAP 6: find the two edges of each triangle, the pixels between them, and offer their depths to depthTest().
    (void)triangles, (void)active, (void)j, (void)picture;
    stillEmpty(__FILE__, __func__);
}
