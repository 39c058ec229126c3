// Where an edge meets the centres of successive lines, exactly: whole subpixels plus a remainder.
//
// Position   x + fraction / dy subpixels, 0 <= fraction < dy; the edge is crossed at line j iff
//            firstLine <= j < endLine, that is Ymin <= 256 j + 128 < Ymax
// Stepping   integer additions only; the remainder is carried, so line 10,000 is as exact as line 0
// Range      32 bits hold every position of an edge inside the guard band, and one step beyond its end; 64 bits hold
//            corners within 2^61 subpixels. Products that need more are done in 64 or 128 bits, once per edge
// Source     docs/correctness.md, Coverage (the same set, for scanline methods)
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "core/geometry/screen_triangle.h"

namespace zscope {

/// Pixel centres lie at 256 j + 128 subpixels.
inline std::int64_t centreOfLine(int line) { return std::int64_t{256} * line + 128; }

/// Lines an edge from ya to yb crosses: [firstLineFrom(ya), firstLineFrom(yb)), empty for a horizontal one.
inline int firstLineFrom(double y) { return firstPixelCentreFrom(y); }

template <class Integer>
class EdgeStepper {
public:
    EdgeStepper() = default;

    /// The edge from (xa, ya) down to (xb, yb), ya < yb, standing at `line`, one of the lines it crosses. `lastLine`
    /// is the last line it will be asked for.
    EdgeStepper(double xa, double ya, double xb, double yb, int line, int lastLine)
    {
        __extension__ using Wide = __int128;
        using Product            = std::conditional_t<sizeof(Integer) == 4, std::int64_t, Wide>;
        const auto    fromX = static_cast<std::int64_t>(xa), fromY = static_cast<std::int64_t>(ya);
        const Product dx = static_cast<std::int64_t>(xb) - fromX, dy = static_cast<std::int64_t>(yb) - fromY;
        m_dy = static_cast<Integer>(dy);
        divide(dx * (centreOfLine(line) - fromY), dy, m_x, m_fraction);
        m_x += static_cast<Integer>(fromX);
        if (lastLine > line) divide(dx * 256, dy, m_stepX, m_stepFraction);
    }

    void nextLine()
    {
        const Integer fraction = m_fraction + m_stepFraction;
        const bool    carries  = fraction >= m_dy;
        m_x += m_stepX + carries;
        m_fraction = carries ? fraction - m_dy : fraction;
    }

    /// A fault: from now on a step is rounded down to whole subpixels.
    void stepByWholeSubpixels() { m_stepFraction = 0; }

    /// The first pixel whose centre is not left of the crossing, limited to +-2^30.
    int firstPixel() const
    {
        const Integer pixel = (m_x + 127 + (m_fraction > 0)) >> 8;
        if constexpr (sizeof(Integer) == 4)
            return pixel;
        else
            return static_cast<int>(std::clamp<Integer>(pixel, -(Integer{1} << 30), Integer{1} << 30));
    }

    /// The crossing in subpixels: rounded down, and the remainder's numerator and denominator.
    Integer x() const { return m_x; }
    Integer fraction() const { return m_fraction; }
    Integer dy() const { return m_dy; }

private:
    /// Rounded towards minus infinity, remainder in [0, by). In the 32-bit case both numbers are exact in float64,
    /// whose division is several times faster and at most one off after truncation: the remainder tells.
    template <class Product>
    static void divide(Product value, Product by, Integer& quotient, Integer& remainder)
    {
        Product q;
        if constexpr (sizeof(Integer) == 4)
            q = static_cast<Product>(static_cast<double>(value) / static_cast<double>(by));
        else
            q = value / by;
        Product r = value - q * by;
        if (r < 0) {
            r += by;
            --q;
        }
        quotient  = static_cast<Integer>(q);
        remainder = static_cast<Integer>(r);
    }

    Integer m_x = 0, m_fraction = 0;
    Integer m_stepX = 0, m_stepFraction = 0;
    Integer m_dy = 1;
};

/// The same edge as an approximation: a float32 that a float32 is added to on every line, rounding errors and all.
class AccumulatedEdge {
public:
    AccumulatedEdge(double xa, double ya, double xb, double yb, int line, int)
        : m_step(static_cast<float>((xb - xa) / (yb - ya) * kSubpixels)),
          m_x(static_cast<float>(xa)
              + m_step * (static_cast<float>(static_cast<double>(centreOfLine(line)) - ya) / 256.0f))
    {}

    void nextLine() { m_x += m_step; }
    void stepByWholeSubpixels() { m_step = std::floor(m_step); }
    int  firstPixel() const { return firstPixelCentreFrom(std::ceil(x32())); }
    /// Subpixels, rounded down.
    std::int64_t x() const { return static_cast<std::int64_t>(std::floor(x32())); }

private:
    /// Far beyond any picture is as good as anywhere there, and fits an integer.
    double x32() const { return std::clamp<double>(m_x, -0x1p40, 0x1p40); }

    float m_step;  // subpixels per line
    float m_x;     // subpixels
};

}  // namespace zscope
