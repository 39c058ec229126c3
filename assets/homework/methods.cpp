#include "methods.h"

#include <algorithm>

static void drawByZBuffer(const std::vector<ScreenTriangle>& triangles, Picture& picture)
{
    for (const ScreenTriangle& triangle : triangles) drawTriangle(triangle, picture);
}

static void drawByScanline(const std::vector<ScreenTriangle>& triangles, Picture& picture)
{
    const EdgeTable   table = makeEdgeTable(triangles, picture.height);
    std::vector<Edge> active;
    for (std::size_t j = 0; j < table.size(); ++j) {
        updateActiveEdges(active, table[j], int(j));
        drawLine(triangles, active, int(j), picture);
    }
}

static void drawByHierarchy(const std::vector<ScreenTriangle>& triangles, Picture& picture)
{
    // From near to far: what is drawn first hides what comes later.
    std::vector<ScreenTriangle> sorted = triangles;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const ScreenTriangle& a, const ScreenTriangle& b) { return a.hi > b.hi; });
    Pyramid pyramid(picture);
    for (const ScreenTriangle& triangle : sorted) {
        const Box box = boxOf(triangle, picture.width, picture.height);
        if (box.isEmpty() || isHidden(pyramid, box, triangle.hi)) continue;
        drawTriangle(triangle, picture);
        for (int j = box.y0; j <= box.y1; ++j)
            for (int i = box.x0; i <= box.x1; ++i) {
                const float depth = picture.depth[picture.at(i, j)];
                if (depth != pyramid.levels[0].at(i, j)) update(pyramid, i, j, depth);
            }
    }
}

void draw(Method method, const std::vector<ScreenTriangle>& triangles, Picture& picture)
{
    switch (method) {
        case Method::ZBuffer:
            return drawByZBuffer(triangles, picture);
        case Method::Scanline:
            return drawByScanline(triangles, picture);
        case Method::Hierarchical:
            return drawByHierarchy(triangles, picture);
    }
}

Pyramid::Pyramid(const Picture& picture)
{
    int width = picture.width, height = picture.height;
    while (true) {
        levels.push_back({width, height, std::vector<float>(std::size_t(width) * std::size_t(height), 0.0f)});
        if (width == 1 && height == 1) return;
        width  = (width + 1) / 2;
        height = (height + 1) / 2;
    }
}
