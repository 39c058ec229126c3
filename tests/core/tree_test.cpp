// What the hierarchy promises: every item in exactly one node, bounds that are the items' own, an octree's item in the
// deepest node that holds it whole, the same tree for the same order; and that no input makes it deep, slow or large.
// Hard cases E1 to E6 of docs/correctness.md.
#include "core/hierarchy/tree.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/hierarchy/scene_trees.h"
#include "core/scene/generators/random.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

class GivenBoxes : public ItemBoxes {
public:
    explicit GivenBoxes(std::vector<Bounds> boxes) : m_boxes(std::move(boxes)) {}

    std::uint32_t count() const override { return static_cast<std::uint32_t>(m_boxes.size()); }
    Bounds        boxOf(std::uint32_t item) const override { return m_boxes[item]; }

private:
    std::vector<Bounds> m_boxes;
};

constexpr TreeKind      kKinds[] = {TreeKind::Octree, TreeKind::Bvh};
constexpr std::uint32_t kLeaf    = 8;

Bounds boxAbout(const dvec3& middle, const dvec3& half) { return {middle - half, middle + half}; }
Bounds boxAbout(const dvec3& middle, double half) { return boxAbout(middle, dvec3{half, half, half}); }

bool isWithin(const Bounds& inner, const Bounds& outer)
{
    for (int k = 0; k < 3; ++k)
        if (inner.min[k] < outer.min[k] || inner.max[k] > outer.max[k]) return false;
    return true;
}

/// Every node in the order of a descent, all of them opened.
std::vector<const TreeNode*> openedNodes(const Tree& tree)
{
    std::vector<const TreeNode*> nodes{&tree.root()};
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const TreeNode& child : tree.childrenOf(tree.open(*nodes[i]))) nodes.push_back(&child);
    return nodes;
}

/// Node name to the items it keeps, sorted.
std::map<std::string, std::vector<std::uint32_t>> ownersOf(const Tree& tree)
{
    std::map<std::string, std::vector<std::uint32_t>> owners;
    for (const TreeNode* node : openedNodes(tree)) {
        const auto own  = tree.ownItems(*node);
        auto&      kept = owners[pathOf(*node)];
        kept.assign(own.begin(), own.end());
        std::ranges::sort(kept);
    }
    return owners;
}

/// `cornersAreItems`: an item is less than its box, and so may its node's ball be.
void expectValid(const Tree& tree, const std::vector<Bounds>& boxes, std::uint32_t leaf = kLeaf,
                 bool cornersAreItems = false)
{
    std::vector<int>      times(boxes.size(), 0);
    std::set<std::string> names;
    const auto            nodes = openedNodes(tree);
    ASSERT_EQ(tree.nodeCount(), nodes.size());
    for (const TreeNode* node : nodes) {
        ASSERT_TRUE(names.insert(pathOf(*node)).second) << "two nodes of one name";
        ASSERT_LE(node->depth, Tree::kMaxDepth);
        Bounds all;
        for (const std::uint32_t item : tree.allItems(*node)) {
            if (boxes[item].isEmpty()) continue;
            all.include(boxes[item].min);
            all.include(boxes[item].max);
        }
        ASSERT_EQ(all.min, node->bounds.min);
        ASSERT_EQ(all.max, node->bounds.max);
        const dvec3 middle = 0.5 * all.min + 0.5 * all.max;
        for (const std::uint32_t item : tree.allItems(*node))
            for (int i = 0; i < 8 && !boxes[item].isEmpty(); ++i) {
                const Bounds& box = boxes[item];
                const dvec3   corner{i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                                   i & 4 ? box.max.z : box.min.z};
                ASSERT_TRUE(cornersAreItems || glm::distance(corner, middle) <= node->radius);
            }

        const auto children = tree.childrenOf(*node);
        for (const std::uint32_t item : tree.ownItems(*node)) ++times[item];
        if (children.empty()) {
            ASSERT_EQ(tree.ownItems(*node).size(), node->size());
            continue;
        }
        ASSERT_GT(node->size(), leaf) << "a small node is not divided";
        std::uint32_t at = node->ownEnd;
        for (const TreeNode& child : children) {
            ASSERT_EQ(child.first, at) << "children stand side by side";
            ASSERT_GT(child.size(), 0u);
            ASSERT_EQ(child.parent, node);
            ASSERT_EQ(child.depth, node->depth + 1);
            at = child.end;
        }
        ASSERT_EQ(at, node->end);
        ASSERT_TRUE(tree.ownItems(*node).empty());
        const bool isHalved = tree.kind() == TreeKind::Bvh || children[0].straddles;
        if (isHalved) {
            ASSERT_EQ(children.size(), 2u);
            for (const TreeNode& child : children) ASSERT_EQ(child.straddles, tree.kind() == TreeKind::Octree);
            if (tree.kind() == TreeKind::Bvh || node->straddles) continue;
        }
        const dvec3 centre = 0.5 * node->cell.min + 0.5 * node->cell.max;
        const auto  octant = [&](unsigned which) {
            Bounds part = node->cell;
            for (int k = 0; k < 3; ++k) (which >> k & 1 ? part.min : part.max)[k] = centre[k];
            return part;
        };
        std::uint32_t stays   = 0;
        int           keepers = 0;
        for (const TreeNode& child : children) {
            if (child.straddles) {
                stays += child.size();
                ++keepers;
                ASSERT_TRUE(isHalved || child.slot >= TreeNode::kOctants);
                for (const std::uint32_t item : tree.allItems(child))
                    for (unsigned which = 0; which < 8; ++which)
                        ASSERT_FALSE(isWithin(boxes[item], octant(which))) << "it could go down";
                continue;
            }
            ASSERT_LT(child.slot, TreeNode::kOctants);
            const Bounds part = octant(static_cast<unsigned>(child.slot));
            ASSERT_EQ(child.cell.min, part.min);
            ASSERT_EQ(child.cell.max, part.max);
            for (const std::uint32_t item : tree.allItems(child))
                ASSERT_TRUE(boxes[item].isEmpty() || isWithin(boxes[item], part));
        }
        if (!isHalved && stays <= leaf) {
            ASSERT_LE(keepers, 1) << "what is little stays together";
        }
    }
    for (const int count : times) ASSERT_EQ(count, 1);
}

