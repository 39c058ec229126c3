#include "core/plain/tree_visit.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/geometry_events.h"

namespace zscope::plain {

namespace {

/// Squared, from the eye to the nearest point of the box; 0 where a flat placement has no place for the eye.
double distance(const dvec3& eye, const Bounds& box)
{
    const dvec3  gap  = eye - glm::clamp(eye, box.min, box.max);
    const double away = glm::dot(gap, gap);
    return away >= 0 ? away : 0;
}

using Children = std::vector<const TreeNode*>;

Children halvesNearestFirst(const dvec3& eye, std::span<const TreeNode> halves)
{
    Children ordered;
    for (const TreeNode& half : halves) ordered.push_back(&half);
    if (ordered.size() > 1 && distance(eye, halves[1].bounds) < distance(eye, halves[0].bounds))
        std::swap(ordered[0], ordered[1]);
    return ordered;
}

Children octantsNearestFirst(const dvec3& eye, const TreeNode& node, std::span<const TreeNode> children)
{
    std::array<const TreeNode*, 8> octant{};
    Children                       straddling, ordered;
    for (const TreeNode& child : children) {
        if (child.straddles)
            straddling.push_back(&child);
        else
            octant[static_cast<std::size_t>(child.slot)] = &child;
    }
    std::ranges::sort(straddling, [&](const TreeNode* a, const TreeNode* b) {
        return std::pair(distance(eye, a->bounds), a->slot) < std::pair(distance(eye, b->bounds), b->slot);
    });
    const dvec3    centre = 0.5 * node.cell.min + 0.5 * node.cell.max;
    const unsigned eyes   = (eye.x > centre.x ? 1u : 0u) | (eye.y > centre.y ? 2u : 0u) | (eye.z > centre.z ? 4u : 0u);
    auto           next   = straddling.begin();
    for (const unsigned across : {0u, 1u, 2u, 4u, 3u, 5u, 6u, 7u}) {  // planes between the eye's octant and this one
        const TreeNode* child = octant[eyes ^ across];
        if (!child) continue;
        while (next != straddling.end() && distance(eye, (*next)->bounds) < distance(eye, child->bounds))
            ordered.push_back(*next++);
        ordered.push_back(child);
    }
    ordered.insert(ordered.end(), next, straddling.end());
    return ordered;
}

Children childrenNearestFirst(const PlacedTree& placed, const TreeNode& node)
{
    const std::span<const TreeNode> children = placed.tree.childrenOf(node);
    const bool isHalved = children.size() > 1 && (children[0].straddles || placed.tree.kind() == TreeKind::Bvh);
    return isHalved ? halvesNearestFirst(placed.eye, children) : octantsNearestFirst(placed.eye, node, children);
}

}  // namespace

TreeVisit::TreeVisit(Work& work, const SceneTrees& trees)
    : m_work(work), m_scene(work.stripe.scene.scene()), m_trees(trees),
      m_volume(work.stripe.projection, work.stripe.visible.width(), work.stripe.firstRow, work.stripe.endRow),
      m_instances(placed(trees.instances(), m_world, true, {}))
{}

PlacedTree TreeVisit::placed(const Tree& tree, const Affine& toWorld, bool isInstanceTree, InstanceId instance) const
{
    const auto&      m = toWorld.rows;
    const glm::dmat3 linear(m[0][0], m[1][0], m[2][0], m[0][1], m[1][1], m[2][1], m[0][2], m[1][2], m[2][2]);
    const dvec3      eye = glm::inverse(linear) * (m_work.stripe.projection.eye - dvec3{m[0][3], m[1][3], m[2][3]});
    const PlacedView view(m_work.stripe.projection, toWorld,
                          isInstanceTree ? m_work.stripe.projection.displacement.instances : 0);
    return {tree, toWorld, view, eye, instance, isInstanceTree};
}

std::span<const PlacedNode> TreeVisit::roots()
{
    m_nodes.clear();
    if (!m_trees.instances().isEmpty()) m_nodes.push_back({.node = &m_trees.instances().root()});
    return m_nodes;
}

const PlacedTree& TreeVisit::treeOf(const PlacedNode& node)
{
    if (node.isInstanceTree()) return m_instances;
    if (!m_mesh || m_mesh->instance != node.instance) {
        const Instance& instance = m_scene.instances[node.instance.value];
        m_mesh.emplace(placed(m_trees.mesh(instance.mesh), instance.toWorld, false, node.instance));
    }
    return *m_mesh;
}

std::span<const PlacedNode> TreeVisit::childrenFarthestFirst(const PlacedNode& node)
{
    const PlacedTree& placed = treeOf(node);
    placed.tree.open(*node.node);
    Children children = childrenNearestFirst(placed, *node.node);
    if (m_work.rules.visitsFarFirst()) std::ranges::reverse(children);  // a fault
    m_work.tell(NodeOpened{placed.place(*node.node), children});

    m_nodes.clear();
    for (const TreeNode* child : children) {
        m_nodes.push_back(node);
        m_nodes.back().node = child;
    }
    std::ranges::reverse(m_nodes);
    if (!node.isInstanceTree()) return m_nodes;

    std::vector<std::pair<double, std::uint32_t>> own;
    for (const std::uint32_t item : placed.tree.ownItems(*node.node))
        own.emplace_back(distance(m_work.stripe.projection.eye, placed.tree.boxOf(item)), item);
    std::ranges::sort(own, std::ranges::greater());
    for (const auto& [away, item] : own) {
        const Tree& tree = m_trees.mesh(m_scene.instances[item].mesh);
        if (tree.isEmpty()) continue;
        m_nodes.push_back({.node = &tree.root(), .holder = node.node, .instance = {item}, .open = node.open});
    }
    return m_nodes;
}

std::span<const BatchPlace> TreeVisit::batchesNearestFirst(const PlacedNode& node)
{
    const PlacedTree&  placed  = treeOf(node);
    const MeshBatches& batches = placed.tree.batchesOf(*node.node, m_scene.meshOf(node.instance));
    m_work.tell(TransparentLeftOut{
        node.instance, static_cast<std::uint32_t>(placed.tree.ownItems(*node.node).size() - batches.triangleCount())});
    std::vector<std::pair<double, std::uint32_t>> order;
    const double                                  sign = m_work.rules.visitsFarFirst() ? -1 : 1;  // a fault
    for (std::uint32_t b = 0; b < batches.batches.size(); ++b)
        order.emplace_back(sign * distance(placed.eye, batches.batches[b].bounds), b);
    std::ranges::sort(order);

    m_batches.clear();
    const Affine* toWorld = placed.toWorld.isIdentity() ? nullptr : &placed.toWorld;
    for (const auto& [away, b] : order)
        m_batches.push_back({batches, batches.batches[b], toWorld, m_scene.firstTriangle[node.instance.value]});
    return m_batches;
}

bool TreeVisit::hasOwnItems(const PlacedNode& node) { return !treeOf(node).tree.ownItems(*node.node).empty(); }

}  // namespace zscope::plain
