// Where a frame's time goes: laps between stages, per thread.
//
// Units      laps are counted in the processor's ticks; how long a tick is follows from the clock's whole life
//            (core/base/ticks.h)
// Cost       one look at the processor's counter per lap (about 8 ns); laps are taken per batch or coarser, never per
//            triangle
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

#include "core/base/stages.h"
#include "core/base/ticks.h"

namespace zscope {

using StageMs = std::array<double, kStages.size()>;

class StageClock {
public:
    /// Everything since the last lap (or the start) was `stage`, or the stage that all laps are counted as.
    void lap(Stage stage)
    {
        const std::uint64_t now = ticksNow();
        m_ticks[static_cast<std::size_t>(m_all.value_or(stage))] += now - m_last;
        m_last = now;
    }

    /// Count all laps from here on as one stage (a pre-pass transforms, sets up and rasterises); nothing: as they come.
    void countAllAs(std::optional<Stage> stage) { m_all = stage; }

    /// What the laps so far took.
    StageMs ms() const
    {
        const double ms = std::chrono::duration<double, std::milli>(Clock::now() - m_start).count();
        // Signed: where processors' counters differ, a thread that moves from one to another may see its own go back.
        const auto   signedTicks = [](std::uint64_t t) { return static_cast<double>(static_cast<std::int64_t>(t)); };
        const double ticks       = signedTicks(ticksNow() - m_startTicks);
        StageMs      stages{};
        for (std::size_t i = 0; i < stages.size() && ticks > 0; ++i)
            stages[i] = std::clamp(signedTicks(m_ticks[i]) * (ms / ticks), 0.0, ms);
        return stages;
    }

private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point                         m_start      = Clock::now();
    std::uint64_t                             m_startTicks = ticksNow(), m_last = m_startTicks;
    std::array<std::uint64_t, kStages.size()> m_ticks{};
    std::optional<Stage>                      m_all;
};

}  // namespace zscope