void expectValid(const std::vector<Bounds>& boxes, const char* what)
{
    for (const TreeKind kind : kKinds) {
        SCOPED_TRACE(testing::Message() << what << (kind == TreeKind::Octree ? ", octree" : ", bvh"));
        expectValid(Tree(kind, std::make_unique<GivenBoxes>(boxes), kLeaf), boxes);
    }
}

std::vector<Bounds> scattered(std::size_t count, std::uint64_t seed, double size = 0.05)
{
    Random              random(seed);
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const dvec3 middle = random.between(dvec3{-1, -1, -1}, dvec3{1, 1, 1});
        boxes.push_back(boxAbout(middle, random.between(dvec3{0, 0, 0}, dvec3{size, size, size})));
    }
    return boxes;
}

TEST(Tree, EveryItemIsInExactlyOneNodeAndAnOctreesInTheDeepestThatHoldsIt)
{
    for (const std::size_t count : {0u, 1u, 2u, 8u, 9u, 100u, 5000u})
        for (const double size : {0.0, 0.01, 0.3, 2.0}) expectValid(scattered(count, count + 7, size), "scattered");
}

TEST(Tree, NothingIsDividedBeforeItIsOpened)
{
    const Tree tree(TreeKind::Octree, std::make_unique<GivenBoxes>(scattered(5000, 3)), kLeaf);
    EXPECT_EQ(tree.nodeCount(), 1u);
    const auto children = tree.childrenOf(tree.open(tree.root()));
    EXPECT_EQ(tree.nodeCount(), 1u + children.size());
    tree.open(tree.root());
    EXPECT_EQ(tree.nodeCount(), 1u + children.size()) << "a node stays as it is";
}

TEST(Tree, IsTheSameInWhateverOrderItsNodesAreOpened)
{
    for (const TreeKind kind : kKinds) {
        const auto boxes = scattered(3000, 11);
        const Tree one(kind, std::make_unique<GivenBoxes>(boxes), kLeaf),
            other(kind, std::make_unique<GivenBoxes>(boxes), kLeaf);
        Random                       random(5);
        std::vector<const TreeNode*> waiting{&other.root()};
        while (!waiting.empty()) {
            std::swap(waiting[random.below(waiting.size())], waiting.back());
            const TreeNode* node = waiting.back();
            waiting.pop_back();
            for (const TreeNode& child : other.childrenOf(other.open(*node))) waiting.push_back(&child);
        }
        EXPECT_EQ(ownersOf(one), ownersOf(other));
        const auto a = one.allItems(one.root()), b = other.allItems(other.root());
        EXPECT_TRUE(std::ranges::equal(a, b));
    }
}

