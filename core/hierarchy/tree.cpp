#include "core/hierarchy/tree.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/geometry/placed_view.h"

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

/// Where a box lies of the planes through `centre`: octants are 0 to 7, a bit per axis; then come the 19 ways of
/// crossing planes. A box in a splitting plane belongs to the lower side.
int slotOf(const Bounds& box, const dvec3& centre)
{
    constexpr int kAcross = 2;
    int           place = 0, octant = 0;  // in base 3, in base 2
    bool          straddles = false;
    for (int axis = 2; axis >= 0; --axis) {
        const int side = box.max[axis] <= centre[axis] ? 0 : box.min[axis] < centre[axis] ? kAcross : 1;
        place          = place * 3 + side;
        octant         = octant * 2 + side;
        straddles      = straddles || side == kAcross;
    }
    if (!straddles) return octant;
    // Counting up to `place` in base 3, octants left out.
    int before = 0;
    for (int other = 0; other < place; ++other)
        before += other % 3 == kAcross || other / 3 % 3 == kAcross || other / 9 == kAcross;
    return TreeNode::kOctants + before;
}

Bounds octantCell(const Bounds& cell, const dvec3& centre, int octant)
{
    Bounds half = cell;
    for (int axis = 0; axis < 3; ++axis) (octant >> axis & 1 ? half.min : half.max)[axis] = centre[axis];
    return half;
}

}  // namespace

Tree::Tree(TreeKind kind, std::unique_ptr<const ItemBoxes> boxes, std::uint32_t leafSize)
    : m_kind(kind), m_boxes(std::move(boxes)), m_leafSize(leafSize), m_items(m_boxes->count()),
      m_root(std::make_unique<TreeNode>())
{
    std::iota(m_items.begin(), m_items.end(), 0u);
    m_root->end = static_cast<std::uint32_t>(m_items.size());
    boundItems(*m_root);
    m_root->cell = m_root->bounds;
}

/// By their box, and by the ball about its middle.
void Tree::boundItems(TreeNode& node) const
{
    for (const std::uint32_t item : allItems(node)) include(node.bounds, m_boxes->boxOf(item));
    const dvec3 middle = centreOf(node.bounds);
    double      most   = 0;
    for (const std::uint32_t item : allItems(node)) most = std::max(most, m_boxes->squaredReach(item, middle));
    node.radius = ballRadius(most);
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
    const std::vector<Group> groups = m_kind == TreeKind::Octree && !node.straddles ? byPlanes(node) : halves(node);
    if (groups.empty()) return;

    node.ownEnd     = groups.front().first;
    node.childCount = static_cast<int>(groups.size());
    node.children   = std::make_unique<TreeNode[]>(groups.size());
    for (std::size_t i = 0; i < groups.size(); ++i) {
        TreeNode& child = node.children[i];
        child.parent    = &node;
        child.slot      = groups[i].slot;
        child.straddles = groups[i].straddles;
        child.depth     = node.depth + 1;
        child.first     = groups[i].first;
        child.end       = groups[i].end;
        child.cell      = groups[i].cell;
        boundItems(child);
    }
    m_nodeCount.fetch_add(groups.size(), std::memory_order_relaxed);
}

/// What goes down octant by octant, then what stays, each in the order it had. If all of it stays: its halves.
std::vector<Tree::Group> Tree::byPlanes(const TreeNode& node) const
{
    const dvec3                                              centre = centreOf(node.cell);
    std::array<std::vector<std::uint32_t>, TreeNode::kSlots> bins;
    for (std::uint32_t i = node.first; i < node.end; ++i)
        bins[static_cast<std::size_t>(slotOf(m_boxes->boxOf(m_items[i]), centre))].push_back(m_items[i]);
    std::size_t stays = 0;
    for (std::size_t slot = TreeNode::kOctants; slot < bins.size(); ++slot) stays += bins[slot].size();
    if (stays == node.size()) return halves(node);

    std::vector<Group> groups;
    std::uint32_t      at = node.first;
    for (int slot = 0; slot < TreeNode::kSlots; ++slot) {
        const auto& items     = bins[static_cast<std::size_t>(slot)];
        const bool  straddles = slot >= TreeNode::kOctants;
        std::ranges::copy(items, m_items.begin() + at);
        const auto end = at + static_cast<std::uint32_t>(items.size());
        if (straddles && stays <= m_leafSize) {  // too little to be told apart
            if (stays > 0 && slot == TreeNode::kOctants) groups.push_back({at, node.end, node.cell, slot, true});
        } else if (!items.empty()) {
            groups.push_back({at, end, straddles ? node.cell : octantCell(node.cell, centre, slot), slot, straddles});
        }
        at = end;
    }
    return groups;
}

