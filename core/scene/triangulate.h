// Splits a polygon of any size into triangles, the same way every time.
//
// Projection along the largest component of the polygon's Newell normal (of equal ones the first of x, y, z)
// Convex     no corner turns against the others and the outline goes round once: a fan from the first corner
// Concave    ears. Bridged outlines, repeated corners and collinear runs are ordinary; a corner that lies within
//            another edge is inserted there, so a polygon of n corners and k such contacts has n - 2 + k triangles
// Mended     no area, or an outline that crosses itself or runs round some place twice: a fan from the first corner,
//            which the caller should report
// Triangles  in the polygon's sense of turning; those without area are kept, they close the seams to neighbours
// Promise    every decision is an exact one (core/scene/orientation.h); time and memory are linear for convex
//            polygons, about n log n for ears
// Source     ears: Meisters, Polygons Have Ears, 1975; docs/correctness.md, Polygons
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/affine.h"
#include "core/scene/outline.h"

namespace zscope {

/// A concave polygon may have this many corners; a convex one any number.
inline constexpr std::size_t kMaxConcaveCorners = 20'000;

enum class PolygonSplit {
    Fan,        // a triangle, or convex
    Ears,       // concave
    MendedFan,  // degenerate or self-intersecting: a fan, to be reported
    Refused,    // concave with more than kMaxConcaveCorners corners: no triangle
};

/// Holds the working memory, so that one splitter serves a whole file.
class PolygonSplitter {
public:
    using Triangle = std::array<std::uint32_t, 3>;

    /// Appends the triangles of `outline` (indices into `positions`, three or more, all finite) to `triangles`.
    PolygonSplit split(std::span<const dvec3> positions, std::span<const std::uint32_t> outline,
                       std::vector<Triangle>& triangles);

private:
    bool cutEars(std::vector<Triangle>& triangles);

    Outline                    m_outline;
    std::vector<Point2>        m_points;
    BoxTree                    m_corners;
    std::vector<std::uint32_t> m_next, m_previous, m_queue;
    std::vector<char>          m_waiting;
};

}  // namespace zscope
