// One picture for each approximation of numbers: whatever the order, culling, pyramid or scan, with and without
// shortcuts, by one thread or two, the ids and the depths are those of the z-buffer of the same approximation.
//
// Numbers    snap, vertices, depth-numbers=float32, depth-format, near; the others may depend on the method
// Faces      interval-polygon draws faces as they were read: of faces that are triangles the same picture, of others
//            the same pixels
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "core/frame/renderer.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

struct AxisWord {
    std::string_view axis, word;
};
using Choices = std::vector<AxisWord>;

const std::vector<Choices>& approximations()
{
    static const std::vector<Choices> kAll{
        {{"snap", "4-bits"}},
        {{"snap", "12-bits"}},
        {{"vertices", "float32"}},
        {{"depth-numbers", "float32"}},
        {{"depth-format", "float32-standard"}},
        {{"depth-format", "fixed-24"}},
        {{"depth-format", "fixed-16"}},
        {{"near", "drop"}},
        {{"snap", "4-bits"}, {"vertices", "float32"}, {"depth-numbers", "float32"}, {"depth-format", "fixed-16"}}};
    return kAll;
}

/// The presets, and what they leave out of what can be chosen about culling.
const std::vector<Pipeline>& methodsTested()
{
    static const std::vector<Pipeline> kAll = [] {
        std::vector<Pipeline> all;
        for (const Preset& preset : presets())
            if (preset.pipeline.chooser != Chooser::Measured && preset.claim != Claim::Approximate)
                all.push_back(preset.pipeline);
        const auto with = [&all](std::string_view preset, const Choices& choices) {
            Pipeline pipeline = findPreset(preset)->pipeline;
            for (const AxisWord& choice : choices) pipeline = withChoice(pipeline, choice.axis, choice.word).value();
            all.push_back(pipeline);
        };
        with("quadtree", {{"upkeep", "pushed"}, {"query", "triangle"}});
        with("quadtree", {{"depth", "zcull"}});
        with("hzb-octree", {{"upkeep", "pushed-farthest"}, {"query", "triangle"}});
        with("hzb-octree", {{"upkeep", "masked"}});
        with("hzb-octree", {{"scan", "edge-walk"}, {"cull", "nodes"}});
        with("hzb-bvh", {{"upkeep", "masked"}, {"query", "triangle"}});
        with("hzb-bvh", {{"depth", "zcull"}});
        with("hzb-bvh", {{"depth", "early"}});
        return all;
    }();
    return kAll;
}

std::optional<Pipeline> approximated(Pipeline pipeline, const Choices& choices)
{
    for (const AxisWord& choice : choices) {
        const auto changed = withChoice(pipeline, choice.axis, choice.word);
        if (!changed) return std::nullopt;
        pipeline = *changed;
    }
    if (explainInvalid(pipeline)) return std::nullopt;
    return pipeline;
}

struct Difference {
    int         pixels = 0;
    std::string first;
};

/// `byCover`: only whether a pixel shows anything is compared.
Difference difference(const VisibilityBuffer& a, const VisibilityBuffer& b, bool byCover)
{
    Difference all;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const auto  one = a.idAt(x, y), other = b.idAt(x, y);
            const float here = a.storedAt(x, y), there = b.storedAt(x, y);
            const bool  same = byCover ? (one < 0) == (other < 0)
                                       : one == other && (one < 0 || std::memcmp(&here, &there, sizeof here) == 0);
            if (same || all.pixels++ > 0) continue;
            all.first = std::to_string(x) + ", " + std::to_string(y) + ": triangles " + std::to_string(one) + " and "
                        + std::to_string(other) + ", depths " + std::to_string(here) + " and " + std::to_string(there);
        }
    return all;
}

bool areTriangles(const Scene& scene)
{
    for (const auto& mesh : scene.meshes)
        if (mesh->triangles.size() != mesh->polygonCount()) return false;
    return true;
}

void draw(const DrawRequest& request, Frame& frame)
{
    Renderer renderer;
    for (int i = 0; i < (request.pipeline.coherence == Coherence::None ? 1 : 2); ++i) {
        const auto report = renderer.draw(request, frame);
        ASSERT_TRUE(report.ok()) << nameOf(request.pipeline) << ": " << report.error().text();
    }
}

