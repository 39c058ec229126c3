// A z-buffer as a careful student writes it, which shares nothing with ZScope but the scene: float32 matrices and
// vertices, clipping at the near plane in clip space, and either a grid of 1/256 pixel or no snapping at all. What it
// draws differs from the reference by rounding alone.
#pragma once

#include <functional>

#include "core/depth/visibility_buffer.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope::tests {

enum class Grid8 { Snapped, Unsnapped };

/// One mistake, to be found by a test; none by default.
struct CarefulRenderer {
    Grid8       grid         = Grid8::Snapped;
    FaceCulling culling      = FaceCulling::None;
    double      centre       = 0.5;    // of a pixel; 0: the mistake of counting from corners
    bool        ownsAllEdges = false;  // no fill rule: samples on an edge belong to both

    Picture draw(const Scene& scene, const Camera& camera) const;
};

}  // namespace zscope::tests