TEST(Tree, E1BoxesThatTouchOrLieInTheSplittingPlanesGoToOneSide)
{
    std::vector<Bounds> boxes;
    for (int x = 0; x <= 16; ++x)
        for (int y = 0; y <= 16; ++y)
            for (int z = 0; z <= 16; ++z) {
                const dvec3 at{x * 0.125 - 1, y * 0.125 - 1, z * 0.125 - 1};
                boxes.push_back({at, at});                                   // a point in up to three planes
                if (x < 16) boxes.push_back({at, at + dvec3{0.125, 0, 0}});  // between two planes, in two others
                if (x < 16 && y < 16) boxes.push_back({at, at + dvec3{0.125, 0.125, 0}});
            }
    expectValid(boxes, "on the planes");
    const Tree tree(TreeKind::Octree, std::make_unique<GivenBoxes>(boxes), kLeaf);
    tree.open(tree.root());
    for (const TreeNode& child : tree.childrenOf(tree.root()))
        EXPECT_FALSE(child.straddles) << "none of them crosses a plane";
}

TEST(Tree, WhatStraddlesIsToldApartByThePlanesItCrosses)
{
    // Flat plates in the cell [-1, 1]: across one plane of the three in each quadrant of the others, and across all.
    std::vector<Bounds> boxes{boxAbout({0, 0, 0}, 1)};
    for (int axis = 0; axis < 3; ++axis)
        for (int quadrant = 0; quadrant < 4; ++quadrant)
            for (int i = 0; i < 20; ++i) {
                dvec3 middle{0, 0, 0}, half{0.01, 0.01, 0.01};
                half[axis]             = 0.2;
                middle[(axis + 1) % 3] = (quadrant & 1 ? 0.5 : -0.5) + 0.02 * i;
                middle[(axis + 2) % 3] = quadrant & 2 ? 0.5 : -0.5;
                boxes.push_back(boxAbout(middle, half));
            }
    for (int i = 0; i < 20; ++i) boxes.push_back(boxAbout({0.3 + 0.01 * i, 0.5, 0.5}, 0.001));  // these go down
    expectValid(boxes, "plates");
    const Tree tree(TreeKind::Octree, std::make_unique<GivenBoxes>(boxes), kLeaf);
    tree.open(tree.root());
    std::vector<std::uint32_t> sizes;
    for (const TreeNode& child : tree.childrenOf(tree.root()))
        if (child.straddles) sizes.push_back(child.size());
    EXPECT_EQ(std::ranges::count(sizes, 20u), 12);
    EXPECT_EQ(std::ranges::count(sizes, 1u), 1);
    EXPECT_EQ(sizes.size(), 13u);

    const Tree few(TreeKind::Octree, std::make_unique<GivenBoxes>(boxes), 1000);
    EXPECT_EQ(few.childrenOf(few.open(few.root())).size(), 0u);
    boxes.resize(4);
    for (int i = 0; i < 20; ++i) boxes.push_back(boxAbout({0.3 + 0.01 * i, 0.5, 0.5}, 0.001));
    const Tree  little(TreeKind::Octree, std::make_unique<GivenBoxes>(boxes), kLeaf);
    std::size_t keepers = 0;
    for (const TreeNode& child : little.childrenOf(little.open(little.root()))) keepers += child.straddles;
    EXPECT_EQ(keepers, 1u) << "little is not told apart";
}

