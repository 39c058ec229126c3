// The hard cases of octree and BVH, docs/correctness.md, E1 to E8. What the trees hold is claimed by the test of the
// trees; here every preset draws them.

#include <algorithm>

#include "core/hierarchy/scene_trees.h"
#include "tests/agreement/hard_support.h"

namespace zscope::hardcase {
namespace {

std::int64_t coveredPixels(const Picture& picture)
{
    return std::ranges::count_if(picture.ids.values(), [](std::int64_t id) { return id >= 0; });
}

TEST(HardE, E1GeometryInTheSplittingPlanesIsDrawnOnce)
{
    const HardCase hard    = hardCase("E1");
    const Picture  picture = agreedPicture(hard);
    EXPECT_GT(coveredPixels(picture), 500);
    const Tree& tree = treesOf(*hard.prepared, TreeKind::Octree).mesh(MeshId{0});
    EXPECT_GT(tree.nodeCount(), 8u) << "it was divided";
    for (const TreeNode& child : tree.childrenOf(tree.root()))
        EXPECT_FALSE(child.straddles) << "and no square crosses a plane";
    expectCounters(hard);
    expectShuffledTwin(hard, picture);
    expectScaledTwin(hard, picture, 10);
}

TEST(HardE, E2CoincidentTrianglesShowTheLowestId)
{
    for (const int count : {1000, 20'000}) {
        const HardCase hard    = hardCase("E2?count=" + std::to_string(count));
        const Picture  picture = agreedPicture(hard, count > 1000 ? Effort::EachPreset : Effort::All);
        for (const std::int64_t id : picture.ids.values()) EXPECT_TRUE(id <= 0 || id == count);
        EXPECT_GT(coveredPixels(picture), 800);
        EXPECT_LE(treesOf(*hard.prepared, TreeKind::Octree).mesh(MeshId{0}).nodeCount(), 2u * Tree::kMaxDepth + 1);
    }
}

TEST(HardE, E3AGiantAmongTinyOnes)
{
    const HardCase hard    = hardCase("E3");
    const Picture  picture = agreedPicture(hard);
    EXPECT_GT(std::ranges::count(picture.ids.values(), 0), 2000);
    EXPECT_GT(std::ranges::count_if(picture.ids.values(), [](std::int64_t id) { return id > 0; }), 100);
    expectCounters(hard);
    expectTwins(hard, picture);
}

TEST(HardE, E4FlatScenesPointsAndNothing)
{
    for (const char* shape : {"wall", "floor", "line", "point"}) {
        const HardCase hard    = hardCase(std::string("E4?shape=") + shape);
        const Picture  picture = agreedPicture(hard);
        const bool     isSeen  = std::string(shape) == "wall" || std::string(shape) == "floor";
        EXPECT_EQ(coveredPixels(picture) > 100, isSeen) << shape;
        if (!isSeen) {
            EXPECT_EQ(coveredPixels(picture), 0) << shape;
        }
        expectCounters(hard);
    }
    Scene          nothing;
    const HardCase empty   = hardCase("nothing", std::move(nothing), hardCase("E1").camera);
    const Picture  picture = agreedPicture(empty);
    EXPECT_EQ(coveredPixels(picture), 0);
}

TEST(HardE, E5TinyNextToHugeLosesNothing)
{
    const HardCase hard    = hardCase("E5");
    const Picture  picture = agreedPicture(hard);
    const auto     shownOf = [&](std::int64_t from, std::int64_t to) {
        return std::ranges::count_if(picture.ids.values(), [&](std::int64_t id) { return id >= from && id < to; });
    };
    EXPECT_GT(shownOf(0, 400), 100) << "the tiny ones";
    EXPECT_GT(shownOf(400, 801), 100) << "the huge ones behind them";
    expectCounters(hard);
    expectShuffledTwin(hard, picture);
}

TEST(HardE, E6EqualCentresInEitherOrderGiveTheSameDepths)
{
    const HardCase forward = hardCase("E6?order=forward"), reversed = hardCase("E6?order=reversed");
    const Picture  one = agreedPicture(forward), other = agreedPicture(reversed);
    EXPECT_EQ(one.depth, other.depth);
    EXPECT_GT(coveredPixels(one), 1000);
    expectCounters(forward);
    expectShuffledTwin(forward, one);
}

TEST(HardE, E7TheEyeInsideOnAFaceAndOnACornerOfNodes)
{
    for (const char* eye : {"corner", "edge", "face", "inside"}) {
        const HardCase hard    = hardCase(std::string("E7?eye=") + eye);
        const Picture  picture = agreedPicture(hard);
        EXPECT_GT(coveredPixels(picture), 4000) << eye;
        expectCounters(hard);
        // In every direction, by turning the camera about its own axes.
        Camera turned = hard.camera;
        for (int turn = 0; turn < 5; ++turn) {
            const dvec3 before                    = turned.forward;
            turned.forward                        = turn < 3 ? turned.right : turned.up;
            (turn < 3 ? turned.right : turned.up) = -before;
            const HardCase there = changed(hard, "turned " + std::to_string(turn), turned, [](auto&, auto&) {});
            EXPECT_GT(coveredPixels(agreedPicture(there, Effort::EachPreset)), 4000) << eye << ", turn " << turn;
        }
    }
}

TEST(HardE, E8WhatCrossesTheNearPlaneIsNotCulledByDepth)
{
    const HardCase hard    = hardCase("E8");
    const Picture  picture = agreedPicture(hard);
    EXPECT_GT(std::ranges::count_if(picture.ids.values(), [](std::int64_t id) { return id >= 0 && id < 600; }), 500);
    EXPECT_GT(std::ranges::count_if(picture.ids.values(), [](std::int64_t id) { return id >= 600; }), 500)
        << "the wall is seen";
    expectCounters(hard);
    expectScaledTwin(hard, picture, 12);
    expectShuffledTwin(hard, picture);
}

}  // namespace
}  // namespace zscope::hardcase
