// Where an edge meets the centres of successive lines, in fixed point: one addition takes it to the next line, one
// shift tells the pixel, one comparison the order of two edges.
//
// Position   in 1/2^31 subpixel, rounded up; kDrift such units are never reached by what rounding adds up to. A
//            crossing that is no whole subpixel lies at least 1/dy from the next one, which is more as long as dy <
//            kTallest. So subpixel and pixel are those of the exact crossing, on every line
// Order      by position; of two equal ones the edge that closes its triangle comes before one that opens the next,
//            which is what neighbours do at the edge they share. Crossings closer than kDrift units may stand either
//            way
// Range      corners inside the guard band; edges of fewer than kTallest subpixels, or placed anew on every line
// Source     docs/correctness.md, Coverage; core/scan/edge_stepper.h is the same with the remainder carried along
#pragma once

#include <algorithm>
#include <cstdint>

namespace zscope {

class LineCrossing {
public:
    /// Height in subpixels from which on an edge cannot step.
    static constexpr std::int64_t kTallest = std::int64_t{1} << 19;

    LineCrossing() = default;

    /// A position and what is added to it on every line, as crossingsOf() finds them
    /// (core/fast/lanes/enter_edges-inl.h).
    LineCrossing(std::int64_t x, std::int64_t step) : m_x(x), m_step(step) {}

    /// A crossing that only stands, `fraction` right of subpixel x, which may be rounded but not to or from 0.
    static LineCrossing standing(std::int64_t x, double fraction, bool opens)
    {
        constexpr auto kOne = std::int64_t{1} << kShift;
        LineCrossing   crossing;
        crossing.m_x = (x << kShift) - kToPixel + opens;
        if (fraction > 0)
            crossing.m_x += std::clamp(static_cast<std::int64_t>(fraction * 0x1p31) << 1, kDrift, kOne - 2);
        return crossing;
    }

    LineCrossing onNextLine() const { return {m_x + m_step, m_step}; }

    /// The first pixel whose centre is not left of the crossing.
    int firstPixel() const { return static_cast<int>(m_x >> kToColumn); }
    /// The same in 1/2^bits pixel.
    std::int64_t column(int bits) const { return m_x >> (kToColumn - bits); }
    /// The crossing in subpixels, rounded down.
    std::int64_t x() const { return (m_x + kToPixel) >> kShift; }
    bool         isLeftOf(const LineCrossing& other) const { return m_x < other.m_x; }

    static constexpr int          kShift    = 32;                  // the lowest bit tells who closes and who opens
    static constexpr int          kToColumn = kShift + 8;          // from a position to its pixel
    static constexpr std::int64_t kDrift = std::int64_t{1} << 13;  // twice 4096: an edge of kTallest crosses 2048 lines
    static_assert(kDrift * kTallest <= std::int64_t{1} << kShift);
    /// What is taken from a position so that its upper bits are the pixel.
    static constexpr std::int64_t kToPixel = kDrift - (std::int64_t{128} << kShift);

private:
    std::int64_t m_x    = 0;  // less kToPixel; the lowest bit: it opens
    std::int64_t m_step = 0;  // even
};

}  // namespace zscope
