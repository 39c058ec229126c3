// Reliefs: a fragment stage that changes depth. Every method draws the same, at every moment of testing and shading;
// where a fragment lies is the definition's to say, and what an early test is still good for the statistics'.
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
#include "core/measure/reference_colours.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

/// The same scene with these patterns on every material.
Scene patternedBy(const Scene& scene, std::optional<Relief> relief, std::optional<Cutout> cutout)
{
    Scene changed = scene;
    for (auto& mesh : changed.meshes) {
        auto copy = std::make_shared<Mesh>(*mesh);
        for (Material& material : copy->materials) {
            material.relief = relief;
            material.cutout = cutout;
        }
        mesh = copy;
    }
    return changed;
}

/// Two sheets across a view of 64 x 64 pixels: at z = 1, where a pixel is 1/32 wide, one with a relief 1 deep; a solid
/// one at `solidAt`, drawn after it or before.
struct CarvedSheets {
    Camera   camera = plainCamera(64, 64);
    Prepared scene;

    CarvedSheets(std::optional<Relief> relief, double solidAt, bool solidFirst = false)
    {
        camera.near = 0.25;
        Mesh mesh;
        mesh.materials = {{.name = "carved", .diffuse = {1, 0, 0}, .relief = relief},
                          {.name = "solid", .diffuse = {0, 1, 0}}};
        const auto add = [&](double z, double reach, MaterialId material) {
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const auto& [x, y] : {std::pair{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}})
                mesh.positions.push_back(pointAt(camera, 32 + 32 * x / z, 32 - 32 * y / z, z));
            mesh.addPolygon(std::array{first, first + 1, first + 2, first + 3}, material);
        };
        if (solidFirst) add(solidAt, 16, MaterialId{1});
        add(1, 4, MaterialId{0});
        if (!solidFirst) add(solidAt, 16, MaterialId{1});
        const std::array places{Affine{}};
        scene = std::make_shared<const PreparedScene>(sceneOf(std::move(mesh), places));
    }

    DrawRequest request(const Pipeline& pipeline) const
    {
        return {.scene = scene, .camera = camera, .pipeline = pipeline, .threads = 1};
    }
};

constexpr std::uint64_t kPixels = 64 * 64;
/// Bricks of 16 by 8 pixels whose joints are one pixel wide, and how many pixels are joints.
constexpr Relief        kBricks{ReliefPattern::Bricks, 0.5, 1};
constexpr std::uint64_t kJoints = 64 * 8 + 56 * 4;

std::map<std::string, std::uint64_t> countersOfSheets(const CarvedSheets& sheets, const Pipeline& pipeline)
{
    Renderer                             renderer;
    const Result<FrameWork>              work = renderer.count(sheets.request(pipeline));
    std::map<std::string, std::uint64_t> counts;
    EXPECT_TRUE(work.ok());
    for (const NamedCount& counter : work->counters) counts[counter.name] = counter.value;
    return counts;
}

/// How deep the definition's relief is `i` pixels right of and `j` pixels above the corner of a cell, in its depth.
double depthAt(ReliefPattern pattern, int i, int j)
{
    switch (pattern) {
        case ReliefPattern::Bricks:
            return j % 8 == 0 || (i + (j / 8 % 2 == 0 ? 0 : 8)) % 16 == 0 ? 1 : 0;
        case ReliefPattern::Louvres:
            return (2 * j + 1) % 16 / 16.0;
        case ReliefPattern::Bowls:
            break;
    }
    const int across = (2 * i + 1) % 16 - 8, down = (2 * j + 1) % 16 - 8;  // from the centre of the cell, sixteenths
    return std::max(0.0, 1 - (across * across + down * down) / 64.0);
}

