// The edge table: every edge of the scene, in the bucket of the first line it crosses.
//
// Lines      a band [firstLine, endLine) of the picture; an edge that begins above the band starts at firstLine
// Edges      only those that cross the centre of a line; horizontal edges never do
// Polygons   triangles after set-up; a triangle that the near plane cut in two is two parts with one id
// Cost       counting sort: linear in edges and lines
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/screen_triangle.h"
#include "core/scan/edge_stepper.h"

namespace zscope {

/// One entry of a bucket: side `side` (from corner side to corner side + 1) of part `part`.
struct EdgeStart {
    std::uint32_t part : 30;
    std::uint32_t side : 2;
};

class EdgeTable {
public:
    void clear(int firstLine, int endLine)
    {
        m_firstLine = firstLine;
        m_endLine   = endLine;
        m_parts.clear();
        m_unsorted.clear();
    }

    /// `part` must have been set up for the lines of this table.
    void add(const ScreenTriangle& part)
    {
        const auto index = static_cast<std::uint32_t>(m_parts.size());
        m_parts.push_back(part);
        for (std::uint32_t side = 0; side < 3; ++side) {
            const auto [first, end] = linesOf(part, side);
            if (first < end) m_unsorted.push_back({first, {index & kMaxPart, side & 3}});
        }
    }

    /// Sorts the edges into their buckets; call once after the last add().
    void fillBuckets()
    {
        m_bucketStart.assign(static_cast<std::size_t>(m_endLine - m_firstLine) + 1, 0);
        for (const Entry& entry : m_unsorted) ++m_bucketStart[bucketOf(entry.line)];
        std::uint32_t before = 0;
        for (std::uint32_t& start : m_bucketStart) before += std::exchange(start, before);
        m_sorted.resize(m_unsorted.size());
        for (const Entry& entry : m_unsorted) m_sorted[m_bucketStart[bucketOf(entry.line)]++] = entry.start;
        // Each start has moved to its bucket's end, which is where the next bucket begins.
        std::copy_backward(m_bucketStart.begin(), m_bucketStart.end() - 1, m_bucketStart.end());
        m_bucketStart.front() = 0;
    }

    int                             firstLine() const { return m_firstLine; }
    int                             endLine() const { return m_endLine; }
    std::span<const ScreenTriangle> parts() const { return m_parts; }
    std::span<const EdgeStart>      startingAt(int y) const
    {
        const std::size_t bucket = bucketOf(y);
        return std::span(m_sorted).subspan(m_bucketStart[bucket], m_bucketStart[bucket + 1] - m_bucketStart[bucket]);
    }
    std::size_t bytes() const
    {
        return m_parts.capacity() * sizeof(ScreenTriangle) + m_unsorted.capacity() * sizeof(Entry) +
               m_sorted.capacity() * sizeof(EdgeStart) + m_bucketStart.capacity() * sizeof(std::uint32_t);
    }

    struct Lines {
        int first, end;  // [first, end)
    };
    /// The lines of this band whose centres the side crosses.
    static Lines linesOf(const ScreenTriangle& part, std::uint32_t side)
    {
        const double ya = part.y[side], yb = part.y[(side + 1) % 3];
        return {std::max(part.box.y0, firstLineFrom(std::min(ya, yb))), std::min(part.box.y1, firstLineFrom(std::max(ya, yb)))};
    }

private:
    static constexpr std::uint32_t kMaxPart = (1u << 30) - 1;  // more parts than any memory holds

    struct Entry {
        int       line;
        EdgeStart start;
    };

    std::size_t bucketOf(int y) const { return static_cast<std::size_t>(y - m_firstLine); }

    int                         m_firstLine = 0;
    int                         m_endLine   = 0;
    std::vector<ScreenTriangle> m_parts;
    std::vector<Entry>          m_unsorted;
    std::vector<EdgeStart>      m_sorted;       // bucket after bucket
    std::vector<std::uint32_t>  m_bucketStart;  // lines + 1 entries
};

}  // namespace zscope
