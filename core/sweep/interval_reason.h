// How the pixels between two neighbouring active edges were decided.
#pragma once

#include <string_view>

namespace zscope {

/// Why an interval went to one polygon as a whole, or could not.
enum class IntervalReason {
    Alone,         // to the only polygon that is open
    Leads,         // to the one that leads all others at both ends by more than the rounding can hide
    TestedOnce,    // to the nearest at the left end (a fault)
    BeyondFar,     // to nobody as a whole: part of the nearest lies beyond far
    DepthLimited,  // the depth of one is limited to its corners', so it is not affine
    HasPattern,    // the nearest at the left end has holes or a relief, so it covers nothing whole
    NoClearLead,   // nobody leads at both ends: they cross, touch or are equally near
    NotByEnds,     // depths as they are stored are not affine (an approximation)
};

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