TEST(Tree, E2AHundredThousandCoincidentItemsStopTheDivision)
{
    for (const double half : {0.0, 0.5})
        for (const bool withStray : {false, true}) {
            std::vector<Bounds> boxes(100'000, boxAbout({0.3, 0.3, 0.3}, half * 1e-7));
            if (withStray) boxes.push_back(boxAbout({1e3, 1e3, 1e3}, 1));
            for (const TreeKind kind : kKinds) {
                const auto start = std::chrono::steady_clock::now();
                const Tree tree(kind, std::make_unique<GivenBoxes>(boxes), kLeaf);
                const auto nodes = openedNodes(tree);
                EXPECT_LE(nodes.size(), 2u * Tree::kMaxDepth + 1);
                EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
                std::size_t owned = 0;
                for (const TreeNode* node : nodes) owned += tree.ownItems(*node).size();
                EXPECT_EQ(owned, boxes.size());
            }
        }
}

TEST(Tree, E3AGiantAmongAMillionTinyOnesIsKeptOnceAndMemoryIsLinear)
{
    std::vector<Bounds> boxes = scattered(1'000'000, 2, 1e-4);
    boxes.push_back(boxAbout({0, 0, 0}, 1.5));
    const auto giant = static_cast<std::uint32_t>(boxes.size() - 1);
    for (const TreeKind kind : kKinds) {
        const Tree  tree(kind, std::make_unique<GivenBoxes>(boxes), SceneTrees::kTriangleLeaf);
        std::size_t keepers = 0, owned = 0;
        for (const TreeNode* node : openedNodes(tree)) {
            const auto own = tree.ownItems(*node);
            owned += own.size();
            keepers += static_cast<std::size_t>(std::ranges::count(own, giant));
        }
        EXPECT_EQ(owned, boxes.size());
        EXPECT_EQ(keepers, 1u);
        EXPECT_LT(tree.bytes(), 16u * boxes.size());
    }
}

TEST(Tree, E4FlatLinesPointsAndNothingBuild)
{
    for (const dvec3& extent : {dvec3{1, 1, 0}, dvec3{0, 1, 1}, dvec3{1, 0, 0}, dvec3{0, 0, 0}}) {
        Random              random(4);
        std::vector<Bounds> boxes;
        for (int i = 0; i < 2000; ++i) {
            const dvec3 at = random.between(-extent, extent);
            boxes.push_back({at, at});
        }
        expectValid(boxes, "of fewer dimensions");
    }
    expectValid({}, "nothing");
    expectValid({boxAbout({1, 2, 3}, 0)}, "one point");
}

TEST(Tree, ItemsOfNoExtentAtAllAreKeptToo)
{
    std::vector<Bounds> boxes = scattered(100, 9);
    for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = Bounds{};  // an instance of a mesh without triangles
    expectValid(boxes, "every third one empty");
    expectValid(std::vector<Bounds>(50), "all empty");
}

TEST(Tree, E5TinyNextToHugeAndAStrayFarAwayStayBoundedAndLoseNothing)
{
    std::vector<Bounds> boxes;
    Random              random(6);
    for (int i = 0; i < 2000; ++i)
        boxes.push_back(boxAbout(random.between(dvec3{-1e-6, -1e-6, -1e-6}, dvec3{1e-6, 1e-6, 1e-6}), 1e-9));
    for (int i = 0; i < 2000; ++i)
        boxes.push_back(boxAbout(random.between(dvec3{-1e6, -1e6, -1e6}, dvec3{1e6, 1e6, 1e6}), 1e2));
    expectValid(boxes, "1e-6 next to 1e6");
    boxes.push_back(boxAbout({1e9, -1e9, 1e9}, 0));
    expectValid(boxes, "and a stray");
    boxes.push_back(boxAbout({1e308, 0, 0}, 0));
    boxes.push_back(boxAbout({-1.5e308, 1e308, -1e308}, 0));
    expectValid(boxes, "and the largest numbers there are");
}

TEST(Tree, E6EqualCentresAndReversedOrderGiveTheSameNodes)
{
    std::vector<Bounds> nested;
    for (int i = 1; i <= 1000; ++i) nested.push_back(boxAbout({0.1, 0.2, 0.3}, i * 0.001));
    expectValid(nested, "one centre");

    for (const TreeKind kind : kKinds) {
        const auto boxes    = scattered(4000, 21);
        auto       reversed = boxes;
        std::ranges::reverse(reversed);
        const Tree one(kind, std::make_unique<GivenBoxes>(boxes), kLeaf),
            other(kind, std::make_unique<GivenBoxes>(reversed), kLeaf);
        auto back = ownersOf(other);
        for (auto& [name, items] : back) {
            for (std::uint32_t& item : items) item = static_cast<std::uint32_t>(boxes.size()) - 1 - item;
            std::ranges::sort(items);
        }
        EXPECT_EQ(ownersOf(one), back);
    }
}

TEST(SceneTrees, HoldEveryTriangleOfEveryMeshAndEveryInstanceOnce)
{
    for (const char* word :
         {"builtin:soccer-field?count=50", "builtin:city?blocks=2", "builtin:soup?count=5000", "builtin:cube"}) {
        auto loaded = loadScene(word);
        ASSERT_TRUE(loaded.ok());
        const PreparedScene prepared(std::make_shared<const Scene>(*std::move(loaded)));
        const Scene&        scene = prepared.scene();
        for (const TreeKind kind : kKinds) {
            const SceneTrees& trees = treesOf(prepared, kind);
            EXPECT_EQ(&trees, &treesOf(prepared, kind)) << "kept between frames";
            for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
                const Mesh&         mesh = *scene.meshes[m];
                std::vector<Bounds> boxes(mesh.triangles.size());
                for (std::size_t t = 0; t < boxes.size(); ++t)
                    for (const std::uint32_t vertex : mesh.triangles[t]) boxes[t].include(mesh.positions[vertex]);
                expectValid(trees.mesh(MeshId{m}), boxes, SceneTrees::kTriangleLeaf, true);
                for (const TreeNode* node : openedNodes(trees.mesh(MeshId{m})))
                    for (const std::uint32_t t : trees.mesh(MeshId{m}).allItems(*node))
                        for (const std::uint32_t vertex : mesh.triangles[t])
                            ASSERT_LE(
                                glm::distance(mesh.positions[vertex], 0.5 * node->bounds.min + 0.5 * node->bounds.max),
                                node->radius)
                                << word;

                std::vector<int> drawn(mesh.triangles.size(), 0);
                for (const TreeNode* node : openedNodes(trees.mesh(MeshId{m})))
                    for (const std::uint32_t t : trees.mesh(MeshId{m}).batchesOf(*node, mesh).meshTriangles())
                        ++drawn[t];
                for (const int times : drawn) ASSERT_EQ(times, 1) << word;
            }
            // Every placed vertex lies in the box of its instance.
            const Tree& instances = trees.instances();
            std::size_t owned     = 0;
            for (const TreeNode* node : openedNodes(instances))
                for (const std::uint32_t item : instances.ownItems(*node)) {
                    ++owned;
                    for (const dvec3& p : scene.meshOf(InstanceId{item}).positions) {
                        const dvec3 placed = scene.instances[item].toWorld(p);
                        ASSERT_TRUE(isWithin({placed, placed}, node->bounds)) << word;
                        ASSERT_TRUE(isWithin({placed, placed}, instances.boxOf(item))) << word;
                        ASSERT_LE(glm::distance(placed, 0.5 * node->bounds.min + 0.5 * node->bounds.max), node->radius)
                            << word;
                    }
                }
            EXPECT_EQ(owned, scene.instances.size());
        }
    }
}