/// The number of pixels that show a triangle, over all approximations.
int expectOnePicture(const std::shared_ptr<const Scene>& loaded, const Camera& camera, const std::string& what,
                     std::vector<FaceCulling> cullings = {FaceCulling::None, FaceCulling::Back},
                     std::vector<int>         threads  = {1, 2})
{
    const auto scene    = std::make_shared<const PreparedScene>(loaded);
    const bool isByFace = !areTriangles(*loaded);
    int        shown    = 0;
    Frame      frame, expected;
    const auto describe = [&](const DrawRequest& request) {
        return what + ", " + nameOf(request.pipeline) + ", back faces "
               + (request.faceCulling == FaceCulling::Back ? "culled" : "drawn") + ", shortcuts "
               + (request.shortcuts.isAll() ? "all" : "none") + ", " + std::to_string(request.threads) + " threads";
    };
    for (const Choices& choices : approximations())
        for (const FaceCulling culling : cullings) {
            DrawRequest request{.scene       = scene,
                                .camera      = camera,
                                .faceCulling = culling,
                                .pipeline    = *approximated(findPreset("zbuffer")->pipeline, choices),
                                .threads     = 1,
                                .shade       = false};
            draw(request, expected);
            for (int y = 0; y < camera.height; ++y)
                for (int x = 0; x < camera.width; ++x) shown += expected.visible.idAt(x, y) >= 0;
            for (const Pipeline& method : methodsTested()) {
                const auto pipeline = approximated(method, choices);
                if (!pipeline) continue;
                request.pipeline   = *pipeline;
                request.shade      = shadesFragments(pipeline->depth);
                const bool byCover = isByFace && drawsFaces(*pipeline);
                for (const int count : threads)
                    for (const ShortcutSet shortcuts : {ShortcutSet::all(), ShortcutSet()}) {
                        if (!shortcuts.isEmpty() && !hasFastText(*pipeline)) continue;
                        request.threads   = count;
                        request.shortcuts = shortcuts;
                        draw(request, frame);
                        const Difference found = difference(expected.visible, frame.visible, byCover);
                        EXPECT_EQ(found.pixels, 0) << describe(request) << ": " << found.first;
                    }
            }
        }
    return shown;
}

/// The same polygons in the same order, each of them a mesh and an instance of its own: a node for every polygon.
std::shared_ptr<const Scene> apart(const Scene& whole)
{
    Scene parts;
    parts.views = whole.views;
    for (const Instance& instance : whole.instances) {
        const Mesh& mesh = *whole.meshes[instance.mesh.value];
        for (std::size_t f = 0; f < mesh.polygonCount(); ++f) {
            Mesh                       one;
            std::vector<std::uint32_t> outline;
            for (std::uint32_t c = mesh.firstCorner[f]; c < mesh.firstCorner[f + 1]; ++c) {
                outline.push_back(static_cast<std::uint32_t>(one.positions.size()));
                one.positions.push_back(mesh.positions[mesh.corners[c]]);
            }
            addFan(one, outline);
            parts.instances.push_back(
                {.mesh = MeshId{static_cast<std::uint32_t>(parts.meshes.size())}, .toWorld = instance.toWorld});
            parts.meshes.push_back(std::make_shared<const Mesh>(std::move(one)));
        }
    }
    return std::make_shared<const Scene>(assemble(std::move(parts)).value());
}

/// A rectangle at distance z: pixels [x0, x1] x [y0, y1] of the camera, as two triangles.
void addRectangle(std::vector<Corners>& triangles, const Camera& camera, double x0, double y0, double x1, double y1,
                  double z)
{
    const auto at = [&](double x, double y) { return pointAt(camera, x, y, z); };
    triangles.push_back({at(x0, y0), at(x0, y1), at(x1, y1)});
    triangles.push_back({at(x0, y0), at(x1, y1), at(x1, y0)});
}

class OnePicture : public testing::TestWithParam<SoupKind> {};

TEST_P(OnePicture, OfASoup)
{
    int shown = 0;
    for (std::uint64_t seed = 1; seed <= shareOf(3); ++seed) {
        const Soup soup = makeSoup(GetParam(), seed, 61, 47);
        shown += expectOnePicture(seed == 1 ? soup.scene : apart(*soup.scene), soup.camera, soup.what,
                                  {seed % 2 ? FaceCulling::None : FaceCulling::Back}, {seed == 1 ? 2 : 1});
        if (HasFailure()) return;
    }
    EXPECT_GT(shown, 0);
}

INSTANTIATE_TEST_SUITE_P(Soups, OnePicture, testing::ValuesIn(soupKinds().begin(), soupKinds().end()),
                         [](const auto& kind) { return std::to_string(static_cast<int>(kind.param)); });

TEST(OnePictureOf, GeneratedScenes)
{
    int culling = 0;
    for (const char* word : {"builtin:teapot?tessellation=4", "builtin:cutouts", "builtin:reliefs",
                             "builtin:layers?count=6", "builtin:soccer-ball", "builtin:wall-and-city?blocks=4"}) {
        const auto loaded = std::make_shared<const Scene>(loadScene(word).value());
        expectOnePicture(loaded, cameraFor(*loaded, 120, 75), word,
                         {++culling % 2 ? FaceCulling::Back : FaceCulling::None}, {2});
    }
}

