// The hierarchical z-buffer: before a triangle is drawn, a pyramid of farthest depths may say that it is hidden.
#include <algorithm>

#include "methods.h"

// The farthest of the cells below that exist: a level of odd size has cells with fewer children.
static float farthestBelow(Pyramid::Level& below, int x, int y)
{
    float farthest = 1;
    for (int v = 2 * y; v <= std::min(2 * y + 1, below.height - 1); ++v)
        for (int u = 2 * x; u <= std::min(2 * x + 1, below.width - 1); ++u)
            farthest = std::min(farthest, below.at(u, v));
    return farthest;
}

void update(Pyramid& pyramid, int i, int j, float depth)
{
    pyramid.levels[0].at(i, j) = depth;
    for (std::size_t n = 1; n < pyramid.levels.size(); ++n) {
        i /= 2;
        j /= 2;
        const float farthest = farthestBelow(pyramid.levels[n - 1], i, j);
        if (pyramid.levels[n].at(i, j) == farthest) return;  // nor does any cell above change
        pyramid.levels[n].at(i, j) = farthest;
    }
}

bool isHidden(Pyramid& pyramid, const Box& box, float nearest)
{
    // The first level on which the box lies in 2 x 2 cells.
    std::size_t n = 0;
    while ((box.x1 >> n) - (box.x0 >> n) > 1 || (box.y1 >> n) - (box.y0 >> n) > 1) ++n;
    // What is exactly as near as a cell is not hidden: it may win by its lower id.
    for (int y = box.y0 >> n; y <= box.y1 >> n; ++y)
        for (int x = box.x0 >> n; x <= box.x1 >> n; ++x)
            if (nearest >= pyramid.levels[n].at(x, y)) return false;
    return true;
}
