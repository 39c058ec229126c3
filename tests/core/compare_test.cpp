// Algorithms side by side: what counts as equal, and what a difference picture shows.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/measure/compare.h"
#include "core/scene/load.h"

namespace zscope::tests {
namespace {

CompareRequest requestFor(const std::string& word, const std::vector<Pipeline>& pipelines)
{
    const Result<Scene> scene = loadScene("builtin:" + word);
    ViewRequest         view  = scene->views.empty() ? ViewRequest{} : scene->views.front().view;
    view.width                = 48;
    view.height               = 36;
    CompareRequest request;
    request.camera = *makeCamera(view, scene->bounds);
    request.scene  = std::make_shared<PreparedScene>(std::make_shared<const Scene>(*scene));
    for (const Pipeline& pipeline : pipelines)
        request.algorithms.push_back({nameOf(pipeline), pipeline, claimOf(pipeline)});
    request.threads = 1;
    request.frames  = 1;
    return request;
}

Pipeline presetNamed(std::string_view name) { return findPreset(name)->pipeline; }

TEST(Compare, EveryPresetIsEqualToTheFirstAndToTheReference)
{
    std::vector<Pipeline> all;
    for (const Preset& preset : presets())
        if (preset.claim != Claim::Approximate) all.push_back(preset.pipeline);
    const auto comparison = compareAlgorithms(requestFor("cubes", all));
    ASSERT_TRUE(comparison.ok()) << comparison.error().sentence;
    EXPECT_TRUE(comparison->areAllEqual());
    for (const ComparedAlgorithm& a : comparison->algorithms) {
        ASSERT_TRUE(a.againstReference);
        EXPECT_EQ(a.againstReference->wrongPixels(), 0u) << a.algorithm.name;
        EXPECT_EQ(a.againstFirst.wrongPixels(), 0u) << a.algorithm.name;
        EXPECT_FALSE(a.counters.empty());
        EXPECT_EQ(a.report.stages.size(), kStages.size());
    }
}

TEST(Compare, AFaultDiffersFromTheFirstAndFromTheReferenceAtTheSamePixels)
{
    Pipeline faulty       = presetNamed("edge-walk");
    faulty.fault          = Fault::XTruncated;
    const auto request    = requestFor("cubes", {presetNamed("zbuffer"), faulty});
    const auto comparison = compareAlgorithms(request);
    ASSERT_TRUE(comparison.ok()) << comparison.error().sentence;
    EXPECT_FALSE(comparison->areAllEqual());
    const ComparedAlgorithm &first = comparison->algorithms[0], &second = comparison->algorithms[1];
    EXPECT_TRUE(first.isEqualToFirst);
    EXPECT_GT(second.againstFirst.wrongPixels(), 0u);
    EXPECT_EQ(second.againstFirst.wrongPixels(), second.againstReference->wrongPixels());

    const Grid<std::uint32_t> picture = paintDifference(first.frame, second.frame, request.scene->scene(), false);
    std::uint64_t             shown = 0, otherDepth = 0;
    for (const std::uint32_t colour : picture.values())
        for (const DifferenceEntry& entry : differences()) {
            shown += colour == entry.colour && entry.difference != DrawnDifference::Depth
                     && entry.difference != DrawnDifference::Colour;
            otherDepth += colour == entry.colour && entry.difference == DrawnDifference::Depth;
        }
    EXPECT_EQ(shown, second.againstFirst.wrongPixels());
    EXPECT_GE(shown + otherDepth, second.againstFirst.depthBitsDiffer)
        << "another depth of another triangle is shown as the latter";
}

TEST(Compare, OtherColoursOfTheSameTrianglesAreADifferenceToo)
{
    Pipeline unsorted     = presetNamed("zbuffer");
    unsorted.transparency = BlendOrder::BackThenFront;
    const auto request    = requestFor("glass", {presetNamed("zbuffer"), presetNamed("hzb-octree"), unsorted});
    const auto comparison = compareAlgorithms(request);
    ASSERT_TRUE(comparison.ok()) << comparison.error().sentence;
    EXPECT_TRUE(comparison->algorithms[1].isEqualToFirst);
    const ComparedAlgorithm& third = comparison->algorithms[2];
    EXPECT_TRUE(third.againstFirst.isExact());
    EXPECT_GT(third.coloursDiffer, 0u);
    EXPECT_FALSE(third.isEqualToFirst);
    const Grid<std::uint32_t> picture =
        paintDifference(comparison->algorithms[0].frame, third.frame, request.scene->scene(), false);
    const auto colour = std::ranges::find(differences(), DrawnDifference::Colour, &DifferenceEntry::difference)->colour;
    EXPECT_EQ(static_cast<std::uint64_t>(std::ranges::count(picture.values(), colour)), third.coloursDiffer);
}

TEST(Compare, WithoutTheReferenceOnlyTheFirstIsHeldAgainst)
{
    CompareRequest request = requestFor("cubes", {presetNamed("zbuffer"), presetNamed("scanline")});
    request.useReference   = false;
    const auto comparison  = compareAlgorithms(request);
    ASSERT_TRUE(comparison.ok());
    EXPECT_FALSE(comparison->algorithms[0].againstReference);
    EXPECT_TRUE(comparison->areAllEqual());
}

TEST(Compare, RefusesNothingAndWhatCannotRun)
{
    EXPECT_EQ(compareAlgorithms(requestFor("cubes", {})).error().kind, Trouble::Usage);
    Pipeline invalid = presetNamed("zbuffer");
    invalid.cull     = Cull::Nodes;
    EXPECT_EQ(compareAlgorithms(requestFor("cubes", {invalid})).error().kind, Trouble::Usage);
}

}  // namespace
}  // namespace zscope::tests
