// What a run's record says: quartiles of stages, error figures, costs per piece of work, and the set worth choosing
// from.
#include "core/measure/bench.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/tally.h"
#include "core/measure/approximate_switches.h"
#include "core/measure/frame_quota.h"
#include "core/measure/reference.h"
#include "core/measure/speed_error.h"
#include "core/measure/unit_costs.h"
#include "core/scene/load.h"

namespace zscope::tests {
namespace {

BenchRequest benchOf(const std::string& word, const std::vector<Pipeline>& pipelines)
{
    const Result<Scene> scene = loadScene("builtin:" + word);
    ViewRequest         view  = scene->views.empty() ? ViewRequest{} : scene->views.front().view;
    view.width                = 96;
    view.height               = 64;
    BenchRequest request;
    request.camera = *makeCamera(view, scene->bounds);
    request.scene  = std::make_shared<const Scene>(*scene);
    for (const Pipeline& pipeline : pipelines)
        request.algorithms.push_back({nameOf(pipeline), pipeline, claimOf(pipeline)});
    request.threads = {1};
    request.warmUp  = 1;
    request.frames  = 7;
    return request;
}

Pipeline pipelineNamed(std::string_view name) { return findPreset(name)->pipeline; }

std::uint64_t counterOf(const BenchRow& row, std::string_view name)
{
    for (const NamedCount& counter : row.counters)
        if (counter.name == name) return counter.value;
    ADD_FAILURE() << "no counter " << name;
    return 0;
}

TEST(Bench, StagesHaveOrderedQuartilesAndThoseOfTheMedianFrameStillAddUp)
{
    const auto rows = bench(benchOf("teapot", {pipelineNamed("hzb-octree"), pipelineNamed("scanline")}));
    ASSERT_TRUE(rows.ok()) << rows.error().text();
    for (const BenchRow& row : *rows) {
        double sum = 0, medians = 0;
        for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
            const StageQuartiles& of = row.stageQuartiles[stage];
            EXPECT_LE(of.q1, of.median);
            EXPECT_LE(of.median, of.q3);
            sum += row.stageMs[stage];
            medians += of.median;
        }
        EXPECT_NEAR(sum, row.medianMs, 1e-6);
        EXPECT_GT(medians, 0) << row.algorithm;
    }
}

TEST(Bench, TellsOfEveryRowWhenItIsFinishedAndKeepsToldRowsWhenItIsStopped)
{
    auto request = benchOf("cubes", {pipelineNamed("zbuffer"), pipelineNamed("scanline"), pipelineNamed("interval")});
    std::atomic<bool> stop{false};
    request.progress.cancel = &stop;
    std::vector<std::string> told;
    request.finished = [&](const BenchRow& row) {
        told.push_back(row.algorithm);
        stop = told.size() == 2;
    };
    const auto rows = bench(request);
    EXPECT_FALSE(rows.ok());
    EXPECT_EQ(told, (std::vector<std::string>{"zbuffer", "scanline"}));
}

TEST(Bench, EveryOtherRoundGoesBackThroughTheRunsSoThatNobodyAlwaysFollowsTheSame)
{
    auto request   = benchOf("cubes", {pipelineNamed("zbuffer"), pipelineNamed("scanline"), pipelineNamed("interval")});
    request.frames = request.rounds = 3;
    std::vector<std::string> order;
    request.progress.report = [&order](double, std::string_view what) { order.emplace_back(what); };
    const auto rows         = bench(request);
    ASSERT_TRUE(rows.ok()) << rows.error().text();
    ASSERT_GE(order.size(), 9u);
    order.erase(order.begin(), order.end() - 9);  // before: the first pictures
    EXPECT_EQ(order, (std::vector<std::string>{"zbuffer", "scanline", "interval", "interval", "scanline", "zbuffer",
                                               "zbuffer", "scanline", "interval"}));
    for (const BenchRow& row : *rows) EXPECT_EQ(row.roundMs.size(), 3u) << row.algorithm;
}

TEST(Bench, FramesGoOnUntilTheyTookTheTimeThatWasAskedFor)
{
    const auto framesDrawn = [](int frames, double leastMs, double each) {
        FrameQuota quota(frames, leastMs);
        int        drawn = 0;
        for (; quota.wantsMore(); ++drawn) quota.drawn(each);
        return drawn;
    };
    EXPECT_EQ(framesDrawn(3, 0, 0.5), 3);
    EXPECT_EQ(framesDrawn(3, 1, 0.5), 3);
    EXPECT_EQ(framesDrawn(3, 1.75, 0.5), 4);
    EXPECT_EQ(framesDrawn(3, 1000, 0.5), 2000);
    EXPECT_EQ(framesDrawn(3, 1000, 0), static_cast<int>(FrameQuota::kMost));  // of a clock that stands still

    auto request       = benchOf("cubes", {pipelineNamed("zbuffer"), pipelineNamed("scanline")});
    request.frames     = 1;
    const auto few     = bench(request);
    request.leastMs    = 60;
    const auto lasting = bench(request);
    request.frames = request.rounds = 4;
    const auto turns                = bench(request);
    ASSERT_TRUE(few.ok() && lasting.ok() && turns.ok());
    for (const BenchRow& row : *few) EXPECT_EQ(row.frames, 1u) << row.algorithm;
    // One frame may have been enough, but then it was long.
    for (const BenchRow& row : *lasting)
        EXPECT_TRUE(row.frames > 1 || row.medianMs >= 60)
            << row.algorithm << ": one frame of " << row.medianMs << " ms";
    for (const BenchRow& row : *turns)
        EXPECT_TRUE(row.frames > 4 || std::ranges::min(row.roundMs) >= 15) << row.algorithm << ": four frames";
    EXPECT_EQ(benchFromJson(benchToJson(*lasting))->front().frames, lasting->front().frames);
}

TEST(Bench, AnExactPictureHasFiguresOfZeroAndOthersAllThatCompareFinds)
{
    Pipeline rough             = pipelineNamed("zbuffer");
    rough.approximation.format = DepthFormat::Fixed16;
    Pipeline faulty            = pipelineNamed("edge-walk");
    faulty.fault               = Fault::XTruncated;
    const auto request = benchOf("cubes", {pipelineNamed("zbuffer"), rough, faulty, pipelineNamed("interval-polygon")});
    const auto rows    = bench(request);
    ASSERT_TRUE(rows.ok()) << rows.error().text();
    const auto reference = referencePicture(*request.scene, request.camera, request.faceCulling);
    ASSERT_TRUE(reference.ok());
    const ErrorFigures itself = compare(*reference, *reference);

    for (const BenchRow& row : *rows) ASSERT_TRUE(row.figures && row.wrongPixels) << row.algorithm;
    const BenchRow &exact = rows->at(0), &depths = rows->at(1), &holes = rows->at(2), &faces = rows->at(3);
    EXPECT_TRUE(exact.figures->isExact());
    EXPECT_EQ(exact.figures->pixels, itself.pixels);
    EXPECT_EQ(exact.figures->covered, itself.covered);
    EXPECT_GT(exact.figures->covered, 0u);
    EXPECT_EQ(exact.figures->worstDistance(), 0);
    EXPECT_GT(depths.figures->depthBitsDiffer, 0u);
    EXPECT_GT(depths.figures->maxDepthSteps, 0u);
    EXPECT_GT(depths.figures->worstDistance(), 0);
    EXPECT_EQ(*depths.wrongPixels, depths.figures->depthBitsDiffer);
    EXPECT_GT(holes.figures->wrongPixels(), 0u);
    EXPECT_EQ(faces.figures->wrongCoverage(), 0u);
    for (const BenchRow& row : *rows) EXPECT_FALSE(row.isBroken()) << row.algorithm;

    BenchRow wrong = holes;
    wrong.claim    = Claim::Exact;  // as if a preset had drawn it
    EXPECT_TRUE(wrong.isBroken());
}

TEST(Bench, WithoutAReferenceThereAreNoFigures)
{
    auto request    = benchOf("cubes", {pipelineNamed("zbuffer")});
    request.verify  = false;
    const auto rows = bench(request);
    ASSERT_TRUE(rows.ok());
    EXPECT_FALSE(rows->front().figures);
    EXPECT_FALSE(rows->front().isBroken());
    EXPECT_TRUE(nlohmann::json::parse(benchToJson(*rows)).at(0).at("figures").is_null());
}

TEST(Bench, TheRecordHoldsQuartilesAndFiguresAndTheTableKeepsItsColumns)
{
    Pipeline faulty = pipelineNamed("edge-walk");
    faulty.fault    = Fault::XTruncated;
    auto rows       = bench(benchOf("cubes", {faulty}));
    ASSERT_TRUE(rows.ok());
    rows->front().figures->distanceOnWrongSurface.max = std::numeric_limits<double>::infinity();
    const auto row                                    = nlohmann::json::parse(benchToJson(*rows)).at(0);
    EXPECT_EQ(row.at("claim"), "approximate");
    EXPECT_EQ(row.at("figures").at("holes"), rows->front().figures->holes);
    EXPECT_EQ(row.at("figures").at("distance_on_wrong_surface").at("max"), "inf");
    for (const Stage stage : kStages) {
        const auto& quartiles = row.at("stage_quartiles").at(std::string(wordOf(stage)));
        EXPECT_EQ(quartiles.at("median"), rows->front().stageQuartiles[static_cast<std::size_t>(stage)].median);
        EXPECT_LE(quartiles.at("q1"), quartiles.at("q3"));
    }
    const std::string csv = benchToCsv(*rows);
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "scene,algorithm,threads,simd,verified,wrong_pixels,best_ms,median_ms,q1_ms,q3_ms,triangles,pixels,"
              "build_ms,bytes,clear,transform,cull,setup,prepass,build,raster,upkeep,shade,other");
}

