// The edge table: every edge of the scene, in the bucket of the first line it crosses.
//
// Lines      a band [firstLine, endLine) of the picture; an edge that begins above the band starts at firstLine
// Edges      only those that cross the centre of a line; horizontal edges never do. Inside a bucket they are ordered by
//            the quarter of a pixel they enter at, so that the active edge table only has to merge them
// Sides      of wide edges, which are placed from them on every line; of the others only if somebody looks on
// Polygons   triangles after set-up (one that the near plane cut in two is two parts with one id), or faces as they
//            were read
// Cost       two counting sorts of places: linear in edges, lines and columns
// Errors     std::bad_alloc where it would take more bytes than it may
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/screen_face.h"
#include "core/scene/view.h"
#include "core/sweep/active_edge.h"
#include "core/sweep/active_polygons.h"

namespace zscope {

class EdgeTable {
public:
    enum class Sides { OfWide, All };  // whose are kept

    /// Where an edge enters, counted from the band's first line and, in quarters of a pixel, from one left of the
    /// picture; the right end of the widest pictures is one column.
    struct Start {
        std::uint16_t line, column;
    };
    static constexpr int kColumnBits = 2;

    /// `memory`: bytes it may take.
    void clear(int firstLine, int endLine, int width, Sides sides, std::uint64_t memory)
    {
        m_memory     = memory;
        m_keepsSides = sides == Sides::All;
        m_firstLine  = firstLine;
        m_endLine    = endLine;
        m_columns    = std::min(width << kColumnBits, 0xFFFE);
        m_partCount  = 0;
        m_edgeCount  = 0;
        m_sides.clear();
    }

    /// Room for so many more polygons and edges; add() needs it.
    void reserve(std::size_t polygons, std::size_t edges)
    {
        // behind the last there is room for what is not kept
        const std::size_t parts = m_partCount + polygons, all = m_edgeCount + edges + 1;
        if (parts > kMost || all > kMost) throw std::bad_alloc();  // some 100 GiB of edges
        if (parts > m_parts.size()) {
            mayHold(2 * parts, m_edges.size());
            m_parts.resize(2 * parts);
        }
        if (all <= m_edges.size()) return;
        mayHold(m_parts.size(), 2 * all);
        m_edges.resize(2 * all);
        m_starts.resize(m_edges.size());
    }
    /// Its place among the parts.
    std::uint32_t add(const SweepPolygon& polygon)
    {
        m_parts[m_partCount] = polygon;
        return static_cast<std::uint32_t>(m_partCount++);
    }
    /// An edge as it stands on its first line.
    void add(const ActiveEdge& edge, int line)
    {
        add(edge,
            Start{static_cast<std::uint16_t>(line - m_firstLine),
                  static_cast<std::uint16_t>(
                      std::clamp<std::int64_t>(edge.crossing().column(kColumnBits), -1, columns()) + 1)},
            true);
    }
    /// The same if it is `kept`: no branch.
    void add(const ActiveEdge& edge, Start start, bool kept)
    {
        m_edges[m_edgeCount]  = edge;
        m_starts[m_edgeCount] = start;
        m_edgeCount += kept;
    }
    /// Of the picture.
    int  columns() const { return m_columns; }
    bool keepsSides() const { return m_keepsSides; }
    /// Of the polygon that comes next.
    std::uint32_t nextPart() const { return static_cast<std::uint32_t>(m_partCount); }
    /// The place of a side, which is kept if it must be.
    std::uint32_t add(const ScreenSide& side, bool isWide)
    {
        if (m_keepsSides || isWide) m_sides.push_back(side);
        return static_cast<std::uint32_t>(m_sides.size() - (m_keepsSides || isWide));
    }

