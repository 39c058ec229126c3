// Ray casting: the definition's picture, by boxes that are grown enough; what each ray says of itself is true.
#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/frame/observed_run.h"
#include "core/frame/shortcuts.h"
#include "core/measure/verify.h"
#include "core/method/ray_casting.h"
#include "core/probe/recorders.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

const Preset& rays() { return *findPreset("ray-casting"); }

TEST(RayCasting, DrawsTheDefinitionsPictureOfEveryKindOfSoupByAnyNumberOfThreads)
{
    for (const SoupKind kind : soupKinds())
        for (std::uint64_t seed = 1; seed <= shareOf(10); ++seed) {
            const Soup soup = makeSoup(kind, seed, 71, 53, 80);
            const auto rows = verify({.scene       = prepared(soup.scene),
                                      .camera      = soup.camera,
                                      .faceCulling = seed % 2 ? FaceCulling::None : FaceCulling::Back,
                                      .algorithms  = {rays()},
                                      .threads     = {1, 3}});
            ASSERT_TRUE(rows.ok());
            for (const VerifyRow& row : *rows) EXPECT_TRUE(row.passed()) << soup.what << ", seed " << seed;
        }
}

/// A rectangle that begins a little right of, or below, a column or line of pixel centres, on which only snapping
/// brings it: the box of its corners begins there, too.
TEST(RayCasting, MeetsATriangleThatOnlySnappingBringsOntoAPixelCentre)
{
    const Camera camera = plainCamera(64, 48);
    for (const double slip : {1.0 / 520, 1.0 / 2000}) {
        const double               left = 20.5 + slip, top = 10.5 + slip, z = 3;
        const std::vector<Corners> triangles{
            {pointAt(camera, left, top, z), pointAt(camera, left, 30, z), pointAt(camera, 50, 30, z)},
            {pointAt(camera, left, top, z), pointAt(camera, 50, 30, z), pointAt(camera, 50, top, z)}};
        DrawRequest request{.scene = prepared(sceneOf(triangles)), .camera = camera, .pipeline = rays().pipeline};
        Renderer    renderer;
        Frame       frame;
        ASSERT_TRUE(renderer.draw(request, frame).ok());
        EXPECT_GE(frame.visible.idAt(20, 20), 0) << "the column that snapping covers";
        EXPECT_GE(frame.visible.idAt(40, 10), 0) << "the line";
        EXPECT_EQ(frame.visible.idAt(19, 20), -1);
        EXPECT_EQ(pictureOf(frame.visible), *referencePicture(request.scene->scene(), camera, FaceCulling::None));
    }
}

/// Holds what the rays say against the picture as it is being drawn, and keeps what they left out.
struct RayJudge {
    using Events = Wants<plain::RayCast, plain::NodeBehindRay>;

    const VisibilityBuffer&           visible;
    std::uint64_t                     rays = 0, boxes = 0, triangles = 0;
    std::vector<plain::NodeBehindRay> behind = {};

    void observe(const plain::RayCast& e)
    {
        ++rays;
        boxes += static_cast<std::uint64_t>(e.boxes);
        triangles += static_cast<std::uint64_t>(e.triangles);
        EXPECT_EQ(e.rank, visible.rankAt(e.pixel.x, e.pixel.y));
        EXPECT_LE(e.missed + e.behind, e.boxes);
        EXPECT_EQ(e.rank != 0, e.triangles > 0) << "nothing here lies beyond the far plane";
    }
    void observe(const plain::NodeBehindRay& e)
    {
        EXPECT_EQ(e.met, visible.comparedAt(e.pixel.x, e.pixel.y));
        EXPECT_LT(e.nearest, e.met);
        behind.push_back(e);
    }
};

TEST(RayCasting, EveryPixelHasOneRayThatAsksFewTrianglesAndSaysWhatItSees)
{
    const Scene       scene = builtinScene("city?blocks=3");
    const DrawRequest request{
        .scene = prepared(scene), .camera = cameraFor(scene, 96, 64), .pipeline = rays().pipeline, .shade = false};
    Frame          frame;
    plain::Scratch scratch;
    RayJudge       judge{frame.visible};
    Listening      listening(judge);
    drawObserved(request, frame, scratch, listening);
    EXPECT_EQ(judge.rays, 96u * 64u);
    EXPECT_GT(judge.boxes, judge.rays);
    EXPECT_LT(judge.triangles, judge.rays * 64) << "of " << scene.triangleCount();
    EXPECT_GT(judge.behind.size(), judge.rays / 10) << "near boxes first: some lie behind";
    auto counters = countersOf(request);
    EXPECT_EQ(judge.triangles, counters["pixels_tested"]) << "what a ray meets is tested";
    EXPECT_EQ(counters["triangle_set_ups"], counters["triangles_in"] - counters["triangles_outside"])
        << "each is set up once, not for every ray";
}

TEST(RayCasting, SaysThatPlainTextDrawsItAndTakesNoMoreMemoryThanItMay)
{
    const Scene scene = builtinScene("city?blocks=3");
    DrawRequest request{
        .scene = prepared(scene), .camera = cameraFor(scene, 96, 64), .pipeline = rays().pipeline, .threads = 1};
    Renderer   renderer;
    Frame      frame;
    const auto report = renderer.draw(request, frame);
    ASSERT_TRUE(report.ok());
    EXPECT_FALSE(whyPlain(request.pipeline).empty());
    for (const ShortcutUse& use : usesOf(report->shortcuts, report->pipeline)) {
        EXPECT_FALSE(use.applies) << use.name;
        EXPECT_EQ(use.why, whyNoFastText(request.pipeline)) << use.name;
    }
    request.memoryLimit = 1 << 20;
    const auto refused  = renderer.draw(request, frame);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().kind, Trouble::Limit);
}

}  // namespace
}  // namespace zscope::tests
