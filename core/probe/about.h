// What an event is about, in words that do not depend on its type: what a lesson's stop can name.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/ids.h"
#include "core/base/stages.h"
#include "core/geometry/pixel_box.h"

namespace zscope {

struct NodePlace;  // core/cull/cull_events.h

/// Nothing (or an empty word): the event says nothing of that.
struct About {
    std::optional<int>        line     = {};
    std::optional<PixelBox>   pixels   = {};
    std::optional<TriangleId> triangle = {};
    const NodePlace*          node     = nullptr;  // valid as long as the event
    std::optional<Stage>      stage    = {};
    std::string_view          verdict  = {};  // over a node
    std::optional<bool>       hidden   = {};  // the answer to a question
    std::optional<int>        level    = {};  // of the pyramid: a cell of it was written
    std::string_view          interval = {};  // why it was decided so
    std::optional<bool>       won      = {};  // a depth test
};

}  // namespace zscope
