// The boxes of the hierarchy's nodes: where they lie in the world and in the picture, and which of them holds a
// triangle.
//
// Names      a node is named by its tree and its path, which stay the same from step to step; ids do not
// Picture    pixels, y down; lines are cut at the near plane and reach beyond the picture as far as they do
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/prepared_scene.h"
#include "core/hierarchy/tree.h"
#include "core/lesson/explanation.h"
#include "core/lesson/step_state.h"

namespace zscope {

inline NodeName nameOf(const NodeRow& row) { return {row.instance, row.path}; }

/// The row of that name, or -1.
int rowOf(const std::vector<NodeRow>& nodes, const NodeName& name);

/// The eight corners in the world: bit 0 of the index is the larger x, bit 1 y, bit 2 z, in the space of the tree.
std::array<dvec3, 8> cornersOf(const NodeRow& node, const Scene& scene);
/// The twelve edges of such a box, as pairs of corners.
inline constexpr std::array<std::array<int, 2>, 12> kBoxEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

struct ScreenLine {
    double x0, y0, x1, y1;
};
/// What is in front of the near plane of the box's edges.
std::vector<ScreenLine> outlineOf(const NodeRow& node, const Scene& scene, const Camera& camera);
/// The same of the sides of a triangle of the scene; none of an id that the scene does not have.
std::vector<ScreenLine> outlineOf(TriangleId triangle, const Scene& scene, const Camera& camera);

/// What the box could touch in the picture, as culling sees it (core/cull/node_reach.h).
struct NodeOnScreen {
    std::int64_t pixels      = 0;      // of the rectangle, inside the picture
    float        nearest     = 1;      // no depth inside the box is larger
    bool         crossesNear = false;  // then neither means anything
};
NodeOnScreen onScreen(const NodeRow& node, const Scene& scene, const Camera& camera);

/// The triangles (of the mesh tree) or instances (of the tree over them) below the node.
std::uint64_t itemsBelow(const NodeRow& node, const PreparedScene& scene, TreeKind kind);

/// The deepest of `nodes` that holds the triangle; -1 if none does.
int nodeHolding(TriangleId triangle, const std::vector<NodeRow>& nodes, const PreparedScene& scene, TreeKind kind);

/// The node of that path, as far as the tree has been opened; nullptr beyond.
const TreeNode* nodeAt(const Tree& tree, const std::string& path);

}  // namespace zscope
