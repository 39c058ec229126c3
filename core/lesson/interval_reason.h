// The words of interval decisions, in JSON.
#pragma once

#include <string_view>

#include "core/sweep/sweep_events.h"

namespace zscope {

constexpr std::string_view wordOf(IntervalReason reason)
{
    switch (reason) {
        case IntervalReason::Alone:
            return "alone";
        case IntervalReason::Leads:
            return "leads";
        case IntervalReason::TestedOnce:
            return "tested-once";
        case IntervalReason::BeyondFar:
            return "beyond-far";
        case IntervalReason::DepthLimited:
            return "depth-limited";
        case IntervalReason::HasPattern:
            return "has-pattern";
        case IntervalReason::NoClearLead:
            return "no-clear-lead";
        case IntervalReason::NotByEnds:
            return "not-by-ends";
    }
    return {};
}

}  // namespace zscope
