// A mesh cut into batches: small indexed pieces that are culled, transformed and set up together.
//
// Order      load order, where its batches share most of their vertices already. Elsewhere, where it saves a quarter of
//            the vertices or more, triangles follow a space-filling curve through their centres, so that a batch is a
//            patch of the surface: its box is small, and its pixels lie together. Ids are what they were. Transparent
//            triangles always keep load order, in which they may be blended
// Layout     a batch has its own copy of the vertices it uses, structure of arrays, so that lanes load them side
//            by side; a vertex shared by two batches is transformed once in each
// Size       as it is wanted (BatchSize), at most kBatchVertices vertices and kBatchTriangles triangles
// Cone       of the normals of its triangles, so that a batch that shows its back is dropped whole (normal_cone.h)
// Sides      of a mesh's own batches, and of those patch by patch: which triangle of the batch lies beyond each
// Patches    of a node's batches, for whoever would rather know of fewer triangles at once (patches.h); and of a mesh's
//            as patchedBatches() has them
// Source     the curve is Morton's, as meshoptimizer sorts along it
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/large_pages.h"
#include "core/geometry/normal_cone.h"
#include "core/geometry/patches.h"
#include "core/scene/mesh.h"

namespace zscope {

inline constexpr std::size_t kBatchVertices  = 640;
inline constexpr std::size_t kBatchTriangles = 1024;
/// Values past the end of the vectors of MeshBatches that may be read: one widest vector.
inline constexpr std::size_t kBatchPadding = 16;

/// At most so many in a batch.
struct BatchSize {
    std::size_t vertices = 256, triangles = 512;
};
/// What is drawn of a tree at once is mostly one batch.
inline constexpr BatchSize kWholeLeaf{kBatchVertices, kBatchTriangles};

struct Batch {
    std::uint32_t firstVertex   = 0;  // into MeshBatches::x, y, z
    std::uint32_t vertexCount   = 0;
    std::uint32_t firstTriangle = 0;  // into MeshBatches::corners and ::meshTriangle
    std::uint32_t triangleCount = 0;
    Bounds        bounds;          // of its vertices, model space
    NormalCone    cone;            // of its triangles, model space
    std::uint32_t firstBlock = 0;  // into MeshBatches::patches

    std::size_t patchCount() const { return (triangleCount + kPatchTriangles - 1) / kPatchTriangles; }
    PatchBits   patches() const { return kAllPatches >> (32 - patchCount()); }
};
static_assert(kBatchTriangles <= 32 * kPatchTriangles && kBatchVertices <= 64 * kVertexGroup,
              "one bit each: PatchBits, PatchBlock::vertexGroups");

struct MeshBatches {
    template <class T>
    using Column = std::vector<T, LargePages<T>>;

    std::vector<Batch>        batches;
    std::vector<PatchBlock>   patches;       // PatchBlock::kPatches of a batch in each; or none at all
    Column<double>            x, y, z;       // model space
    Column<std::uint32_t>     meshTriangle;  // which triangle of the mesh each one is
    std::vector<std::uint8_t> patterned;     // whether it has holes or a relief; empty if none has
    Bounds                    bounds;        // of all batches

    /// Corners as positions in the batch's own vertices; padded like x, y, z and meshTriangle.
    std::array<Column<std::uint16_t>, 3> corners;

    /// beyond[k]: the triangle of the same batch, counted from its first, that has the side from corner k to the next
    /// one, too, but runs along it the other way: each of the two names the other. kNobody if there is none, or if it
    /// belongs to a third one. Padded likewise; empty of a node's batches and of transparent ones.
    std::array<Column<std::uint16_t>, 3> beyond;
    static constexpr std::uint16_t       kNobody = kBatchTriangles;

    std::span<const std::uint32_t> meshTriangles() const { return std::span(meshTriangle).first(triangleCount()); }
    std::size_t                    vertexCount() const
    {
        return batches.empty() ? 0 : batches.back().firstVertex + batches.back().vertexCount;
    }
    std::size_t triangleCount() const
    {
        return batches.empty() ? 0 : batches.back().firstTriangle + batches.back().triangleCount;
    }
    bool          isPatterned(std::uint32_t triangle) const { return !patterned.empty() && patterned[triangle] != 0; }
    std::uint64_t bytes() const;

    std::span<const PatchBlock> patchesOf(const Batch& batch) const
    {
        return std::span(patches).subspan(batch.firstBlock,
                                          (batch.patchCount() + PatchBlock::kPatches - 1) / PatchBlock::kPatches);
    }
};

/// Which triangles of a mesh are wanted: those that decide ids and depth, or those that are blended over them
/// afterwards.
enum class Surfaces { Opaque, Transparent };
/// Transparent: the triangle's material has an opacity below 1.
Surfaces surfaceOf(const Mesh& mesh, std::uint32_t triangle);

/// Some triangles of a mesh in another order: so that those of a patch lie close together and face the same way.
std::vector<std::uint32_t> inPatches(const Mesh& mesh, std::span<const std::uint32_t> triangles);

/// Triangles of the other kind are in no batch.
MeshBatches makeBatches(const Mesh& mesh, Surfaces wanted = Surfaces::Opaque);
/// The same for some of its triangles, in the order given.
MeshBatches makeBatches(const Mesh& mesh, std::span<const std::uint32_t> triangles, Surfaces wanted = Surfaces::Opaque,
                        BatchSize size = {});
/// Batches of the same triangles as the mesh's own, `whole`, in which they stand patch by patch: for whoever need not
/// draw in load order. None, where by patches not even a tenth of the triangles more is seen to face away than by
/// batches, from anywhere on average.
MeshBatches patchedBatches(const Mesh& mesh, const MeshBatches& whole);

}  // namespace zscope
