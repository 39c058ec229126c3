// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture shows of each pixel: the layer, and of depths the range.
#pragma once

#include "core/lesson/layers.h"

namespace zscope::ui {

struct Look {
    const Layer* layer = &zscope::layers().front();
    DepthRange   range;  // of the layer of depths

    bool        isShaded() const { return layer == &zscope::layers().front(); }
    friend bool operator==(const Look&, const Look&) = default;
};

}  // namespace zscope::ui