TEST(UnitCosts, AreTheStagesTimeInTheMedianFrameOverWhatThatStageWorksOn)
{
    BenchRow row;
    row.medianMs  = 2;
    row.triangles = 1000;
    row.pixels    = 500;
    row.tallies   = {{"vertices_transformed", 50}, {"triangle_set_ups", 100}, {"nodes_visited", 20},
                     {"pixels_tested", 400},       {"pyramid_writes", 8},     {"fragments_shaded", 250}};
    row.stageMs.fill(1);
    row.stageMs[static_cast<std::size_t>(Stage::Prepass)] = 0;
    for (StageQuartiles& stage : row.stageQuartiles) stage = {2, 3, 7};  // of other frames, too
    const auto cost = [&row](Stage stage) { return unitCosts(row, stage); };

    const std::tuple<Stage, WorkUnit, double> expected[]{
        {Stage::Transform, WorkUnit::Vertex, 1e6 / 50}, {Stage::Setup, WorkUnit::Triangle, 1e6 / 100},
        {Stage::Cull, WorkUnit::Node, 1e6 / 20},        {Stage::Raster, WorkUnit::Pixel, 1e6 / 400},
        {Stage::Upkeep, WorkUnit::Cell, 1e6 / 8},       {Stage::Shade, WorkUnit::Pixel, 1e6 / 250}};
    for (const auto& [stage, unit, ns] : expected) {
        ASSERT_EQ(cost(stage).size(), 1u) << wordOf(stage);
        EXPECT_EQ(cost(stage).front().unit, unit) << wordOf(stage);
        EXPECT_DOUBLE_EQ(cost(stage).front().ns, ns) << wordOf(stage);
    }
    for (const Stage stage : {Stage::Clear, Stage::Prepass, Stage::Build, Stage::Other})
        EXPECT_TRUE(cost(stage).empty()) << wordOf(stage);
    EXPECT_DOUBLE_EQ(frameCosts(row).at(0).ns, 2000);
    EXPECT_DOUBLE_EQ(frameCosts(row).at(1).ns, 4000);

    row.tallies.push_back({"edges", 5});  // a sweep: its set-up makes an edge table
    EXPECT_EQ(cost(Stage::Setup).front().unit, WorkUnit::Edge);
    row.tallies.push_back({"fragments_transparent", 1});
    EXPECT_TRUE(cost(Stage::Shade).empty());
    row.tallies.push_back({"prepass_pixels_tested", 40});  // vertices are then counted twice and timed once
    row.stageMs[static_cast<std::size_t>(Stage::Prepass)] = 1;
    EXPECT_TRUE(cost(Stage::Transform).empty());
    EXPECT_DOUBLE_EQ(cost(Stage::Prepass).front().ns, 1e6 / 40);
    row.stageMs[static_cast<std::size_t>(Stage::Raster)] = 0;
    EXPECT_TRUE(cost(Stage::Raster).empty()) << "no time, no cost";
    row.counters = std::exchange(row.tallies, {});
    EXPECT_TRUE(cost(Stage::Cull).empty()) << "the counters of another run divide no time";
    row.tallies = row.counters;
    row.chosen  = "hzb-octree";
    EXPECT_TRUE(cost(Stage::Cull).empty()) << "its frames may be several presets'";
}

