// The fault gallery and the approximations: each shows what it claims to show, and the exact text beside it shows
// nothing.
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/frame/faults.h"
#include "core/measure/verify.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"

namespace zscope::tests {
namespace {

std::shared_ptr<const PreparedScene> preparedBuiltin(const std::string& builtin)
{
    auto scene = loadScene("builtin:" + builtin);
    EXPECT_TRUE(scene) << builtin;
    return std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(scene)));
}

/// One picture of an odd size against the reference.
VerifyRow judge(const std::string& builtin, const Pipeline& pipeline, Simd simd = Simd::Auto)
{
    const auto    scene = preparedBuiltin(builtin);
    VerifyRequest request;
    request.scene      = scene;
    request.camera     = cameraFor(scene->scene(), 333, 217);
    request.algorithms = {{"judged", {}, pipeline, claimOf(pipeline)}};
    request.simd       = {simd};
    // What one level of cells leaves out depends on where the stripes begin, and that on how fast the machine is.
    if (pipeline.approximation.cells == CellDescent::OneLevel) request.threads = {1};
    const auto rows = verify(request);
    EXPECT_TRUE(rows) << builtin;
    return rows ? rows->front() : VerifyRow{};
}

/// A scene in which the fault shows.
std::string sceneFor(Fault fault)
{
    switch (fault) {
        case Fault::OneTestPerInterval:
            return "hard/F8";
        case Fault::EqualIsHidden:
            return "layers?order=back";
        case Fault::NearRejected:
            return "wall-and-city";
        case Fault::LinearZ:
            return "cubes";
        case Fault::BehindTheEye:
            return "wall-and-city";
        case Fault::FarFirst:
            return "hard/C2";
        default:
            return "city";
    }
}

TEST(Faults, EachMakesWrongPixelsWhereTheExactTextMakesNone)
{
    for (const FaultEntry& entry : faults()) {
        Pipeline pipeline = findPreset(entry.preset)->pipeline;
        EXPECT_TRUE(judge(sceneFor(entry.fault), pipeline).figures.isExact()) << entry.word;
        pipeline.fault.add(entry.fault);
        const VerifyRow row = judge(sceneFor(entry.fault), pipeline);
        EXPECT_EQ(row.claim, Claim::Approximate) << entry.word;
        EXPECT_GT(row.figures.wrongPixels(), 0u) << entry.word;
    }
}

TEST(Faults, EachSpoilsTheSamePixelsWithAnyNumberOfThreads)
{
    for (const FaultEntry& entry : faults()) {
        const auto  scene = preparedBuiltin(sceneFor(entry.fault));
        DrawRequest request{.scene    = scene,
                            .camera   = cameraFor(scene->scene(), 333, 217),
                            .pipeline = findPreset(entry.preset)->pipeline};
        request.pipeline.fault = entry.fault;
        const auto drawn       = [&request](int threads) {
            request.threads = threads;
            Frame frame;
            EXPECT_TRUE(Renderer().draw(request, frame));
            std::vector<std::int64_t> ids;
            for (int y = 0; y < frame.visible.height(); ++y)
                for (int x = 0; x < frame.visible.width(); ++x) ids.push_back(frame.visible.rankAt(x, y));
            return ids;
        };
        EXPECT_EQ(drawn(1), drawn(3)) << entry.word;
    }
}

TEST(Faults, FarFirstIsWrongWhereFacesCoincideAndDrawsInVainWhatIsHiddenTooLate)
{
    Pipeline   pipeline     = findPreset("hzb-octree")->pipeline;
    const auto scene        = preparedBuiltin("million?faces=100000");
    const auto pixelsTested = [&] {
        Renderer    renderer;
        DrawRequest request;
        request.scene    = scene;
        request.camera   = cameraFor(scene->scene(), 333, 217);
        request.pipeline = pipeline;
        const auto work  = renderer.count(request);
        EXPECT_TRUE(work);
        std::uint64_t tested = 0;
        for (const NamedCount& count : work->counters)
            if (count.name == "pixels_tested") tested = count.value;
        return tested;
    };
    const std::uint64_t nearFirst = pixelsTested();
    pipeline.fault                = Fault::FarFirst;
    EXPECT_GT(pixelsTested(), 2 * nearFirst);
    EXPECT_TRUE(judge("million?faces=100000", pipeline).figures.isExact()) << "no two of its faces are equally near";

    const ErrorFigures ties = judge(sceneFor(Fault::FarFirst), pipeline).figures;
    EXPECT_GT(ties.nearTies, 100u);
    EXPECT_EQ(ties.nearTies, ties.wrongPixels());
    EXPECT_EQ(ties.depthBitsDiffer, 0u);
}

TEST(Faults, EachIsRefusedWithASentenceWhereItCannotHappen)
{
    for (const FaultEntry& entry : faults()) {
        for (const Preset& preset : presets()) {
            Pipeline pipeline = preset.pipeline;
            pipeline.fault    = entry.fault;
            EXPECT_EQ(explainInvalid(pipeline).has_value(), !entry.canHappen(pipeline))
                << preset.name << ' ' << entry.word;
        }
    }
}

