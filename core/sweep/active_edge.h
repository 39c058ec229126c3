// One row of the active edge table: 32 bytes, so that stepping and sorting a line's edges stays in the nearest cache.
//
// Shared     an edge where one triangle closes and the next one opens (shared_sides.h): only where nobody looks on
// Wide       an edge that reaches beyond the guard band, or is too tall to step without its rounding being seen, is
//            placed anew on every line by the 64-bit stepper, and stands at most kFarAway subpixels from the picture's
//            left border, which is outside in any case
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/geometry/screen_face.h"
#include "core/scan/edge_stepper.h"
#include "core/sweep/line_crossing.h"

namespace zscope {

/// What decides whether a place is inside a polygon.
enum class Inside : std::uint8_t {
    EvenOdd,     // its sides have been passed an odd number of times
    AnyWinding,  // its sides wind round the place, whichever way
};

class alignas(32) ActiveEdge {
public:
    static constexpr std::uint32_t kMaxPlace = (1u << 30) - 1;

    ActiveEdge() = default;

    /// An edge of `polygon`, a part of the edge table. `side`: its place there, at most kMaxPlace; of no matter for an
    /// edge that is not wide and that nobody looks at.
    ActiveEdge(LineCrossing crossing, std::uint32_t polygon, int lastLine, std::uint32_t side, std::uint32_t winding)
        : m_crossing(crossing), m_polygon(polygon), m_lastLine(lastLine), m_place(side & kMaxPlace), m_winding(winding)
    {}
    /// A wide one: `side` stands at `place` in the edge table.
    ActiveEdge(const ScreenSide& side, std::uint32_t polygon, int line, int lastLine, std::uint32_t place,
               std::uint32_t winding)
        : ActiveEdge(placed(side, line), polygon, lastLine, place, winding)
    {
        m_place |= kWide;
    }

    /// From what lanes have put together: its crossing's position and step, its polygon, and what a shared one opens
    /// (shared()), each of these two with 32 bits more above it: its last line, and its winding.
    using Row = std::array<std::int64_t, 4>;
    explicit ActiveEdge(const Row& row) : ActiveEdge(std::bit_cast<ActiveEdge>(row)) {}
    /// What says that an edge opens that part, too.
    static constexpr std::uint32_t shared(std::uint32_t opens) { return opens | kShared; }

    /// True if such a side must be wide.
    static bool isTooTall(const ScreenSide& side)
    {
        return std::abs(side.ya - side.yb) >= static_cast<double>(LineCrossing::kTallest);
    }

    /// Where it meets the line at hand.
    LineCrossing crossing() const { return m_crossing; }
    void         standAt(LineCrossing crossing) { m_crossing = crossing; }
    /// Where a wide edge meets a line that it crosses; the others step.
    static LineCrossing placed(const ScreenSide& side, int line)
    {
        const EdgeStepper<std::int64_t> exact = stepper<std::int64_t>(side, line, line);
        const std::int64_t              x     = std::clamp(exact.x(), -kFarAway, kFarAway);
        const double fraction                 = static_cast<double>(exact.fraction()) / static_cast<double>(exact.dy());
        return LineCrossing::standing(x, fraction, side.ya > side.yb);
    }

    /// The exact stepper of a side at a line it crosses, computed from its ends.
    template <class Integer>
    static EdgeStepper<Integer> stepper(const ScreenSide& side, int line, int lastLine)
    {
        if (side.ya < side.yb) return {side.xa, side.ya, side.xb, side.yb, line, lastLine};
        return {side.xb, side.yb, side.xa, side.ya, line, lastLine};
    }

    /// The index of its part in the edge table: the one that it closes, if it is shared.
    std::uint32_t polygon() const { return m_polygon; }
    bool          isShared() const { return (m_place & kShared) != 0; }
    /// Of a shared edge: the part that it opens.
    std::uint32_t opens() const { return m_place & kMaxPlace; }

    bool          isLeftOf(const ActiveEdge& other) const { return m_crossing.isLeftOf(other.m_crossing); }
    int           firstPixel() const { return m_crossing.firstPixel(); }
    std::uint32_t side() const { return m_place & kMaxPlace; }
    int           lastLine() const { return m_lastLine; }  // inclusive
    bool          isWide() const { return (m_place & kWide) != 0; }
    std::uint32_t winding() const { return m_winding; }

    /// What passing an edge from left to right adds to its polygon's winding, which is 0 outside: a turn one way or the
    /// other; by the even-odd rule a half of all there is, so that twice is nothing.
    static constexpr std::uint32_t windingOf(Inside rule, bool runsDown)
    {
        return rule == Inside::EvenOdd ? 1u << 31 : runsDown ? 1u : ~0u;
    }

private:
    static constexpr std::uint32_t kShared = kMaxPlace + 1, kWide = kShared << 1;
    static constexpr std::int64_t  kFarAway = std::int64_t{1} << 29;

    LineCrossing  m_crossing;  // with the current line's centre
    std::uint32_t m_polygon  = 0;
    int           m_lastLine = 0;
    // in the edge table: of its side, or of the part that it opens; and whether it is shared, or wide
    std::uint32_t m_place   = 0;
    std::uint32_t m_winding = 0;
};
static_assert(sizeof(ActiveEdge) == 32);

}  // namespace zscope