/// Where only snapping to 1/16 pixel brings a rectangle onto a column or a line of pixel centres, beside a nearer one
/// that hides all the rest of it.
TEST(OnePictureOf, RectanglesThatSnappingMovesOntoPixelCentres)
{
    const Camera camera = plainCamera(64, 64);
    const double slip   = 1.0 / 64;
    for (int side = 0; side < 4; ++side) {
        std::vector<Corners> triangles;
        const double         first = 20.5 + slip, last = 40.5 + slip;
        if (side == 0) {  // column 20
            addRectangle(triangles, camera, 21, 5, 60, 60, 2);
            addRectangle(triangles, camera, first, 5, 50, 55, 4);
        } else if (side == 1) {  // line 20
            addRectangle(triangles, camera, 5, 21, 60, 60, 2);
            addRectangle(triangles, camera, 5, first, 55, 50, 4);
        } else if (side == 2) {  // column 41 and line 41 stay free
            addRectangle(triangles, camera, 5, 5, 41, 60, 2);
            addRectangle(triangles, camera, 10, 5, last + 1, 55, 4);
        } else {
            addRectangle(triangles, camera, 5, 5, 60, 41, 2);
            addRectangle(triangles, camera, 5, 10, 55, last + 1, 4);
        }
        EXPECT_GT(expectOnePicture(apart(*sceneOf(triangles)), camera, "side " + std::to_string(side)), 0);
    }
}

/// Rectangles that reach the outermost pixel centres, or miss them, by less than what may be displaced.
TEST(OnePictureOf, RectanglesAtTheBorder)
{
    const Camera camera = plainCamera(32, 32);
    for (const double slip : {1.0 / 64, 1.0 / 40, -1.0 / 64, 1e-5, -1e-5}) {
        std::vector<Corners> triangles;
        addRectangle(triangles, camera, -20, -5, 0.5 + slip, 40, 4);
        addRectangle(triangles, camera, 31.5 + slip, -5, 50, 40, 4);
        addRectangle(triangles, camera, -5, -20, 40, 0.5 + slip, 4);
        addRectangle(triangles, camera, -5, 31.5 + slip, 40, 50, 4);
        addRectangle(triangles, camera, -5, 15.5 + slip, 40, 16.5 + slip, 4);  // at the border of two stripes
        expectOnePicture(apart(*sceneOf(triangles)), camera, "slip " + std::to_string(slip));
    }
}

/// Far from the origin float32 moves vertices by pixels.
TEST(OnePictureOf, BigCoordinates)
{
    for (const double away : {1e3, 1e4, 1e5, 1e6}) {
        Camera camera = plainCamera(48, 40);
        camera.eye    = dvec3{away, -0.7 * away, 0.3 * away} + dvec3{0.37, 0.21, 0.13};
        std::vector<Corners> triangles;
        for (int i = 0; i < 12; ++i) addRectangle(triangles, camera, 4 * i, 0, 4 * i + 3.6, 40, 3 + 0.2 * i);
        for (int i = 0; i < 10; ++i) addRectangle(triangles, camera, 0, 4 * i, 48, 4 * i + 3.6, 5 + 0.1 * i);
        addRectangle(triangles, camera, -3, -3, 0.4, 43, 2);
        addRectangle(triangles, camera, 47.6, -3, 52, 43, 2);
        EXPECT_GT(expectOnePicture(apart(*sceneOf(triangles)), camera, "away " + std::to_string(away)), 0);
    }
}

/// A mesh far from its own origin that its matrix brings back: in the world nothing is large. Narrow strips stand
/// behind the edges of near ones, so that float32 moves some of them into view.
TEST(OnePictureOf, InstancesThatBringAFarMeshBack)
{
    for (const double away : {1e4, 1e5, 1e6}) {
        const Camera camera = plainCamera(48, 40);
        Scene        parts;
        const auto   add = [&](double x0, double x1, double z, const dvec3& offset) {
            Mesh                       mesh;
            std::vector<std::uint32_t> outline;
            for (const auto& [x, y] : {std::pair{x0, 0.0}, {x0, 40.0}, {x1, 40.0}, {x1, 0.0}}) {
                outline.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
                mesh.positions.push_back(pointAt(camera, x, y, z) + offset);
            }
            addFan(mesh, std::array{outline[0], outline[1], outline[2]});
            addFan(mesh, std::array{outline[0], outline[2], outline[3]});
            parts.instances.push_back({.mesh    = MeshId{static_cast<std::uint32_t>(parts.meshes.size())},
                                         .toWorld = Affine::translation(-offset)});
            parts.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
        };
        for (int i = 0; i < 6; ++i) {
            add(8 * i, 8 * i + 6, 2, {0, 0, 0});
            const dvec3 offset{away * (1 + 0.013 * i), 0.6 * away, -0.8 * away};
            add(8 * i + 0.3, 8 * i + 5.7, 3 + 0.2 * i, offset);
            add(8 * i - 0.49, 8 * i + 5.9, 5 + 0.1 * i, offset * 1.07);
        }
        const auto scene = std::make_shared<const Scene>(assemble(std::move(parts)).value());
        EXPECT_GT(expectOnePicture(scene, camera, "away " + std::to_string(away)), 0);
    }
}