TEST(UnitCosts, DivideByTheTalliesOfTheTimedRun)
{
    const auto rows = bench(benchOf("teapot", {pipelineNamed("scanline"), pipelineNamed("hzb-bvh")}));
    ASSERT_TRUE(rows.ok());
    const auto tallyOf = [](const BenchRow& row, Unit unit) {
        const auto found = std::ranges::find(row.tallies, wordOf(unit), &NamedCount::name);
        return found == row.tallies.end() ? std::uint64_t{0} : found->value;
    };
    const BenchRow& sweep  = rows->at(0);
    const auto      raster = unitCosts(sweep, Stage::Raster);
    ASSERT_EQ(raster.size(), 1u);
    EXPECT_EQ(raster[0].unit, WorkUnit::ActiveEdge);
    EXPECT_EQ(raster[0].count, tallyOf(sweep, Unit::ActiveEdges));
    EXPECT_LT(raster[0].count, counterOf(sweep, "active_edge_lines")) << "two triangles share one edge";
    EXPECT_EQ(unitCosts(sweep, Stage::Setup).at(0).count, tallyOf(sweep, Unit::Edges));
    EXPECT_TRUE(unitCosts(sweep, Stage::Cull).empty()) << "a sweep visits no nodes";
    const auto nodes = unitCosts(rows->at(1), Stage::Cull);
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_EQ(nodes.front().count, tallyOf(rows->at(1), Unit::Nodes));
    const auto read = benchFromJson(benchToJson(*rows));
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(tallyOf(read->at(0), Unit::Edges), tallyOf(sweep, Unit::Edges));
}

