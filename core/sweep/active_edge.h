// One row of the active edge table: 32 bytes, so that stepping and sorting a line's edges stays in the nearest cache.
//
// Wide       an edge beyond the guard band does not fit 32 bits: it is placed anew on every line by the 64-bit stepper,
//            and stands at most kFarAway subpixels from the picture's left border, which is outside in any case
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/geometry/screen_face.h"
#include "core/scan/edge_stepper.h"

namespace zscope {

/// What decides whether a place is inside a polygon.
enum class Inside : std::uint8_t {
    EvenOdd,     // its sides have been passed an odd number of times
    AnyWinding,  // its sides wind round the place, whichever way
};

class ActiveEdge {
public:
    static constexpr std::uint32_t kMaxIndex = (1u << 29) - 1;

    /// `side` at `line`, owned by `polygon`. `index`: its place in the edge table, at most kMaxIndex.
    ActiveEdge(const ScreenSide& side, Inside rule, bool wide, std::uint32_t polygon, std::uint32_t index, int line, int lastLine)
        : m_polygon(polygon),
          m_lastLine(lastLine),
          m_index(index & kMaxIndex),
          m_wide(wide),
          m_evenOdd(rule == Inside::EvenOdd),
          m_runsDown(side.ya < side.yb)
    {
        if (m_wide)
            placeWide(side, line);
        else
            m_crossing = stepper<std::int32_t>(side, line, lastLine);
    }

    void nextLine() { m_crossing.nextLine(); }
    /// For wide edges only, instead of nextLine().
    void placeWide(const ScreenSide& side, int line)
    {
        const EdgeStepper<std::int64_t> exact = stepper<std::int64_t>(side, line, line);
        const std::int64_t              x     = std::clamp(exact.x(), -kFarAway, kFarAway);
        m_crossing = EdgeStepper<std::int32_t>::standing(static_cast<std::int32_t>(x), x == exact.x() && exact.fraction() > 0);
    }

    /// The exact stepper of a side at a line it crosses, computed from its ends.
    template <class Integer>
    static EdgeStepper<Integer> stepper(const ScreenSide& side, int line, int lastLine)
    {
        if (side.ya < side.yb) return {side.xa, side.ya, side.xb, side.yb, line, lastLine};
        return {side.xb, side.yb, side.xa, side.ya, line, lastLine};
    }

    /// In the edge table: the index of the part. In the active edge table: the row of the active polygon table.
    std::uint32_t polygon() const { return m_polygon; }
    void          setPolygon(std::uint32_t row) { m_polygon = row; }

    bool          isLeftOf(const ActiveEdge& other) const { return m_crossing.isLeftOf(other.m_crossing); }
    int           firstPixel() const { return m_crossing.firstPixel(); }
    template <class Rules>
    int firstPixel(const Rules& rules) const { return rules.firstPixel(m_crossing.firstPixel(), m_crossing.x()); }
    std::uint32_t index() const { return m_index; }
    int           lastLine() const { return m_lastLine; }  // inclusive
    bool          isWide() const { return m_wide; }
    /// What passing the edge from left to right adds to its polygon's winding, which is 0 outside: a turn one way or the
    /// other; by the even-odd rule a half of all there is, so that twice is nothing.
    std::uint32_t winding() const { return m_evenOdd ? 1u << 31 : m_runsDown ? 1u : ~0u; }

private:
    static constexpr std::int64_t kFarAway = std::int64_t{1} << 29;

    EdgeStepper<std::int32_t> m_crossing;  // with the current line's centre
    std::uint32_t             m_polygon;
    int                       m_lastLine;
    std::uint32_t             m_index : 29;
    bool                      m_wide : 1;
    bool                      m_evenOdd : 1;
    bool                      m_runsDown : 1;
};
static_assert(sizeof(ActiveEdge) == 32);

}  // namespace zscope
