// Transparent surfaces: the sorted list draws the colours of the reference whatever crosses what, and for any cut of
// the picture into stripes; back faces before front faces does so for one convex body, and not where bodies overlap.
#include <gtest/gtest.h>

#include <memory>

#include "core/frame/renderer.h"
#include "core/measure/reference.h"
#include "core/measure/reference_colours.h"
#include "core/measure/verify.h"
#include "core/scene/load.h"
#include "core/shade/colour_table.h"
#include "tests/agreement/agreement_support.h"

namespace zscope::tests {
namespace {

struct Shown {
    std::shared_ptr<const PreparedScene> scene;
    Camera                               camera;
    Picture                              opaque;
    Grid<std::uint32_t>                  colours;  // of the reference
};

Shown shown(const std::shared_ptr<const Scene>& scene, const Camera& camera, FaceCulling culling = FaceCulling::None)
{
    Shown all{std::make_shared<const PreparedScene>(scene), camera, {}, {}};
    auto  opaque = referencePicture(*scene, camera, culling);
    EXPECT_TRUE(opaque);
    all.opaque   = *std::move(opaque);
    auto colours = referenceColours(*scene, camera, culling, all.opaque);
    EXPECT_TRUE(colours);
    all.colours = *std::move(colours);
    return all;
}

std::shared_ptr<const Scene> builtin(const std::string& word)
{
    auto scene = loadScene("builtin:" + word);
    EXPECT_TRUE(scene) << word;
    return std::make_shared<const Scene>(*std::move(scene));
}

/// Every triangle of the scene, with this opacity.
std::shared_ptr<const Scene> ofGlass(const Scene& scene, float opacity)
{
    Scene glass = scene;
    for (auto& mesh : glass.meshes) {
        auto copy = std::make_shared<Mesh>(*mesh);
        for (Material& material : copy->materials) material.opacity = opacity;
        mesh = std::move(copy);
    }
    return std::make_shared<const Scene>(std::move(glass));
}

ColourFigures figuresOf(const Shown& all, BlendOrder order, int threads = 1, FaceCulling culling = FaceCulling::None)
{
    DrawRequest request{
        .scene = all.scene, .camera = all.camera, .faceCulling = culling, .pipeline = {}, .threads = threads};
    request.pipeline.transparency = order;
    Frame    frame;
    Renderer renderer;
    EXPECT_TRUE(renderer.draw(request, frame));
    EXPECT_EQ(pictureOf(frame.visible), all.opaque);
    return compareColours(all.colours, frame.colour);
}

TEST(Transparency, SurfacesThatCrossAreBlendedAsTheReferenceBlendsThem)
{
    const auto scene = builtin("glass");
    for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
        const Shown all = shown(scene, cameraFor(*scene, 211, 157), culling);
        for (const int threads : {1, 2, 3})
            EXPECT_EQ(figuresOf(all, BlendOrder::Sorted, threads, culling), ColourFigures{}) << threads;
    }
}

TEST(Transparency, BackFacesBeforeFrontFacesIsRightForOneConvexBodyAndWrongWhereBodiesOverlap)
{
    const auto ball = ofGlass(*builtin("cubes"), 0.5f);
    Scene      one  = *ball;
    one.instances.resize(1);
    auto alone = assemble(std::move(one));
    ASSERT_TRUE(alone);
    const auto  single = std::make_shared<const Scene>(*std::move(alone));
    const Shown convex = shown(single, cameraFor(*single, 211, 157));
    EXPECT_EQ(figuresOf(convex, BlendOrder::BackThenFront), ColourFigures{});

    const auto          glass = builtin("glass");
    const ColourFigures wrong = figuresOf(shown(glass, cameraFor(*glass, 211, 157)), BlendOrder::BackThenFront);
    EXPECT_GT(wrong.wrong, 500u);
    EXPECT_GT(wrong.maxChannel, 20);
}

TEST(Transparency, AColourIsMixedByOpacityOverWhatIsBehind)
{
    // A white pane of opacity 1/4 over the background, seen head-on: every channel a quarter of the way.
    const auto          pane  = ofGlass(*builtin("layers?count=1"), 0.25f);
    const Shown         all   = shown(pane, cameraFor(*pane, 31, 17));
    const std::uint32_t mixed = all.colours.at(15, 8), source = colourOf(*pane, InstanceId{0}, 0);
    for (const int shift : {0, 8, 16}) {
        const double before = static_cast<double>(kBackgroundColour >> shift & 0xFFu),
                     over   = static_cast<double>(source >> shift & 0xFFu);
        EXPECT_NEAR(static_cast<double>(mixed >> shift & 0xFFu), before + 0.25 * (over - before), 0.51) << shift;
    }
    EXPECT_EQ(figuresOf(all, BlendOrder::Sorted), ColourFigures{});
}

TEST(Transparency, TheColoursOfAnotherShadingCostAreWrongAndARowWithWrongColoursFails)
{
    const auto   scene    = std::make_shared<const PreparedScene>(builtin("glass"));
    const Camera camera   = cameraFor(scene->scene(), 131, 97);
    const auto   opaque   = referencePicture(scene->scene(), camera, FaceCulling::None);
    const auto   unshaded = referenceColours(scene->scene(), camera, FaceCulling::None, *opaque);
    for (const Preset& preset : exactPresets()) {
        Pipeline pipeline = preset.pipeline;
        pipeline.cost     = ShadingCost::Ten;
        const auto rows =
            verify({.scene = scene, .camera = camera, .algorithms = {{preset.name, {}, pipeline, preset.claim}}});
        ASSERT_TRUE(rows);
        VerifyRow row = rows->front();
        EXPECT_TRUE(row.passed()) << preset.name;
        ASSERT_EQ(row.colours, ColourFigures{}) << preset.name;
        row.colours->wrong = 1;
        EXPECT_FALSE(row.passed()) << preset.name;

        Frame    frame;
        Renderer renderer;
        ASSERT_TRUE(renderer.draw({.scene = scene, .camera = camera, .pipeline = pipeline}, frame));
        const ColourFigures wrong = compareColours(*unshaded, frame.colour);
        EXPECT_GT(wrong.wrong, 100u) << preset.name;
        if (preset.isExact()) {
            EXPECT_EQ(wrong.maxChannel, 1) << preset.name;
        }
    }
}

TEST(Transparency, ALineOfMoreFragmentsThanAreKeptAtOnceIsBlendedInParts)
{
    const auto  layers = ofGlass(*builtin("layers?count=5000&order=back"), 0.001f);
    const Shown all    = shown(layers, cameraFor(*layers, 1100, 1));
    EXPECT_EQ(figuresOf(all, BlendOrder::Sorted), ColourFigures{});
}

TEST(Transparency, ASceneWithoutItBlendsNothingAndSaysSo)
{
    const auto  scene = builtin("cubes");
    DrawRequest request{
        .scene = std::make_shared<const PreparedScene>(scene), .camera = cameraFor(*scene, 64, 48), .pipeline = {}};
    Frame      frame;
    Renderer   renderer;
    const auto report = renderer.draw(request, frame);
    ASSERT_TRUE(report);
    for (const NamedCount& bytes : report->bytes) {
        if (bytes.name == "transparent_batches") {
            EXPECT_EQ(bytes.value, 0u);
        }
    }
    const auto work = renderer.count(request);
    ASSERT_TRUE(work);
    for (const NamedCount& count : work->counters) {
        if (count.name == "pixels_blended" || count.name == "fragments_transparent") {
            EXPECT_EQ(count.value, 0u) << count.name;
        }
    }
}

}  // namespace
}  // namespace zscope::tests
