// A stripe: whole lines of the picture that one thread draws from start to finish.
#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/base/shortcut.h"
#include "core/depth/visibility_buffer.h"
#include "core/geometry/prepared_scene.h"
#include "core/geometry/projection.h"

namespace zscope {

struct Painter;  // core/shade/painter.h

/// What to draw: the lines [firstRow, endRow) of `visible`. Borrows everything.
struct Stripe {
    const PreparedScene& scene;
    const Projection&    projection;
    FaceCulling          culling;
    VisibilityBuffer&    visible;
    int                  firstRow;
    int                  endRow;
    Progress             progress;                       // only its cancel flag is read
    const Painter*       painter   = nullptr;            // of fragments that are shaded as they come; nullptr: none are
    std::uint64_t        memory    = ~std::uint64_t{0};  // bytes that its edge table may take
    ShortcutSet          shortcuts = {};                 // of the fast text

    PixelBox region() const { return {0, firstRow, visible.width(), endRow}; }
};

}  // namespace zscope