TEST(Relief, FragmentsLieWhereIntegersSayTheyDo)
{
    for (const ReliefPattern pattern : {ReliefPattern::Bricks, ReliefPattern::Louvres, ReliefPattern::Bowls}) {
        // 8 pixels, of bricks 16, and pixel centres at odd multiples of 1/16 or 1/32 of a cell
        const CarvedSheets sheets(Relief{pattern, pattern == ReliefPattern::Bricks ? 0.5 : 0.25, 1}, 1.45);
        const bool         mirrored = pointAt(sheets.camera, 64, 32, 1).x < 0,
                   upsideDown       = pointAt(sheets.camera, 32, 0, 1).y < 0;
        const auto picture          = referencePicture(sheets.scene->scene(), sheets.camera, FaceCulling::None, {});
        ASSERT_TRUE(picture.ok());
        int behind = 0;
        for (int y = 0; y < 64; ++y) {
            for (int x = 0; x < 64; ++x) {
                const int    i = mirrored ? 63 - x : x, j = upsideDown ? y : 63 - y;  // as the mesh counts
                const double z = 1 + depthAt(pattern, i, j);
                EXPECT_EQ(picture->ids.at(x, y) >= 2, z > 1.45)
                    << x << ", " << y << ", " << kReliefWords[static_cast<std::size_t>(pattern)];
                const double nearer = std::min(z, 1.45);
                EXPECT_NEAR(picture->depth.at(x, y) * nearer, sheets.camera.near, 1e-6 * sheets.camera.near);
                behind += z > 1.45;
            }
        }
        EXPECT_GT(behind, 500);
        if (pattern == ReliefPattern::Bricks) {
            EXPECT_EQ(behind, static_cast<int>(kJoints));
        }
    }
}

TEST(Relief, EveryPresetDrawsWhatTheReferenceDraws)
{
    for (const char* word : {"reliefs", "reliefs?size=0.07", "reliefs?depth=3", "reliefs?size=3&depth=0.01"}) {
        const Scene    scene = builtinScene(word);
        const Prepared ready = prepared(scene);
        for (const auto& [width, height] : {std::array{97, 71}, std::array{33, 64}})
            EXPECT_GT(expectAgreement(ready, cameraFor(scene, width, height), FaceCulling::None, word), 1000u);
        EXPECT_GT(expectAgreement(ready, cameraFor(scene, 80, 45), FaceCulling::Back, word, {.threads = {2}}), 100u);
    }
}

TEST(Relief, EveryPresetDrawsWhatTheReferenceDrawsOfSoups)
{
    std::uint64_t seed = 0, covered = 0, changed = 0;
    for (const SoupKind kind : soupKinds()) {
        const Soup   soup = makeSoup(kind, ++seed, 65, 43);
        const double size = kind == SoupKind::TinyScale                                  ? 1e-6
                            : kind == SoupKind::Huge || kind == SoupKind::BeyondTheGuard ? 100
                                                                                         : 0.3;
        const Relief relief{static_cast<ReliefPattern>(seed % 3), size, 2 * size};
        const auto   cutout =
            seed % 2 == 0 ? std::optional(Cutout{static_cast<CutoutPattern>(seed / 2 % 3), size}) : std::nullopt;
        const Scene carved = patternedBy(*soup.scene, relief, cutout);
        covered += expectAgreement(prepared(carved), soup.camera, FaceCulling::None, soup.what, {.threads = {2}});
        const auto with = referencePicture(carved, soup.camera, FaceCulling::None, {});
        const auto without =
            referencePicture(patternedBy(*soup.scene, std::nullopt, cutout), soup.camera, FaceCulling::None, {});
        changed += with->ids != without->ids;
    }
    EXPECT_GT(covered, 5000u);
    EXPECT_GT(changed, soupKinds().size() / 2) << "reliefs that change no winner prove nothing";
}

TEST(Relief, NoMomentChangesAColourAndGlassIsBlendedOverWhereFragmentsReallyLie)
{
    const Scene    scene  = builtinScene("reliefs?size=0.2");
    const Camera   camera = cameraFor(scene, 101, 67);
    const Prepared ready  = prepared(scene);
    const auto     opaque = referencePicture(scene, camera, FaceCulling::None);
    ASSERT_TRUE(opaque.ok());
    const auto colours = referenceColours(scene, camera, FaceCulling::None, *opaque);
    ASSERT_TRUE(colours.ok());
    for (const ShadingCost cost : {ShadingCost::None, ShadingCost::Ten}) {
        DrawRequest request{.scene = ready, .camera = camera, .pipeline = {}, .threads = 2};
        request.pipeline.cost = cost;
        Renderer renderer;
        Frame    deferred, frame;
        ASSERT_TRUE(renderer.draw(request, deferred).ok());
        if (cost == ShadingCost::None) {
            EXPECT_EQ(deferred.colour, *colours);
        }
        for (const Preset& preset : exactPresets()) {
            if (preset.claim != Claim::Exact) continue;
            request.pipeline      = preset.pipeline;
            request.pipeline.cost = cost;
            ASSERT_TRUE(renderer.draw(request, frame).ok());
            EXPECT_EQ(frame.colour, deferred.colour) << preset.name;
        }
    }
}

