// The method that draws whole faces, on faces of every sort: seeded polygons of many corners, concave, crossing
// themselves, not plane, cut by the near plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "core/geometry/face_batches.h"
#include "core/measure/face_figures.h"
#include "core/scene/generators/icosphere.h"
#include "core/scene/generators/random.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

enum class Bend { Plane, Bent, AcrossNear };

struct Polygons {
    std::shared_ptr<const PreparedScene> scene;
    Camera                               camera;
    std::string                          what;
};

using Places = std::vector<std::array<double, 2>>;  // pixels

/// Star-shaped about a centre, or corners anywhere, which mostly cross themselves; now and then a corner repeated or in
/// the middle of two others, or all corners on the grid of pixel centres.
Places anyOutline(Random& random, int width, int height)
{
    const auto   corners = 3 + random.below(random.below(4) == 0 ? 40 : 7);
    const double x = random.between(-0.1, 1.1) * width, y = random.between(-0.1, 1.1) * height;
    const double reach    = random.between(0.05, 0.8) * std::max(width, height);
    const bool   anywhere = random.below(5) == 0, onGrid = random.below(4) == 0, clockwise = random.below(2) == 0;
    Places       places;
    for (std::uint64_t i = 0; i < corners; ++i) {
        const double angle =
            2 * std::numbers::pi * (static_cast<double>(i) + 0.4 * random.unit()) / static_cast<double>(corners);
        const double far = reach * random.between(0.15, 1);
        places.push_back(anywhere
                             ? std::array{x + reach * random.between(-1, 1), y + reach * random.between(-1, 1)}
                             : std::array{x + far * std::cos(angle), y + (clockwise ? far : -far) * std::sin(angle)});
        if (onGrid) places.back() = {std::floor(places.back()[0]) + 0.5, std::floor(places.back()[1]) + 0.5};
        if (random.below(12) == 0) places.push_back(places.back());
        if (i > 0 && random.below(12) == 0) {
            const auto &a = places[places.size() - 2], b = places.back();
            places.insert(places.end() - 1, {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2});
        }
    }
    return places;
}

/// Each face in a slab of depth of its own, the slabs in no order of the ids; or across the near plane, in no slab at
/// all.
Polygons makePolygons(std::uint64_t seed, int count, Bend bend, int width, int height)
{
    Random       random(seed * 977 + static_cast<std::uint64_t>(bend));
    const Camera camera = plainCamera(width, height);
    Mesh         mesh;
    for (int f = 0; f < count; ++f) {
        const Places               places = anyOutline(random, width, height);
        const double               near = 2 + 0.5 * ((f * 7) % count), thick = 0.4;
        const double               leanX = random.between(-1, 1), leanY = random.between(-1, 1);
        std::vector<std::uint32_t> outline;
        for (const auto& [x, y] : places) {
            // 1 / z is affine over the picture where a face is plane; the slab holds all of it.
            const double across  = std::clamp(0.5 + 0.1 * (leanX * x / width + leanY * y / height), 0.2, 0.8);
            double       inverse = 1 / near + (1 / (near + thick) - 1 / near) * across;
            if (bend == Bend::Bent) inverse = 1 / (near + thick * random.unit());
            const double z       = bend == Bend::AcrossNear ? random.between(-1.5, 4) : 1 / inverse;
            const bool   repeats = !outline.empty() && std::array{x, y} == places[outline.size() - 1];
            if (repeats) {
                outline.push_back(outline.back());
                continue;
            }
            outline.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(bend == Bend::AcrossNear && z < 0.5
                                         ? dvec3{(x / width - 0.5) * 4, (y / height - 0.5) * 4, z}
                                         : pointAt(camera, x, y, z));
        }
        mesh.addPolygon(outline);
    }
    const auto scene = sceneOf(std::move(mesh), std::array{Affine{}});
    return {std::make_shared<const PreparedScene>(scene), camera,
            "polygons, seed " + std::to_string(seed) + ", bend " + std::to_string(static_cast<int>(bend))};
}

