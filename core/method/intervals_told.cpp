// What the interval scanline says of an interval.
#include <fmt/format.h>

#include "core/method/intervals.h"
#include "core/probe/words.h"

namespace zscope::plain {

std::string IntervalDecided::sentence(const Telling& telling) const
{
    const std::string pixels = x1 - x0 == 1 ? fmt::format("pixel {}", x0) : fmt::format("pixels {} to {}", x0, x1 - 1);
    const std::string where  = fmt::format("Line {}, {} between neighbouring edges: {}", y, pixels,
                                           counted(open.size(), "polygon is open", "polygons are open"));
    const std::string name(telling.polygon());
    const std::string leader = winner ? fmt::format("{} {}", name, grouped(winner->id.value)) : name;
    switch (reason) {
        case IntervalReason::Alone:
            return where + fmt::format(", {}, so all of it is its own without a test.", leader);
        case IntervalReason::Leads:
            return where
                   + fmt::format(
                       "; {} leads all others by more than 2 float32 steps at both ends, so it leads everywhere "
                       "between and wins them all.",
                       leader);
        case IntervalReason::TestedOnce:
            return where + fmt::format("; {} is nearest at the left end and, by a fault, gets them all.", leader);
        case IntervalReason::BeyondFar:
            return where + "; the nearest reaches beyond the far plane, so they are compared pixel by pixel.";
        case IntervalReason::DepthLimited:
            return where + "; a depth is limited to its " + name
                   + "'s corners there, so the ends do not speak for the rest: compared pixel by pixel.";
        case IntervalReason::HasPattern:
            return where
                   + "; the nearest has holes or a relief and covers nothing whole, so they are compared pixel by "
                     "pixel.";
        case IntervalReason::NoClearLead:
            return where
                   + "; none leads by more than 2 float32 steps at both ends, as where they cross or touch: compared "
                     "pixel by pixel.";
        case IntervalReason::NotByEnds:
            return where
                   + "; depths are not stored as they are found, so the ends do not speak for the rest: compared "
                     "pixel by pixel.";
    }
    return where;
}

}  // namespace zscope::plain
