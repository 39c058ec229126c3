// The renderer keeps its promises beside the picture: any thread count and vector target, honest times and counters,
// clear errors.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>

#include "core/frame/frame_plan.h"
#include "core/frame/renderer.h"
#include "core/hierarchy/tree.h"
#include "core/measure/reference.h"
#include "core/scene/load.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

DrawRequest requestFor(std::shared_ptr<const Scene> scene, const Camera& camera, const Pipeline& pipeline)
{
    DrawRequest request;
    request.scene    = std::make_shared<PreparedScene>(std::move(scene));
    request.camera   = camera;
    request.pipeline = pipeline;
    return request;
}

struct Drawn {
    Picture             picture;
    Grid<std::uint32_t> colour;
    FrameReport         report;

    bool showsTheSameAs(const Drawn& other) const { return picture == other.picture && colour == other.colour; }
};

Drawn draw(Renderer& renderer, const DrawRequest& request)
{
    Frame                     frame;
    const Result<FrameReport> report = renderer.draw(request, frame);
    EXPECT_TRUE(report.ok()) << report.error().text();
    if (!report) return {};
    return {pictureOf(frame.visible), frame.colour, *report};
}

Drawn draw(const DrawRequest& request)
{
    Renderer renderer;
    return draw(renderer, request);
}

std::map<std::string, std::uint64_t> countsOf(const DrawRequest& request)
{
    const Result<FrameWork> work = Renderer().count(request);
    EXPECT_TRUE(work.ok()) << work.error().text();
    std::map<std::string, std::uint64_t> byName;
    for (const NamedCount& count : work->counters) byName[count.name] = count.value;
    return byName;
}

TEST(Renderer, OneToEightThreadsGiveTheSameBitsAlsoWithFewerLinesThanThreads)
{
    for (const auto& [width, height] : {std::pair{53, 41}, {40, 5}, {33, 1}, {1, 7}, {16384, 2}}) {
        const Soup soup = makeSoup(SoupKind::NearCrossing, 7, width, height, 60);
        for (const Preset& preset : presets()) {
            DrawRequest request = requestFor(soup.scene, soup.camera, preset.pipeline);
            request.threads     = 1;
            const Drawn one     = draw(request);
            Renderer    renderer;  // its stripes move while the thread count changes
            for (int threads = 1; threads <= 8; ++threads) {
                request.threads = threads;
                for (int frame = 0; frame < 3; ++frame)
                    EXPECT_TRUE(draw(renderer, request).showsTheSameAs(one))
                        << preset.name << ", " << soup.what << ", " << threads;
                EXPECT_EQ(draw(renderer, request).report.threads, std::min(threads, height));
            }
        }
    }
}

TEST(Renderer, EveryVectorTargetOfTheMachineGivesTheSameBits)
{
    int targets = 0;
    for (const SimdEntry& entry : simdTargets()) {
        if (!entry.available) continue;
        ++targets;
        for (const SoupKind kind : {SoupKind::Loose, SoupKind::OnTheGrid, SoupKind::Slivers, SoupKind::Turned}) {
            const Soup soup = makeSoup(kind, 9, 61, 37, 80);
            for (const Preset& preset : presets()) {
                DrawRequest request = requestFor(soup.scene, soup.camera, preset.pipeline);
                request.simd        = Simd::Scalar;
                const Drawn scalar  = draw(request);
                request.simd        = entry.target;
                const Drawn other   = draw(request);
                EXPECT_TRUE(other.showsTheSameAs(scalar)) << preset.name << ", " << soup.what << ", " << entry.word;
                EXPECT_EQ(other.report.simd, entry.target);
            }
        }
    }
    EXPECT_GE(targets, 1);
    EXPECT_NE(resolved(Simd::Auto), Simd::Auto);
}

TEST(Renderer, AVectorTargetTheMachineLacksIsAUsageError)
{
    const Soup soup = makeSoup(SoupKind::Loose, 1, 8, 8, 2);
    for (const SimdEntry& entry : simdTargets()) {
        DrawRequest request          = requestFor(soup.scene, soup.camera, {});
        request.simd                 = entry.target;
        const Result<FramePlan> plan = planFrame(request);
        EXPECT_EQ(plan.ok(), entry.available) << entry.word;
        if (plan.ok()) continue;
        EXPECT_EQ(plan.error().kind, Trouble::Usage);
        EXPECT_NE(plan.error().sentence.find(entry.word), std::string::npos) << plan.error().sentence;
    }
}