TEST(SceneTrees, ABallThatIsTurnedHasABoxOfItsOwnSize)
{
    auto loaded = loadScene("builtin:soccer-field?count=200&ball=icosphere");
    ASSERT_TRUE(loaded.ok());
    const PreparedScene prepared(std::make_shared<const Scene>(*std::move(loaded)));
    const Scene&        scene = prepared.scene();
    const Tree&         tree  = treesOf(prepared, TreeKind::Bvh).instances();
    const Bounds        ball  = scene.meshes.front()->bounds();
    for (std::uint32_t item = 0; item < scene.instances.size(); ++item) {
        const Bounds box = tree.boxOf(item);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_LE(box.max[axis] - box.min[axis], 1.001 * (ball.max[axis] - ball.min[axis])) << item;
    }
}

TEST(Tree, ABallWhoseSquaresRunUnderOrOverBoundsNothing)
{
    for (const double size : {1e-170, 1e160}) {
        const std::vector<Bounds> boxes{boxAbout({0, 0, 0}, size), boxAbout({size, 0, 0}, size)};
        EXPECT_EQ(Tree(TreeKind::Bvh, std::make_unique<GivenBoxes>(boxes), kLeaf).root().radius,
                  std::numeric_limits<double>::infinity())
            << size;
    }
    const std::vector<Bounds> boxes{boxAbout({0, 0, 0}, 1e-100)};
    EXPECT_LT(Tree(TreeKind::Bvh, std::make_unique<GivenBoxes>(boxes), kLeaf).root().radius, 1.8e-100);
}

}  // namespace
}  // namespace zscope
