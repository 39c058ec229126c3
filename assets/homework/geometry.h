// From triangles in space to triangles on the screen: view, near plane, perspective, rounding to a grid. This is given.
//
// Pixels     pixel (i, j) has its centre at (i + 0.5, j + 0.5); y goes downwards
// Grid       corners are rounded to 1/256 pixel, so that whole numbers compute edges without any error. The centre of
//            pixel (i, j) is (256 i + 128, 256 j + 128) there
// Depth      near / z: 1 at the near plane, smaller behind it, 0 for background. Linear on the screen: a x + b y + c
#pragma once

#include <vector>

#include "camera.h"
#include "scene.h"

struct ScreenTriangle {
    int       id;          // of the triangle in the scene. The near plane may make two of one; both keep its id
    long long x[3], y[3];  // corners in 1/256 pixel, in clockwise order on the screen
    double    a, b, c;     // depth = a x + b y + c, x and y in pixels
    float     lo, hi;      // least and greatest depth of its corners
};

enum class Cull { None, BackFaces };

/// All triangles that have an area on the grid.
std::vector<ScreenTriangle> toScreen(const Scene& scene, const Camera& camera, Cull cull);

/// Depth at the centre of pixel (i, j).
float depthAt(const ScreenTriangle& triangle, int i, int j);

/// Pixels whose centres may lie in a triangle: i from x0 to x1 and j from y0 to y1, ends included, within the picture.
struct Box {
    int x0, y0, x1, y1;

    bool isEmpty() const { return x0 > x1 || y0 > y1; }
};
Box boxOf(const ScreenTriangle& triangle, int width, int height);

/// numerator / denominator rounded upwards; denominator > 0.
long long ceilDiv(long long numerator, long long denominator);