    /// Sorts the edges into their buckets; call once after the last add().
    void fillBuckets()
    {
        if (m_byLine.size() < m_edgeCount) {
            m_byColumn.resize(m_edges.size());
            m_byLine.resize(m_edges.size());
        }
        const std::span<const Start> starts = std::span(m_starts).first(m_edgeCount);
        countInto(m_bounds, &Start::column, m_columns + 2);
        for (std::uint32_t i = 0; i < starts.size(); ++i) m_byColumn[m_bounds[starts[i].column]++] = i;

        countInto(m_bounds, &Start::line, m_endLine - m_firstLine);
        for (const std::uint32_t i : std::span(m_byColumn).first(m_edgeCount)) m_byLine[m_bounds[starts[i].line]++] = i;
        // Each bound has moved to its bucket's end, which is where the next bucket begins.
        std::copy_backward(m_bounds.begin(), m_bounds.end() - 1, m_bounds.end());
        m_bounds.front() = 0;
    }

    int                           firstLine() const { return m_firstLine; }
    int                           endLine() const { return m_endLine; }
    std::size_t                   edgeCount() const { return m_edgeCount; }
    std::span<const SweepPolygon> parts() const { return std::span(m_parts).first(m_partCount); }
    /// An edge as it stands on its first line.
    const ActiveEdge& operator[](std::uint32_t edge) const { return m_edges[edge]; }
    /// The edges whose first line is y, by their places.
    std::span<const std::uint32_t> startingAt(int y) const
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
        return m_parts.capacity() * sizeof(SweepPolygon) + m_edges.capacity() * sizeof(ActiveEdge)
               + m_sides.capacity() * sizeof(ScreenSide) + m_starts.capacity() * sizeof(Start)
               + (m_byColumn.capacity() + m_byLine.capacity() + m_bounds.capacity()) * sizeof(std::uint32_t);
    }

    struct Lines {
        int first, end;  // [first, end)
    };
    /// The lines of this band whose centres the side crosses.
    Lines linesOf(const ScreenSide& side) const
    {
        const double top = std::min(side.ya, side.yb);
        return {std::max(m_firstLine, firstLineFrom(top)),
                std::min(m_endLine, firstLineFrom(std::max(side.ya, side.yb)))};
    }

private:
    /// With what fillBuckets() will need, and the sides that are there.
    void mayHold(std::size_t parts, std::size_t edges) const
    {
        constexpr std::size_t kPerEdge = sizeof(ActiveEdge) + sizeof(Start) + 2 * sizeof(std::uint32_t);
        if (parts * sizeof(SweepPolygon) + edges * kPerEdge + m_sides.size() * sizeof(ScreenSide) > m_memory)
            throw std::bad_alloc();
    }

    static constexpr std::size_t kMost = ActiveEdge::kMaxPlace;
    static_assert(kMaxPictureSide <= 0xFFFF);

    /// Where each of `count` buckets begins, by one part of Start.
    void countInto(std::vector<std::uint32_t>& bounds, std::uint16_t Start::*key, int count) const
    {
        bounds.assign(static_cast<std::size_t>(count) + 1, 0);
        for (const Start& start : std::span(m_starts).first(m_edgeCount)) ++bounds[start.*key];
        std::uint32_t before = 0;
        for (std::uint32_t& bound : bounds) before += std::exchange(bound, before);
    }

    int           m_firstLine  = 0;
    int           m_endLine    = 0;
    int           m_columns    = 0;  // of the picture
    bool          m_keepsSides = false;
    std::uint64_t m_memory     = 0;
    std::size_t   m_partCount  = 0;
    std::size_t   m_edgeCount  = 0;
    // Each may have more entries than are in use, so that entering an edge is storing it.
    std::vector<SweepPolygon>  m_parts;
    std::vector<ActiveEdge>    m_edges;     // in the order they were added, each on its first line
    std::vector<Start>         m_starts;    // likewise
    std::vector<std::uint32_t> m_byColumn;  // indices of m_edges
    std::vector<std::uint32_t> m_byLine;    // likewise, bucket after bucket
    std::vector<ScreenSide>    m_sides;     // those that are kept; no more
    std::vector<std::uint32_t> m_bounds;    // lines + 1 entries: where each bucket begins in m_byLine
};

}  // namespace zscope