ErrorFigures figuresByFace(const Polygons& polygons, FaceCulling culling, int threads)
{
    const Scene& scene     = polygons.scene->scene();
    const auto   reference = referencePicture(scene, polygons.camera, culling);
    DrawRequest  request{.scene       = polygons.scene,
                         .camera      = polygons.camera,
                         .faceCulling = culling,
                         .pipeline    = findPreset("interval-polygon")->pipeline,
                         .shade       = false};
    request.threads = threads;
    Renderer renderer;
    Frame    frame;
    EXPECT_TRUE(renderer.draw(request, frame).ok());
    const auto figures = compareByFace(scene, polygons.camera, culling, *reference, pictureOf(frame.visible));
    EXPECT_TRUE(figures.ok());
    return *figures;
}

constexpr std::array kCullings{FaceCulling::None, FaceCulling::Back};

TEST(FaceAgreement, AFaceAloneCoversExactlyWhatItsTrianglesCover)
{
    std::uint64_t covered = 0;
    for (const Bend bend : {Bend::Plane, Bend::Bent, Bend::AcrossNear})
        for (std::uint64_t seed = 0; seed < shareOf(300); ++seed) {
            const Polygons polygons = makePolygons(seed, 1, bend, 64, 64);
            for (const FaceCulling culling : kCullings) {
                const ErrorFigures figures = figuresByFace(polygons, culling, static_cast<int>(1 + seed % 3));
                ASSERT_EQ(figures.wrongPixels(), 0u) << polygons.what << ", culling " << static_cast<int>(culling);
                covered += figures.covered;
            }
        }
    EXPECT_GT(covered, shareOf(300) * 500);
}

TEST(FaceAgreement, AFaceWalkedThereAndBackDrawsNothing)
{
    const Camera camera = plainCamera(32, 32);
    Mesh         mesh;
    for (const auto& [x, y, z] : {std::array{4.0, 4.0, 2.0}, {4.0, 28.0, 3.0}, {28.0, 20.0, 2.5}})
        mesh.positions.push_back(pointAt(camera, x, y, z));
    mesh.addPolygon(std::array<std::uint32_t, 4>{0, 1, 2, 1});
    mesh.addPolygon(std::array<std::uint32_t, 6>{0, 1, 2, 0, 2, 1});
    for (const FaceCulling culling : kCullings) {
        const Polygons     polygons{std::make_shared<const PreparedScene>(sceneOf(mesh, std::array{Affine{}})), camera,
                                "there and back"};
        const ErrorFigures figures = figuresByFace(polygons, culling, 1);
        EXPECT_EQ(figures.wrongPixels(), 0u);
    }
}

/// A ramp that winds one and a half times round the line of sight, ever farther away, so that its second turn is seen
/// on top of its first: the outline goes twice round a pixel, which the even-odd rule would leave empty.
TEST(FaceAgreement, AFaceSeenTwiceOnOnePixelIsStillWhole)
{
    const Camera               camera = plainCamera(64, 64);
    constexpr int              kSteps = 60;
    Mesh                       mesh;
    std::vector<std::uint32_t> outline;
    for (int i = 0; i <= 2 * kSteps + 1; ++i) {
        const bool   isOuter = i <= kSteps;
        const double angle   = 3 * std::numbers::pi * (isOuter ? i : 2 * kSteps + 1 - i) / kSteps;
        const double reach   = isOuter ? 26.3 : 16.7;
        outline.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(pointAt(camera, 32 + reach * std::cos(angle), 32 - reach * std::sin(angle),
                                         2 * std::pow(2.2, angle / (2 * std::numbers::pi))));
    }
    ASSERT_TRUE(mesh.addPolygon(outline)) << "it does not cross itself";
    const Polygons polygons{std::make_shared<const PreparedScene>(sceneOf(mesh, std::array{Affine{}})), camera,
                            "a ramp"};
    int            twice = 0;
    for (int x = 0; x < 64; ++x) {
        const auto covering = coveringTriangles(polygons.scene->scene(), camera, FaceCulling::None, {x, 20});
        ASSERT_TRUE(covering.ok());
        twice += covering->size() == 2;
    }
    EXPECT_GT(twice, 5);
    const auto work = Renderer().count({.scene    = polygons.scene,
                                        .camera   = camera,
                                        .pipeline = findPreset("interval-polygon")->pipeline,
                                        .shade    = false});
    ASSERT_TRUE(work.ok());
    for (const NamedCount& count : work->counters) {
        if (count.name == "polygons_by_outline") {
            EXPECT_EQ(count.value, 1u);
        }
    }
    for (const FaceCulling culling : kCullings) {
        const ErrorFigures figures = figuresByFace(polygons, culling, 2);
        EXPECT_EQ(figures.wrongPixels(), 0u);
        EXPECT_GT(figures.covered, 1000u);
    }
}

