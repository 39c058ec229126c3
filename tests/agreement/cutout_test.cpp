// Cut-outs: a fragment in a hole does not exist, for every method, at every moment of testing and shading, and where
// the holes are is the definition's to say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/frame/renderer.h"
#include "core/lesson/replay.h"
#include "core/measure/reference.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// The same scene with this cut-out on every material.
Scene cutBy(const Scene& scene, std::optional<Cutout> cutout)
{
    Scene cut = scene;
    for (auto& mesh : cut.meshes) {
        auto changed = std::make_shared<Mesh>(*mesh);
        for (Material& material : changed->materials) material.cutout = cutout;
        mesh = changed;
    }
    return cut;
}

/// Two sheets across a view of 64 x 64 pixels: at z = 1, where a pixel is 1/32 wide, one with cells of 8 pixels; behind
/// it a solid one.
struct CutSheets {
    Camera   camera = plainCamera(64, 64);
    Prepared scene;

    explicit CutSheets(std::optional<Cutout> cutout, bool cutLast = false)
    {
        Mesh mesh;
        mesh.materials = {{"cut", {1, 0, 0}, 1, cutout}, {"solid", {0, 1, 0}, 1, std::nullopt}};
        const auto add = [&](double z, double reach, MaterialId material) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const auto& [x, y] : {std::pair{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}})
                mesh.positions.push_back(pointAt(camera, 32 + 32 * x / z, 32 - 32 * y / z, z));
            mesh.addPolygon(std::array{first, first + 1, first + 2, first + 3}, material);
        };
        if (cutLast) add(2, 16, MaterialId{1});
        add(1, 4, MaterialId{0});
        if (!cutLast) add(2, 16, MaterialId{1});
        const std::array places{Affine{}};
        scene = std::make_shared<const PreparedScene>(sceneOf(std::move(mesh), places));
    }

    DrawRequest request(const Pipeline& pipeline) const
    {
        return {.scene = scene, .camera = camera, .pipeline = pipeline, .threads = 1};
    }
};

TEST(Cutout, HolesLieWhereIntegersSayTheyDo)
{
    for (const CutoutPattern pattern : {CutoutPattern::Checker, CutoutPattern::Stripes, CutoutPattern::Holes}) {
        const CutSheets sheets(
            Cutout{pattern, 0.25});  // 8 pixels, and pixel centres at odd multiples of 1/16 of a cell
        const bool mirrored   = pointAt(sheets.camera, 64, 32, 1).x < 0,
                   upsideDown = pointAt(sheets.camera, 32, 64, 1).y < 0;
        const auto picture    = referencePicture(sheets.scene->scene(), sheets.camera, FaceCulling::None, {});
        ASSERT_TRUE(picture.ok());
        int holes = 0;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                const int i = mirrored ? 63 - x : x, j = upsideDown ? 63 - y : y;  // as the mesh counts
                // from the centre of the cell, sixteenths
                const int  across = (2 * i + 1) % 16 - 8, down = (2 * j + 1) % 16 - 8;
                const bool isHole = pattern == CutoutPattern::Checker   ? (i / 8 + j / 8) % 2 != 0
                                    : pattern == CutoutPattern::Stripes ? i % 8 >= 4
                                                                        : across * across + down * down < 24;
                EXPECT_EQ(picture->ids.at(x, y) >= 2, isHole)
                    << x << ", " << y << ", " << kCutoutWords[static_cast<std::size_t>(pattern)];
                holes += isHole;
            }
        }
        EXPECT_GT(holes, 500);
    }
}

TEST(Cutout, EveryPresetDrawsWhatTheReferenceDraws)
{
    for (const char* word : {"cutouts", "cutouts?size=0.07", "cutouts?size=3"}) {
        const Scene    scene = builtinScene(word);
        const Prepared ready = prepared(scene);
        for (const auto& [width, height] : {std::array{97, 71}, std::array{33, 64}})
            EXPECT_GT(expectAgreement(ready, cameraFor(scene, width, height), FaceCulling::None, word), 1000u);
        EXPECT_GT(expectAgreement(ready, cameraFor(scene, 80, 45), FaceCulling::Back, word, {.threads = {2}}), 100u);
    }
}

TEST(Cutout, EveryPresetDrawsWhatTheReferenceDrawsOfSoups)
{
    std::uint64_t seed = 0, covered = 0, changed = 0;
    for (const SoupKind kind : soupKinds()) {
        const Soup   soup    = makeSoup(kind, ++seed, 65, 43);
        const double size    = kind == SoupKind::TinyScale                                  ? 1e-6
                               : kind == SoupKind::Huge || kind == SoupKind::BeyondTheGuard ? 100
                                                                                            : 0.3;
        const auto   pattern = static_cast<CutoutPattern>(seed % 3);
        const Scene  cut     = cutBy(*soup.scene, Cutout{pattern, size});
        covered += expectAgreement(prepared(cut), soup.camera, FaceCulling::None, soup.what, {.threads = {2}});
        const auto with    = referencePicture(cut, soup.camera, FaceCulling::None, {}),
                   without = referencePicture(*soup.scene, soup.camera, FaceCulling::None, {});
        changed += with->ids != without->ids;
    }
    EXPECT_GT(covered, 5000u);
    EXPECT_GT(changed, soupKinds().size() / 2) << "patterns that hit nothing prove nothing";
}