TEST(SpeedError, WhatIsWorseInOneAndNoBetterInTheOtherIsDominated)
{
    const auto indices = [](std::vector<SpeedError> points) { return nonDominated(points); };
    using Indices      = std::vector<std::size_t>;
    EXPECT_EQ(indices({}), Indices{});
    EXPECT_EQ(indices({{1, 5}}), Indices{0});
    EXPECT_EQ(indices({{3, 0}, {1, 5}, {2, 6}, {4, 0}, {2, 1}}), (Indices{1, 4, 0}));
    EXPECT_EQ(indices({{1, 2}, {1, 1}}), Indices{1}) << "as fast, and less wrong";
    EXPECT_EQ(indices({{2, 1}, {1, 1}}), Indices{1}) << "as wrong, and faster";
    EXPECT_EQ(indices({{1, 1}, {2, 0}, {1, 1}}), (Indices{0, 2, 1})) << "equal points stand beside each other";
    EXPECT_EQ(indices({{1, std::numeric_limits<double>::infinity()}, {2, 0}}), (Indices{0, 1}));
}

TEST(SpeedError, TheSetIsWhatTheDefinitionSaysOfPairs)
{
    std::vector<SpeedError> points;
    std::uint32_t           seed = 12345;
    const auto next = [&seed] { return static_cast<double>((seed = seed * 1664525u + 1013904223u) >> 27); };
    for (int i = 0; i < 200; ++i) points.push_back({next(), next()});
    const auto                  kept = nonDominated(points);
    const std::set<std::size_t> set(kept.begin(), kept.end());
    EXPECT_EQ(set.size(), kept.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool isDominated = false;
        for (const SpeedError& p : points)
            isDominated |= p.ms <= points[i].ms && p.error <= points[i].error
                           && (p.ms < points[i].ms || p.error < points[i].error);
        EXPECT_EQ(set.contains(i), !isDominated) << i;
    }
}

TEST(ApproximateSwitches, AreEveryChoiceOfEveryKindAloneAndCanRun)
{
    Pipeline base             = pipelineNamed("hzb-octree");
    base.approximation.near   = NearPlane::Drop;  // neither this nor a fault is taken over
    base.fault                = Fault::CornersOnly;
    const auto            all = approximateSwitches(base);
    std::set<std::string> seen;
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.front().name, "hzb-octree");
    EXPECT_EQ(all.front().claim, Claim::Exact);
    for (std::size_t i = 1; i < all.size(); ++i) {
        EXPECT_FALSE(explainInvalid(all[i].pipeline)) << all[i].name;
        EXPECT_EQ(all[i].claim, Claim::Approximate) << all[i].name;
        EXPECT_EQ(all[i].pipeline.fault, Fault::None);
        int switched = 0;
        for (const AxisEntry& axis : axes()) {
            Pipeline exact                = all[i].pipeline;
            exact.approximation           = {};
            const std::string_view choice = chosen(all[i].pipeline, axis.word);
            if (choice == chosen(exact, axis.word)) continue;
            ++switched;
            EXPECT_TRUE(seen.insert(std::string(axis.word) + "=" + std::string(choice)).second) << "twice: " << choice;
        }
        EXPECT_EQ(switched, 1) << all[i].name;
    }
    const std::set<std::string_view> kinds{"snap",  "vertices", "depth-numbers", "depth-format",
                                           "edges", "near",     "cells",         "small-nodes"};
    for (const AxisEntry& entry : axes()) {
        if (!kinds.contains(entry.word)) continue;
        for (const ChoiceEntry& choice : entry.choices.subspan(1))
            EXPECT_TRUE(seen.contains(std::string(entry.word) + "=" + std::string(choice.word)))
                << entry.word << "=" << choice.word;
    }
}

TEST(ApproximateSwitches, StandBesideEveryPresetThatFastTextDraws)
{
    for (const Preset& preset : presets()) {
        const auto all = presetsToTime();
        EXPECT_EQ(std::ranges::find(all, preset.name, &BenchAlgorithm::name) != all.end(), hasFastText(preset.pipeline))
            << preset.name;
    }
}

}  // namespace
}  // namespace zscope::tests
