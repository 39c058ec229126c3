// What one stripe remembers from frame to frame: the nodes whose triangles were drawn, mostly seen and not found
// hidden. Whatever was visible a frame ago is a good guess at what hides the rest now.
//
// Worth      to draw a node unasked saves a question per triangle and costs the pixels of those that are hidden after
//            all. A node is remembered as long as that pays; every kTurns-th in turn is left to the visit, whose
//            questions tell
// A guess    nothing here decides a pixel: a node too many costs its triangles, a node too few is found by the visit
//            that follows. That is why cuts, half-turns, other sizes and other stripes need no care
// Identity   nodes are remembered by address, so the trees they belong to are remembered too: by a token that no other
//            trees can have, not even later ones at the same address. Other trees: everything is forgotten
// Whole      a frame that draws small nodes undivided remembers them so. One that divides them forgets these, and the
//            other way round
// Order      front to back as the last frame's visit found it, which is nearly right for this one
// Cost       per remembered node 24 bytes and a place in a hash table; a look-up per node that has triangles of its own
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/ids.h"
#include "core/hierarchy/scene_trees.h"

namespace zscope {

/// What became of a node's triangles that were set up.
struct DrawnTriangles {
    std::uint32_t drawn = 0, hidden = 0;
    std::uint64_t hiddenPixels = 0;  // of the boxes of those hidden

    void add(const DrawnTriangles& other)
    {
        drawn += other.drawn;
        hidden += other.hidden;
        hiddenPixels += other.hiddenPixels;
    }
};

struct RememberedNode {
    InstanceId      instance;
    const TreeNode* holder;  // of the tree over the instances: the node that holds the instance
    const TreeNode* node;    // of the instance's mesh tree
};

class NodeMemory {
public:
    static constexpr std::uint64_t kPixelsPerQuestion = 256;  // filled in the time that one question takes
    static constexpr std::size_t   kTurns             = 8;

    /// The next frame may be drawn by shortcuts, too: nodes need not be as small as plain text finds them.
    void allowWholeNodes() { m_mayHoldWhole = true; }
    /// In this frame small nodes are remembered undivided.
    bool holdsWholeNodes() const { return m_holdsWhole; }

    /// Begins a frame that visits `trees`; with `drawsWhole` it may leave small nodes undivided.
    void begin(const SceneTrees& trees, bool drawsWhole = false)
    {
        const bool isSame     = !m_owner.owner_before(trees.identity()) && !trees.identity().owner_before(m_owner);
        const bool holdsWhole = m_mayHoldWhole && drawsWhole;
        if (!isSame || holdsWhole != m_holdsWhole) m_last.clear();
        m_owner      = trees.identity();
        m_holdsWhole = holdsWhole;
        m_next.clear();
        std::size_t slots = 16;
        while (slots < 2 * m_last.size()) slots *= 2;
        m_slots.assign(slots, 0);
        ++m_frame;
    }

    /// Becomes what `kept` was before it began its frame.
    void restore(const NodeMemory& kept)
    {
        *this = kept;
        --m_frame;
    }

    /// What the last frame left, nearest first.
    std::span<const RememberedNode> lastFrame() const { return m_last; }

    /// Whether it is the turn of this one of lastFrame() to be asked about again.
    bool isItsTurn(const RememberedNode& node) const
    {
        return (static_cast<std::size_t>(&node - m_last.data()) + m_frame) % kTurns == 0;
    }
    static bool isWorthIt(const DrawnTriangles& triangles)
    {
        return triangles.drawn > 0
               && triangles.hiddenPixels <= kPixelsPerQuestion * (triangles.drawn + triangles.hidden);
    }

    /// The node, one of lastFrame(), has been drawn before the visit.
    void noteDrawnAhead(const RememberedNode& node)
    {
        std::size_t slot = slotOf(node.instance, node.node);
        while (m_slots[slot] != 0) slot = next(slot);
        m_slots[slot] = static_cast<std::uint32_t>(&node - m_last.data()) + 1;
    }
    bool isDrawnAhead(InstanceId instance, const TreeNode& node) const
    {
        for (std::size_t slot = slotOf(instance, &node); m_slots[slot] != 0; slot = next(slot)) {
            const RememberedNode& known = m_last[m_slots[slot] - 1];
            if (known.node == &node && known.instance == instance) return true;
        }
        return false;
    }

    /// The node was drawn in this frame, is not known to be hidden, and is worth it.
    void remember(const RememberedNode& node) { m_next.push_back(node); }
    /// What this frame remembered is what the next one begins with.
    void finish() { std::swap(m_last, m_next); }

    std::size_t bytes() const
    {
        return (m_last.capacity() + m_next.capacity()) * sizeof(RememberedNode)
               + m_slots.capacity() * sizeof(std::uint32_t);
    }

private:
    std::size_t next(std::size_t slot) const { return (slot + 1) & (m_slots.size() - 1); }
    std::size_t slotOf(InstanceId instance, const TreeNode* node) const
    {
        const std::uint64_t key =
            (reinterpret_cast<std::uintptr_t>(node) / alignof(TreeNode)) ^ (std::uint64_t{instance.value} << 40);
        return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15u) >> 32) & (m_slots.size() - 1);
    }

    std::weak_ptr<const void>   m_owner;         // token of the trees that m_last belongs to
    std::vector<RememberedNode> m_last, m_next;  // of the last frame, of this one
    std::size_t                 m_frame        = 0;
    bool                        m_mayHoldWhole = false, m_holdsWhole = false;
    std::vector<std::uint32_t>  m_slots;  // nodes drawn ahead: position in m_last + 1, 0 is free; a power of two
};

}  // namespace zscope
