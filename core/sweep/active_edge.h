// One row of the active edge table: 32 bytes, so that stepping and sorting a line's edges stays in the nearest cache.
//
// Wide       an edge beyond the guard band does not fit 32 bits: it is placed anew on every line by the 64-bit stepper,
//            and stands at most kFarAway subpixels from the picture's left border, which is outside in any case
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/scan/edge_stepper.h"

namespace zscope {

class ActiveEdge {
public:
    /// Side `side` (from corner side to corner side + 1) of `part` at `line`, owned by `polygon`.
    ActiveEdge(const ScreenTriangle& part, std::uint32_t polygon, std::uint32_t side, int line, int lastLine)
        : m_polygon(polygon), m_lastLine(lastLine), m_side(static_cast<std::uint8_t>(side)), m_wide(part.wide)
    {
        if (m_wide)
            placeWide(part, line);
        else
            m_crossing = stepper<std::int32_t>(part, line, lastLine);
    }

    void nextLine() { m_crossing.nextLine(); }
    /// For wide edges only, instead of nextLine().
    void placeWide(const ScreenTriangle& part, int line)
    {
        const EdgeStepper<std::int64_t> exact = stepper<std::int64_t>(part, line, line);
        const std::int64_t              x     = std::clamp(exact.x(), -kFarAway, kFarAway);
        m_crossing = EdgeStepper<std::int32_t>::standing(static_cast<std::int32_t>(x), x == exact.x() && exact.fraction() > 0);
    }

    /// The exact stepper of this edge at a line it crosses, computed from the corners.
    template <class Integer>
    EdgeStepper<Integer> stepper(const ScreenTriangle& part, int line, int lastLine) const
    {
        std::size_t top = m_side, bottom = (m_side + 1u) % 3;
        if (part.y[bottom] < part.y[top]) std::swap(top, bottom);
        return {part.x[top], part.y[top], part.x[bottom], part.y[bottom], line, lastLine};
    }

    /// In the edge table: the index of the part. In the active edge table: the row of the active polygon table.
    std::uint32_t polygon() const { return m_polygon; }
    void          setPolygon(std::uint32_t row) { m_polygon = row; }

    bool          isLeftOf(const ActiveEdge& other) const { return m_crossing.isLeftOf(other.m_crossing); }
    int           firstPixel() const { return m_crossing.firstPixel(); }
    template <class Rules>
    int firstPixel(const Rules& rules) const { return rules.firstPixel(m_crossing.firstPixel(), m_crossing.x()); }
    std::uint32_t side() const { return m_side; }
    int           lastLine() const { return m_lastLine; }  // inclusive
    bool          isWide() const { return m_wide; }

private:
    static constexpr std::int64_t kFarAway = std::int64_t{1} << 29;

    EdgeStepper<std::int32_t> m_crossing;  // with the current line's centre
    std::uint32_t             m_polygon;
    int                       m_lastLine;
    std::uint8_t              m_side;
    bool                      m_wide;
};
static_assert(sizeof(ActiveEdge) == 32);

}  // namespace zscope
