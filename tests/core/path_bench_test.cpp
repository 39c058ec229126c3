// Along a camera path exact methods are exact in every frame, and what errs after a cut is told frame by frame.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/measure/path_bench.h"
#include "core/scene/camera_path.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

SeriesFrame frameWith(std::uint64_t wrong)
{
    SeriesFrame frame;
    frame.wrongPixels = wrong;
    frame.covered     = 100;
    return frame;
}

TEST(Series, TheLagOfACutIsTheNumberOfWrongFramesBeforeTheFirstRightOne)
{
    const std::vector frames{frameWith(0), frameWith(9), frameWith(3), frameWith(0),
                             frameWith(5), frameWith(0), frameWith(7), frameWith(7)};
    const std::vector cuts{1, 5, 6};
    const std::vector expected{Lag{1, 2}, Lag{5, 0}, Lag{6, std::nullopt}};
    EXPECT_EQ(lagsOf(frames, cuts), expected);
    Series series;
    series.frames = frames;
    EXPECT_DOUBLE_EQ(worstShare(series), 0.09);
}

TEST(Series, IsReadBackWithItsRow)
{
    BenchRow row;
    row.simd = Simd::Scalar;
    Series series;
    series.counters     = {"nodes_visited", "fragments_tested"};
    series.frames       = {frameWith(2), SeriesFrame{}};
    series.frames[0].ms = 1.5, series.frames[0].stageMs[6] = 0.5, series.frames[0].chosen = "zbuffer",
    series.frames[0].counts = {1, 2};
    series.frames[1].counts = {3, 4};
    series.lags             = {{1, std::nullopt}, {3, 2}};
    row.series              = series;
    const auto read         = benchFromJson(benchToJson(std::vector{row}));
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(read->front().series, series);
}

TEST(ErrorFigures, TogetherCountsAddUpAndMeansWeighByPixels)
{
    ErrorFigures a, b;
    a.pixels = 10, a.covered = 4, a.holes = 1, a.exactShare = 1, a.maxDepthSteps = 3, a.distanceOnSameSurface.rms = 1;
    b.pixels = 10, b.covered = 9, b.spills = 2, b.exactShare = 0.5, b.maxDepthSteps = 2,
    b.distanceOnSameSurface.rms = 3;
    const ErrorFigures all      = together(std::vector{a, b});
    EXPECT_EQ(all.pixels, 20u);
    EXPECT_EQ(all.wrongCoverage(), 3u);
    EXPECT_EQ(all.maxDepthSteps, 3u);
    EXPECT_DOUBLE_EQ(all.exactShare, (3 + 4.5) / 12);  // 3 pixels of a, 9 of b
    EXPECT_DOUBLE_EQ(all.distanceOnSameSurface.rms, std::sqrt((3 * 1.0 + 9 * 9.0) / 12));
}

BenchRequest requestOn(const std::string& scene, std::vector<std::string> words)
{
    BenchRequest request{.scene      = std::make_shared<const Scene>(*loadScene(scene)),
                         .camera     = {},
                         .algorithms = {},
                         .threads    = {1, 2},
                         .simd       = {Simd::Scalar},
                         .warmUp     = 1,
                         .rounds     = 2};
    for (const std::string& word : words) {
        Pipeline pipeline = std::ranges::find(presets(), word.substr(0, word.find('+')), &Preset::name)->pipeline;
        if (word.find('+') != std::string::npos) pipeline.coherence = Coherence::LastPyramid;
        request.algorithms.push_back({word, pipeline, claimOf(pipeline)});
    }
    return request;
}

/// Stands, cuts to the other side, stands there.
PathRequest cutTo(const BenchRequest& request)
{
    const CameraPath path{.keys    = {{.frame = 0, .eye = {0, 0.4, 1.6}},
                                      {.frame = 2, .eye = {0.4, 0.4, -1.4}, .isCut = true},
                                      {.frame = 4, .eye = {0.4, 0.4, -1.4}}},
                          .inScene = true};
    return {.cameras = *camerasOf(path, request.scene->bounds, 80, 60), .cuts = path.cuts()};
}

TEST(PathBench, ExactMethodsAreExactInEveryFrameAndTheLastPyramidErrsOnceAfterACut)
{
    const BenchRequest request =
        requestOn("builtin:soccer-field?count=60", {"two-pass", "auto", "hzb-octree+coherence=last-pyramid"});
    const auto rows = benchPath(request, cutTo(request));
    ASSERT_TRUE(rows) << rows.error().sentence;
    ASSERT_EQ(rows->size(), 6u);
    for (const BenchRow& row : *rows) {
        ASSERT_TRUE(row.series);
        const Series& series = *row.series;
        ASSERT_EQ(series.frames.size(), 5u);
        ASSERT_EQ(series.lags.size(), 1u);
        EXPECT_EQ(row.roundMs.size(), 2u);
        EXPECT_GT(row.medianMs, 0);
        std::uint64_t wrong = 0;
        for (const SeriesFrame& frame : series.frames) {
            EXPECT_GT(frame.covered, 0u);
            EXPECT_EQ(frame.counts.size(), series.counters.size());
            EXPECT_NEAR(std::accumulate(frame.stageMs.begin(), frame.stageMs.end(), 0.0), frame.ms,
                        1e-6 + 0.03 * frame.ms);
            EXPECT_EQ(frame.chosen.empty(), row.algorithm != "auto");
            wrong += *frame.wrongPixels;
        }
        EXPECT_EQ(row.wrongPixels, wrong);
        if (row.claim == Claim::Exact) {
            EXPECT_EQ(wrong, 0u) << row.algorithm;
            EXPECT_EQ(series.lags[0].frames, 0);
        } else {
            EXPECT_EQ(series.frames[1].wrongPixels, 0u);  // it stands still
            EXPECT_GT(series.frames[2].wrongPixels, 0u);  // the cut
            EXPECT_EQ(series.frames[3].wrongPixels, 0u);
            EXPECT_EQ(series.lags[0].frames, 1);
        }
    }
}

TEST(PathBench, SamplesFindTheSameErrorInFewerPixels)
{
    BenchRequest request =
        requestOn("builtin:soccer-field?count=60", {"two-pass", "hzb-octree+coherence=last-pyramid"});
    request.threads        = {1};
    request.samples        = 1500;
    const PathRequest path = cutTo(request);
    const auto        rows = benchPath(request, path);
    ASSERT_TRUE(rows) << rows.error().sentence;
    EXPECT_EQ(rows->front().samples, 1500u);
    EXPECT_EQ(rows->front().figures->pixels, 5 * 1500u);
    EXPECT_EQ(rows->front().wrongPixels, 0u);
    EXPECT_GT(rows->back().series->frames[2].wrongPixels, 0u);
    EXPECT_EQ(rows->back().series->frames[3].wrongPixels, 0u);
}

}  // namespace
}  // namespace zscope
