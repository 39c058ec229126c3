// Where an edge meets the centres of successive lines, exactly: whole subpixels plus a remainder.
//
// Position   x + fraction / dy subpixels, 0 <= fraction < dy; the edge is crossed at line j iff
//            firstLine <= j < endLine, that is Ymin <= 256 j + 128 < Ymax
// Stepping   integer additions only; the remainder is carried, so line 10,000 is as exact as line 0
// Range      corners within 2^61 subpixels; products that need more than 64 bits are done in 128, once per edge
// Source     docs/correctness.md, Coverage (the same set, for scanline methods)
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/geometry/screen_triangle.h"

namespace zscope {

/// Pixel centres lie at 256 j + 128 subpixels.
inline std::int64_t centreOfLine(int line) { return std::int64_t{256} * line + 128; }

class EdgeStepper {
public:
    EdgeStepper() = default;

    /// The edge from (xa, ya) to (xb, yb), ya < yb, standing at `line`, one of the lines it crosses. `lastLine`
    /// is the last line it will be asked for.
    EdgeStepper(double xa, double ya, double xb, double yb, int line, int lastLine)
    {
        __extension__ using Wide = __int128;
        const auto toX = static_cast<std::int64_t>(xa), toY = static_cast<std::int64_t>(ya);
        const std::int64_t dx = static_cast<std::int64_t>(xb) - toX;
        m_dy                  = static_cast<std::int64_t>(yb) - toY;
        const std::int64_t down = centreOfLine(line) - toY;
        const bool fits = std::abs(dx) < kProductLimit && m_dy < kProductLimit;

        if (fits) {
            divide(dx * down, m_dy, m_x, m_fraction);
            if (lastLine > line) divide(dx * 256, m_dy, m_stepX, m_stepFraction);
        } else {
            divide(Wide{dx} * down, Wide{m_dy}, m_x, m_fraction);
            if (lastLine > line) divide(Wide{dx} * 256, Wide{m_dy}, m_stepX, m_stepFraction);
        }
        m_x += toX;
    }

    void nextLine()
    {
        m_x += m_stepX;
        m_fraction += m_stepFraction;
        if (m_fraction >= m_dy) {
            m_fraction -= m_dy;
            ++m_x;
        }
    }

    /// The first pixel whose centre is not left of the crossing, limited to +-2^30.
    int firstPixel() const
    {
        const std::int64_t pixel = (m_x - 128 + 255 + (m_fraction > 0)) >> 8;
        return static_cast<int>(std::clamp<std::int64_t>(pixel, -(std::int64_t{1} << 30), std::int64_t{1} << 30));
    }

    /// The crossing in subpixels: rounded down, and the remainder's numerator and denominator.
    std::int64_t x() const { return m_x; }
    std::int64_t fraction() const { return m_fraction; }
    std::int64_t dy() const { return m_dy; }

    /// Strictly left of `other` on the current line, compared exactly.
    bool isLeftOf(const EdgeStepper& other) const
    {
        if (m_x != other.m_x) return m_x < other.m_x;
        __extension__ using Wide = __int128;
        return Wide{m_fraction} * other.m_dy < Wide{other.m_fraction} * m_dy;
    }

private:
    static constexpr std::int64_t kProductLimit = std::int64_t{1} << 31;  // two factors below it fit 64 bits

    /// Rounded towards minus infinity, remainder in [0, by).
    template <class Integer>
    static void divide(Integer value, Integer by, std::int64_t& quotient, std::int64_t& remainder)
    {
        Integer q = value / by, r = value % by;
        if (r < 0) {
            r += by;
            --q;
        }
        quotient  = static_cast<std::int64_t>(q);
        remainder = static_cast<std::int64_t>(r);
    }

    std::int64_t m_x = 0, m_fraction = 0;
    std::int64_t m_stepX = 0, m_stepFraction = 0;
    std::int64_t m_dy = 1;
};

/// Lines an edge from ya to yb crosses: [firstLine(ya), firstLine(yb)), empty for a horizontal one.
inline int firstLineFrom(double y) { return firstPixelCentreFrom(y); }

}  // namespace zscope
