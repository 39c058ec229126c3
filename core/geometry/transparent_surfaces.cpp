#include "core/geometry/transparent_surfaces.h"

#include <algorithm>
#include <memory>

namespace zscope {

TransparentSurfaces::TransparentSurfaces(const Scene& scene)
{
    m_meshes.reserve(scene.meshes.size());
    for (const auto& mesh : scene.meshes) {
        const bool mayHave = std::ranges::any_of(mesh->materials, [](const Material& m) { return m.opacity < 1; });
        m_meshes.push_back(mayHave ? makeBatches(*mesh, Surfaces::Transparent) : MeshBatches{});
    }
    for (const Instance& instance : scene.instances) m_triangles += of(instance.mesh).triangleCount();
}

std::uint64_t TransparentSurfaces::bytes() const
{
    std::uint64_t total = 0;
    for (const MeshBatches& mesh : m_meshes) total += mesh.bytes();
    return total;
}

const TransparentSurfaces& transparentSurfacesOf(const PreparedScene& scene)
{
    return scene.derived().get<TransparentSurfaces>(
        [&scene] { return std::make_unique<TransparentSurfaces>(scene.scene()); });
}

}  // namespace zscope
