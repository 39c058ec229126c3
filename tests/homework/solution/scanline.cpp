// The scanline method: line after line, with an edge table and an active edge table.
#include <algorithm>
#include <map>

#include "methods.h"

// The first pixel whose centre does not lie left of the crossing: x - 1/2, rounded upwards. A span begins with that of
// its left edge and ends before that of its right edge, which is the top-left rule.
static int firstPixel(const Edge& edge) { return int(ceilDiv(2 * edge.x - edge.denominator, 2 * edge.denominator)); }

EdgeTable makeEdgeTable(const std::vector<ScreenTriangle>& triangles, int height)
{
    EdgeTable table{std::size_t(height)};
    for (std::size_t n = 0; n < triangles.size(); ++n) {
        const ScreenTriangle& t = triangles[n];
        for (int i = 0; i < 3; ++i) {
            int top = i, bottom = (i + 1) % 3;
            if (t.y[top] > t.y[bottom]) std::swap(top, bottom);
            // The first centre at or below the top; the last one above the bottom. A horizontal edge crosses none.
            const long long first = std::max(ceilDiv(t.y[top] - 128, 256), 0LL);
            const long long last  = std::min(ceilDiv(t.y[bottom] - 128, 256), 0LL + height) - 1;
            if (first > last) continue;
            const long long dx = t.x[bottom] - t.x[top], dy = t.y[bottom] - t.y[top];
            Edge            edge;
            edge.triangle    = int(n);
            edge.lastLine    = int(last);
            edge.denominator = 256 * dy;
            edge.x           = t.x[top] * dy + dx * (256 * first + 128 - t.y[top]);
            edge.dx          = 256 * dx;
            table[std::size_t(first)].push_back(edge);
        }
    }
    return table;
}

void updateActiveEdges(std::vector<Edge>& active, const std::vector<Edge>& entering, int j)
{
    const auto hasEnded = [j](const Edge& edge) { return edge.lastLine < j; };
    active.erase(std::remove_if(active.begin(), active.end(), hasEnded), active.end());
    for (Edge& edge : active) edge.x += edge.dx;
    active.insert(active.end(), entering.begin(), entering.end());
    std::stable_sort(active.begin(), active.end(),
                     [](const Edge& a, const Edge& b) { return firstPixel(a) < firstPixel(b); });
}

void drawLine(const std::vector<ScreenTriangle>& triangles, const std::vector<Edge>& active, int j, Picture& picture)
{
    std::map<int, int> leftEnds;  // triangle -> first pixel of its span, once its left edge was met
    for (const Edge& edge : active) {
        const auto left = leftEnds.find(edge.triangle);
        if (left == leftEnds.end()) {
            leftEnds[edge.triangle] = firstPixel(edge);
            continue;
        }
        const ScreenTriangle& triangle = triangles[std::size_t(edge.triangle)];
        const int             to       = std::min(firstPixel(edge), picture.width);
        for (int i = std::max(left->second, 0); i < to; ++i)
            depthTest(picture, i, j, depthAt(triangle, i, j), triangle.id);
        leftEnds.erase(left);
    }
}
