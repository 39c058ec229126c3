// The polygons of a sweep, and how far the line at hand has come in each of them.
//
// Active     a polygon is active on the lines that its edges cross. They name it by its place in the edge table, and it
//            stays there: nothing is entered or removed
// Cost       per line nothing; 8 bytes per polygon beside what the edge table holds
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/screen_triangle.h"
#include "core/sweep/active_edge.h"

namespace zscope {

/// A triangle after set-up, or a face as it was read.
struct SweepPolygon {
    DepthPlane depth;
    TriangleId id;
    bool       patterned;  // it has holes or a relief

    std::uint32_t rank() const { return id.value + 1; }
};

class ActivePolygons {
public:
    /// Where the pixels of a polygon begin and end on the line at hand.
    struct Span {
        int           openAt  = 0;  // while it is open: where its span begins (which pixel, or where in a list)
        std::uint32_t winding = 0;  // of its sides round the place on the line that has been reached; 0: it is closed

        bool isOpen() const { return winding != 0; }
        /// An edge of it is passed on the way to the right; tells whether it is open beyond.
        bool pass(const ActiveEdge& edge)
        {
            winding += edge.winding();
            return isOpen();
        }
    };

    /// All are closed. Borrows the parts of the edge table until the sweep ends.
    void begin(std::span<const SweepPolygon> parts)
    {
        m_parts = parts;
        m_spans.assign(parts.size(), {});
    }

    const SweepPolygon& operator[](std::uint32_t polygon) const { return m_parts[polygon]; }
    Span&               spanOf(std::uint32_t polygon) { return m_spans[polygon]; }
    std::size_t         bytes() const { return m_spans.capacity() * sizeof(Span); }

private:
    std::span<const SweepPolygon> m_parts;
    std::vector<Span>             m_spans;  // one per part
};

}  // namespace zscope