TEST(Renderer, RequestsThatCannotBeMetAreRefusedInASentence)
{
    const Soup  soup    = makeSoup(SoupKind::Loose, 1, 640, 480, 2);
    DrawRequest request = requestFor(soup.scene, soup.camera, {});
    Frame       frame;
    for (const int threads : {-1, 257, std::numeric_limits<int>::max()}) {
        request.threads = threads;
        EXPECT_EQ(Renderer().draw(request, frame).error().kind, Trouble::Usage) << threads;
    }
    request.threads                   = 1;
    request.memoryLimit               = 1 << 20;
    const Result<FrameReport> refused = Renderer().draw(request, frame);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().kind, Trouble::Limit);
    EXPECT_NE(refused.error().sentence.find("640x480"), std::string::npos) << refused.error().sentence;
    request.memoryLimit = 64 << 20;
    EXPECT_TRUE(Renderer().draw(request, frame).ok());
}

TEST(Renderer, ACancelledFrameSaysSoAndTheNextOneIsWhole)
{
    const Soup        soup   = makeSoup(SoupKind::Loose, 3, 64, 64, 50);
    std::atomic<bool> cancel = true;
    for (const Preset& preset : presets()) {
        DrawRequest request = requestFor(soup.scene, soup.camera, preset.pipeline);
        const Drawn whole   = draw(request);
        request.cancel      = &cancel;
        Renderer renderer;
        Frame    frame;
        cancel = true;
        EXPECT_EQ(renderer.draw(request, frame).error().kind, Trouble::Cancelled) << preset.name;
        EXPECT_EQ(renderer.count(request).error().kind, Trouble::Cancelled) << preset.name;
        cancel = false;
        EXPECT_TRUE(draw(renderer, request).showsTheSameAs(whole)) << preset.name;
    }
}

TEST(Renderer, StageTimesAddUpToTheFrameAndEveryStageHasAReason)
{
    const Soup soup = makeSoup(SoupKind::Loose, 4, 300, 200, 400);
    for (const Preset& preset : presets()) {
        for (const bool shade : {true, false}) {
            DrawRequest request = requestFor(soup.scene, soup.camera, preset.pipeline);
            request.threads     = 2;
            request.shade       = shade;
            Renderer renderer;
            for (int frame = 0; frame < 3; ++frame) {
                const FrameReport report = draw(renderer, request).report;
                ASSERT_EQ(report.stages.size(), kStages.size());
                double sum = 0;
                for (std::size_t i = 0; i < kStages.size(); ++i) {
                    const StageTime& stage = report.stages[i];
                    EXPECT_EQ(stage.stage, kStages[i]);
                    EXPECT_FALSE(stage.why.empty());
                    EXPECT_GE(stage.ms, -0.03 * report.frameMs) << preset.name << ", " << wordOf(stage.stage);
                    if (!stage.ran) {
                        EXPECT_EQ(stage.ms, 0) << preset.name << ", " << wordOf(stage.stage) << " did not run";
                    }
                    sum += stage.ms;
                }
                EXPECT_GT(report.frameMs, 0);
                EXPECT_NEAR(sum, report.frameMs, 0.03 * report.frameMs) << preset.name;
            }
        }
    }
}

TEST(Renderer, WhatIsMadeOnceIsAccountedToTheStageBuild)
{
    const auto  scene   = std::make_shared<const Scene>(loadScene("builtin:icosphere?frequency=60").value());
    DrawRequest request = requestFor(scene, *makeCamera({}, scene->bounds), presets().front().pipeline);
    Renderer    renderer;
    const auto  builtMs = [&](FaceCulling culling) {
        request.faceCulling   = culling;
        const StageTime build = draw(renderer, request).report.stages[static_cast<std::size_t>(Stage::Build)];
        EXPECT_EQ(build.ran, culling == FaceCulling::Back);
        return build.ms;
    };
    EXPECT_EQ(builtMs(FaceCulling::None), 0);
    // 72,000 triangles are put into patches, then none is
    const double first = builtMs(FaceCulling::Back), second = builtMs(FaceCulling::Back);
    EXPECT_GT(first, second);
}

