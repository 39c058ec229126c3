// How many frames a run is timed: a number of them, and more if these were over sooner than a time that was asked for.
//
// Why        thirty frames of half a millisecond are over in fifteen: whatever the machine does for a moment is all
//            that their median knows
// Promise    at least `frames` frames, and no more than it takes to fill `leastMs`, or kMost
#pragma once

#include <cstddef>

namespace zscope {

class FrameQuota {
public:
    static constexpr std::size_t kMost = 100'000;  // frames that a time may ask for

    /// `leastMs` in ms, 0 or more: what the frames take together.
    FrameQuota(int frames, double leastMs) : m_frames(static_cast<std::size_t>(frames)), m_leastMs(leastMs) {}

    bool wantsMore() const { return m_drawn < m_frames || (m_spentMs < m_leastMs && m_drawn < kMost); }
    void drawn(double ms) { ++m_drawn, m_spentMs += ms; }

private:
    std::size_t m_frames;
    double      m_leastMs;
    std::size_t m_drawn   = 0;
    double      m_spentMs = 0;
};

}  // namespace zscope