TEST(Relief, GlassHasNeitherHolesNorRelief)
{
    const Scene everything =
        patternedBy(builtinScene("glass"), Relief{ReliefPattern::Bowls, 0.3, 0.5}, Cutout{CutoutPattern::Stripes, 0.3});
    Scene opaqueOnly = everything;
    for (auto& mesh : opaqueOnly.meshes) {
        auto copy = std::make_shared<Mesh>(*mesh);
        for (Material& material : copy->materials)
            if (material.opacity < 1) material.relief = {}, material.cutout = {};
        mesh = copy;
    }
    const Camera camera = cameraFor(everything, 101, 67);
    const auto   opaque = referencePicture(everything, camera, FaceCulling::None);
    ASSERT_TRUE(opaque.ok());
    const auto colours = referenceColours(everything, camera, FaceCulling::None, *opaque);
    ASSERT_TRUE(colours.ok());
    for (const Scene& scene : {everything, opaqueOnly}) {
        Renderer renderer;
        Frame    frame;
        ASSERT_TRUE(
            renderer.draw({.scene = prepared(scene), .camera = camera, .pipeline = {}, .threads = 2}, frame).ok());
        EXPECT_EQ(frame.colour, *colours);
    }
}

TEST(Relief, AnEarlyTestIsOnlyABoundAndSoShadesInVain)
{
    // The relief comes first, then what is seen through its joints.
    const CarvedSheets carved(kBricks, 1.5), flat(std::nullopt, 1.5);
    const auto         shaded = [](const CarvedSheets& sheets, DepthMoment moment) {
        return countersOfSheets(sheets, {.depth = moment})["fragments_shaded"];
    };
    EXPECT_EQ(shaded(flat, DepthMoment::Early), kPixels);
    EXPECT_EQ(shaded(carved, DepthMoment::Early), kPixels + kJoints);
    EXPECT_EQ(shaded(flat, DepthMoment::Prepass), kPixels);
    EXPECT_EQ(shaded(carved, DepthMoment::Prepass), kPixels + kJoints)
        << "whether depths are equal is known after shading";
    EXPECT_EQ(shaded(carved, DepthMoment::Late), 2 * kPixels);

    // The other way round every fragment of the relief passes where its triangle is, and those in the joints do not
    // where they are.
    const CarvedSheets after(kBricks, 1.5, true);
    for (const DepthMoment moment : {DepthMoment::Deferred, DepthMoment::Early, DepthMoment::ZCull}) {
        auto counters = countersOfSheets(after, {.depth = moment});
        EXPECT_EQ(counters["fragments_moved"], kPixels);
        EXPECT_EQ(counters["fragments_moved_and_hidden"], kJoints);
        EXPECT_EQ(counters["fragments_shaded"], (moment == DepthMoment::Deferred ? 1 : 2) * kPixels);
    }

    // Where even the triangle is hidden, nobody looks at the relief, except whoever shades first.
    const CarvedSheets hidden(kBricks, 0.5, true);
    EXPECT_EQ(countersOfSheets(hidden, {.depth = DepthMoment::Early})["fragments_moved"], 0u);
    EXPECT_EQ(countersOfSheets(hidden, {.depth = DepthMoment::Late})["fragments_moved"], kPixels);
    EXPECT_GE(countersOfSheets(hidden, {.depth = DepthMoment::ZCull})["tiles_rejected"], 64u);
    EXPECT_GE(countersOfSheets(flat, {.depth = DepthMoment::ZCull})["tiles_rejected"], 64u);
    EXPECT_EQ(countersOfSheets(carved, {.depth = DepthMoment::ZCull})["tiles_rejected"], 0u)
        << "a joint crosses every tile";
}

