// What is said of patches before their triangles are looked at, against every triangle, in every instruction set that
// the machine has.
#include <vector>

#include "core/geometry/batches.h"
#include "core/geometry/placed_view.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/core/patches_test.cpp"
#include <hwy/foreach_target.h>  // includes this file once per target

#include "core/fast/patches/patches-inl.h"

namespace zscope {
#ifndef ZSCOPE_PATCHES_SAID
#define ZSCOPE_PATCHES_SAID
struct Said {
    PatchBits             towards = 0;
    std::uint64_t         groups  = 0;  // of those
    PatchBits             patches = 0;
    PixelBox              pixels;
    float                 nearest = 0;
    std::vector<PixelBox> boxes;     // per patch
    std::vector<float>    nearests;  // likewise
};
#endif
}  // namespace zscope

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

Said ask(const MeshBatches& mesh, const Batch& batch, const BehindQuestion* behind, const PlacedView& view,
         const Projection& projection, const PixelBox& region)
{
    Said said;
    said.towards = behind ? towardsEye(mesh, batch, *behind) : batch.patches();
    said.groups  = vertexGroupsOf(mesh, batch, said.towards);
    const PatchReach reach(mesh, batch, said.towards, view, projection, region);
    said.patches = reach.patches(), said.pixels = reach.pixels(), said.nearest = reach.nearest();
    for (std::size_t patch = 0; patch < batch.patchCount(); ++patch)
        said.boxes.push_back(reach.pixelsOf(patch)), said.nearests.push_back(reach.nearestOf(patch));
    return said;
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <hwy/targets.h>
#include <glm/geometric.hpp>

#include "core/geometry/rules.h"
#include "core/geometry/screen_triangle.h"
#include "core/scene/generators/random.h"
#include "core/scene/load.h"

namespace zscope {

HWY_EXPORT(ask);

namespace {

constexpr PixelBox kRegion{100, 40, 900, 500};

/// As NormalCone has it.
NormalCone coneOf(const MeshBatches& mesh, const Batch& batch, std::size_t patch)
{
    const PatchBlock& block = mesh.patchesOf(batch)[patch / PatchBlock::kPatches];
    const std::size_t lane  = patch % PatchBlock::kPatches;
    const auto        at    = [lane](const std::array<PatchBlock::Column, 3>& columns) {
        return dvec3{columns[0][lane], columns[1][lane], columns[2][lane]};
    };
    return {at(block.axis), at(block.apex), block.cosine[lane], block.sine[lane], block.altitude[lane]};
}

/// A mesh along `word`, in patches, with room for as many triangles in a batch as there may be.
MeshBatches patched(const std::string& word)
{
    const Result<Scene>        scene = loadScene("builtin:" + word);
    const Mesh&                mesh  = scene.value().meshOf(InstanceId{0});
    std::vector<std::uint32_t> all(mesh.triangles.size());
    for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
    return makeBatches(mesh, inPatches(mesh, all), Surfaces::Opaque, kWholeLeaf);
}

Camera anyCamera(Random& random, double away)
{
    ViewRequest request;
    request.eye         = random.rotation()({0, 0, away});
    request.target      = random.between(dvec3{-1, -1, -1}, dvec3{1, 1, 1});
    request.up          = random.rotation()({0, 1, 0});
    request.verticalFov = random.between(10, 60);
    request.width = 1000, request.height = 600;
    request.near = 0.3, request.far = 1e4;
    return makeCamera(request, Bounds{{-1, -1, -1}, {1, 1, 1}}).value();
}

Affine anyPlacement(Random& random, bool mirrors)
{
    Affine       place  = random.rotation();
    const double mirror = mirrors ? -1 : 1;
    for (auto& row : place.rows) {
        for (std::size_t c = 0; c < 3; ++c) row[c] *= c == 0 ? mirror * random.between(0.3, 2) : 1;
        row[3] = random.between(-0.5, 0.5);
    }
    return place;
}

bool areSame(const PixelBox& a, const PixelBox& b)
{
    return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
}

struct Tally {
    std::size_t away = 0, backTowards = 0, reached = 0, outside = 0, beforeNear = 0;
    double      boxes = 0, tight = 0;  // pixels of boxes, and of the triangles' own
};

void expectTrue(const MeshBatches& mesh, const Batch& batch, const Affine& toWorld, const Camera& camera, Tally& tally)
{
    const Projection projection(camera);
    const PlacedView view(projection, toWorld);
    const Facing     facing{FaceCulling::Back, toWorld.isMirrored()};
    const auto       behind = BackFaces(view, projection, toWorld.isMirrored()).question(view(batch.bounds));
    const Said said = HWY_DYNAMIC_DISPATCH(ask)(mesh, batch, behind ? &*behind : nullptr, view, projection, kRegion);
    ASSERT_EQ(said.patches & ~said.towards, 0u);
    PixelBox together{kRegion.x1, kRegion.y1, kRegion.x0, kRegion.y0};
    for (std::uint32_t patch = 0; patch < batch.patchCount(); ++patch) {
        const bool          isTowards = said.towards >> patch & 1, isReached = said.patches >> patch & 1;
        const PixelBox&     box     = said.boxes[patch];
        bool                allBack = true, hasPixels = false;
        PixelBox            own{kRegion.x1, kRegion.y1, kRegion.x0, kRegion.y0};
        const std::uint32_t first = batch.firstTriangle + patch * kPatchTriangles,
                            end   = std::min(first + kPatchTriangles, batch.firstTriangle + batch.triangleCount);
        for (std::uint32_t t = first; t < end; ++t) {
            std::array<ScreenCorner, 3> corner;
            bool                        isBefore = false;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t place = mesh.corners[i][t], v = batch.firstVertex + place;
                const dvec3       seen = projection.toView(toWorld({mesh.x[v], mesh.y[v], mesh.z[v]}));
                isBefore |= !(seen.z >= projection.near);
                corner[i] = projection.toScreen(seen);
                ASSERT_TRUE(!isTowards || (said.groups >> place / kVertexGroup & 1) != 0);
            }
            if (isBefore) {
                ++tally.beforeNear, allBack = false;
                ASSERT_TRUE(!isTowards || (areSame(box, kRegion) && said.nearests[patch] >= 1));
                continue;
            }
            allBack &= facing.isCulled(turnOf(corner[0], corner[1], corner[2], true));
            const auto [left, right] = std::minmax({corner[0].xs, corner[1].xs, corner[2].xs});
            const auto [top, bottom] = std::minmax({corner[0].ys, corner[1].ys, corner[2].ys});
            const PixelBox pixels{
                std::max(kRegion.x0, firstPixelCentreFrom(left)), std::max(kRegion.y0, firstPixelCentreFrom(top)),
                std::min(kRegion.x1, firstPixelCentreFrom(right)), std::min(kRegion.y1, firstPixelCentreFrom(bottom))};
            if (!isTowards || pixels.isEmpty()) continue;
            hasPixels = true;
            ASSERT_TRUE(isReached);
            ASSERT_TRUE(pixels.x0 >= box.x0 && pixels.y0 >= box.y0 && pixels.x1 <= box.x1 && pixels.y1 <= box.y1);
            for (const ScreenCorner& c : corner) ASSERT_LE(static_cast<float>(c.d), said.nearests[patch]);
            own = {std::min(own.x0, pixels.x0), std::min(own.y0, pixels.y0), std::max(own.x1, pixels.x1),
                   std::max(own.y1, pixels.y1)};
        }
        ASSERT_TRUE(isTowards || allBack);
        ASSERT_EQ(isTowards, !behind || !behind->holdsOf(coneOf(mesh, batch, patch)));
        tally.away += !isTowards, tally.backTowards += isTowards && allBack;
        tally.reached += isReached, tally.outside += isTowards && !isReached;
        if (!isReached) continue;
        ASSERT_LE(said.nearests[patch], said.nearest);
        together = {std::min(together.x0, box.x0), std::min(together.y0, box.y0), std::max(together.x1, box.x1),
                    std::max(together.y1, box.y1)};
        if (hasPixels) {
            tally.boxes += double(box.x1 - box.x0) * (box.y1 - box.y0);
            tally.tight += double(own.x1 - own.x0) * (own.y1 - own.y0);
        }
    }
    ASSERT_EQ(said.pixels.isEmpty(), said.patches == 0);
    ASSERT_TRUE(said.patches == 0 || areSame(together, said.pixels));
}

TEST(Patches, SayOnlyWhatIsTrueOfEveryTriangleInEveryInstructionSet)
{
    const std::array meshes{patched("icosphere?frequency=16&bumps=0.3"), patched("teapot"),
                            patched("icosphere?frequency=1")};
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
        const std::int64_t target = left & -left;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(target);
        Random random(7);
        Tally  tally;
        for (int i = 0; i < 80; ++i)
            for (const MeshBatches& mesh : meshes) {
                const bool   isFar = i >= 60;  // triangles smaller than pixels, which snapping may turn over
                const Camera camera =
                    anyCamera(random, std::pow(10.0, isFar ? random.between(2, 3.5) : random.between(-0.2, 1.3)));
                const Affine toWorld = anyPlacement(random, i % 3 == 0);
                for (const Batch& batch : mesh.batches) {
                    expectTrue(mesh, batch, toWorld, camera, tally);
                    if (testing::Test::HasFatalFailure()) FAIL() << hwy::TargetName(target);
                }
            }
        EXPECT_GT(tally.away, tally.backTowards)
            << "most that face away are known to, though batches around the eye know nothing";
        EXPECT_GT(tally.reached, 1000u);
        EXPECT_GT(tally.outside, 500u);
        EXPECT_GT(tally.beforeNear, 1000u);
        EXPECT_LT(tally.boxes, 8 * tally.tight) << hwy::TargetName(target);
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

/// A triangle some hundredths of a pixel wide, about as far from the middle of a pixel.
MeshBatches triangleAtPixelCentre(const Projection& projection, Random& random)
{
    const auto corner = [&](double x, double y) {
        constexpr double kZ       = 10;
        const double     perPixel = kZ / (projection.scale * projection.near);
        return projection.eye + projection.right * ((x - projection.centreX) * perPixel)
               + projection.up * ((projection.centreY - y) * perPixel) + projection.forward * kZ;
    };
    const double x = 490.5 + random.between(-0.01, 0.01), y = 305.5 + random.between(-0.01, 0.01),
                 size = random.between(0.002, 0.01);
    Mesh mesh;
    mesh.materials = {Material{}};
    mesh.positions = {corner(x - size, y), corner(x + size, y), corner(x, y + size)};
    mesh.triangles = {{0, 2, 1}};
    mesh.trianglePolygon.push_back(PolygonId{0});
    mesh.corners       = {0, 2, 1};
    mesh.firstCorner   = {0, 3};
    mesh.firstTriangle = {0, 1};
    mesh.polygonMaterial.push_back(MaterialId{0});
    mesh.polygonGroup.push_back({});
    return makeBatches(mesh, std::vector<std::uint32_t>{0});
}

TEST(Patches, ReachWhatSnappingReaches)
{
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
        const std::int64_t target = left & -left;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(target);
        Random       random(8);
        const Camera camera = anyCamera(random, 5);
        Tally        tally;
        for (int i = 0; i < 2000; ++i) {
            const MeshBatches mesh = triangleAtPixelCentre(Projection(camera), random);
            expectTrue(mesh, mesh.batches[0], Affine{}, camera, tally);
            if (testing::Test::HasFatalFailure()) FAIL() << hwy::TargetName(target) << ", " << i;
        }
        EXPECT_GT(tally.tight, 50) << "that have a pixel";
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(Patches, AreSmallPiecesOfTheSurface)
{
    const Result<Scene>        scene = loadScene("builtin:icosphere?frequency=16");
    const Mesh&                mesh  = scene.value().meshOf(InstanceId{0});
    const MeshBatches          made  = patched("icosphere?frequency=16");
    std::vector<std::uint32_t> triangles(made.meshTriangles().begin(), made.meshTriangles().end());
    std::ranges::sort(triangles);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) ASSERT_EQ(triangles[t], t);
    ASSERT_EQ(triangles.size(), mesh.triangles.size());
    std::size_t wide = 0, all = 0;
    for (const Batch& batch : made.batches)
        for (std::size_t patch = 0; patch < batch.patchCount(); ++patch, ++all)
            wide += !(made.patchesOf(batch)[patch / PatchBlock::kPatches].cosine[patch % PatchBlock::kPatches] > 0.9);
    EXPECT_LT(10 * wide, all) << "5,120 triangles face as many ways, those of a patch nearly the same";
}

TEST(Patches, PartWhereNormalsLeaveAGap)
{
    // A house of a roof and four walls, 80 small triangles each, in no order.
    const std::array<dvec3, 5> facings{dvec3{0, 1, 0}, dvec3{1, 0, 0}, dvec3{-1, 0, 0}, dvec3{0, 0, 1},
                                       dvec3{0, 0, -1}};
    Random                     random(11);
    Mesh                       mesh;
    std::vector<std::uint32_t> all;
    for (std::uint32_t t = 0; t < 400; ++t) {
        const dvec3& facing = facings[t % facings.size()];
        const dvec3  right{facing.z + facing.y, 0, -facing.x}, up = glm::cross(facing, right);
        const dvec3  at = facing + right * random.between(-1, 1) + up * random.between(-1, 1);
        for (const dvec3& corner : {at, at + right * 0.1, at + up * 0.1}) mesh.positions.push_back(corner);
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        all.push_back(t);
    }
    const std::vector<std::uint32_t> order = inPatches(mesh, all);
    ASSERT_TRUE(std::ranges::is_permutation(order, all));
    int facingOneWay = 0;
    for (std::size_t first = 0; first + kPatchTriangles <= order.size(); first += kPatchTriangles) {
        const std::span patch = std::span(order).subspan(first, kPatchTriangles);
        facingOneWay += std::ranges::all_of(
            patch, [&](std::uint32_t t) { return t % facings.size() == patch[0] % facings.size(); });
    }
    EXPECT_GE(facingOneWay, 10) << "two patches of each side, and what is left of them apart";
}

TEST(Patches, HoldEveryTriangleOnceHoweverLargeOrSmallTheNumbers)
{
    for (const double scale : {0.0, 1e-320, 1e-160, 1e155, 1e308}) {
        Random random(9);
        Mesh   mesh;
        for (int v = 0; v < 300; ++v)
            mesh.positions.push_back(random.between(dvec3{-scale, -scale, -scale}, dvec3{scale, scale, scale}));
        std::vector<std::uint32_t> all;
        for (std::uint32_t t = 0; t < 500; ++t) {
            const auto corner = [&] { return static_cast<std::uint32_t>(random.below(300)); };
            mesh.triangles.push_back({corner(), corner(), corner()});
            all.push_back(t);
        }
        std::vector<std::uint32_t> order = inPatches(mesh, all);
        std::ranges::sort(order);
        EXPECT_EQ(order, all) << scale;
    }
}

TEST(Patches, RunsOfBitsAreTakenLowestFirst)
{
    std::uint64_t                                        bits = 0xF000'0000'0000'0016;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
    while (bits != 0) {
        const BitRun run = takeRun(bits);
        runs.emplace_back(run.first, run.count);
    }
    EXPECT_EQ(runs, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{1, 2}, {4, 1}, {60, 4}}));
    std::uint32_t full = ~0u;
    EXPECT_EQ(takeRun(full).count, 32u);
    EXPECT_EQ(full, 0u);
}

}  // namespace
}  // namespace zscope

#endif  // HWY_ONCE
