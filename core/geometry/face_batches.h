// A mesh cut into batches of whole faces, as they were read: what a method needs that draws polygons, not triangles.
//
// Sides      of a face of several triangles: the directed edges of its triangles that no other of them cancels by
//            running the other way. That is the outline as read, with the corners that the split inserted where the
//            outline touches itself, and without the bridges to its holes. Whatever the corners' places, sides wind
//            round a point as often as the face's triangles cover it, counted by their sense of turning
// Plane      in model space: Newell's normal, through the mean of the corners
// Order      load order; triangles of a face are consecutive, its id is that of the first
// Size       a batch has at most as many vertices and triangles as BatchSize says, or a single face of any size
// Made       on first request, for the whole scene (facesOf)
// Triangles  where every face of a mesh is one, shortcuts draw the mesh's triangles
//            (visitFacesAsSubmitted)
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/batches.h"
#include "core/geometry/prepared_scene.h"

namespace zscope {

/// Corners of a batch by their place among its vertices.
struct FaceSide {
    std::uint32_t from, to;
};
using FaceEar = std::array<std::uint32_t, 3>;

struct FacePlane {
    dvec3 normal;  // any length; 0 if the face has no area
    dvec3 mean;
};

struct Face {
    static constexpr std::uint32_t kNoPlane = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t firstSide     = 0;         // into FaceBatches::sides; those of a face end where the next face's begin
    std::uint32_t firstEar      = 0;         // likewise, FaceBatches::ears
    std::uint32_t firstTriangle = 0;         // of the mesh
    std::uint32_t plane         = kNoPlane;  // into FaceBatches::planes; a face of one triangle has none, and no sides
    bool          patterned     = false;     // it has holes or a relief
    // crosses itself or has no area: filled by the even-odd rule, whatever its triangles
    bool isMended = false;
};

struct FaceBatch {
    std::uint32_t firstFace = 0, faceCount = 0;
};

struct FaceBatches {
    MeshBatches            points;   // batches, vertices and boxes; meshTriangle, but no corners of triangles
    std::vector<FaceBatch> batches;  // one per batch of `points`
    std::vector<Face>      faces;    // and one more, where the last one's sides and ears end
    std::vector<FaceSide>  sides;
    std::vector<FaceEar>   ears;
    std::vector<FacePlane> planes;

    std::span<const FaceSide> sidesOf(std::uint32_t face) const
    {
        return std::span(sides).subspan(faces[face].firstSide, faces[face + 1].firstSide - faces[face].firstSide);
    }
    std::span<const FaceEar> earsOf(std::uint32_t face) const
    {
        return std::span(ears).subspan(faces[face].firstEar, faces[face + 1].firstEar - faces[face].firstEar);
    }
    /// Every face is a triangle: to draw the mesh's triangles is to draw its faces.
    bool areTriangles() const { return planes.empty(); }

    std::uint64_t bytes() const;
};

/// Transparent faces (opacity below 1) are in no batch.
FaceBatches makeFaceBatches(const Mesh& mesh);

class SceneFaces {
public:
    explicit SceneFaces(const Scene& scene);

    const FaceBatches& of(MeshId mesh) const { return m_meshes[mesh.value]; }
    /// Whether that is so of at least one mesh.
    bool          someAreTriangles() const { return std::ranges::any_of(m_meshes, &FaceBatches::areTriangles); }
    std::uint64_t bytes() const;

private:
    std::vector<FaceBatches> m_meshes;
};

/// The scene's faces; made by the first who asks.
const SceneFaces& facesOf(const PreparedScene& scene);

}  // namespace zscope
