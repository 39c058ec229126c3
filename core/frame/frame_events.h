// What a frame tells of itself: its stages and its end.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/stages.h"
#include "core/probe/about.h"
#include "core/probe/grain.h"
#include "core/probe/telling.h"

namespace zscope {

struct StageStarted {
    Stage stage;
};

struct StageFinished {
    static constexpr Grain grain = Grain::Stage;
    using Says                   = std::string(std::uint64_t made);
    Stage         stage;
    Says*         says = nullptr;  // what it came to in the method's words; nullptr: in any method's
    std::uint64_t made = 0;        // what `says` counts

    About       about() const { return {.stage = stage}; }
    std::string sentence(const Telling& telling) const;
};

/// The picture is finished.
struct FrameFinished {
    static constexpr Grain grain = Grain::Frame;

    About       about() const { return {}; }
    std::string sentence(const Telling& telling) const;
};

}  // namespace zscope
