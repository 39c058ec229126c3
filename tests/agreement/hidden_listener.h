// Draws one frame with one thread and one lane and hands every event to a listener of the test's.
#pragma once

#include <cstdint>
#include <vector>

#include "core/cull/cull_events.h"
#include "core/frame/renderer.h"

namespace zscope::tests {

/// What culling by node and by triangle left out of one frame.
struct Culled {
    std::vector<bool> byNode;      // by triangle id: below a node that was hidden or outside
    std::vector<bool> byTriangle;  // every part of it that reached the pixels' side was called hidden
    std::uint64_t     nodesHidden = 0, nodesOutside = 0, trianglesHidden = 0, hiddenByNode = 0;
};
Culled culledBy(const DrawRequest& request);

/// How the children of every octree node were ordered, and in which order nodes were judged.
struct OpenedNode {
    NodePlace                    place;
    std::vector<const TreeNode*> children;   // in the order announced
    std::vector<std::uint64_t>   judgedWhen; // position of each child's verdict among all verdicts
};
std::vector<OpenedNode> visitOf(const DrawRequest& request);

}  // namespace zscope::tests