/// Opaque and transparent triangles, instances, near crossings, back faces, degenerates, out of range.
TEST(Renderer, EveryTriangleEndsInExactlyOneCounter)
{
    for (const SoupKind kind : soupKinds()) {
        const Soup soup = makeSoup(kind, 21, 45, 33, 90);
        // The same mesh with every third polygon of glass, placed twice.
        Mesh mesh = *soup.scene->meshes[0];
        mesh.materials.push_back({.name = "glass", .diffuse = {}, .opacity = 0.3f});
        std::uint64_t glass = 0;
        for (std::uint32_t p = 0; p < mesh.polygonCount(); ++p) {
            if (p % 3 != 0) continue;
            mesh.polygonMaterial[p] = MaterialId{static_cast<std::uint32_t>(mesh.materials.size() - 1)};
            glass += mesh.firstTriangle[p + 1] - mesh.firstTriangle[p];
        }
        const Affine aside = Affine::translation({0.25, 0.125, 0});
        const auto   scene = sceneOf(mesh, std::array{Affine{}, aside});
        for (const Preset& preset : presets()) {
            for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
                DrawRequest request  = requestFor(scene, soup.camera, preset.pipeline);
                request.faceCulling  = culling;
                auto          counts = countsOf(request);
                std::uint64_t sum    = 0;
                for (const auto& [name, value] : counts) {
                    if (name.starts_with("triangles_") && name != "triangles_in" && name != "triangles_clipped"
                        && name != "triangles_wide")
                        sum += value;
                    EXPECT_LT(value, std::uint64_t{1} << 40) << name << ", " << preset.name;  // nothing ran below 0
                }
                EXPECT_EQ(counts["triangles_in"], scene->triangleCount());
                EXPECT_EQ(sum, counts["triangles_in"]) << preset.name << ", " << soup.what;
                EXPECT_LE(counts["pixels_won"], counts["pixels_tested"]);
                if (preset.pipeline == Pipeline{}) {
                    EXPECT_EQ(counts["triangles_transparent"], 2 * glass) << soup.what;
                    EXPECT_EQ(counts["triangles_back_facing"] > 0,
                              culling == FaceCulling::Back && counts["triangles_back_facing"] > 0);
                    const auto fates = *referenceFates(*scene, soup.camera, culling);
                    EXPECT_LE(counts["triangles_drawn"], fates.drawn) << soup.what;
                    EXPECT_LE(counts["triangles_out_of_range"], fates.outOfRange) << soup.what;
                }
            }
        }
    }
}

TEST(Renderer, TheWorkOfEveryDepthOfTheHierarchyAddsUpToTheWorkOfTheFrame)
{
    const auto loaded = loadScene("builtin:soccer-field?count=120");
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    const auto  field = std::make_shared<const Scene>(*loaded);
    ViewRequest view  = field->views.front().view;
    view.width = 256, view.height = 192;
    const Camera  camera              = *makeCamera(view, field->bounds);
    const Soup    cut                 = makeSoup(SoupKind::NearCrossing, 3, 128, 96, 2000);
    std::uint64_t hiddenBelowTheRoots = 0;
    for (const Preset& preset : presets()) {
        for (const DrawRequest& request :
             {requestFor(field, camera, preset.pipeline), requestFor(cut.scene, cut.camera, preset.pipeline)}) {
            const Result<FrameWork> work = Renderer().count(request);
            ASSERT_TRUE(work.ok()) << work.error().text();
            std::map<std::string, std::uint64_t> counters;
            for (const NamedCount& count : work->counters) counters[count.name] = count.value;
            EXPECT_EQ(work->depths.empty(), preset.pipeline.order == Order::Submitted) << preset.name;

            DepthWork sum;
            for (std::size_t i = 0; i < work->depths.size(); ++i) {
                const DepthWork& at = work->depths[i];
                SCOPED_TRACE(std::string(preset.name) + (at.isInstanceTree ? ", instances, depth " : ", meshes, depth ")
                             + std::to_string(at.depth));
                EXPECT_EQ(at.nodesVisited, at.nodesOutside + at.nodesHidden + at.nodesEntered);
                EXPECT_LE(at.nodesDrawn, at.nodesEntered);
                if (at.depth > 0) {
                    const DepthWork& above = work->depths[i - 1];
                    EXPECT_EQ(above.depth, at.depth - 1);
                    EXPECT_LE(at.nodesVisited, TreeNode::kSlots * above.nodesEntered);
                    hiddenBelowTheRoots += at.nodesHidden;
                }
                for (auto figure : {&DepthWork::nodesVisited, &DepthWork::nodesOutside, &DepthWork::nodesHidden,
                                    &DepthWork::nodesEntered, &DepthWork::nodesDrawn, &DepthWork::trianglesOutside,
                                    &DepthWork::trianglesHiddenByNode, &DepthWork::trianglesHidden,
                                    &DepthWork::trianglesDrawn, &DepthWork::queries, &DepthWork::cellsRead})
                    sum.*figure += at.*figure;
            }
            EXPECT_EQ(sum.nodesVisited, counters["nodes_visited"]) << preset.name;
            EXPECT_EQ(sum.nodesOutside, counters["nodes_outside"]) << preset.name;
            EXPECT_EQ(sum.nodesHidden, counters["nodes_hidden"]) << preset.name;
            EXPECT_EQ(sum.nodesEntered, counters["nodes_entered"]) << preset.name;
            EXPECT_EQ(sum.nodesDrawn, counters["nodes_drawn"]) << preset.name;
            EXPECT_EQ(sum.trianglesHiddenByNode, counters["triangles_hidden_by_node"]) << preset.name;
            EXPECT_EQ(counters["nodes_visited"],
                      counters["nodes_outside"] + counters["nodes_hidden"] + counters["nodes_entered"])
                << preset.name;
            if (work->depths.empty()) continue;
            EXPECT_EQ(sum.trianglesHidden, counters["triangles_hidden"]) << preset.name;
            EXPECT_EQ(sum.trianglesDrawn, counters["triangles_drawn"]) << preset.name;
            EXPECT_EQ(sum.queries, counters["pyramid_queries"]) << preset.name;
            EXPECT_EQ(sum.cellsRead, counters["pyramid_cells_read"]) << preset.name;
        }
    }
    EXPECT_GT(hiddenBelowTheRoots, 100u);
}

