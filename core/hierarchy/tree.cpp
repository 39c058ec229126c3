#include "core/hierarchy/tree.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace zscope {

namespace {

dvec3 centreOf(const Bounds& box) { return 0.5 * box.min + 0.5 * box.max; }

void include(Bounds& all, const Bounds& one)
{
    if (one.isEmpty()) return;
    all.include(one.min);
    all.include(one.max);
}

double areaOf(const Bounds& box)
{
    if (box.isEmpty()) return 0;
    const dvec3 size = box.max - box.min;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// The octant of `cell` that holds `box` whole, or -1. A box in the splitting plane belongs to the lower side.
int octantOf(const Bounds& box, const dvec3& centre)
{
    int octant = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (box.max[axis] <= centre[axis]) continue;
        if (box.min[axis] < centre[axis]) return -1;
        octant |= 1 << axis;
    }
    return octant;
}

Bounds octantCell(const Bounds& cell, const dvec3& centre, int octant)
{
    Bounds half = cell;
    for (int axis = 0; axis < 3; ++axis) (octant >> axis & 1 ? half.min : half.max)[axis] = centre[axis];
    return half;
}

}  // namespace

Tree::Tree(TreeKind kind, std::unique_ptr<const ItemBoxes> boxes, std::uint32_t leafSize)
    : m_kind(kind), m_boxes(std::move(boxes)), m_leafSize(leafSize), m_items(m_boxes->count()), m_root(std::make_unique<TreeNode>())
{
    std::iota(m_items.begin(), m_items.end(), 0u);
    m_root->end    = static_cast<std::uint32_t>(m_items.size());
    m_root->bounds = boundsOf(0, m_root->end);
    m_root->cell   = m_root->bounds;
}

Bounds Tree::boundsOf(std::uint32_t first, std::uint32_t end) const
{
    Bounds all;
    for (std::uint32_t i = first; i < end; ++i) include(all, m_boxes->boxOf(m_items[i]));
    return all;
}

const TreeNode& Tree::open(const TreeNode& node) const
{
    if (node.isOpen.load(std::memory_order_acquire)) return node;
    const std::scoped_lock lock(m_mutex);
    if (!node.isOpen.load(std::memory_order_relaxed)) {
        TreeNode& mine = const_cast<TreeNode&>(node);  // owned by this tree, which alone changes nodes
        divide(mine);
        mine.isOpen.store(true, std::memory_order_release);
    }
    return node;
}

void Tree::divide(TreeNode& node) const
{
    node.ownEnd = node.end;
    if (node.size() <= m_leafSize || node.depth >= kMaxDepth || node.bounds.isEmpty()) return;
    const std::vector<Group> groups = m_kind == TreeKind::Octree ? octants(node) : halves(node);
    if (groups.empty()) return;

    node.ownEnd     = groups.front().first;
    node.childCount = static_cast<int>(groups.size());
    node.children   = std::make_unique<TreeNode[]>(groups.size());
    for (std::size_t i = 0; i < groups.size(); ++i) {
        TreeNode& child = node.children[i];
        child.id        = node.id * 8 + static_cast<std::uint64_t>(groups[i].slot);
        child.depth     = node.depth + 1;
        child.first     = groups[i].first;
        child.end       = groups[i].end;
        child.cell      = groups[i].cell;
        child.bounds    = boundsOf(child.first, child.end);
    }
    m_nodeCount.fetch_add(groups.size(), std::memory_order_relaxed);
}

