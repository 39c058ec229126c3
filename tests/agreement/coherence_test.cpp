// What a frame takes over from the one before changes its work and never its picture: one renderer draws frame after
// frame while camera, size, threads, algorithm and scene change under it, and every frame is the z-buffer's.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <string>

#include "core/measure/verify.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

std::shared_ptr<const PreparedScene> load(const std::string& word)
{
    auto loaded = loadScene(word);
    EXPECT_TRUE(loaded.ok()) << word << ": " << (loaded.ok() ? "" : loaded.error().text());
    return std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(loaded)));
}

/// At street level round the middle of the city, looking along the way; every tenth frame is a cut to somewhere else.
Camera onTheWay(const Bounds& bounds, int frame, int width, int height)
{
    const dvec3  centre = 0.5 * (bounds.min + bounds.max), size = bounds.max - bounds.min;
    const double turn = 0.02 * frame + 2.1 * (frame / 10);
    ViewRequest  view;
    view.eye          = dvec3{centre.x + 0.3 * size.x * std::cos(turn), bounds.min.y + 0.03 * size.y * (1 + frame % 4),
                     centre.z + 0.3 * size.z * std::sin(turn)};
    view.target       = *view.eye + dvec3{-std::sin(turn), 0.05, std::cos(turn)};
    view.width        = width;
    view.height       = height;
    const auto camera = makeCamera(view, bounds);
    EXPECT_TRUE(camera.ok()) << (camera.ok() ? "" : camera.error().text());
    return *camera;
}

/// One renderer for the z-buffer, which forgets everything, and one for the method under test.
class Pair {
public:
    DrawRequest request;

    /// Draws `request` by both; how many pixels are covered.
    std::uint64_t expectSame(const std::string& what)
    {
        DrawRequest plain = request;
        plain.pipeline    = findPreset("zbuffer")->pipeline;
        EXPECT_TRUE(m_plain.draw(plain, m_expected).ok()) << what;
        EXPECT_TRUE(m_renderer.draw(request, m_frame).ok()) << what;
        const Picture expected = pictureOf(m_expected.visible);
        EXPECT_TRUE(expected == pictureOf(m_frame.visible)) << what << ": the picture is another";
        return compare(expected, expected).covered;
    }

    /// Draws `request` by the method alone.
    void expectDrawn() { EXPECT_TRUE(m_renderer.draw(request, m_frame).ok()); }

private:
    Renderer m_plain, m_renderer;
    Frame    m_expected, m_frame;
};

/// One renderer and one buffer for everything, whose pictures may lie above each other, against new ones for each.
class Stack {
public:
    void expectSame(const DrawRequest& request, const std::string& what)
    {
        Frame fresh;
        EXPECT_TRUE(Renderer().draw(request, fresh).ok()) << what;
        EXPECT_TRUE(m_renderer.draw(request, m_frame).ok()) << what;
        const Picture expected = pictureOf(fresh.visible);
        EXPECT_TRUE(expected == pictureOf(m_frame.visible)) << what << ": the picture is another";
        EXPECT_TRUE(fresh.colour == m_frame.colour) << what << ": its colours are others";
        covered += compare(expected, expected).covered;
        above += m_frame.visible.background() > m_lastBackground;
        m_lastBackground = m_frame.visible.background();
    }

    void draw(const DrawRequest& request) { EXPECT_TRUE(m_renderer.draw(request, m_frame).ok()); }

    std::uint64_t covered = 0;
    int           above   = 0;  // pictures that did

private:
    Renderer m_renderer;
    Frame    m_frame;
    PixelKey m_lastBackground = std::numeric_limits<PixelKey>::max();
};

DrawRequest requestFor(std::shared_ptr<const PreparedScene> scene, const Camera& camera, const Pipeline& pipeline)
{
    DrawRequest request;
    request.scene    = std::move(scene);
    request.camera   = camera;
    request.pipeline = pipeline;
    request.shade    = false;
    return request;
}

std::vector<Preset> coherentPresets()
{
    std::vector<Preset> coherent;
    for (const Preset& preset : presets())
        if (preset.isExact()
            && (preset.pipeline.coherence != Coherence::None || preset.pipeline.chooser == Chooser::Measured))
            coherent.push_back(preset);
    return coherent;
}

