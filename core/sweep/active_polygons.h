// The active polygon table: the polygons that the current line crosses, each with what its pixels need.
//
// Rows       numbered; a row is free again when the polygon's last active edge has left. Active edges name the row
// Cost       constant per edge that enters or leaves; 48 bytes per row, so that a line's polygons stay close together
#pragma once

#include <cassert>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/screen_triangle.h"

namespace zscope {

struct ActivePolygon {
    static constexpr int kClosed = std::numeric_limits<int>::min();

    DepthPlane    depth;
    TriangleId    id;
    std::uint32_t part;        // index into EdgeTable::parts()
    int           openAt;      // first pixel of the span that has begun on this line, or kClosed
    int           edges = 0;   // how many of its edges are active; 0: the row is free

    std::uint32_t rank() const { return id.value + 1; }
};

class ActivePolygons {
public:
    void clear(std::size_t parts)
    {
        m_rows.clear();
        m_free.clear();
        m_rowOf.assign(parts, kNoRow);
    }

    /// An edge of part `part` enters; the row of its polygon, new if this is its first active edge.
    std::uint32_t enter(const ScreenTriangle& triangle, std::uint32_t part)
    {
        std::uint32_t& row = m_rowOf[part];
        if (row == kNoRow) {
            row         = freeRow();
            m_rows[row] = {triangle.depth, triangle.id, part, ActivePolygon::kClosed, 0};
        }
        ++m_rows[row].edges;
        return row;
    }

    /// An edge of the polygon in `row` leaves.
    void leave(std::uint32_t row)
    {
        assert(m_rows[row].edges > 0);
        if (--m_rows[row].edges > 0) return;
        m_rowOf[m_rows[row].part] = kNoRow;
        m_free.push_back(row);
    }

    ActivePolygon&                 operator[](std::uint32_t row) { return m_rows[row]; }
    const ActivePolygon&           operator[](std::uint32_t row) const { return m_rows[row]; }
    std::span<const ActivePolygon> rows() const { return m_rows; }  // free ones included
    std::size_t                    bytes() const
    {
        return m_rows.capacity() * sizeof(ActivePolygon) + (m_free.capacity() + m_rowOf.capacity()) * sizeof(std::uint32_t);
    }

private:
    static constexpr std::uint32_t kNoRow = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t freeRow()
    {
        if (m_free.empty()) {
            m_rows.emplace_back();
            return static_cast<std::uint32_t>(m_rows.size() - 1);
        }
        const std::uint32_t row = m_free.back();
        m_free.pop_back();
        return row;
    }

    std::vector<ActivePolygon> m_rows;
    std::vector<std::uint32_t> m_free;   // rows that may be used again
    std::vector<std::uint32_t> m_rowOf;  // per part: its row, or kNoRow
};

}  // namespace zscope
