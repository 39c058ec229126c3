// Counts the steps of every grain, so that whatever a recorder notes can be found again in a timeline.
//
// Order      must hear an event before the recorders that ask it
// Steps      as Replay counts them: those of a grain and of all coarser ones
#pragma once

#include <numeric>

#include "core/lesson/explanation.h"
#include "core/probe/recorders.h"

namespace zscope {

class StepCounter {
public:
    void hear(const Heard& heard)
    {
        if (heard.kind.grain) ++m_events[static_cast<std::size_t>(*heard.kind.grain)];
    }

    /// How many steps of a grain there have been.
    std::uint64_t seen(Grain grain) const
    {
        const auto end = m_events.begin() + static_cast<std::ptrdiff_t>(grain) + 1;
        return std::accumulate(m_events.begin(), end, std::uint64_t{0});
    }
    /// Of an event that is no step, or of what has just happened between two: the next step shows it.
    Moment next() const { return moment(kGrains.size()); }
    /// Of an event that is being heard right now: it is a step of its own grain and of finer ones.
    Moment of(const Heard& heard) const
    {
        return heard.kind.grain ? moment(static_cast<std::size_t>(*heard.kind.grain)) : next();
    }

private:
    Moment moment(std::size_t own) const
    {
        Moment        moment;
        std::uint64_t seen = 0;
        for (std::size_t grain = 0; grain < m_events.size(); ++grain) {
            seen += m_events[grain];
            moment.steps[grain] = grain >= own ? seen - 1 : seen;
        }
        return moment;
    }

    std::array<std::uint64_t, kGrains.size()> m_events{};
};

}  // namespace zscope
