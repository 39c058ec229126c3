#include "core/frame/frame_events.h"

#include <fmt/format.h>

#include "core/probe/words.h"

namespace zscope {

std::string StageFinished::sentence(const Telling& telling) const
{
    if (says) return says(made);
    switch (stage) {
        case Stage::Clear:
            return "The picture is cleared: every pixel is background, farther than anything that may be kept.";
        case Stage::Raster:
            return fmt::format("Every pixel is decided: {} a triangle, the nearest that covers it.",
                               counted(telling.coveredPixels(), "pixel shows", "pixels show"));
        case Stage::Shade:
            return fmt::format("{} taken the colour of its triangle, once.",
                               counted(telling.coveredPixels(), "covered pixel has", "covered pixels have each"));
        default:
            return fmt::format("The stage '{}' is over.", wordOf(stage));
    }
}

std::string FrameFinished::sentence(const Telling& telling) const
{
    return fmt::format("The picture is finished: {} one of {}.",
                       counted(telling.coveredPixels(), "pixel shows", "pixels show"),
                       counted(telling.triangles(), "triangle", "triangles"));
}

}  // namespace zscope
