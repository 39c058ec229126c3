// Draws one frame with one thread and one lane and keeps the order in which nodes were opened and judged, or who was
// asked about.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cull/cull_events.h"
#include "core/frame/renderer.h"

namespace zscope::tests {

/// How the children of every octree node were ordered, and in which order nodes were judged.
struct OpenedNode {
    NodePlace                    place;
    std::vector<const TreeNode*> children;    // in the order announced
    std::vector<std::uint64_t>   judgedWhen;  // position of each child's verdict among all verdicts
};
std::vector<OpenedNode> visitOf(const DrawRequest& request);

/// The boxes of triangles: of those that the pyramid was asked about, and of those that were drawn without that.
struct AskedTriangles {
    std::vector<PixelBox> asked, unasked;
};
AskedTriangles askedBy(const DrawRequest& request);

}  // namespace zscope::tests
