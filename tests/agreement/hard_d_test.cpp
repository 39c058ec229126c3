// The hard cases of the pyramid, docs/correctness.md, D1 to D9. Its cells are held to brute force in the test of its
// own; here the frames are: every preset, and how much each of them hid. D8 is about frames that follow one another;
// what else may change between frames is in the coherence test.

#include <algorithm>

#include "core/measure/error_figures.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/hard_support.h"

namespace zscope::hardcase {
namespace {

using Counters = std::map<std::string, std::uint64_t>;

Counters countersOfCase(const HardCase& hard, const char* preset)
{
    DrawRequest request;
    request.scene    = hard.prepared;
    request.camera   = hard.camera;
    request.pipeline = findPreset(preset)->pipeline;
    return zscope::tests::countersOf(request);
}

std::uint64_t hiddenBy(const HardCase& hard, const char* preset)
{
    const Counters counters = countersOfCase(hard, preset);
    return counters.at("triangles_hidden_by_node") + counters.at("triangles_hidden");
}

/// Presets that see what hides before what is hidden, whatever the order of the file: an octree's order is exact (that
/// of a BVH is not), and a pre-pass has seen everything.
constexpr const char* kComplete[] = {"hzb-octree", "hzb-simple", "hzb-bvh-prepass"};

bool isWall(const HardCase& hard, std::int64_t id)
{
    return id >= static_cast<std::int64_t>(hard.scene->triangleCount()) - 2;
}

TEST(HardD, D1ASheetBehindOneCellIsHiddenAndOneAPixelWiderShowsThatPixel)
{
    for (int level = 3; level <= 5; ++level) {
        const int      side    = 1 << level;
        const HardCase exact   = hardCase("D1?level=" + std::to_string(level));
        const Picture  picture = agreedPicture(exact);
        for (const std::int64_t id : picture.ids.values()) EXPECT_TRUE(id < 0 || isWall(exact, id));
        for (const char* preset : kComplete) {
            const Counters counters = countersOfCase(exact, preset);
            EXPECT_EQ(counters.at("triangles_drawn"), 2u) << preset << ", level " << level;
        }
        expectTwins(exact, picture);

        const HardCase wider  = hardCase("D1?wider=yes&level=" + std::to_string(level));
        const Picture  behind = agreedPicture(wider);
        int            shown  = 0;
        for (int y = 0; y < wider.height(); ++y)
            for (int x = 0; x < wider.width(); ++x)
                if (behind.ids.at(x, y) >= 0 && !isWall(wider, behind.ids.at(x, y))) {
                    EXPECT_EQ(x, 2 * side);
                    ++shown;
                }
        EXPECT_EQ(shown, side);
        expectCounters(wider);
    }
}

TEST(HardD, D2WhatLiesBehindAHoleOfOnePixelIsSeenThroughIt)
{
    for (const int level : {0, 3, 4, 6})
        for (int corner = 0; corner < 4; ++corner) {
            const int      x = (1 << level) - (corner & 1), y = (1 << level) - (corner >> 1);
            const HardCase hard    = hardCase("D2?x=" + std::to_string(x) + "&y=" + std::to_string(y));
            const Picture  picture = agreedPicture(hard, Effort::EachPreset);
            for (int j = 0; j < hard.height(); ++j)
                for (int i = 0; i < hard.width(); ++i)
                    ASSERT_EQ(picture.ids.at(i, j) < 512, i == x && j == y) << hard.word << " at " << i << ", " << j;
            EXPECT_GT(hiddenBy(hard, "hzb-octree"), 300u) << hard.word;
        }
    for (const char* border : {"D2?x=0&y=0", "D2?x=127&y=0", "D2?x=0&y=127", "D2?x=127&y=127", "D2?x=127&y=64"}) {
        const HardCase hard    = hardCase(border);
        const Picture  picture = agreedPicture(hard);
        EXPECT_EQ(std::ranges::count_if(picture.ids.values(), [](std::int64_t id) { return id < 512; }), 1) << border;
        expectTwins(hard, picture);
    }
}

TEST(HardD, D4EqualDepthIsNotCulledAndTheLowerIdWins)
{
    for (const bool wallFirst : {true, false}) {
        const HardCase hard    = hardCase(std::string("D4?steps=0&first=") + (wallFirst ? "wall" : "sheet"));
        const Picture  picture = agreedPicture(hard);
        for (int y = 0; y < hard.height(); ++y)
            for (int x = 0; x < hard.width(); ++x) {
                ASSERT_EQ(picture.depth.at(x, y), 0.25f);
                const bool inSheet = x >= 32 && x < 96 && y >= 32 && y < 96;
                const bool isSheet = wallFirst ? picture.ids.at(x, y) >= 2 : picture.ids.at(x, y) < 512;
                ASSERT_EQ(isSheet, inSheet && !wallFirst) << hard.word << " at " << x << ", " << y;
            }
        for (const char* preset : kComplete)
            EXPECT_EQ(hiddenBy(hard, preset), 0u) << preset << ": it might win by its id";
        expectCounters(hard);
        expectReversedTwin(hard, picture);
        expectShuffledTwin(hard, picture);
    }
}

TEST(HardD, D5OneStepNearerIsSeenAndOneStepFartherIsCulled)
{
    for (const int steps : {-2, -1, 1, 2})
        for (const char* first : {"wall", "sheet"}) {
            const HardCase hard    = hardCase("D4?steps=" + std::to_string(steps) + "&first=" + first);
            const Picture  picture = agreedPicture(hard);
            const bool     isSheet = depthSteps(0.25f, picture.depth.at(64, 64)) > 0;
            EXPECT_EQ(isSheet, steps > 0) << hard.word;
            EXPECT_EQ(depthSteps(0.25f, picture.depth.at(64, 64)), std::max(steps, 0)) << hard.word;
            EXPECT_EQ(picture.depth.at(2, 2), 0.25f);
            // After a pre-pass each triangle of the sheet is asked about against the finished depth. (A node's bound is
            // rounded outward by a step, so it may take two.)
            EXPECT_EQ(hiddenBy(hard, "hzb-simple"), steps < 0 ? 512u : 0u) << hard.word;
        }
}

TEST(HardD, D6RectanglesOverTheBordersAreJudgedByTheirInsidePart)
{
    const HardCase hard    = hardCase("D6");
    const Picture  picture = agreedPicture(hard);
    for (int y = 0; y < hard.height(); ++y)
        for (int x = 0; x < hard.width(); ++x) {
            const bool behind = x >= 120 && y < 40;
            ASSERT_EQ(picture.ids.at(x, y) >= 0, x < 120 || behind) << x << ", " << y;
            ASSERT_EQ(picture.depth.at(x, y), x < 120 ? 0.125f : behind ? 0.0625f : 0.0f);
        }
    for (const char* preset : kComplete) EXPECT_GT(hiddenBy(hard, preset), 500u) << preset;
    expectCounters(hard);
    expectTwins(hard, picture);
}

TEST(HardD, D7AStripAsWideAsThePictureIsSeenInItsLastPixel)
{
    for (const int width : {9, 64, 65, 511, 512, 513, 1025}) {
        const HardCase hard    = hardCase("D7?width=" + std::to_string(width));
        const Picture  picture = agreedPicture(hard, Effort::EachPreset);
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < width; ++x) {
                const bool last = x == width - 1;
                ASSERT_EQ(picture.depth.at(x, y), last              ? (y >= 2 && y < 5 ? 0.0625f : 0.0f)
                                                  : y >= 1 && y < 6 ? 0.125f
                                                                    : 0.0f);
            }
        expectCounters(hard);
    }
}

/// The case's camera turned about its own up axis by whole quarters.
Camera turned(Camera camera, int quarters)
{
    for (; quarters > 0; --quarters) {
        const dvec3 right = camera.right;
        camera.right      = -camera.forward;
        camera.forward    = right;
    }
    return camera;
}

/// The sheet behind the wall, without the wall.
HardCase withoutWall(const HardCase& hard)
{
    return only(hard, [&hard](std::uint32_t id) { return !isWall(hard, id); });
}

TEST(HardD, D8AfterACutAHalfTurnAndARemovedOccluderTwoPassesAreExactInEveryFrame)
{
    const HardCase wall = hardCase("D1?level=5"), open = withoutWall(wall), hole = hardCase("D2?x=63&y=64");
    struct View {
        const char*     what;
        const HardCase& hard;
        Camera          camera;
    };
    Camera nearer = wall.camera;
    nearer.eye += 0.5 * nearer.near * nearer.forward;
    const View way[] = {{"first", wall, wall.camera},
                        {"again", wall, wall.camera},
                        {"after a half-turn", wall, turned(wall.camera, 2)},
                        {"back", wall, wall.camera},
                        {"after a cut", wall, nearer},
                        {"after a quarter", wall, turned(nearer, 1)},
                        {"before the wall again", wall, wall.camera},
                        {"without the wall", open, open.camera},
                        {"with it again", wall, wall.camera},
                        {"another wall with a hole", hole, hole.camera},
                        {"which has become larger", hole, nearer}};
    for (const Preset& preset : presets()) {
        if (!preset.isExact() || preset.pipeline.coherence == Coherence::None) continue;
        for (const int threads : {1, 2, 3}) {
            Renderer renderer;
            Frame    frame;
            for (const View& view : way) {
                const auto expected = referencePicture(*view.hard.scene, view.camera, FaceCulling::None);
                ASSERT_TRUE(expected.ok());
                DrawRequest request;
                request.scene    = view.hard.prepared;
                request.camera   = view.camera;
                request.pipeline = preset.pipeline;
                request.threads  = threads;
                ASSERT_TRUE(renderer.draw(request, frame).ok());
                EXPECT_TRUE(*expected == pictureOf(frame.visible))
                    << preset.name << ", " << threads << " threads, " << view.what;
            }
        }
    }
    const auto shown = referencePicture(*open.scene, open.camera, FaceCulling::None);
    EXPECT_TRUE(std::ranges::any_of(shown->ids.values(), [](std::int64_t id) { return id >= 0; }))
        << "the wall hid something";
}

/// The same way without the second pass: what has come out from behind the wall is missing for a frame, and then it is
/// there.
TEST(HardD, D8WithoutASecondPassTheOccluderHidesForOneFrameAfterItIsGone)
{
    const HardCase wall = hardCase("D1?level=5"), open = withoutWall(wall);
    Pipeline       lagging = findPreset("hzb-octree")->pipeline;
    lagging.coherence      = Coherence::LastPyramid;
    EXPECT_EQ(claimOf(lagging), Claim::Approximate);
    for (const int threads : {1, 2, 3}) {
        Renderer   renderer;
        Frame      frame;
        const auto wrongAfter = [&](const HardCase& hard) {
            DrawRequest request;
            request.scene    = hard.prepared;
            request.camera   = hard.camera;
            request.pipeline = lagging;
            request.threads  = threads;
            EXPECT_TRUE(renderer.draw(request, frame).ok());
            const auto expected = referencePicture(*hard.scene, hard.camera, FaceCulling::None);
            return compare(*expected, pictureOf(frame.visible)).wrongPixels();
        };
        EXPECT_EQ(wrongAfter(wall), 0u) << "a first frame has nothing to be misled by";
        EXPECT_EQ(wrongAfter(wall), 0u) << "nothing has moved";
        const std::uint64_t lag = wrongAfter(open);
        EXPECT_EQ(lag, 32u * 32u) << threads << " threads: the whole sheet is missing";
        EXPECT_EQ(wrongAfter(open), 0u) << "a frame later it is there";
    }
}

TEST(HardD, D9FromFarToNearEverySheetIsDrawnOverWhatWasThere)
{
    const HardCase hard    = hardCase("D9");
    const Picture  picture = agreedPicture(hard);
    for (int y = 0; y < hard.height(); ++y)
        for (int x = 0; x < hard.width(); ++x) {
            const int ring = std::min({x, y, 127 - x, 127 - y, 23});
            ASSERT_EQ(picture.depth.at(x, y), static_cast<float>(0.03125 * (1 + ring * 0.125))) << x << ", " << y;
        }
    EXPECT_EQ(hiddenBy(hard, "quadtree"), 0u) << "in the order of the file nothing is hidden when it comes";
    EXPECT_GT(hiddenBy(hard, "hzb-octree"), hard.scene->triangleCount() / 8);
    expectCounters(hard);
    expectTwins(hard, picture);
}

}  // namespace
}  // namespace zscope::hardcase
