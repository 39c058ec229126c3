// What must be seen, by whole numbers alone: an independent way to the pixels of a triangle or polygon whose corners
// are known on the 1/256 grid, and to the winner where depths are known exactly.
//
// Coverage   by rows: row j meets an edge iff Ymin <= 256 j + 128 < Ymax; its pixels lie between ceilings of exact
//            quotients. (The reference of core/measure decides by edge functions instead.)
// Depth      as fractions of 128-bit integers
// Source     docs/correctness.md, Coverage; Depth and the winner
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/grid.h"
#include "core/depth/visibility_buffer.h"

namespace zscope::hardcase {

/// A point of the grid, in 1/256 pixel.
struct GridPoint {
    std::int64_t x = 0, y = 0;

    friend bool operator==(const GridPoint&, const GridPoint&) = default;
};
using Outline = std::vector<GridPoint>;

/// The grid point nearest to a place in pixels; halfway, the one with the even coordinate.
GridPoint snapped(double px, double py);

/// 1 where the outline, filled by the even-odd rule, covers the pixel's centre; else 0.
Grid<int> fill(const Outline& outline, int width, int height);
/// The sum of the fills.
Grid<int>    fill(const std::vector<Outline>& outlines, int width, int height);
std::int64_t sum(const Grid<int>& counts);

/// 1 where the picture shows a triangle.
Grid<int> coverageOf(const Picture& picture);
/// 1 where the picture shows triangle `id`.
Grid<int> coverageOf(const Picture& picture, std::int64_t id);

/// A triangle with its snapped corners and their depths, which must be multiples of 2^-30.
struct GridTriangle {
    std::array<GridPoint, 3> corner;
    std::array<double, 3>    depth;

    Outline outline() const { return {corner.begin(), corner.end()}; }
};

/// The winners by exact comparison of exact depths.
struct ExactPicture {
    Grid<std::int64_t> ids;      // -1 is background; of equal depths the lowest id
    Grid<double>       depth;    // the exact depth rounded to float64
    Grid<int>          unclear;  // 1: another triangle is nearer than three float32 steps, but not equal
};
ExactPicture winners(const std::vector<GridTriangle>& triangles, int width, int height);

}  // namespace zscope::hardcase
