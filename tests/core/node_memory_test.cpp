// What is remembered of the last frame is told apart by trees, and found again by instance and node.
#include "core/hierarchy/node_memory.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/agreement/soups.h"

namespace zscope {
namespace {

std::shared_ptr<const Scene> scene(std::uint64_t seed)
{
    return tests::makeSoup(tests::SoupKind::Grid, seed, 64, 64, 3000).scene;
}

/// Every node below and at `node`, opened.
std::vector<const TreeNode*> nodesOf(const Tree& tree, const TreeNode& node)
{
    std::vector<const TreeNode*> nodes{&node};
    for (const TreeNode& child : tree.childrenOf(tree.open(node)))
        for (const TreeNode* below : nodesOf(tree, child)) nodes.push_back(below);
    return nodes;
}

TEST(NodeMemory, TheNextFrameBeginsWithWhatThisOneRemembered)
{
    const auto       shared = scene(1);
    const SceneTrees trees(*shared, TreeKind::Octree);
    const Tree&      tree  = trees.mesh(MeshId{0});
    const auto       nodes = nodesOf(tree, tree.root());
    ASSERT_GT(nodes.size(), 8u);
    NodeMemory memory;
    memory.begin(trees);
    EXPECT_TRUE(memory.lastFrame().empty());
    for (const TreeNode* node : nodes)
        for (std::uint32_t instance = 0; instance < 40; ++instance)
            memory.remember({InstanceId{instance}, &trees.instances().root(), node});
    EXPECT_TRUE(memory.lastFrame().empty()) << "not before the frame is finished";
    memory.finish();

    memory.begin(trees);
    ASSERT_EQ(memory.lastFrame().size(), 40 * nodes.size());
    for (std::size_t i = 0; i < memory.lastFrame().size(); i += 3) memory.noteDrawnAhead(memory.lastFrame()[i]);
    for (std::size_t i = 0; i < memory.lastFrame().size(); ++i) {
        const RememberedNode& last = memory.lastFrame()[i];
        EXPECT_EQ(last.node, nodes[i / 40]);
        EXPECT_EQ(memory.isDrawnAhead(last.instance, *last.node), i % 3 == 0);
    }
    EXPECT_FALSE(memory.isDrawnAhead(InstanceId{40}, *nodes[0])) << "another instance of the same mesh";
    memory.finish();
    memory.begin(trees);
    EXPECT_TRUE(memory.lastFrame().empty()) << "nothing was remembered of that frame";
}

TEST(NodeMemory, NodesThatWereDrawnWholeAreForgottenByAFrameThatDividesThem)
{
    const auto       shared = scene(1);
    const SceneTrees trees(*shared, TreeKind::Octree);
    NodeMemory       memory;
    const auto       frame = [&](bool drawsWhole) {
        memory.begin(trees, drawsWhole);
        const std::size_t known = memory.lastFrame().size();
        memory.remember({InstanceId{0}, &trees.instances().root(), &trees.mesh(MeshId{0}).root()});
        memory.finish();
        return known;
    };
    frame(true);
    EXPECT_FALSE(memory.holdsWholeNodes()) << "somebody may listen to the next frame";
    EXPECT_EQ(frame(false), 1u);

    memory.allowWholeNodes();
    EXPECT_EQ(frame(true), 0u);
    EXPECT_TRUE(memory.holdsWholeNodes());
    EXPECT_EQ(frame(true), 1u);
    EXPECT_EQ(frame(false), 0u);
    EXPECT_FALSE(memory.holdsWholeNodes());
    EXPECT_EQ(frame(false), 1u);
    EXPECT_EQ(frame(true), 0u);
}

TEST(NodeMemory, OtherTreesMakeItForgetEvenWhereTheyStandAtTheSameAddress)
{
    const auto                 shared = scene(1);
    std::allocator<SceneTrees> places;
    SceneTrees* const          trees = places.allocate(1);
    std::construct_at(trees, *shared, TreeKind::Octree);
    NodeMemory memory;
    memory.begin(*trees);
    memory.remember({InstanceId{0}, &trees->instances().root(), &trees->mesh(MeshId{0}).root()});
    memory.finish();
    memory.begin(*trees);
    EXPECT_EQ(memory.lastFrame().size(), 1u);
    memory.remember(memory.lastFrame().front());
    memory.finish();

    std::destroy_at(trees);
    std::construct_at(trees, *shared, TreeKind::Octree);  // in the same place
    memory.begin(*trees);
    EXPECT_TRUE(memory.lastFrame().empty());
    std::destroy_at(trees);
    places.deallocate(trees, 1);
}

}  // namespace
}  // namespace zscope