TEST(Renderer, ATriangleCutByTheNearPlaneIsCountedAsClippedHoweverManyPartsAreLeft)
{
    const Camera camera = plainCamera(32, 32);
    const dvec3  front = pointAt(camera, 8, 8, 2), right = pointAt(camera, 24, 8, 2);
    const dvec3  behind{0.1, -0.2, -1}, alsoBehind{0.3, -0.2, -1};
    const auto   clipped = [&](const Corners& triangle) {
        return countsOf(requestFor(sceneOf(std::span(&triangle, 1)), camera, {}))["triangles_clipped"];
    };
    EXPECT_EQ(clipped({front, right, pointAt(camera, 16, 24, 3)}), 0u);
    EXPECT_EQ(clipped({front, right, behind}), 1u) << "two parts";
    EXPECT_EQ(clipped({front, behind, alsoBehind}), 1u) << "one part";
}

TEST(Renderer, ASampleExactlyAtFarIsKeptAndOneStepBeyondIsNot)
{
    const Camera base      = plainCamera(16, 16);  // near = 1
    const auto   coveredAt = [&](double z, double far, const Preset& preset) {
        Camera camera = base;
        camera.far    = far;
        const Corners wall{pointAt(camera, -40, -40, z), pointAt(camera, 80, -40, z), pointAt(camera, 8, 90, z)};
        const Picture picture = draw(requestFor(sceneOf(std::span(&wall, 1)), camera, preset.pipeline)).picture;
        return std::ranges::count(picture.ids.values(), 0);
    };
    for (const Preset& preset : presets()) {
        // Z = 0.25 exactly; then far planes whose float32(near / far) is that, one step above, one step below.
        EXPECT_EQ(coveredAt(4, 4, preset), 256) << preset.name;
        EXPECT_EQ(coveredAt(4, 1 / double{std::nextafter(0.25f, 1.0f)}, preset), 0) << preset.name;
        EXPECT_EQ(coveredAt(4, 1 / double{std::nextafter(0.25f, 0.0f)}, preset), 256) << preset.name;
        EXPECT_EQ(coveredAt(0x1p200, std::numeric_limits<double>::infinity(), preset), 256)
            << preset.name << ": depth 0 is kept where there is no far plane";
        EXPECT_EQ(coveredAt(0x1p200, 0x1p100, preset), 0) << preset.name;
    }
}

TEST(Renderer, EmptyScenesAndMeshesDrawBackground)
{
    Scene withEmptyMesh;
    withEmptyMesh.meshes    = {std::make_shared<Mesh>()};
    withEmptyMesh.instances = {{.mesh = {}, .toWorld = {}, .colour = {}}};
    for (Scene scene : {Scene{}, withEmptyMesh}) {
        const auto whole = std::make_shared<const Scene>(*assemble(scene));
        for (const Preset& preset : presets()) {
            const Drawn drawn = draw(requestFor(whole, plainCamera(7, 5), preset.pipeline));
            EXPECT_EQ(std::ranges::count(drawn.picture.ids.values(), -1), 35) << preset.name;
            EXPECT_EQ(std::ranges::count(drawn.colour.values(), kBackgroundColour), 35) << preset.name;
            EXPECT_EQ(countsOf(requestFor(whole, plainCamera(7, 5), preset.pipeline))["triangles_in"], 0u);
        }
    }
}

