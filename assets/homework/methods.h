// The three methods. Each draws all triangles into an empty picture, and all three draw the same picture.
//
// Given      methods.cpp: how each method goes through the triangles or the lines
// Gaps       zbuffer.cpp, scanline.cpp, hierarchical.cpp: the functions below. Fill in those of zbuffer.cpp first
#pragma once

#include <vector>

#include "geometry.h"
#include "picture.h"

enum class Method { ZBuffer, Scanline, Hierarchical };

void draw(Method method, const std::vector<ScreenTriangle>& triangles, Picture& picture);

// ---- zbuffer.cpp

/// Offers a depth to a pixel. The nearest wins, of equally near ones the one with the lowest id. What lies beyond the
/// far plane (depth < picture.far) never wins.
void depthTest(Picture& picture, int i, int j, float depth, int id);

/// Whether the centre of pixel (i, j) belongs to the triangle. A centre exactly on an edge belongs to it if that is a
/// left or a top edge: of two triangles with a common edge exactly one has it.
bool isInside(const ScreenTriangle& triangle, int i, int j);

/// Offers the triangle's depth to each pixel that it covers.
void drawTriangle(const ScreenTriangle& triangle, Picture& picture);

// ---- scanline.cpp

/// An edge of a triangle that is not horizontal. x is exact and stays exact from line to line.
struct Edge {
    int       triangle;     // place of its triangle in the list
    int       lastLine;     // the last line whose centre it crosses
    long long x;            // where it crosses the current line's centre: x / denominator pixels
    long long dx;           // what x changes by from line to line
    long long denominator;  // above 0
};
using EdgeTable = std::vector<std::vector<Edge>>;  // for each line the edges whose first line it is

/// Edges that begin above the picture enter on line 0; `x` is that of the line on which they enter.
EdgeTable makeEdgeTable(const std::vector<ScreenTriangle>& triangles, int height);

/// Makes line j's active edges of those of line j - 1: some end, the others move on by dx, new ones enter, and all of
/// them are sorted by x.
/// Numbers: with the denominator 256 h, h the edge's height in steps of the grid, |x| < 2^59 in a picture of any size:
/// long long holds x, dx and 2 x. To compare two edges, compare their first pixels, ceilDiv(2 x - denominator,
/// 2 denominator). Do not compare a.x * b.denominator with b.x * a.denominator: these reach 2^97. They fit into 64 bits
/// only if all triangles lie within a picture of up to 1024 x 1024 pixels, and a triangle may reach far beyond it.
void updateActiveEdges(std::vector<Edge>& active, const std::vector<Edge>& entering, int j);

/// Draws line j. Each triangle on it has two active edges, and covers the pixels whose centres lie between them.
void drawLine(const std::vector<ScreenTriangle>& triangles, const std::vector<Edge>& active, int j, Picture& picture);

// ---- hierarchical.cpp

/// Level 0 has the picture's depths. A cell of level n + 1 holds the FARTHEST depth of up to 2 x 2 cells of level n;
/// each level is half as large as the one below, rounded up. The last level is one cell.
struct Pyramid {
    struct Level {
        int                width, height;
        std::vector<float> farthest;

        float& at(int x, int y) { return farthest[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    };
    std::vector<Level> levels;

    explicit Pyramid(const Picture& picture);  // all cells are 0, the background
};

/// Pixel (i, j) has this depth now: brings its cell of each level up to date.
void update(Pyramid& pyramid, int i, int j, float depth);

/// Whether all pixels of the box hold something nearer than `nearest`; read from at most 2 x 2 cells of one level. It
/// may say no although they do. It may not say yes although one of them does not.
bool isHidden(Pyramid& pyramid, const Box& box, float nearest);
