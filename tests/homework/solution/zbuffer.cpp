// The z-buffer: every triangle, every pixel that it covers; the nearest stays.
#include "methods.h"

void depthTest(Picture& picture, int i, int j, float depth, int id)
{
    const std::size_t pixel = picture.at(i, j);
    if (depth < picture.far || depth < picture.depth[pixel]) return;
    if (depth == picture.depth[pixel] && picture.ids[pixel] != -1 && id >= picture.ids[pixel]) return;
    picture.depth[pixel] = depth;
    picture.ids[pixel]   = id;
}

bool isInside(const ScreenTriangle& t, int i, int j)
{
    const long long px = 256LL * i + 128, py = 256LL * j + 128;
    for (int a = 0; a < 3; ++a) {
        const int       b  = (a + 1) % 3;
        const long long dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
        const long long side      = dx * (py - t.y[a]) - dy * (px - t.x[a]);
        const bool      leftOrTop = dy < 0 || (dy == 0 && dx > 0);
        if (side < 0 || (side == 0 && !leftOrTop)) return false;
    }
    return true;
}

void drawTriangle(const ScreenTriangle& triangle, Picture& picture)
{
    const Box box = boxOf(triangle, picture.width, picture.height);
    for (int j = box.y0; j <= box.y1; ++j)
        for (int i = box.x0; i <= box.x1; ++i)
            if (isInside(triangle, i, j)) depthTest(picture, i, j, depthAt(triangle, i, j), triangle.id);
}
