// Where an edge meets the centres of successive lines, in fixed point: one addition takes it to the next line, one shift tells the
// pixel, one comparison the order of two edges.
//
// Position   in 1/2^31 subpixel, rounded up; kDrift such units are never reached by what rounding adds up to. A crossing that is no
//            whole subpixel lies at least 1/dy from the next one, which is more as long as dy < kTallest. So subpixel and pixel
//            are those of the exact crossing, on every line
// Order      by position; of two equal ones the edge that closes its triangle comes before one that opens the next, which is what
//            neighbours do at the edge they share. Crossings closer than kDrift units may stand either way
// Range      corners inside the guard band; edges of fewer than kTallest subpixels, or placed anew on every line
// Source     docs/correctness.md, Coverage; core/scan/edge_stepper.h is the same with the remainder carried along
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "core/scan/edge_stepper.h"

namespace zscope {

class LineCrossing {
public:
    /// Height in subpixels from which on an edge cannot step.
    static constexpr std::int64_t kTallest = std::int64_t{1} << 19;

    LineCrossing() = default;

    /// The edge from (xa, ya) down to (xb, yb), at `line`, one of the lines it crosses. All are whole numbers inside the guard
    /// band, yb - ya is at least 1 and less than kTallest. `opens`: it is the left edge of its triangle.
    LineCrossing(double xa, double ya, double xb, double yb, int line, bool opens)
    {
        const double dx = xb - xa, dy = yb - ya;
        assert(dy > 0 && dy < static_cast<double>(kTallest));
        const double perLine = 1 / dy;
        m_x    = inUnits(dx * (static_cast<double>(centreOfLine(line)) - ya), dy, perLine) + (static_cast<std::int64_t>(xa) << kShift) +
              2 - kToPixel + opens;
        m_step = inUnits(dx * kSubpixels, dy, perLine);
    }

    /// A crossing that only stands, `fraction` right of subpixel x, which may be rounded but not to or from 0.
    static LineCrossing standing(std::int64_t x, double fraction, bool opens)
    {
        constexpr auto kOne = std::int64_t{1} << kShift;
        LineCrossing   crossing;
        crossing.m_x = (x << kShift) - kToPixel + opens;
        if (fraction > 0) crossing.m_x += std::clamp(static_cast<std::int64_t>(fraction * 0x1p31) << 1, kDrift, kOne - 2);
        return crossing;
    }

    void nextLine() { m_x += m_step; }

    /// The first pixel whose centre is not left of the crossing.
    int firstPixel() const { return static_cast<int>(m_x >> (kShift + 8)); }
    /// The crossing in subpixels, rounded down.
    std::int64_t x() const { return (m_x + kToPixel) >> kShift; }
    bool         isLeftOf(const LineCrossing& other) const { return m_x < other.m_x; }

private:
    static constexpr int          kShift = 32;                    // the lowest bit tells who closes and who opens
    static constexpr std::int64_t kDrift = std::int64_t{1} << 13; // twice 4096: an edge of kTallest crosses 2048 lines
    static_assert(kDrift * kTallest <= std::int64_t{1} << kShift);
    /// What is taken from a position so that its upper bits are the pixel.
    static constexpr std::int64_t kToPixel = kDrift - (std::int64_t{128} << kShift);

    /// value / by in units, by at most one unit (two in the lowest bit) too large. Both are whole numbers that float64 holds;
    /// `inverse` is 1 / by.
    static std::int64_t inUnits(double value, double by, double inverse)
    {
        // The quotient may be one off, or is the next towards zero; what remains of the value is exact in any case.
        const auto   whole = static_cast<std::int64_t>(value * inverse);
        const double rest  = value - static_cast<double>(whole) * by;
        // Two wholes more, so that what is cut off is a rounding down; and one unit, so that it is up.
        const auto part = static_cast<std::int64_t>((rest * inverse + 2) * 0x1p31) + 1;
        return ((whole - 2) << kShift) + (part << 1);
    }

    std::int64_t m_x    = 0;  // less kToPixel; the lowest bit: it opens
    std::int64_t m_step = 0;  // even
};

}  // namespace zscope
