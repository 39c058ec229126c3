// What is said about other renderers: how their pictures differ from ours, and how ratios are formed. None of them is
// needed.
#include "app/cli/peers/peer.h"
#include "app/cli/peers/peer_tables.h"

#include <gtest/gtest.h>

#include "core/measure/bench.h"
#include "core/scene/load.h"

namespace zscope::cli {
namespace {

PeerRun shows(const Grid<std::int64_t>& ids, const Grid<float>& depth)
{
    PeerRun run;
    run.ids   = ids;
    run.depth = depth;
    return run;
}

TEST(PeerDifference, CountsIdsThatDifferAndWhetherOurPictureShowsThemNextToThePixel)
{
    Grid<std::int64_t> ours(8, 4, -1);
    const Grid<float>  depth(8, 4, 0.5f);
    ours.at(2, 1)             = 7;
    Grid<std::int64_t> theirs = ours;
    EXPECT_EQ(differenceOf(shows(theirs, depth), ours, depth).pixels, 0u);
    theirs.at(3, 2)                 = 7;  // beside our 7
    theirs.at(6, 3)                 = 7;  // far from it
    theirs.at(0, 0)                 = 9;  // nowhere in our picture
    const PeerDifference difference = differenceOf(shows(theirs, depth), ours, depth);
    EXPECT_EQ(difference.pixels, 3u);
    EXPECT_EQ(difference.besideEdges, 1u);
}

TEST(PeerDifference, WithoutIdsComparesCoverageAndDistanceToOnePartInAHundred)
{
    const Grid<std::int64_t> ids(8, 4, 0);
    Grid<float>              ours(8, 4, 0.5f);
    for (int y = 0; y < 4; ++y) ours.at(7, y) = 0;
    Grid<float> theirs = ours;
    theirs.at(1, 1)    = 0.504f;
    EXPECT_EQ(differenceOf(shows({}, theirs), ids, ours).pixels, 0u);
    theirs.at(1, 1)                 = 0.51f;  // too near, and nothing of ours is there
    theirs.at(6, 2)                 = 0;      // a hole beside our background
    theirs.at(7, 3)                 = 0.5f;   // covered beside our surface
    theirs.at(3, 2)                 = 0;      // a hole in the middle of ours
    const PeerDifference difference = differenceOf(shows({}, theirs), ids, ours);
    EXPECT_EQ(difference.pixels, 4u);
    EXPECT_EQ(difference.besideEdges, 2u);
}

TEST(Peers, RefuseScenesWithTransparentOrCutOutSurfacesOnly)
{
    for (const auto& [word, isDrawable] :
         {std::pair{"builtin:cubes", true}, {"builtin:glass", false}, {"builtin:cutouts", false}}) {
        const auto scene = loadScene(word);
        ASSERT_TRUE(scene.ok()) << word;
        EXPECT_EQ(explainUndrawable(*scene).empty(), isDrawable) << word;
    }
}

BenchRow row(const char* scene, const char* algorithm, bool shaded, double ms, std::uint64_t wrong = 0)
{
    BenchRow row;
    row.scene       = scene;
    row.algorithm   = algorithm;
    row.shaded      = shaded;
    row.medianMs    = ms;
    row.wrongPixels = wrong;
    if (row.algorithm.starts_with("peer:")) row.counters = {{"pixels_that_differ", wrong}, {"of_them_beside_edges", 0}};
    return row;
}

TEST(PeerTables, HoldTheFastestRightPresetOfEachSceneAgainstThePeerThatDrawsTheSame)
{
    const std::vector<BenchRow> rows{
        row("a", "zbuffer", true, 4),   row("a", "two-pass", true, 1),         row("a", "scanline", true, 0.1, 5),
        row("a", "zbuffer", false, 10), row("a", "peer:llvmpipe", true, 2, 3), row("a", "peer:embree", false, 50),
        row("b", "zbuffer", true, 2),   row("b", "two-pass", true, 3),         row("b", "peer:llvmpipe", true, 16)};
    const std::string text    = peerTablesOf(rows);
    const auto        summary = text.substr(text.find("Shaded, 1 thread"));
    EXPECT_NE(summary.find("a               two-pass            1.000  peer:llvmpipe      2.000           2.00"),
              std::string::npos)
        << summary;
    EXPECT_NE(summary.find("b               zbuffer             2.000  peer:llvmpipe     16.000           8.00"),
              std::string::npos)
        << summary;
    const auto lineOf = [&](std::string_view title, std::size_t from) {
        const std::size_t start = summary.find(title, from);
        return summary.substr(start, summary.find('\n', start) - start);
    };
    EXPECT_TRUE(lineOf("geometric mean", 0).ends_with(" 4.00")) << summary;
    EXPECT_TRUE(lineOf("least", 0).ends_with(" 2.00")) << summary;
    EXPECT_TRUE(lineOf("geometric mean", summary.find("Ids and depth")).ends_with(" 5.00")) << summary;
    EXPECT_NE(text.find("3 differ"), std::string::npos);
}

}  // namespace
}  // namespace zscope::cli