TEST(Relief, TheStatisticsSaySoAndOfOtherScenesThatThereIsNone)
{
    const CarvedSheets carved(kBricks, 1.5), flat(std::nullopt, 1.5);
    Renderer           renderer;
    Frame              frame;
    for (const Preset& preset : exactPresets()) {
        for (const CarvedSheets* sheets : {&carved, &flat}) {
            const Result<FrameReport> report = renderer.draw(sheets->request(preset.pipeline), frame);
            ASSERT_TRUE(report.ok());
            const std::string why  = std::ranges::find(report->stages, Stage::Raster, &StageTime::stage)->why;
            const auto        says = [&why](const char* words) { return why.find(words) != std::string::npos; };
            EXPECT_EQ(says("the fragments of 2 triangles are moved away from the eye"), sheets == &carved) << why;
            EXPECT_EQ(says("no fragment can be discarded or moved"), sheets == &flat) << why;
            const bool late = preset.pipeline.depth == DepthMoment::Late;
            EXPECT_EQ(says("moved and tested once"), late && sheets == &carved) << why;
            EXPECT_EQ(says("can only say no for where the triangle is"), !late && sheets == &carved) << why;
        }
        if (preset.pipeline.chooser == Chooser::Measured) continue;
        EXPECT_EQ(countersOfSheets(flat, preset.pipeline)["fragments_moved"], 0u) << preset.name;
        EXPECT_GE(countersOfSheets(carved, preset.pipeline)["fragments_moved"], kPixels) << preset.name;
    }
}

TEST(Relief, AnIntervalIsNeverItsOwnButMayBeARivalsWhole)
{
    // Through every line: first the relief in front, then behind a solid sheet.
    const auto reasons = [](const CarvedSheets& sheets) {
        Replay                        steps(sheets.request({.scan = Scan::SweepIntervals}));
        const Result<std::uint64_t>   count = steps.count(Grain::Interval);
        std::map<IntervalReason, int> met;
        EXPECT_TRUE(count.ok());
        for (std::uint64_t k = 0; k < *count; k += 5) {
            const Result<StepState> state = steps.at(Grain::Interval, StepIndex{k});
            EXPECT_TRUE(state.ok());
            if (!state->interval || state->event != Grain::Interval) continue;
            EXPECT_EQ(state->interval->winner.has_value(), state->interval->reason == IntervalReason::Leads)
                << state->sentence;
            ++met[state->interval->reason];
        }
        return met;
    };
    EXPECT_GT(reasons(CarvedSheets(kBricks, 1.5))[IntervalReason::HasPattern], 0);
    EXPECT_EQ(reasons(CarvedSheets(kBricks, 1.5))[IntervalReason::Leads], 0);
    EXPECT_GT(reasons(CarvedSheets(kBricks, 0.5))[IntervalReason::Leads], 0);
}

TEST(Relief, StepsSayHowFarBackAFragmentLies)
{
    const CarvedSheets carved(kBricks, 1.5, true);
    for (const DepthMoment moment : {DepthMoment::Late, DepthMoment::Early}) {
        Replay              steps(carved.request({.depth = moment}));
        const std::uint64_t count    = *steps.count(Grain::Pixel);
        int                 inJoints = 0;
        for (std::uint64_t k = count / 2; k < count; k += 97) {
            const Result<StepState> state = steps.at(Grain::Pixel, StepIndex{k});
            ASSERT_TRUE(state.ok());
            if (!state->pixel || !state->pixel->unmovedDepth) continue;
            const bool isInJoint = state->pixel->depth < *state->pixel->unmovedDepth;
            EXPECT_EQ(state->pixel->won, !isInJoint);
            EXPECT_EQ(state->sentence.find("moved back from") != std::string::npos, isInJoint) << state->sentence;
            EXPECT_TRUE(state->pixel->shaded);
            EXPECT_EQ(state->sentence.find("only its shader knew how far back it lies") != std::string::npos,
                      isInJoint && moment == DepthMoment::Early)
                << state->sentence;
            inJoints += isInJoint;
        }
        EXPECT_GT(inJoints, 3);
    }
}

}  // namespace
}  // namespace zscope::tests