/// Two halves by the surface area heuristic over bins of the centres along the longest axis. Empty if all centres
/// agree.
std::vector<Tree::Group> Tree::halves(const TreeNode& node) const
{
    constexpr std::size_t kBins = 16;
    Bounds                centres;
    for (std::uint32_t i = node.first; i < node.end; ++i) centres.include(centreOf(m_boxes->boxOf(m_items[i])));
    const dvec3 extent = 0.5 * centres.max - 0.5 * centres.min;  // halved, so that no sum of finite numbers runs over
    const int   axis   = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    if (!(extent[axis] > 0)) return {};
    const auto binOf = [&](std::uint32_t item) {
        const double place = (0.5 * centreOf(m_boxes->boxOf(item))[axis] - 0.5 * centres.min[axis]) / extent[axis];
        // an empty box has no centre
        return place > 0 ? std::min(kBins - 1, static_cast<std::size_t>(place * kBins)) : 0;
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
    const auto middle    = std::stable_partition(m_items.begin() + node.first, m_items.begin() + node.end,
                                                 [&](std::uint32_t item) { return binOf(item) < best; });
    const auto split     = static_cast<std::uint32_t>(middle - m_items.begin());
    const bool straddles = m_kind == TreeKind::Octree;
    return {{node.first, split, node.cell, 0, straddles}, {split, node.end, node.cell, 1, straddles}};
}

const MeshBatches& Tree::batchesOf(const TreeNode& node, const Mesh& mesh) const
{
    if (node.hasBatches.load(std::memory_order_acquire)) return *node.batches;
    TreeNode& mine = const_cast<TreeNode&>(node);
    return make(mine.batches, mine.hasBatches, mesh, ownItems(node), {});
}

const MeshBatches& Tree::allBatchesOf(const TreeNode& node, const Mesh& mesh) const
{
    if (node.hasAllBatches.load(std::memory_order_acquire)) return *node.allBatches;
    TreeNode& mine = const_cast<TreeNode&>(node);
    return make(mine.allBatches, mine.hasAllBatches, mesh, inPatches(mesh, allItems(node)), kWholeLeaf);
}

/// The items stand still as long as the lock is held.
const MeshBatches& Tree::make(std::unique_ptr<const MeshBatches>& batches, std::atomic<bool>& isMade, const Mesh& mesh,
                              std::span<const std::uint32_t> items, BatchSize size) const
{
    const std::scoped_lock lock(m_mutex);
    if (!isMade.load(std::memory_order_relaxed)) {
        batches = std::make_unique<const MeshBatches>(makeBatches(mesh, items, Surfaces::Opaque, size));
        m_batchBytes.fetch_add(sizeof(MeshBatches) + batches->bytes(), std::memory_order_relaxed);
        isMade.store(true, std::memory_order_release);
    }
    return *batches;
}

std::string pathOf(const TreeNode& node)
{
    return node.parent ? pathOf(*node.parent) + "." + std::to_string(node.slot) : "0";
}

std::uint64_t Tree::bytes() const
{
    return m_boxes->bytes() + m_items.capacity() * sizeof(std::uint32_t) + nodeCount() * sizeof(TreeNode)
           + m_batchBytes.load(std::memory_order_relaxed);
}

}  // namespace zscope
