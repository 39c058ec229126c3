// Where a frame's time goes: laps between stages, per thread.
//
// Cost       one clock reading per lap (about 25 ns); laps are taken per batch or coarser, never per triangle
#pragma once

#include <array>
#include <chrono>
#include <optional>

#include "core/base/stages.h"

namespace zscope {

using StageMs = std::array<double, kStages.size()>;

class StageClock {
public:
    StageClock() : m_last(Clock::now()) {}

    /// Everything since the last lap (or the start) was `stage`, or the stage that all laps are counted as.
    void lap(Stage stage)
    {
        const Clock::time_point now = Clock::now();
        m_ms[static_cast<std::size_t>(m_all.value_or(stage))] += std::chrono::duration<double, std::milli>(now - m_last).count();
        m_last = now;
    }

    /// Count all laps from here on as one stage (a pre-pass transforms, sets up and rasterises); nothing: as they come.
    void countAllAs(std::optional<Stage> stage) { m_all = stage; }

    const StageMs& ms() const { return m_ms; }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point    m_last;
    StageMs              m_ms{};
    std::optional<Stage> m_all;
};

}  // namespace zscope
