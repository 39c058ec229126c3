// Batches hold every opaque triangle of a mesh exactly once, with its own corners: in load order, or by patches of
// the surface where that shares more vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "core/geometry/batches.h"
#include "core/scene/load.h"

namespace zscope {
namespace {

/// `vertices` points, `triangles` triangles with corners near each other in the list, or anywhere.
Mesh anyMesh(std::uint64_t seed, std::uint32_t vertices, std::uint32_t triangles, bool isLocal, bool hasTransparent)
{
    std::mt19937_64 random(seed);
    Mesh            mesh;
    mesh.materials = {Material{}, Material{.name = "glass", .diffuse = {}, .opacity = 0.5f}};
    for (std::uint32_t v = 0; v < vertices; ++v)
        mesh.positions.push_back(
            {static_cast<double>(random() % 1000), static_cast<double>(random() % 1000), static_cast<double>(v)});
    for (std::uint32_t t = 0; t < triangles; ++t) {
        const std::uint64_t around = isLocal ? std::uint64_t{t} * vertices / triangles : random();
        const auto          corner = [&] {
            return static_cast<std::uint32_t>((around + random() % (isLocal ? 40 : vertices)) % vertices);
        };
        const std::array outline{corner(), corner(), corner()};  // repeated corners occur
        mesh.triangles.push_back(outline);
        mesh.trianglePolygon.push_back(PolygonId{t});
        mesh.corners.insert(mesh.corners.end(), outline.begin(), outline.end());
        mesh.firstCorner.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
        mesh.firstTriangle.push_back(t + 1);
        mesh.polygonMaterial.push_back(MaterialId{hasTransparent && random() % 3 == 0 ? 1u : 0u});
        mesh.polygonGroup.push_back({});
    }
    return mesh;
}

void expectFaithful(const Mesh& mesh)
{
    const MeshBatches          made = makeBatches(mesh);
    std::vector<std::uint32_t> opaque;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        if (mesh.materialOf(mesh.trianglePolygon[t]).opacity >= 1) opaque.push_back(t);
    if (made.batches.size() < 2)
        ASSERT_TRUE(std::ranges::equal(made.meshTriangles(), opaque));
    else
        ASSERT_TRUE(std::ranges::is_permutation(made.meshTriangles(), opaque));
    ASSERT_EQ(made.x.size(), made.y.size());
    ASSERT_EQ(made.x.size(), made.z.size());

    std::uint32_t vertex = 0, triangle = 0;
    for (const Batch& batch : made.batches) {
        ASSERT_EQ(batch.firstVertex, vertex);
        ASSERT_EQ(batch.firstTriangle, triangle);
        EXPECT_GE(batch.triangleCount, 1u);
        EXPECT_LE(batch.vertexCount, kBatchVertices);
        EXPECT_LE(batch.triangleCount, kBatchTriangles);
        Bounds bounds;
        for (std::uint32_t t = triangle; t < triangle + batch.triangleCount; ++t) {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint16_t corner = made.corners[i][t];
                ASSERT_LT(corner, batch.vertexCount);
                const std::size_t at = batch.firstVertex + corner;
                const dvec3       p  = mesh.positions[mesh.triangles[made.meshTriangle[t]][i]];
                EXPECT_EQ((dvec3{made.x[at], made.y[at], made.z[at]}), p);
                bounds.include(p);
            }
        }
        EXPECT_EQ(batch.bounds.min, bounds.min);
        EXPECT_EQ(batch.bounds.max, bounds.max);
        vertex += batch.vertexCount;
        triangle += batch.triangleCount;
    }
    EXPECT_EQ(triangle, opaque.size());
    EXPECT_GE(made.x.size(), vertex + kBatchPadding);
}

TEST(Batches, HoldEveryOpaqueTriangleOnceWithItsCorners)
{
    expectFaithful(anyMesh(1, 3000, 6000, true, false));
    expectFaithful(anyMesh(2, 3000, 6000, true, true));
    expectFaithful(anyMesh(3, 3000, 2000, false, true));  // hardly a vertex shared: batches end by vertices
    expectFaithful(anyMesh(4, 10, 5000, false, false));   // all shared: batches end by triangles
    expectFaithful(anyMesh(5, 257, 1, false, false));
    expectFaithful(anyMesh(6, 1, 3, false, false));
    expectFaithful(anyMesh(10, 300, kBatchTriangles, false, true));
}

TEST(Batches, TransparentTrianglesStayInLoadOrder)
{
    Mesh mesh                 = anyMesh(11, 300, 3 * kBatchTriangles, false, false);
    mesh.materials[0].opacity = 0.5f;
    const MeshBatches made    = makeBatches(mesh, Surfaces::Transparent);
    EXPECT_EQ(made.triangleCount(), mesh.triangles.size());
    EXPECT_TRUE(std::ranges::is_sorted(made.meshTriangles()));
}

/// A flat sheet of 64 by 64 squares with shared corners, loaded row by row or in no order.
Mesh sheet(bool isShuffled)
{
    Mesh                       mesh = anyMesh(12, 65 * 65, 2 * 4096, false, false);
    std::vector<std::uint32_t> place(2 * 4096);
    std::iota(place.begin(), place.end(), 0u);
    if (isShuffled) std::ranges::shuffle(place, std::mt19937_64(12));
    for (std::uint32_t v = 0; v < 65 * 65; ++v)
        mesh.positions[v] = {static_cast<double>(v % 65), static_cast<double>(v / 65), 0};
    for (std::uint32_t t = 0; t < place.size(); ++t) {
        const std::uint32_t square = place[t] / 2, corner = square / 64 * 65 + square % 64;
        if (place[t] % 2 == 0)
            mesh.triangles[t] = {corner, corner + 1, corner + 66};
        else
            mesh.triangles[t] = {corner, corner + 66, corner + 65};
    }
    return mesh;
}

TEST(Batches, AMeshInNoOrderIsCutIntoPatches)
{
    const MeshBatches made = makeBatches(sheet(true));
    double            area = 0;
    for (const Batch& batch : made.batches)
        area += (batch.bounds.max.x - batch.bounds.min.x) * (batch.bounds.max.y - batch.bounds.min.y);
    EXPECT_LE(area, 3 * 64.0 * 64.0);  // in load order each of them would reach over the whole sheet
    EXPECT_LE(made.vertexCount(), 2 * 65u * 65u);
    EXPECT_FALSE(std::ranges::is_sorted(made.meshTriangles()));
}

TEST(Batches, LoadOrderIsKeptWhereItSharesVerticesAsWell)
{
    EXPECT_TRUE(std::ranges::is_sorted(makeBatches(sheet(false)).meshTriangles()));
    Mesh loose = sheet(true);  // no vertex is shared: no order saves any
    for (std::uint32_t t = 0; t < loose.triangles.size(); ++t) {
        std::array<std::uint32_t, 3> own{};
        for (std::size_t i = 0; i < 3; ++i) {
            own[i] = static_cast<std::uint32_t>(loose.positions.size());
            loose.positions.push_back(loose.positions[loose.triangles[t][i]]);
        }
        loose.triangles[t] = own;
    }
    EXPECT_TRUE(std::ranges::is_sorted(makeBatches(loose).meshTriangles()));
}

TEST(Batches, OfAMeshThatFacesEveryWayMayStandPatchByPatch)
{
    const Mesh flat = sheet(true);
    EXPECT_TRUE(patchedBatches(flat, makeBatches(flat)).batches.empty()) << "its batches say all that patches could";
    const Result<Scene> scene = loadScene("builtin:icosphere?frequency=40");
    const Mesh&         mesh  = scene.value().meshOf(InstanceId{0});
    const MeshBatches   whole = makeBatches(mesh), made = patchedBatches(mesh, whole);
    EXPECT_TRUE(whole.patches.empty());
    ASSERT_GE(made.batches.size(), 17u) << "more than are tried";
    ASSERT_EQ(made.batches.size(), whole.batches.size());
    for (std::size_t b = 0; b < made.batches.size(); ++b) {
        const auto of = [b](const MeshBatches& batches) {
            return batches.meshTriangles().subspan(batches.batches[b].firstTriangle, batches.batches[b].triangleCount);
        };
        ASSERT_TRUE(std::ranges::is_permutation(of(made), of(whole))) << b;
    }
    std::size_t blocks = 0;
    for (const Batch& batch : made.batches) {
        ASSERT_EQ(batch.firstBlock, blocks);
        blocks += (batch.patchCount() + PatchBlock::kPatches - 1) / PatchBlock::kPatches;
        ASSERT_LE(blocks, made.patches.size());
        for (std::uint32_t patch = 0; patch < batch.patchCount(); ++patch) {
            const PatchBlock& block = made.patchesOf(batch)[patch / PatchBlock::kPatches];
            EXPECT_GT(block.altitude[patch % PatchBlock::kPatches], 0);
            std::uint64_t groups = 0;  // of the vertices of its triangles
            for (std::uint32_t t = patch * kPatchTriangles;
                 t < std::min(batch.triangleCount, (patch + 1) * kPatchTriangles); ++t)
                for (const auto& corner : made.corners)
                    groups |= std::uint64_t{1} << corner[batch.firstTriangle + t] / kVertexGroup;
            EXPECT_EQ(block.vertexGroups[patch % PatchBlock::kPatches], groups);
        }
    }
    EXPECT_EQ(blocks, made.patches.size());
}

TEST(Batches, AMeshWithNothingOpaqueHasNone)
{
    Mesh mesh                 = anyMesh(7, 30, 20, false, false);
    mesh.materials[0].opacity = 0.25f;
    EXPECT_TRUE(makeBatches(mesh).batches.empty());
    EXPECT_TRUE(makeBatches(mesh).bounds.isEmpty());
    EXPECT_TRUE(makeBatches(Mesh{}).batches.empty());
}

TEST(Batches, AVertexIsTransformedOncePerBatch)
{
    const Mesh        mesh = anyMesh(8, 100, 400, false, false);
    const MeshBatches made = makeBatches(mesh);
    ASSERT_EQ(made.batches.size(), 1u);
    EXPECT_LE(made.batches[0].vertexCount, 100u);
}

TEST(Batches, ASelectionIsTakenInTheOrderGiven)
{
    const Mesh                       mesh = anyMesh(9, 100, 50, false, false);
    const std::vector<std::uint32_t> some{40, 3, 17, 3};
    EXPECT_TRUE(std::ranges::equal(makeBatches(mesh, some).meshTriangles(), some));
}

}  // namespace
}  // namespace zscope