/// The ids of a picture, row after row.
std::vector<std::int64_t> idsOf(const VisibilityBuffer& visible)
{
    std::vector<std::int64_t> ids;
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x) ids.push_back(visible.idAt(x, y));
    return ids;
}

/// A picture of 333 x 217 pixels with these faults, drawn by one thread.
std::vector<std::int64_t> drawnWith(const std::string& builtin, const Pipeline& preset, const FaultSet& faults,
                                    FaceCulling culling = FaceCulling::None)
{
    const auto  scene = preparedBuiltin(builtin);
    DrawRequest request{.scene       = scene,
                        .camera      = cameraFor(scene->scene(), 333, 217),
                        .faceCulling = culling,
                        .pipeline    = preset,
                        .threads     = 1};
    request.pipeline.fault = faults;
    Frame frame;
    EXPECT_TRUE(Renderer().draw(request, frame)) << builtin;
    return idsOf(frame.visible);
}

/// Wherever both can happen, on a scene with all that faults need, at a size in which no level of the pyramid is even.
TEST(Faults, AnyTwoDrawTogetherWithAnyNumberOfThreads)
{
    const auto scene = preparedBuiltin("wall-and-city?blocks=2");
    int        pairs = 0;
    for (const FaultEntry& one : faults())
        for (const FaultEntry& other : faults()) {
            DrawRequest request{.scene    = scene,
                                .camera   = cameraFor(scene->scene(), 61, 43),
                                .pipeline = findPreset(one.preset)->pipeline};
            request.pipeline.fault = one.fault;
            request.pipeline.fault.add(other.fault);
            if (explainInvalid(request.pipeline)) {
                EXPECT_FALSE(other.canHappen(request.pipeline)) << one.word << '+' << other.word;
                EXPECT_NE(explainInvalid(request.pipeline)->find(other.word), std::string::npos);
                continue;
            }
            ++pairs;
            std::vector<std::vector<std::int64_t>> pictures;
            for (const int threads : {1, 3}) {
                request.threads = threads;
                Frame frame;
                ASSERT_TRUE(Renderer().draw(request, frame)) << one.word << '+' << other.word;
                pictures.push_back(idsOf(frame.visible));
            }
            EXPECT_EQ(pictures[0], pictures[1]) << one.word << '+' << other.word;
        }
    EXPECT_GT(pairs, 200);
}

/// Both are seen: the picture is neither the one's nor the other's.
TEST(Faults, TwoTogetherSpoilMoreThanEachAlone)
{
    const Pipeline zbuffer = findPreset("zbuffer")->pipeline;
    FaultSet       both    = Fault::HalfPixel;
    both.add(Fault::NearRejected);
    const auto picture = drawnWith("wall-and-city", zbuffer, both);
    EXPECT_NE(picture, drawnWith("wall-and-city", zbuffer, Fault::HalfPixel));
    EXPECT_NE(picture, drawnWith("wall-and-city", zbuffer, Fault::NearRejected));
}

TEST(Faults, AreASetThatIsWrittenAndReadByWords)
{
    FaultSet faults;
    EXPECT_TRUE(faults.isEmpty());
    EXPECT_EQ(wordsOf(faults), "");
    faults.add(Fault::BoxShort);
    faults.add(Fault::NoTopLeft);
    faults.add(Fault::None);
    EXPECT_EQ(wordsOf(faults), "no-top-left+box-short");
    EXPECT_EQ(findFaults("box-short+no-top-left"), faults);
    EXPECT_EQ(findFaults("no-top-left"), FaultSet(Fault::NoTopLeft));
    for (const char* none : {"", "none", "no-top-left+", "+no-top-left", "no-top-left+bogus"})
        EXPECT_FALSE(findFaults(none)) << none;
    faults.remove(Fault::NoTopLeft);
    EXPECT_TRUE(faults == Fault::BoxShort);
    EXPECT_FALSE(faults.has(Fault::NoTopLeft));

    Pipeline pipeline = findPreset("zbuffer")->pipeline;
    pipeline.fault    = *findFaults("no-top-left+box-short");
    EXPECT_EQ(nameOf(pipeline), "zbuffer+fault=no-top-left+fault=box-short");
    pipeline.fault = Fault::NoTopLeft;
    EXPECT_EQ(nameOf(pipeline), "zbuffer+fault=no-top-left");
}

TEST(Faults, OfASetTheOneThatCannotHappenIsNamed)
{
    Pipeline pipeline = findPreset("zbuffer")->pipeline;
    pipeline.fault    = *findFaults("no-top-left+edge-drift+half-pixel");
    ASSERT_TRUE(explainInvalid(pipeline));
    EXPECT_EQ(*explainInvalid(pipeline),
              "The fault 'edge-drift' cannot happen here: it is one of edge walks and sweeps, as in edge-walk");
}