TEST(Coherence, EveryFrameOfAWayThroughTheCityIsTheZBuffers)
{
    const auto scene = load("builtin:city?blocks=4");
    ASSERT_FALSE(coherentPresets().empty());
    for (const Preset& preset : coherentPresets()) {
        Pair          pair;
        std::uint64_t covered = 0;
        for (int frame = 0; frame < static_cast<int>(shareOf(30)); ++frame) {
            pair.request         = requestFor(scene, onTheWay(scene->scene().bounds, frame, 160, 100), preset.pipeline);
            pair.request.threads = 2;
            covered += pair.expectSame(std::string(preset.name) + ", frame " + std::to_string(frame));
        }
        EXPECT_GT(covered, 10000u);
    }
}

TEST(Coherence, SizeThreadsTreeAndAlgorithmMayChangeBetweenFrames)
{
    const auto scene = load("builtin:city?blocks=2");
    Pair       pair;
    for (int frame = 0; frame < 24; ++frame) {
        const Pipeline pipelines[] = {findPreset("two-pass")->pipeline,
                                      *withChoice(findPreset("two-pass")->pipeline, "order", "bvh"),
                                      findPreset("hzb-octree")->pipeline, findPreset("two-pass")->pipeline};
        const int      sizes[][2]  = {{96, 64}, {96, 64}, {33, 129}, {1, 1}, {160, 31}};
        const auto&    size        = sizes[frame % 5];
        pair.request =
            requestFor(scene, onTheWay(scene->scene().bounds, frame, size[0], size[1]), pipelines[frame / 2 % 4]);
        pair.request.threads = 1 + frame % 3;
        pair.expectSame("frame " + std::to_string(frame));
    }
}

/// By every preset in turn, whatever it promises, so that those whose depths have one scale come between; with far
/// planes that leave room for a hundred pictures, and for one.
TEST(Coherence, PicturesThatLieAboveTheLastOneAreThoseOfANewBuffer)
{
    for (const SoupKind kind : soupKinds()) {
        Stack stack;
        int   picture = 0;
        for (const Preset& preset : presets())
            for (const double far : {1.5, 300.0, 3e5, 1e20}) {
                const Soup  soup = makeSoup(kind, static_cast<std::uint64_t>(picture % 5), 150, 90, 40);
                DrawRequest request =
                    requestFor(std::make_shared<const PreparedScene>(soup.scene), soup.camera, preset.pipeline);
                request.camera.far  = far * request.camera.near;
                request.threads     = 1 + picture % 2;
                request.shade       = picture % 3 != 0;
                request.faceCulling = picture % 4 == 3 ? FaceCulling::Back : FaceCulling::None;
                request.simd        = targetsTested()[static_cast<std::size_t>(picture) % targetsTested().size()];
                stack.expectSame(request, soup.what + ", " + std::string(preset.name) + ", far " + std::to_string(far));
                ++picture;
            }
        EXPECT_GT(stack.covered, 1000u) << nameOf(kind);
        EXPECT_GT(stack.above, 20) << nameOf(kind);
    }
}

TEST(Coherence, PicturesOfAWalkLieAboveEachOther)
{
    const auto scene = load("builtin:city?blocks=2");
    for (const std::string_view preset :
         {"zbuffer", "hzb-bvh", "two-pass", "hzb-octree", "scanline", "interval", "auto"}) {
        Stack stack;
        for (int frame = 0; frame < static_cast<int>(shareOf(40)); ++frame) {
            DrawRequest request =
                requestFor(scene, onTheWay(scene->scene().bounds, frame, 160, 100), findPreset(preset)->pipeline);
            request.threads = 2;
            request.shade   = frame % 2 == 0;
            stack.expectSame(request, std::string(preset) + ", frame " + std::to_string(frame));
        }
        EXPECT_GT(stack.covered, 10000u);
        EXPECT_GT(stack.above, static_cast<int>(shareOf(40)) / 2) << preset;
    }
}

/// What is shaded where it wins must not win over what was left far below the background, though the scale of the
/// picture between is its own: whatever the number of pictures before, the picture of a wall beyond the far plane shows
/// nothing.
TEST(Coherence, APictureThatIsShadedWhereItWinsFindsItsTilesEmptied)
{
    Camera camera     = plainCamera(64, 48);
    camera.far        = 200;
    const auto wallAt = [&camera](double z, double size) {
        const Corners wall[] = {
            {pointAt(camera, -9, -9, z), pointAt(camera, size, -9, z), pointAt(camera, -9, size, z)}};
        return std::make_shared<const PreparedScene>(sceneOf(wall));
    };
    const auto before = wallAt(190, 200), aside = wallAt(190, 12), beyond = wallAt(300, 200);
    for (int pictures = 1; pictures < 60; ++pictures) {
        Stack stack;
        for (int i = 0; i < pictures; ++i) stack.draw(requestFor(before, camera, findPreset("zbuffer")->pipeline));
        stack.expectSame(requestFor(aside, camera, findPreset("zbuffer")->pipeline),
                         std::to_string(pictures) + " pictures");
        DrawRequest shaded = requestFor(beyond, camera, findPreset("zbuffer-late")->pipeline);
        shaded.shade       = true;
        stack.expectSame(shaded, std::to_string(pictures) + " pictures, then shaded");
    }
}

