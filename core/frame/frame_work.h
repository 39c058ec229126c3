// The work behind a frame: counters over the whole of it, and for hierarchical methods what became of the nodes of each
// depth of the hierarchy.
//
// Two trees  the tree over the instances and, below it, the trees over the triangles of the meshes; depth is counted
//            from each root, and all mesh trees share one list
// Sums       visited = outside + hidden + entered + dropped at every depth; summed over depths, every figure is the
//            counter of the same name. A depth pre-pass is counted apart
// Pyramid    updates = cells written on the level of tiles; pyramid_writes and pyramid_levels_updated are the cells
//            written and changed on all levels. An upkeep that pushes writes, on every level above, the cells changed
//            below it
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/stages.h"

namespace zscope {

struct DepthWork {
    bool isInstanceTree = false;  // else the trees of the meshes
    int  depth          = 0;      // 0: a root

    std::uint64_t nodesVisited = 0;
    std::uint64_t nodesOutside = 0, nodesHidden = 0, nodesEntered = 0;
    std::uint64_t nodesDrawn   = 0;  // of those entered: have triangles (or instances) of their own
    std::uint64_t nodesDropped = 0, trianglesDropped = 0;  // too small on the screen: an approximation

    // drawn before the visit, because the last frame saw them; they are visited all the same
    std::uint64_t nodesRecalled = 0;

    std::uint64_t trianglesOutside = 0, trianglesHiddenByNode = 0;  // skipped with a node
    // in nodes drawn or recalled: hidden one by one, or rasterised
    std::uint64_t trianglesHidden = 0, trianglesDrawn = 0;

    std::uint64_t queries = 0, cellsRead = 0;  // of the pyramid, about nodes and about triangles
};

/// What the upkeep of one level of the pyramid took.
struct LevelWork {
    int           level        = 0;
    std::uint64_t cellsWritten = 0;  // computed anew
    std::uint64_t cellsChanged = 0;  // of those: have another value than before
};

struct FrameWork {
    std::vector<NamedCount> counters;
    std::vector<LevelWork>  levels;  // of the pyramid, those that were written, tiles first
    std::vector<DepthWork>  depths;  // the instance tree from its root down, then the mesh trees; empty without a tree
};

}  // namespace zscope
