// Any thread may open the nodes of a tree, and ask for a mesh's tree or a node's batches: all see the same ones.
#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

#include "core/hierarchy/scene_trees.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

/// Everything below the node: names, items, and how many triangles its batches hold. `last` child first, if asked.
void describe(const Tree& tree, const TreeNode& node, const Mesh& mesh, bool lastFirst,
              std::vector<std::uint64_t>& words)
{
    const auto children = tree.childrenOf(tree.open(node));
    for (std::size_t i = 0; i < children.size() && lastFirst; ++i) tree.open(children[children.size() - 1 - i]);
    words.push_back(static_cast<std::uint64_t>(node.slot));
    for (const std::uint32_t item : tree.ownItems(node)) words.push_back(item);
    words.push_back(tree.batchesOf(node, mesh).triangleCount());
    for (const TreeNode& child : children) describe(tree, child, mesh, lastFirst, words);
}

TEST(TreeThreads, SeveralThreadsOpenOneTreeAtOnceAndAllSeeTheSame)
{
    auto loaded = loadScene("builtin:soup?count=20000");
    ASSERT_TRUE(loaded.ok());
    const auto  scene = std::make_shared<const Scene>(*std::move(loaded));
    const Mesh& mesh  = *scene->meshes[0];
    for (const TreeKind kind : {TreeKind::Octree, TreeKind::Bvh}) {
        std::vector<std::uint64_t> expected;
        const PreparedScene        alone(scene);
        const Tree&                tree = treesOf(alone, kind).mesh(MeshId{0});
        describe(tree, tree.root(), mesh, false, expected);
        ASSERT_GT(tree.nodeCount(), 20u);

        const PreparedScene                     shared(scene);
        std::vector<std::vector<std::uint64_t>> seen(4);
        std::vector<std::thread>                workers;
        for (std::size_t i = 0; i < seen.size(); ++i)
            workers.emplace_back([&, i] {
                const Tree& mine = treesOf(shared, kind).mesh(MeshId{0});
                describe(mine, mine.root(), mesh, i % 2 == 1, seen[i]);
            });
        for (std::thread& worker : workers) worker.join();
        for (const auto& words : seen) EXPECT_EQ(words, expected);
        EXPECT_EQ(treesOf(shared, kind).mesh(MeshId{0}).nodeCount(), tree.nodeCount());
        EXPECT_EQ(treesOf(shared, kind).bytes(), treesOf(alone, kind).bytes());
    }
}

}  // namespace
}  // namespace zscope
