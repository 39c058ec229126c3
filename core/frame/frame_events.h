// What a frame tells of itself: its stages and its end.
#pragma once

#include "core/base/stages.h"
#include "core/probe/about.h"
#include "core/probe/grain.h"

namespace zscope {

struct StageStarted {
    Stage stage;
};

struct StageFinished {
    static constexpr Grain grain = Grain::Stage;
    Stage                  stage;

    About about() const { return {.stage = stage}; }
};

/// The picture is finished.
struct FrameFinished {
    static constexpr Grain grain = Grain::Frame;

    About about() const { return {}; }
};

}  // namespace zscope
