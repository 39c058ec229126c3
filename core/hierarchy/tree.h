// A hierarchy of boxes over numbered items (the triangles of a mesh, or the instances of a scene).
//
// Octree     an item goes down while one octant contains it whole, else it stays in the node. What stays is kept in
//            nodes of its own beside the octants (`straddles`), each with a box of its own: one if it is little, else
//            one for each set of splitting planes that its items cross; a large one is halved like a BVH
// BVH        halves by the surface area heuristic
// Nodes      only nodes without children hold items. `bounds` is the box of all items below, not the cell; a ball about
//            its middle holds them, too, and is the smaller one where what is round has been turned
// Lazy       a node is divided when it is first opened, and stays so: a part of the scene that nobody looks at is
//            never divided. Any thread may open nodes
// Names      a node is named by its path from the root, whatever order the nodes were opened in: pathOf()
// Promise    deterministic for a given order of items; depth at most kMaxDepth; every item is in exactly one node
// Cost       dividing is linear in the node's items; memory linear in the items
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/batches.h"
#include "core/scene/mesh.h"

namespace zscope {

enum class TreeKind { Octree, Bvh };

/// Where the items' boxes come from.
class ItemBoxes {
public:
    virtual ~ItemBoxes()                                  = default;
    virtual std::uint32_t count() const                   = 0;
    virtual Bounds        boxOf(std::uint32_t item) const = 0;
    /// The square of how far the item reaches from there; at least that.
    virtual double squaredReach(std::uint32_t item, const dvec3& from) const
    {
        const Bounds box = boxOf(item);
        if (box.isEmpty()) return 0;
        const dvec3 far = glm::max(glm::abs(box.min - from), glm::abs(box.max - from));
        return glm::dot(far, far);
    }
    virtual std::uint64_t bytes() const { return 0; }
};

struct TreeNode {
    static constexpr int kOctants = 8;
    static constexpr int kSlots   = 27;  // per axis: below the splitting plane, above it, across it

    // What a visit reads of a node that it does not enter stands first, on one or two cache lines.
    Bounds bounds;  // of everything below
    // of a ball about the middle of `bounds` that holds everything below; infinite: not known
    double        radius = 0;
    std::uint32_t first = 0, end = 0;  // of Tree::items: everything below
    // which child of its parent: octants and halves from 0 on, what straddles from kOctants on
    int  slot      = 0;
    int  depth     = 0;
    bool straddles = false;  // octree: no octant of the node that was divided by planes contains its items

    // Written once, when the node is opened.
    std::atomic<bool>           isOpen     = false;
    std::atomic<bool>           hasBatches = false, hasAllBatches = false;  // see `batches`
    int                         childCount = 0;
    std::uint32_t               ownEnd     = 0;  // items [first, ownEnd) belong to no child: all of them, or none
    std::unique_ptr<TreeNode[]> children;

    // Mesh trees: the batches of its own items, and those of everything below, made when they are first drawn.
    std::unique_ptr<const MeshBatches> batches, allBatches;

    const TreeNode* parent = nullptr;  // of the root
    Bounds          cell;              // octree: the box that is cut in octants; of a straddling node: its parent's

    std::uint32_t size() const { return end - first; }
};

/// "0.3.6": the slots taken from the root, which is 0.
std::string pathOf(const TreeNode& node);

class Tree {
public:
    static constexpr int kMaxDepth = 20;

    /// `leafSize`: a node of no more items is not divided.
    Tree(TreeKind kind, std::unique_ptr<const ItemBoxes> boxes, std::uint32_t leafSize);

    const TreeNode& root() const { return *m_root; }
    bool            isEmpty() const { return m_items.empty(); }

    /// Divides the node if that has not been done; afterwards its children and own items may be read.
    const TreeNode& open(const TreeNode& node) const;
    /// Valid once the node is open.
    std::span<const std::uint32_t> ownItems(const TreeNode& node) const
    {
        return std::span(m_items).subspan(node.first, node.ownEnd - node.first);
    }
    /// Everything below the node, opened or not.
    std::span<const std::uint32_t> allItems(const TreeNode& node) const
    {
        return std::span(m_items).subspan(node.first, node.size());
    }
    std::span<TreeNode> childrenOf(const TreeNode& node) const
    {
        return {node.children.get(), static_cast<std::size_t>(node.childCount)};
    }
    /// The node's own items as batches of `mesh`; the node must be open, and the items triangles of the mesh.
    const MeshBatches& batchesOf(const TreeNode& node, const Mesh& mesh) const;
    /// The same of everything below the node, opened or not.
    const MeshBatches& allBatchesOf(const TreeNode& node, const Mesh& mesh) const;

    Bounds boxOf(std::uint32_t item) const { return m_boxes->boxOf(item); }

    TreeKind      kind() const { return m_kind; }
    std::uint64_t nodeCount() const { return m_nodeCount.load(std::memory_order_relaxed); }
    std::uint64_t bytes() const;

private:
    struct Group {
        std::uint32_t first, end;
        Bounds        cell;
        int           slot;
        bool          straddles;
    };

    const MeshBatches& make(std::unique_ptr<const MeshBatches>& batches, std::atomic<bool>& isMade, const Mesh& mesh,
                            std::span<const std::uint32_t> items, BatchSize size) const;
    void               divide(TreeNode& node) const;
    std::vector<Group> byPlanes(const TreeNode& node) const;
    std::vector<Group> halves(const TreeNode& node) const;
    void               boundItems(TreeNode& node) const;

    TreeKind                           m_kind;
    std::unique_ptr<const ItemBoxes>   m_boxes;
    std::uint32_t                      m_leafSize;
    mutable std::vector<std::uint32_t> m_items;  // permuted so that each node's items stand together
    std::unique_ptr<TreeNode>          m_root;
    mutable std::mutex                 m_mutex;  // held while a node is divided or its batches are made
    mutable std::atomic<std::uint64_t> m_nodeCount{1};
    mutable std::atomic<std::uint64_t> m_batchBytes{0};
};

}  // namespace zscope
