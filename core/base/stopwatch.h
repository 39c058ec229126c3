// How long something took, in milliseconds of a clock that never goes back.
#pragma once

#include <chrono>

namespace zscope {

class Stopwatch {
public:
    /// Since it was made, or since the last lap.
    double lap()
    {
        const Clock::time_point now = Clock::now();
        const double            ms  = std::chrono::duration<double, std::milli>(now - m_start).count();
        m_start                     = now;
        return ms;
    }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point m_start = Clock::now();
};

}  // namespace zscope