/// Triangles with corners thousands of pixels away, inside the guard band: the most bits that an edge value may have.
TEST(OnePictureOf, LargeTriangles)
{
    const Camera  camera = plainCamera(48, 40);
    std::uint64_t state  = 1;
    const auto    random = [&state] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 11) * 0x1p-53;
    };
    std::vector<Corners> triangles;
    for (int i = 0; i < 40; ++i) {
        const auto corner = [&] {
            const double reach = std::ldexp(1.0, 6 + i % 11);
            const double x = 24 + (2 * random() - 1) * reach, y = 20 + (2 * random() - 1) * reach;
            return pointAt(camera, x, y, 2 + 8 * random());
        };
        const Corners one{corner(), corner(), corner()};
        triangles.push_back(one);
        triangles.push_back({one[0], one[2], corner()});
    }
    EXPECT_GT(expectOnePicture(sceneOf(triangles), camera, "large triangles", {FaceCulling::None}), 0);
    // Edges through pixel centres, or past them by the least that 12 bits can tell.
    triangles.clear();
    for (int i = 0; i < 30; ++i) {
        // of many bits; where the step is 0, the edge goes through the centre of pixel (20, line)
        const double dx = std::floor(random() * 0x1.dp27) / 4096, dy = std::floor(random() * 0x1.dp27) / 4096,
                     step = (i % 3 - 1) / 4096.0;
        const double line = 4.5 + i;
        const auto   at   = [&](double x, double y) { return pointAt(camera, x, y, 2 + i); };
        triangles.push_back({at(20.5 - dx, line - dy), at(20.5 + dx, line + dy + step), at(20.5 + dy, line - dx)});
    }
    EXPECT_GT(expectOnePicture(sceneOf(triangles), camera, "edges through pixel centres", {FaceCulling::Back}), 0);
}

/// In units so small or so large that float32 underflows or overflows.
TEST(OnePictureOf, ScalesAtTheEndsOfFloat32)
{
    for (const double scale : {1e-42, 1e-36, 1e-20, 1e18, 1e30, 1e37, 1e60}) {
        Camera camera = plainCamera(32, 32);
        camera.near   = scale;
        std::vector<Corners> triangles;
        for (int i = 0; i < 8; ++i) {
            addRectangle(triangles, camera, 4 * i, 0, 4 * i + 3.6, 32, scale * (3 + 0.2 * i));
            addRectangle(triangles, camera, 0, 4 * i, 32, 4 * i + 3.6, scale * (5 - 0.2 * i));
        }
        expectOnePicture(apart(*sceneOf(triangles)), camera, "scale " + std::to_string(std::log10(scale)));
    }
}

/// Distances about the near plane, for distances of it that float32 rounds up and down.
TEST(OnePictureOf, ObjectsAtTheNearPlane)
{
    int seen = 0;
    for (const double near : {0.1, 0.3, 0.7, 1.0, 1.0 + 0x1p-26, 1.0 - 0x1p-27}) {
        Camera camera = plainCamera(40, 40);
        camera.near   = near;
        std::vector<Corners> triangles;
        int                  i = 0;
        for (const double times :
             {1 + 1e-3, 1 + 1e-6, 1 + 1e-7, 1 + 4e-8, 1 + 1e-8, 1.0, 1 - 1e-8, 1 - 4e-8, 1 - 1e-6}) {
            addRectangle(triangles, camera, 4 * i, 0, 4 * i + 3, 40, near * times);
            ++i;
        }
        for (int line = 0; line < 10; ++line) addRectangle(triangles, camera, 0, 4 * line, 40, 4 * line + 3, 2 * near);
        // tilted, so that one side may lie before the plane
        const auto at = [&](double x, double y, double z) { return pointAt(camera, x, y, z * near); };
        triangles.push_back({at(0, 0, 1 + 1e-7), at(40, 3, 1 - 1e-7), at(20, 40, 1.5)});
        triangles.push_back({at(40, 0, 1 + 1e-8), at(0, 30, 1), at(20, 40, 1 + 1e-7)});
        seen += expectOnePicture(apart(*sceneOf(triangles)), camera, "near " + std::to_string(near));
    }
    EXPECT_GT(seen, 0);
}

}  // namespace
}  // namespace zscope::tests
