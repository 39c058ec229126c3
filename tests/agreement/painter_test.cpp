// The painter's algorithm: right where one order is right for all pixels, and wrong, and counted, where none is.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/frame/observed_run.h"
#include "core/measure/verify.h"
#include "core/method/painter.h"
#include "core/probe/recorders.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

const Preset& painter() { return *findPreset("painter"); }

VerifyRow judged(const std::string& word, int width, int height)
{
    const Scene scene = builtinScene(word);
    const auto  rows  = verify({.scene      = prepared(scene),
                                .camera     = cameraFor(scene, width, height),
                                .algorithms = {painter()},
                                .threads    = {2}});
    EXPECT_TRUE(rows.ok()) << word;
    return rows.ok() ? rows->front() : VerifyRow{};
}

TEST(Painter, IsRightWhereLayersLieOneBehindTheOther)
{
    for (const char* word : {"layers?count=9&order=front", "layers?count=9&order=back", "hard/C1"}) {
        const VerifyRow row = judged(word, 97, 61);
        EXPECT_TRUE(row.figures.isExact()) << word << ": of equal depths the lower id lies on top";
        EXPECT_GT(row.figures.covered, 100u) << word;
    }
}

TEST(Painter, IsWrongWhereTrianglesPierceOrOverlapInACircleAndItsPixelsAreCounted)
{
    for (const char* word : {"hard/C3", "hard/C4"}) {
        const VerifyRow row = judged(word, 128, 128);
        EXPECT_EQ(row.claim, Claim::Approximate);
        EXPECT_GT(row.figures.wrongSurface(), 20u) << word;
        EXPECT_EQ(row.figures.holes + row.figures.spills, 0u)
            << word << ": which pixels are covered does not depend on order";
        EXPECT_TRUE(row.passed()) << "its figures are published, not judged";
    }
}

/// The order as it was painted.
struct Order {
    using Events = Wants<plain::TrianglePainted>;

    std::vector<plain::TrianglePainted> painted = {};

    void observe(const plain::TrianglePainted& e) { painted.push_back(e); }
};

TEST(Painter, PaintsEveryTriangleInViewOnceFromTheFarthestToTheNearest)
{
    const Soup     soup = makeSoup(SoupKind::Loose, 5, 61, 47, 90);
    Frame          frame;
    plain::Scratch scratch;
    Order          order;
    Listening      listening(order);
    drawObserved({.scene = prepared(soup.scene), .camera = soup.camera, .pipeline = painter().pipeline}, frame, scratch,
                 listening);
    ASSERT_GT(order.painted.size(), 20u);
    for (std::size_t i = 0; i < order.painted.size(); ++i) {
        EXPECT_EQ(order.painted[i].place, i + 1);
        EXPECT_EQ(order.painted[i].count, order.painted.size());
        if (i > 0) {
            EXPECT_LE(order.painted[i - 1].farthest, order.painted[i].farthest);
        }
    }
}

/// Notes the fragments that are not kept.
struct Lost {
    using Events = Wants<PixelTested>;

    std::vector<PixelTested> lost = {};
    std::uint64_t            won  = 0;

    void observe(const PixelTested& e)
    {
        won += e.won;
        if (!e.won) lost.push_back(e);
    }
};

TEST(Painter, KeepsEveryFragmentThatTheFarPlaneDoes)
{
    const Soup     soup = makeSoup(SoupKind::Turned, 7, 80, 60, 60);
    Frame          frame;
    plain::Scratch scratch;
    Lost           fragments;
    Listening      listening(fragments);
    drawObserved({.scene = prepared(soup.scene), .camera = soup.camera, .pipeline = painter().pipeline}, frame, scratch,
                 listening);
    EXPECT_GT(fragments.won, 1000u);
    for (const PixelTested& e : fragments.lost)
        EXPECT_LE(e.depth, frame.visible.empty()) << "no depth is compared but with the far plane's";
}

}  // namespace
}  // namespace zscope::tests
