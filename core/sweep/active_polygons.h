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
#include "core/sweep/active_edge.h"

namespace zscope {

/// A polygon of the sweep: a triangle after set-up, or a face as it was read.
struct SweepPolygon {
    DepthPlane depth;
    TriangleId id;
    bool       patterned;  // it has holes or a relief
};

struct ActivePolygon {
    DepthPlane    depth;
    TriangleId    id;
    std::uint32_t part : 31;       // index into EdgeTable::parts()
    std::uint32_t patterned : 1;   // it has holes or a relief
    int           openAt;       // while it is open: where its span begins on this line (which pixel, or where in a list)
    std::uint32_t winding = 0;  // of its sides round the place on this line that has been reached; 0: it is closed

    std::uint32_t rank() const { return id.value + 1; }
    bool          isOpen() const { return winding != 0; }
    /// An edge of it is passed on the way to the right; tells whether it is open beyond.
    bool pass(const ActiveEdge& edge)
    {
        winding += edge.winding();
        return isOpen();
    }
};
static_assert(sizeof(ActivePolygon) == 48);

class ActivePolygons {
public:
    void clear(std::size_t parts)
    {
        m_rows.clear();
        m_edges.clear();
        m_free.clear();
        m_rowOf.assign(parts, kNoRow);
    }

    /// An edge of part `part` enters; the row of its polygon, new if this is its first active edge.
    std::uint32_t enter(const SweepPolygon& polygon, std::uint32_t part)
    {
        std::uint32_t& row = m_rowOf[part];
        if (row == kNoRow) {
            row         = freeRow();
            m_rows[row] = {polygon.depth, polygon.id, part & 0x7FFFFFFFu, polygon.patterned, 0, 0};
        }
        ++m_edges[row];
        return row;
    }

    /// An edge of the polygon in `row` leaves.
    void leave(std::uint32_t row)
    {
        assert(isActive(row));
        if (--m_edges[row] > 0) return;
        m_rowOf[m_rows[row].part] = kNoRow;
        m_free.push_back(row);
    }

    ActivePolygon&                 operator[](std::uint32_t row) { return m_rows[row]; }
    const ActivePolygon&           operator[](std::uint32_t row) const { return m_rows[row]; }
    std::uint32_t                  rowCount() const { return static_cast<std::uint32_t>(m_rows.size()); }  // free ones included
    bool                           isActive(std::uint32_t row) const { return m_edges[row] > 0; }
    std::size_t                    bytes() const
    {
        return m_rows.capacity() * sizeof(ActivePolygon) +
               (m_edges.capacity() + m_free.capacity() + m_rowOf.capacity()) * sizeof(std::uint32_t);
    }

private:
    static constexpr std::uint32_t kNoRow = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t freeRow()
    {
        if (m_free.empty()) {
            m_rows.emplace_back();
            m_edges.push_back(0);
            return static_cast<std::uint32_t>(m_rows.size() - 1);
        }
        const std::uint32_t row = m_free.back();
        m_free.pop_back();
        return row;
    }

    std::vector<ActivePolygon> m_rows;
    std::vector<std::uint32_t> m_edges;  // of each row: how many of its polygon's edges are active; 0: the row is free
    std::vector<std::uint32_t> m_free;   // rows that may be used again
    std::vector<std::uint32_t> m_rowOf;  // per part: its row, or kNoRow
};

}  // namespace zscope