TEST(Cutout, NoMomentChangesAColour)
{
    const Scene    scene = builtinScene("cutouts?size=0.2");
    const Prepared ready = prepared(scene);
    for (const ShadingCost cost : {ShadingCost::None, ShadingCost::Ten}) {
        DrawRequest request{.scene = ready, .camera = cameraFor(scene, 101, 67), .pipeline = {}, .threads = 2};
        request.pipeline.cost = cost;
        Renderer renderer;
        Frame    deferred, frame;
        ASSERT_TRUE(renderer.draw(request, deferred).ok());
        for (const Preset& preset : exactPresets()) {
            if (preset.claim != Claim::Exact) continue;
            request.pipeline      = preset.pipeline;
            request.pipeline.cost = cost;
            ASSERT_TRUE(renderer.draw(request, frame).ok());
            EXPECT_EQ(frame.colour, deferred.colour) << preset.name;
        }
    }
}

TEST(Cutout, TestingEarlyStillMeetsEveryHoleAndTheStatisticsSaySo)
{
    const CutSheets cut(Cutout{CutoutPattern::Stripes, 0.25}), whole(std::nullopt);
    const auto      counters = [](const CutSheets& sheets, DepthMoment moment) {
        return countersOf(sheets.request({.depth = moment}));
    };
    for (const DepthMoment moment :
         {DepthMoment::Deferred, DepthMoment::Late, DepthMoment::Early, DepthMoment::ZCull, DepthMoment::Prepass}) {
        auto with = counters(cut, moment), without = counters(whole, moment);
        EXPECT_EQ(without["fragments_discarded"], 0u);
        EXPECT_EQ(with["fragments_discarded"], 64u * 32)
            << "half of the nearer sheet, which passes every test on its way in";
        Renderer renderer;
        Frame    frame;
        for (const CutSheets* sheets : {&cut, &whole}) {
            const Result<FrameReport> report = renderer.draw(sheets->request({.depth = moment}), frame);
            ASSERT_TRUE(report.ok());
            const auto raster = std::ranges::find(report->stages, Stage::Raster, &StageTime::stage);
            EXPECT_EQ(
                raster->why.find("2 triangles can be discarded: their depth is written late") != std::string::npos,
                sheets == &cut)
                << raster->why;
        }
    }
    EXPECT_EQ(counters(whole, DepthMoment::Early)["fragments_shaded"], 64u * 64);
    EXPECT_EQ(counters(cut, DepthMoment::Early)["fragments_shaded"], 64u * 64) << "half of each sheet";
    EXPECT_EQ(counters(cut, DepthMoment::Late)["fragments_shaded"], 2u * 64 * 64) << "who shades first shades holes";
}

TEST(Cutout, HolesAreNoCoverForTilesAndIntervals)
{
    // The nearer sheet covers every tile and every line; only its holes let the farther one be seen.
    const CutSheets cut(Cutout{CutoutPattern::Checker, 0.25}), whole(std::nullopt);
    EXPECT_GE(countersOf(whole.request({.depth = DepthMoment::ZCull}))["tiles_rejected"], 64u);
    EXPECT_EQ(countersOf(cut.request({.depth = DepthMoment::ZCull}))["tiles_rejected"], 32u + 8)
        << "the tiles without a hole, those on the diagonal once for each triangle";

    Replay                      steps(cut.request({.scan = Scan::SweepIntervals}));
    const Result<std::uint64_t> count = steps.count(Grain::Interval);
    ASSERT_TRUE(count.ok());
    int withHoles = 0;
    for (std::uint64_t k = 0; k < *count; k += 5) {
        const Result<StepState> state = steps.at(Grain::Interval, StepIndex{k});
        ASSERT_TRUE(state.ok());
        if (!state->interval || state->event != Grain::Interval) continue;
        EXPECT_FALSE(state->interval->winner.has_value()) << state->sentence;
        withHoles += state->interval->reason == IntervalReason::HasPattern;
    }
    EXPECT_GT(withHoles, 0);
}

TEST(Cutout, StepsSayThatAFragmentLiesInAHole)
{
    const CutSheets cut(Cutout{CutoutPattern::Stripes, 0.25}, true);
    for (const DepthMoment moment : {DepthMoment::Late, DepthMoment::Early}) {
        Replay              steps(cut.request({.depth = moment}));
        const std::uint64_t count = *steps.count(Grain::Pixel);
        int                 holes = 0;
        for (std::uint64_t k = 2; k < count; k += 211) {
            const Result<StepState> state = steps.at(Grain::Pixel, StepIndex{k});
            ASSERT_TRUE(state.ok());
            if (!state->pixel || !state->pixel->discarded) continue;
            ++holes;
            EXPECT_FALSE(state->pixel->won);
            EXPECT_NE(state->sentence.find("the fragment does not exist"), std::string::npos) << state->sentence;
            EXPECT_EQ(state->pixel->shaded, moment == DepthMoment::Late);
        }
        EXPECT_GT(holes, 3);
    }
}

}  // namespace
}  // namespace zscope::tests