TEST(Renderer, FlattenedMirroredAndHugeInstancesDrawWhatTheReferenceDraws)
{
    const Camera camera = plainCamera(48, 40);
    Mesh         mesh;
    for (const dvec3& p :
         {pointAt(camera, 10, 5, 3), pointAt(camera, 40, 8, 4), pointAt(camera, 20, 35, 5), pointAt(camera, 30, 30, 3)})
        mesh.positions.push_back(p);
    addFan(mesh, std::array<std::uint32_t, 3>{0, 2, 1});  // counter-clockwise to the viewer: fronts, mirrored or not
    addFan(mesh, std::array<std::uint32_t, 3>{1, 2, 3});
    Affine mirrored, flat, point, huge, line;
    mirrored.rows[0][0] = -1;
    flat.rows[2]        = {0, 0, 0, 4};
    point.rows          = {{{0, 0, 0, 0.1}, {0, 0, 0, 0.1}, {0, 0, 0, 4}}};
    huge.rows           = {{{1e200, 0, 0, 0}, {0, 1e200, 0, 0}, {0, 0, 1, 0}}};
    line.rows[1]        = line.rows[0];
    Affine beyond;
    beyond.rows[0][0] = 1e300;
    const auto scene  = sceneOf(mesh, std::array{mirrored, flat, point, huge, line, beyond});
    for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back}) {
        const Picture reference = *referencePicture(*scene, camera, culling);
        EXPECT_GT(std::ranges::count_if(reference.ids.values(), [](std::int64_t id) { return id >= 0; }), 0);
        for (const Preset& preset : presets()) {
            if (preset.claim == Claim::Approximate) continue;
            DrawRequest request = requestFor(scene, camera, preset.pipeline);
            request.faceCulling = culling;
            EXPECT_EQ(draw(request).picture, reference) << preset.name;
        }
    }
}

/// 2^32 - 2 triangles: 4,095 instances of a mesh of 2^20, all but the last far behind the eye, and one smaller mesh.
TEST(Renderer, TheLastTriangleThatAnIdCanNameIsDrawn)
{
    const Camera            camera = plainCamera(16, 16);
    constexpr std::uint32_t kMany  = 1 << 20;
    std::vector<Corners>    corners(
           1, {pointAt(camera, -40, -40, 4), pointAt(camera, 80, -40, 4), pointAt(camera, 8, 90, 4)});
    const std::shared_ptr<const Mesh> one    = sceneOf(corners)->meshes[0];
    const auto                        meshOf = [&](std::uint32_t count) {  // the same triangle `count` times
        auto mesh = std::make_shared<Mesh>(*one);
        mesh->triangles.resize(count, one->triangles[0]);
        mesh->trianglePolygon.resize(count, PolygonId{0});
        mesh->firstTriangle.back() = count;
        return mesh;
    };
    Scene parts;
    parts.meshes        = {meshOf(kMany), meshOf(kMany - 3), one};
    const Affine behind = Affine::translation({0, 0, -1000});
    for (int i = 0; i < 4095; ++i) parts.instances.push_back({.mesh = MeshId{0}, .toWorld = behind, .colour = {}});
    parts.instances.push_back({.mesh = MeshId{1}, .toWorld = behind, .colour = {}});
    parts.instances.push_back({.mesh = MeshId{2}, .toWorld = {}, .colour = {}});
    const auto scene = std::make_shared<const Scene>(*assemble(std::move(parts)));
    ASSERT_EQ(scene->triangleCount(), kMaxTriangles);
    const auto prepared = std::make_shared<PreparedScene>(scene);
    for (const Preset& preset : presets()) {
        if (preset.pipeline.order != Order::Submitted) continue;  // trees take longer than this is worth
        DrawRequest request;
        request.scene     = prepared;
        request.camera    = camera;
        request.pipeline  = preset.pipeline;
        const Drawn drawn = draw(request);
        EXPECT_EQ(std::ranges::count(drawn.picture.ids.values(), static_cast<std::int64_t>(kMaxTriangles) - 1), 256)
            << preset.name;
        EXPECT_EQ(std::ranges::count(drawn.colour.values(), colourOf(*scene, InstanceId{4096}, 0)), 256) << preset.name;
    }
}

}  // namespace
}  // namespace zscope::tests