TEST(FaceAgreement, FacesInSlabsOfTheirOwnAreSeenWhereTheirTrianglesAreSeen)
{
    for (const Bend bend : {Bend::Plane, Bend::Bent})
        for (std::uint64_t seed = 0; seed < shareOf(60); ++seed) {
            const Polygons polygons = makePolygons(1000 + seed, 40, bend, 128, 64);
            for (const FaceCulling culling : kCullings) {
                const ErrorFigures figures = figuresByFace(polygons, culling, static_cast<int>(1 + seed % 3));
                ASSERT_EQ(figures.wrongPixels(), 0u) << polygons.what << ", culling " << static_cast<int>(culling);
                EXPECT_GT(figures.covered, 1000u);
            }
        }
}

/// Meshes whose faces are triangles all are drawn batch by batch, next to others that are drawn face by face.
TEST(FaceAgreement, MeshesOfTrianglesStandNextToMeshesOfPolygons)
{
    const auto ball = makeIcosphere({.frequency = 12, .bumps = 0.1});
    for (std::uint64_t seed = 0; seed < shareOf(40); ++seed) {
        const Polygons polygons = makePolygons(4000 + seed, 10, Bend::Plane, 128, 64);
        const auto     placed   = [&](double x, double z, double radius) {
            const dvec3 at = pointAt(polygons.camera, x, 30, z);
            return Instance{.mesh    = MeshId{1},
                                  .toWorld = {{{{radius, 0, 0, at.x}, {0, radius, 0, at.y}, {0, 0, radius, at.z}}}}};
        };
        Scene parts;
        parts.meshes    = {polygons.scene->scene().meshes[0], ball};
        parts.instances = {placed(30.2, 1.5, 0.3), Instance{.mesh = MeshId{0}, .toWorld = {}}, placed(70.4, 12, 4.5),
                           placed(90.9, 1.6, 0.45)};
        auto scene      = assemble(std::move(parts));
        ASSERT_TRUE(scene.ok());
        const Polygons all{std::make_shared<const PreparedScene>(std::make_shared<const Scene>(*std::move(scene))),
                           polygons.camera, "balls among " + polygons.what};
        ASSERT_FALSE(facesOf(*all.scene).of(MeshId{0}).areTriangles());
        ASSERT_TRUE(facesOf(*all.scene).of(MeshId{1}).areTriangles());
        for (const FaceCulling culling : kCullings) {
            const ErrorFigures figures = figuresByFace(all, culling, static_cast<int>(1 + seed % 3));
            ASSERT_EQ(figures.wrongPixels(), 0u) << all.what << ", culling " << static_cast<int>(culling);
            EXPECT_GT(figures.covered, 1000u);
        }
    }
}

TEST(FaceAgreement, OnPlaneFacesDepthIsWithinOneStep)
{
    std::uint64_t same = 0;
    for (std::uint64_t seed = 0; seed < shareOf(60); ++seed) {
        const Polygons     polygons = makePolygons(2000 + seed, 12, Bend::Plane, 128, 64);
        const ErrorFigures figures  = figuresByFace(polygons, FaceCulling::None, 1);
        EXPECT_LE(figures.maxDepthSteps, 1u) << polygons.what;
        same += figures.exactShare > 0.9;
    }
    EXPECT_GE(same, shareOf(60) * 9 / 10);
}

TEST(FaceAgreement, EveryPresetDrawsPolygonsThatCrossTheNearPlaneAndEachOther)
{
    const auto targets = targetsTested();
    for (std::uint64_t seed = 0; seed < shareOf(60); ++seed) {
        const Polygons polygons = makePolygons(3000 + seed, 30, Bend::AcrossNear, 96, 64);
        EXPECT_GT(
            expectAgreement(polygons.scene, polygons.camera, kCullings[seed % 2], polygons.what,
                            {.threads = {static_cast<int>(1 + seed % 3)}, .targets = {targets[seed % targets.size()]}}),
            100u);
    }
}

}  // namespace
}  // namespace zscope::tests
