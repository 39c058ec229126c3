// The transparent triangles of a scene in batches of their own: what is blended over the opaque picture.
//
// Made       on first request, and only for a scene that has any (transparentSurfacesOf)
// Order      load order, as for the opaque ones
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/batches.h"
#include "core/geometry/prepared_scene.h"

namespace zscope {

class TransparentSurfaces {
public:
    explicit TransparentSurfaces(const Scene& scene);

    const MeshBatches& of(MeshId mesh) const { return m_meshes[mesh.value]; }
    std::uint64_t      triangles() const { return m_triangles; }  // of the whole scene, instances included
    bool               isEmpty() const { return m_triangles == 0; }
    std::uint64_t      bytes() const;

private:
    std::vector<MeshBatches> m_meshes;  // one per mesh
    std::uint64_t            m_triangles = 0;
};

const TransparentSurfaces& transparentSurfacesOf(const PreparedScene& scene);

}  // namespace zscope