/// Own items first, then octant after octant, each in the order they had. Empty if no item fits an octant.
std::vector<Tree::Group> Tree::octants(TreeNode& node) const
{
    const dvec3                               centre = centreOf(node.cell);
    std::array<std::vector<std::uint32_t>, 9> bins;  // [0] stays, [1 + octant] goes down
    for (std::uint32_t i = node.first; i < node.end; ++i)
        bins[static_cast<std::size_t>(octantOf(m_boxes->boxOf(m_items[i]), centre) + 1)].push_back(m_items[i]);
    std::vector<Group> groups;
    if (bins[0].size() == node.size()) return groups;

    std::uint32_t at = node.first;
    for (int bin = 0; bin < 9; ++bin) {
        const auto& items = bins[static_cast<std::size_t>(bin)];
        std::ranges::copy(items, m_items.begin() + at);
        const auto end = at + static_cast<std::uint32_t>(items.size());
        if (bin > 0 && !items.empty()) groups.push_back({at, end, octantCell(node.cell, centre, bin - 1), bin - 1});
        at = end;
    }
    return groups;
}

/// Two halves by the surface area heuristic over bins of the centres along the longest axis. Empty if all centres agree.
std::vector<Tree::Group> Tree::halves(TreeNode& node) const
{
    constexpr std::size_t kBins = 16;
    Bounds                centres;
    for (std::uint32_t i = node.first; i < node.end; ++i) centres.include(centreOf(m_boxes->boxOf(m_items[i])));
    const dvec3 extent = 0.5 * centres.max - 0.5 * centres.min;  // halved, so that no sum of finite numbers runs over
    const int   axis   = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    if (!(extent[axis] > 0)) return {};
    const auto binOf = [&](std::uint32_t item) {
        const double place = (0.5 * centreOf(m_boxes->boxOf(item))[axis] - 0.5 * centres.min[axis]) / extent[axis];
        return place > 0 ? std::min(kBins - 1, static_cast<std::size_t>(place * kBins)) : 0;  // an empty box has no centre
    };

    std::array<Bounds, kBins>        boxes;
    std::array<std::uint32_t, kBins> counts{};
    for (std::uint32_t i = node.first; i < node.end; ++i) {
        const std::size_t bin = binOf(m_items[i]);
        include(boxes[bin], m_boxes->boxOf(m_items[i]));
        ++counts[bin];
    }
    std::array<double, kBins> fromRight{};  // cost of bins [b, kBins)
    Bounds                    all;
    std::uint32_t             count = 0;
    for (std::size_t b = kBins; b-- > 0;) {
        include(all, boxes[b]);
        count += counts[b];
        fromRight[b] = areaOf(all) * count;
    }
    std::size_t best     = 0;
    double      bestCost = std::numeric_limits<double>::infinity();
    all                  = {};
    count                = 0;
    for (std::size_t b = 1; b < kBins; ++b) {
        include(all, boxes[b - 1]);
        count += counts[b - 1];
        const double cost = areaOf(all) * count + fromRight[b];
        if (count == 0 || count == node.size() || !(cost < bestCost)) continue;
        best     = b;
        bestCost = cost;
    }
    if (best == 0) return {};
    const auto middle = std::stable_partition(m_items.begin() + node.first, m_items.begin() + node.end,
                                              [&](std::uint32_t item) { return binOf(item) < best; });
    const auto split  = static_cast<std::uint32_t>(middle - m_items.begin());
    return {{node.first, split, {}, 0}, {split, node.end, {}, 1}};
}

const MeshBatches& Tree::batchesOf(const TreeNode& node, const Mesh& mesh) const
{
    if (node.hasBatches.load(std::memory_order_acquire)) return node.batches;
    const std::scoped_lock lock(m_mutex);
    if (!node.hasBatches.load(std::memory_order_relaxed)) {
        TreeNode& mine = const_cast<TreeNode&>(node);
        mine.batches   = makeBatches(mesh, ownItems(node));
        m_batchBytes.fetch_add(mine.batches.bytes(), std::memory_order_relaxed);
        mine.hasBatches.store(true, std::memory_order_release);
    }
    return node.batches;
}

std::uint64_t Tree::bytes() const
{
    return m_items.capacity() * sizeof(std::uint32_t) + nodeCount() * sizeof(TreeNode) + m_batchBytes.load(std::memory_order_relaxed);
}

}  // namespace zscope
