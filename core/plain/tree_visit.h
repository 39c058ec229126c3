// The two-level hierarchy of a scene, for a visit from near to far.
//
// Order      octree: the eye's octant first, then the octants across one splitting plane, two, three. What straddles
//            the planes comes before the first octant whose box is farther from the eye. BVH: the nearer box first.
//            Instances and batches of one node: the nearer box first
// Space      an affine placement keeps planes planes, so the eye is taken into the tree's own space
// Source     Greene, Kass, Miller: Hierarchical Z-Buffer Visibility, SIGGRAPH 1993
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/cull/cull_events.h"
#include "core/geometry/placed_view.h"
#include "core/geometry/set_up.h"
#include "core/hierarchy/scene_trees.h"
#include "core/plain/placed_node.h"
#include "core/plain/work.h"

namespace zscope::plain {

/// One tree as it is placed in the world, seen from the eye.
struct PlacedTree {
    const Tree&   tree;
    const Affine& toWorld;
    PlacedView    view;
    dvec3         eye;  // in the tree's own space
    InstanceId    instance;
    bool          isInstanceTree;

    NodePlace place(const TreeNode& node) const { return {isInstanceTree, instance, tree, node}; }
};

class TreeVisit {
public:
    TreeVisit(Work& work, const SceneTrees& trees);

    const SceneTrees&   trees() const { return m_trees; }
    const StripeVolume& volume() const { return m_volume; }

    /// The root of the tree over the instances; nothing of an empty scene.
    std::span<const PlacedNode> roots();
    /// Valid until the next call with a node of another instance.
    const PlacedTree& treeOf(const PlacedNode& node);

    /// Divides the node, if that has not been done, and reports its children. Farthest first, as a stack wants them:
    /// the children, then, of the tree over the instances, the roots of the node's own instances, which come before
    /// the children. Valid until the next call.
    std::span<const PlacedNode> childrenFarthestFirst(const PlacedNode& node);
    /// The node's own triangles as batches, the nearest box first; valid until the next call. The node is of a mesh
    /// tree and has been divided.
    std::span<const BatchPlace> batchesNearestFirst(const PlacedNode& node);
    bool                        hasOwnItems(const PlacedNode& node);

private:
    PlacedTree placed(const Tree& tree, const Affine& toWorld, bool isInstanceTree, InstanceId instance) const;

    Work&                     m_work;
    const Scene&              m_scene;
    const SceneTrees&         m_trees;
    StripeVolume              m_volume;
    Affine                    m_world;      // the identity
    PlacedTree                m_instances;  // the tree over the instances
    std::optional<PlacedTree> m_mesh;       // the mesh tree asked for last
    std::vector<PlacedNode>   m_nodes;
    std::vector<BatchPlace>   m_batches;
};

}  // namespace zscope::plain