/// One approximation put into a preset that takes it, and a scene in which it shows.
struct Relaxed {
    const char* axis;
    const char* choice;
    const char* preset;
    const char* scene;
};
constexpr Relaxed kRelaxed[] = {
    {"snap", "4-bits", "zbuffer", "city"},
    {"snap", "12-bits", "zbuffer", "city"},
    {"vertices", "float32", "zbuffer", "city"},
    {"depth-numbers", "float32", "zbuffer", "city"},
    {"depth-numbers", "accumulated", "edge-walk", "city"},
    {"depth-format", "float32-standard", "zbuffer", "city"},
    {"depth-format", "fixed-24", "hzb-octree", "city"},
    {"depth-format", "fixed-16", "scanline", "city"},
    {"edges", "accumulated", "edge-walk", "wall-and-city"},
    {"near", "drop", "interval", "wall-and-city"},
    {"cells", "one-level", "hzb-bvh-prepass", "soccer-field?count=300"},
    {"small-nodes", "drop-below-4", "hzb-octree", "city"},
    {"small-nodes", "drop-below-16", "octree-frustum", "city"},
    {"coherence", "last-pyramid", "hzb-octree", "city"},
};

TEST(Approximations, EachPublishesItsErrorWhereTheDefinitionsChoiceHasNone)
{
    for (const Relaxed& each : kRelaxed) {
        const Pipeline exact = findPreset(each.preset)->pipeline;
        EXPECT_TRUE(judge(each.scene, exact).figures.isExact()) << each.preset;
        const auto relaxed = withChoice(exact, each.axis, each.choice);
        ASSERT_TRUE(relaxed);
        const VerifyRow row = judge(each.scene, *relaxed);
        EXPECT_GT(row.figures.wrongPixels() + row.figures.depthBitsDiffer, 0u) << each.axis << '=' << each.choice;
        EXPECT_TRUE(row.passed()) << "an approximation is reported, not failed";
    }
}

/// A dropped node is dropped whole, wherever a thread's lines begin, and its triangles are accounted for.
TEST(Approximations, SmallNodesAreDroppedAlikeByEveryThreadAndCounted)
{
    const auto  scene    = preparedBuiltin("city");
    const auto  pipeline = withChoice(findPreset("hzb-octree")->pipeline, "small-nodes", "drop-below-16");
    DrawRequest request;
    request.scene    = scene;
    request.camera   = cameraFor(scene->scene(), 333, 217);
    request.pipeline = *pipeline;
    Renderer             renderer;
    Frame                frame;
    std::vector<Picture> pictures;
    for (const int threads : {1, 2, 3, 5}) {
        request.threads = threads;
        ASSERT_TRUE(renderer.draw(request, frame));
        pictures.push_back(pictureOf(frame.visible));
        EXPECT_EQ(pictures.back(), pictures.front()) << threads << " threads";
    }
    const auto work = renderer.count(request);
    ASSERT_TRUE(work);
    std::map<std::string, std::uint64_t> counters;
    for (const NamedCount& count : work->counters) counters[std::string(count.name)] = count.value;
    EXPECT_GT(counters["nodes_dropped"], 0u);
    EXPECT_EQ(counters["nodes_visited"], counters["nodes_outside"] + counters["nodes_hidden"]
                                             + counters["nodes_entered"] + counters["nodes_dropped"]);
    EXPECT_GT(counters["triangles_dropped_with_node"], 0u);
    std::uint64_t sum = 0;
    for (const char* fate : {"transparent", "outside", "clipped_away", "back_facing", "degenerate", "no_pixel_centre",
                             "out_of_range", "hidden_by_node", "hidden", "dropped_with_node", "drawn"})
        sum += counters[std::string("triangles_") + fate];
    EXPECT_EQ(counters["triangles_in"], sum);
}

/// Nodes and questions that an approximation could not change.
TEST(Approximations, OfCullingAreRefusedWhereNothingIsCulled)
{
    for (const Preset& preset : presets()) {
        Pipeline pipeline            = preset.pipeline;
        pipeline.approximation.cells = CellDescent::OneLevel;
        EXPECT_EQ(explainInvalid(pipeline).has_value(), pipeline.upkeep == Upkeep::None) << preset.name;
        pipeline                     = preset.pipeline;
        pipeline.approximation.small = SmallNodes::DropBelow4;
        EXPECT_EQ(explainInvalid(pipeline).has_value(), pipeline.order == Order::Submitted) << preset.name;
    }
}

TEST(Approximations, AreTheSameOnEveryInstructionSet)
{
    for (const Relaxed& each : kRelaxed) {
        const auto relaxed = withChoice(findPreset(each.preset)->pipeline, each.axis, each.choice);
        ASSERT_TRUE(relaxed);
        const ErrorFigures scalar = judge(each.scene, *relaxed, Simd::Scalar).figures;
        for (const Simd simd : targetsTested()) {
            const ErrorFigures wide = judge(each.scene, *relaxed, simd).figures;
            EXPECT_EQ(wide.wrongPixels(), scalar.wrongPixels())
                << each.axis << '=' << each.choice << ' ' << wordOf(simd);
            EXPECT_EQ(wide.depthBitsDiffer, scalar.depthBitsDiffer)
                << each.axis << '=' << each.choice << ' ' << wordOf(simd);
        }
    }
}

}  // namespace
}  // namespace zscope::tests
