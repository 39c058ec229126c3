// The edge table: every edge of the scene, in the bucket of the first line it crosses.
//
// Lines      a band [firstLine, endLine) of the picture; an edge that begins above the band starts at firstLine
// Edges      only those that cross the centre of a line; horizontal edges never do. Inside a bucket they are ordered by
//            the pixel they enter at, so that the active edge table only has to merge them
// Sides      of wide edges, which are placed from them on every line; of the others only if somebody looks on
// Polygons   triangles after set-up (one that the near plane cut in two is two parts with one id), or faces as they were read
// Cost       two counting sorts, the first of numbers, the second of edges: linear in edges, lines and columns
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/screen_face.h"
#include "core/sweep/active_edge.h"
#include "core/sweep/active_polygons.h"

namespace zscope {

class EdgeTable {
public:
    enum class Sides { OfWide, All };  // whose are kept

    void clear(int firstLine, int endLine, int width, Sides sides)
    {
        m_keepsSides = sides == Sides::All;
        m_firstLine = firstLine;
        m_endLine   = endLine;
        m_width     = width;
        m_parts.clear();
        m_edges.clear();
        m_sides.clear();
        m_starts.clear();
    }

    /// `part` must have been set up for the lines of this table.
    template <class Rules>
    void add(const ScreenTriangle& part, const Rules& rules)
    {
        const auto &x = part.x, &y = part.y;
        const std::array<ScreenSide, 3> sides{{{x[0], y[0], x[1], y[1]}, {x[1], y[1], x[2], y[2]}, {x[2], y[2], x[0], y[0]}}};
        add(SweepPolygon{part.depth, part.id, part.patterned}, Inside::EvenOdd, part.wide, sides, std::min({y[0], y[1], y[2]}), rules);
    }

    /// `sides` are closed, however often they cross.
    template <class Rules>
    void add(const ScreenFace& face, std::span<const ScreenSide> sides, const Rules& rules)
    {
        add(SweepPolygon{face.depth, face.id, face.patterned}, face.isMended ? Inside::EvenOdd : Inside::AnyWinding, face.wide, sides, face.top, rules);
    }

    /// Sorts the edges into their buckets; call once after the last add().
    void fillBuckets()
    {
        m_byColumn.resize(m_edges.size());
        countInto(m_bounds, &Start::column, m_width + 2);
        for (std::uint32_t i = 0; i < m_starts.size(); ++i) m_byColumn[m_bounds[static_cast<std::size_t>(m_starts[i].column)]++] = i;

        m_byLine.resize(m_edges.size());
        countInto(m_bounds, &Start::line, m_endLine - m_firstLine);
        for (const std::uint32_t i : m_byColumn) m_byLine[m_bounds[static_cast<std::size_t>(m_starts[i].line)]++] = m_edges[i];
        // Each bound has moved to its bucket's end, which is where the next bucket begins.
        std::copy_backward(m_bounds.begin(), m_bounds.end() - 1, m_bounds.end());
        m_bounds.front() = 0;
    }

    int                           firstLine() const { return m_firstLine; }
    int                           endLine() const { return m_endLine; }
    std::size_t                   edgeCount() const { return m_edges.size(); }
    std::span<const SweepPolygon> parts() const { return m_parts; }
    /// The edges whose first line is y, as they stand on it.
    std::span<const ActiveEdge> startingAt(int y) const
    {
        const auto bucket = static_cast<std::size_t>(y - m_firstLine);
        return std::span(m_byLine).subspan(m_bounds[bucket], m_bounds[bucket + 1] - m_bounds[bucket]);
    }
    /// The side of its polygon that an edge is; it must have been kept.
    const ScreenSide& sideOf(const ActiveEdge& edge) const
    {
        assert(m_keepsSides || edge.isWide());
        return m_sides[edge.side()];
    }

    std::size_t bytes() const
    {
        return m_parts.capacity() * sizeof(SweepPolygon) + (m_edges.capacity() + m_byLine.capacity()) * sizeof(ActiveEdge) +
               m_sides.capacity() * sizeof(ScreenSide) + m_starts.capacity() * sizeof(Start) +
               (m_byColumn.capacity() + m_bounds.capacity()) * sizeof(std::uint32_t);
    }

    struct Lines {
        int first, end;  // [first, end)
    };
    /// The lines of this band whose centres the side crosses. `topOfPolygon` is the least y of its polygon.
    template <class Rules>
    Lines linesOf(const ScreenSide& side, double topOfPolygon, const Rules& rules) const
    {
        const double top = std::min(side.ya, side.yb);
        if (rules.isSkippedAsHorizontal(side.xa, side.xb)) return {0, 0};
        const int first = top == topOfPolygon ? rules.firstLineOfTriangle(top) : firstLineFrom(top);
        return {std::max(m_firstLine, first), std::min(m_endLine, firstLineFrom(std::max(side.ya, side.yb)))};
    }

private:
    template <class Rules>
    void add(const SweepPolygon& polygon, Inside rule, bool wide, std::span<const ScreenSide> sides, double top, const Rules& rules)
    {
        const auto part = static_cast<std::uint32_t>(m_parts.size());
        m_parts.push_back(polygon);
        for (const ScreenSide& side : sides) {
            const auto [first, end] = linesOf(side, top, rules);
            if (first >= end) continue;
            const bool isWide = wide || ActiveEdge::isTooTall(side);
            const auto place  = static_cast<std::uint32_t>(m_sides.size());
            if (m_keepsSides || isWide) keep(side);
            const ActiveEdge& edge = m_edges.emplace_back(side, rule, isWide, part, place, first, end - 1);
            m_starts.push_back({first - m_firstLine, std::clamp(edge.firstPixel(), -1, m_width) + 1});
        }
    }

    void keep(const ScreenSide& side)
    {
        if (m_sides.size() > ActiveEdge::kMaxSide) throw std::bad_alloc();  // some 40 GiB of edges
        m_sides.push_back(side);
    }

    /// Where an edge enters, counted from the band's first line and from one pixel left of the picture.
    struct Start {
        int line, column;
    };

    /// Where each of `count` buckets begins, by one part of Start.
    void countInto(std::vector<std::uint32_t>& bounds, int Start::*key, int count) const
    {
        bounds.assign(static_cast<std::size_t>(count) + 1, 0);
        for (const Start& start : m_starts) ++bounds[static_cast<std::size_t>(start.*key)];
        std::uint32_t before = 0;
        for (std::uint32_t& bound : bounds) before += std::exchange(bound, before);
    }

    int                        m_firstLine  = 0;
    int                        m_endLine    = 0;
    int                        m_width      = 0;
    bool                       m_keepsSides = false;
    std::vector<SweepPolygon>  m_parts;
    std::vector<ActiveEdge>    m_edges;     // in the order they were added, each on its first line
    std::vector<Start>         m_starts;    // likewise
    std::vector<ScreenSide>    m_sides;     // those that are kept, likewise
    std::vector<std::uint32_t> m_byColumn;  // indices of m_edges
    std::vector<ActiveEdge>    m_byLine;    // the edges again, bucket after bucket
    std::vector<std::uint32_t> m_bounds;    // lines + 1 entries: where each bucket begins in m_byLine
};

}  // namespace zscope