/// At full speed small nodes are drawn and remembered undivided; an approximation divides them.
TEST(Coherence, FramesOfAnApproximationMayComeBetween)
{
    const auto     scene       = load("builtin:soccer-field?ball=icosphere&count=60");
    const Pipeline exact       = findPreset("two-pass")->pipeline;
    Pipeline       rough       = exact;
    rough.approximation.vertex = VertexNumbers::Float32;
    Pair pair;
    for (int frame = 0; frame < 12; ++frame) {
        pair.request =
            requestFor(scene, onTheWay(scene->scene().bounds, frame, 200, 120), frame % 4 == 2 ? rough : exact);
        pair.request.threads = 1 + frame % 2;
        if (frame % 4 != 2)
            pair.expectSame("frame " + std::to_string(frame));
        else
            pair.expectDrawn();
    }
}

/// The scene of the frame before is gone when the next is made: nodes of the new one may stand where those of the old
/// one stood, and a memory that trusted addresses would draw them, or worse.
TEST(Coherence, AnotherSceneIsNotTakenForTheLastOne)
{
    Pair          pair;
    std::uint64_t covered = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        const Soup soup      = makeSoup(soupKinds()[seed % 5], seed, 61, 43, 900);
        pair.request         = requestFor(std::make_shared<const PreparedScene>(soup.scene), soup.camera,
                                          findPreset("two-pass")->pipeline);
        pair.request.threads = 1;
        covered += pair.expectSame(soup.what);
        covered += pair.expectSame(soup.what + " again");
        pair.request.scene.reset();
    }
    EXPECT_GT(covered, 1000u);
}

/// Whatever it tries and keeps, it draws one picture and says by what.
TEST(Coherence, AMeasuredChoiceSaysWhatDrewTheFrameAndWhy)
{
    const auto  scene  = load("builtin:city?blocks=2");
    const auto  camera = cameraFor(scene->scene(), 96, 64);
    Renderer    renderer;
    Frame       frame;
    DrawRequest request = requestFor(scene, camera, findPreset("auto")->pipeline);
    request.threads     = 1;
    std::string last;
    int         trials = 0;
    for (int i = 0; last.empty(); ++i) {
        ASSERT_LT(i, 100) << "trials end";
        const auto report = renderer.draw(request, frame);
        ASSERT_TRUE(report.ok());
        ASSERT_NE(findPreset(report->chosen), nullptr) << report->chosen;
        EXPECT_NE(report->why.find(report->chosen), std::string::npos) << report->why;
        if (i == 0) {
            EXPECT_EQ(report->chosen, "zbuffer");
        }
        if (!report->isTrial) last = report->why;
        trials += report->isTrial;
    }
    EXPECT_GE(trials, 4) << "each candidate at least once";
    EXPECT_TRUE(last.starts_with("auto keeps ")) << last;
    request.camera.width = 95;
    EXPECT_TRUE(renderer.draw(request, frame)->isTrial) << "another size, other times";
    request.pipeline = findPreset("zbuffer")->pipeline;
    EXPECT_EQ(renderer.draw(request, frame)->chosen, "");
}

/// A wall before a ball, from afar: what the last frame saw is the wall.
TEST(Coherence, WhatWasSeenIsDrawnWithoutAQuestionAndTheRestIsHiddenByIt)
{
    const auto   scene  = load("builtin:wall-and-city?blocks=3");
    const Camera camera = cameraFor(scene->scene(), 160, 100);
    auto         plain  = countersOf(requestFor(scene, camera, findPreset("hzb-octree")->pipeline));
    auto         twice  = countersOf(requestFor(scene, camera, findPreset("two-pass")->pipeline));
    EXPECT_EQ(plain["nodes_recalled"], 0u);
    EXPECT_GT(twice["nodes_recalled"], 0u);
    EXPECT_LE(twice["nodes_entered"], plain["nodes_entered"]) << "the second visit asks a pyramid that is finished";
    EXPECT_LT(twice["pyramid_queries"], plain["pyramid_queries"])
        << "nobody asks about the triangles of the first pass";
    EXPECT_EQ(twice["triangles_in"], plain["triangles_in"]);
}

}  // namespace
}  // namespace zscope::tests
