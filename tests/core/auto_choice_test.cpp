// The preset `auto` chooses by what frames cost. Here the costs are made up; no clock is read.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "core/frame/auto_choice.h"
#include "core/scene/load.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

using Times = std::map<std::string, double>;  // ms a frame, by preset

const Times kTreesPay{{"zbuffer", 20}, {"hzb-octree", 5}, {"hzb-bvh", 6}, {"two-pass", 4}, {"scanline", 80}};
const Times kAlike{{"zbuffer", 3}, {"hzb-octree", 3.02}, {"hzb-bvh", 3.02}, {"two-pass", 3.02}, {"scanline", 9}};
const Times kTreesDoNot{{"zbuffer", 3}, {"hzb-octree", 5}, {"hzb-bvh", 4.4}, {"two-pass", 3.6}, {"scanline", 9}};

constexpr SceneNumbers kSmall{.trianglesInView = 70'000, .pixels = 1'000'000};
constexpr SceneNumbers kLarge{.trianglesInView = 1'000'000, .pixels = 1'000'000};

/// Draws frames that take what `times` says.
struct Drawing {
    AutoChoice                 choice;
    double                     ms     = 0;
    double                     least  = 0;  // by the fastest, every time
    int                        frames = 0;
    std::map<std::string, int> drawnBy;

    explicit Drawing(const SceneNumbers& numbers) : choice(numbers) {}

    void draw(const Times& times)
    {
        const double whole = times.at(std::string(choice.preset().name));
        ++drawnBy[std::string(choice.preset().name)];
        ms += whole;
        double fastest = whole;
        for (const auto& [name, time] : times) fastest = std::min(fastest, time);
        least += fastest;
        ++frames;
        choice.drawn({.whole = whole, .geometry = 0.5 * whole, .culling = 0.1 * whole, .raster = 0.4 * whole});
    }
    void settle(const Times& times)
    {
        for (int guard = 0; choice.isTrial() && guard < 100; ++guard) draw(times);
        ASSERT_FALSE(choice.isTrial());
    }
};

TEST(AutoChoice, TheFirstFrameDependsOnTheTrianglesInViewAlone)
{
    EXPECT_EQ(AutoChoice(kSmall).preset().name, "zbuffer");
    EXPECT_EQ(AutoChoice(kLarge).preset().name, "hzb-octree");
    EXPECT_EQ(AutoChoice({.trianglesInView = AutoChoice::kFewTriangles}).preset().name, "zbuffer");
    EXPECT_EQ(AutoChoice({.trianglesInView = AutoChoice::kFewTriangles + 1, .threads = 64}).preset().name,
              "hzb-octree");
    EXPECT_TRUE(AutoChoice(kSmall).isTrial());
}

TEST(AutoChoice, TheFastestOfThoseTriedIsKept)
{
    for (const SceneNumbers& numbers : {kSmall, kLarge}) {
        Drawing paying(numbers), notPaying(numbers);
        paying.settle(kTreesPay);
        EXPECT_EQ(paying.choice.preset().name, "two-pass");
        notPaying.settle(kTreesDoNot);
        EXPECT_EQ(notPaying.choice.preset().name, "zbuffer");
        EXPECT_LE(paying.frames, AutoChoice::kMostTrialFrames);
    }
}

TEST(AutoChoice, TrialsEndHoweverCloseAllAre)
{
    Drawing few({.trianglesInView = 12, .pixels = 100});
    few.settle({{"zbuffer", 3}, {"hzb-octree", 3}, {"hzb-bvh", 3}, {"two-pass", 3}, {"scanline", 3}});
    EXPECT_EQ(few.frames, AutoChoice::kMostTrialFrames);
    for (const auto& [name, frames] : few.drawnBy)
        EXPECT_EQ(frames, AutoChoice::kMostTrialFrames / AutoChoice::kCandidates) << name;
}

TEST(AutoChoice, AFrameThatWarmsUpDoesNotCountAndTheShorterOfTwoDoes)
{
    Drawing                    drawing(kSmall);
    std::map<std::string, int> frames;
    while (drawing.choice.isTrial()) {
        const std::string name(drawing.choice.preset().name);
        Times             times = kTreesDoNot;
        times[name] += frames[name] == 0 ? 1000 : frames[name] == 1 ? 0.5 : 0;
        ++frames[name];
        drawing.draw(times);
        ASSERT_LT(drawing.frames, 100);
    }
    EXPECT_EQ(drawing.choice.preset().name, "zbuffer");
    EXPECT_NE(drawing.choice.why().find("3.00 ms"), std::string::npos) << drawing.choice.why();
}

TEST(AutoChoice, OneFrameThatWasHeldUpDropsNobody)
{
    for (const int held : {0, 1}) {  // of the two that are timed
        Drawing                    drawing(kLarge);
        std::map<std::string, int> frames;
        while (drawing.choice.isTrial()) {
            const std::string name(drawing.choice.preset().name);
            Times             times = kTreesPay;
            if (frames[name]++ == AutoChoice::kWarmUp + held) times[name] *= 30;
            drawing.draw(times);
            ASSERT_LT(drawing.frames, 100);
        }
        EXPECT_EQ(drawing.choice.preset().name, "two-pass") << held;
    }
}

TEST(AutoChoice, ThoseThatAreCloseToTheFastestTakeTurns)
{
    Drawing                    drawing(kSmall);
    std::map<std::string, int> frames;
    while (drawing.choice.isTrial()) {
        const std::string name(drawing.choice.preset().name);
        Times             times = kAlike;
        // somebody else was busy
        if (name == "zbuffer" && frames[name]++ < AutoChoice::kWarmUp + AutoChoice::kTimed) times[name] += 0.5;
        drawing.draw(times);
        ASSERT_LT(drawing.frames, 100);
    }
    EXPECT_EQ(drawing.choice.preset().name, "zbuffer");
    Drawing apart(kSmall);
    Times   times = kTreesDoNot;
    for (const char* name : {"hzb-octree", "hzb-bvh", "two-pass"})
        times[name] = 1.1 * AutoChoice::kClose * times["zbuffer"];
    apart.settle(times);
    EXPECT_EQ(apart.drawnBy["zbuffer"], AutoChoice::kWarmUp + AutoChoice::kTimed) << "nobody is close";
}

TEST(AutoChoice, AMachineWithOtherWorkDoesNotHideTheFastest)
{
    struct Share {
        std::uint32_t busyOf100  = 0;  // frames, in no order
        int           leastRight = 0;  // of 1000
    };
    for (const Share& share : {Share{50, 995}, Share{75, 930}}) {
        int right = 0;
        for (int seed = 0; seed < 1000; ++seed) {
            Drawing       drawing(kLarge);
            std::uint32_t state = 2654435761u * static_cast<std::uint32_t>(seed + 1);
            while (drawing.choice.isTrial()) {
                Times times       = kTreesPay;
                times["two-pass"] = 4.9;
                times["hzb-bvh"]  = 4;
                state             = state * 1664525u + 1013904223u;
                const bool isBusy = (state >> 16) % 100 < share.busyOf100;
                for (auto& [name, time] : times) time *= isBusy ? 1.5 : 1;
                drawing.draw(times);
                ASSERT_LE(drawing.frames, AutoChoice::kMostTrialFrames);
            }
            right += drawing.choice.preset().name == "hzb-bvh";
        }
        EXPECT_GE(right, share.leastRight)
            << share.busyOf100 << " %: it loses only if all of its frames come when the machine is busy";
    }
}

TEST(AutoChoice, ASlowPhaseDoesNotHideTheFastest)
{
    int right = 0;
    for (int seed = 0; seed < 1000; ++seed) {
        Drawing       drawing(kLarge);
        std::uint32_t state  = 2654435761u * static_cast<std::uint32_t>(seed + 1);
        int           left   = 0;  // frames of the phase at hand
        bool          isSlow = false;
        while (drawing.choice.isTrial()) {
            if (left-- == 0) {
                state  = state * 1664525u + 1013904223u;
                left   = 5 + static_cast<int>(state >> 16) % 10;  // longer than a trial
                isSlow = !isSlow;
            }
            Times times       = kTreesPay;
            times["two-pass"] = 4.9;
            times["hzb-bvh"]  = 4;
            for (auto& [name, time] : times) time *= isSlow ? 1.5 : 1;
            drawing.draw(times);
            ASSERT_LE(drawing.frames, AutoChoice::kMostTrialFrames);
        }
        right += drawing.choice.preset().name == "hzb-bvh";
    }
    EXPECT_GE(right, 990) << "turns come in every phase";
}

TEST(AutoChoice, WhatCannotPayIsNeverTried)
{
    Drawing tower({.trianglesInView = 538'000'000, .pixels = 1'000'000, .threads = 2});
    Times   times    = kTreesPay;
    times["zbuffer"] = times["scanline"] = 1e6;
    tower.settle(times);
    EXPECT_FALSE(tower.drawnBy.contains("zbuffer")) << "2.7 seconds at least";
    EXPECT_FALSE(tower.drawnBy.contains("scanline"));
    EXPECT_TRUE(tower.drawnBy.contains("hzb-bvh"));
    for (int i = 0; i < 5000; ++i) tower.draw(times);
    EXPECT_FALSE(tower.drawnBy.contains("zbuffer")) << "nor later";

    Drawing few({.trianglesInView = 12, .pixels = 100});
    few.settle(kTreesDoNot);
    EXPECT_TRUE(few.drawnBy.contains("scanline")) << "a dozen triangles are swept quickly";
}

TEST(AutoChoice, AHopelessZBufferDrawsOneFrameAndNotThree)
{
    Drawing drawing(kLarge);
    Times   times    = kTreesPay;
    times["zbuffer"] = 500;
    drawing.settle(times);
    EXPECT_EQ(drawing.drawnBy["zbuffer"], 1);
}

TEST(AutoChoice, LaterTrialsCostAHundredthAtMost)
{
    Drawing drawing(kLarge);
    drawing.settle(kTreesPay);
    const double msBefore = drawing.ms, leastBefore = drawing.least;
    const int    bvhBefore = drawing.drawnBy["hzb-bvh"];
    for (int i = 0; i < 20000; ++i) drawing.draw(kTreesPay);
    EXPECT_GT(drawing.drawnBy["hzb-bvh"], bvhBefore) << "it is tried again now and then";
    EXPECT_LE(drawing.ms - msBefore, 1.011 * (drawing.least - leastBefore));
}

TEST(AutoChoice, WhenTheTimesDriftTheOthersAreTriedAgain)
{
    Drawing drawing(kSmall);
    drawing.settle(kAlike);
    for (int i = 0; i < AutoChoice::kKeptFrames - 50; ++i) drawing.draw(kAlike);
    ASSERT_EQ(drawing.choice.preset().name, "zbuffer");
    for (int i = 0; i < AutoChoice::kDriftFrames; ++i) {
        EXPECT_FALSE(drawing.choice.isTrial()) << i;
        drawing.draw(kTreesPay);
    }
    EXPECT_TRUE(drawing.choice.isTrial()) << "the z-buffer takes 20 ms instead of 3, three frames in a row";
    drawing.settle(kTreesPay);
    EXPECT_EQ(drawing.choice.preset().name, "two-pass");
    for (int i = 0; i < 3000; ++i) drawing.draw(kTreesDoNot);
    EXPECT_EQ(drawing.choice.preset().name, "zbuffer") << "and back, when trying it costs little enough";
}

TEST(AutoChoice, OneLongFrameIsNoDrift)
{
    Drawing drawing(kSmall);
    drawing.settle(kTreesDoNot);
    Times slow      = kTreesDoNot;
    slow["zbuffer"] = 1000;
    for (int i = 0; i < 100; ++i) {
        drawing.draw(i % 4 == 3 ? slow : kTreesDoNot);
        ASSERT_FALSE(drawing.choice.isTrial()) << i;
    }
}

TEST(AutoChoice, TheSentenceNamesTheChoiceItsTimeAndTheOthers)
{
    Drawing drawing(kSmall);
    EXPECT_NE(drawing.choice.why().find("70000 triangles"), std::string::npos) << drawing.choice.why();
    drawing.settle(kTreesPay);
    const std::string why = drawing.choice.why();
    for (const char* part : {"two-pass", "4.00 ms", "culling takes 0.40 ms", "80 % of the time for triangles", "1.6 ns",
                             "zbuffer 20.00 ms", "hzb-octree 5.00 ms"})
        EXPECT_NE(why.find(part), std::string::npos) << part << " in: " << why;
}

TEST(AutoChoice, TrianglesInViewAreThoseOfInstancesThatReachIt)
{
    const Camera  camera = plainCamera(64, 64);
    const Corners corners{pointAt(camera, 10, 10, 4), pointAt(camera, 50, 10, 4), pointAt(camera, 30, 50, 5)};
    const auto    scene = std::make_shared<const PreparedScene>(sceneOf(std::span(&corners, 1)));
    EXPECT_EQ(numbersOf(*scene, camera, 1).trianglesInView, 1u);
    EXPECT_EQ(numbersOf(*scene, camera, 1).pixels, 64u * 64u);
    Camera away  = camera;
    away.forward = -away.forward;
    away.right   = -away.right;
    EXPECT_EQ(numbersOf(*scene, away, 1).trianglesInView, 0u);
}

}  // namespace
}  // namespace zscope::tests
