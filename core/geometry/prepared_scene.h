// A scene with what drawing derives from it once: the batches of every mesh, and, on first request, whatever
// later stages need (colours, octrees). Made when a scene has been loaded and shared by everything that draws it.
//
// Threads    any thread may read it and ask for derived values
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/derived.h"
#include "core/geometry/batches.h"
#include "core/scene/scene.h"

namespace zscope {

class PreparedScene {
public:
    explicit PreparedScene(std::shared_ptr<const Scene> scene);

    const Scene&                 scene() const { return *m_scene; }
    std::shared_ptr<const Scene> share() const { return m_scene; }
    const MeshBatches&           batchesOf(MeshId mesh) const { return m_batches[mesh.value]; }
    std::uint64_t                bytes() const;  // of the batches
    const Derived&               derived() const { return m_derived; }

private:
    std::shared_ptr<const Scene> m_scene;
    std::vector<MeshBatches>     m_batches;  // one per mesh
    Derived                      m_derived;
};

/// The batches of every mesh patch by patch, where that is worth while; made on the first frame that culls back faces
/// in load order, by exact rules.
class PatchedBatches {
public:
    explicit PatchedBatches(const PreparedScene& scene);

    /// patchedBatches(), or the mesh's own if there are none.
    const MeshBatches& of(MeshId mesh) const
    {
        return m_meshes[mesh.value].batches.empty() ? m_scene.batchesOf(mesh) : m_meshes[mesh.value];
    }
    std::uint64_t bytes() const;

private:
    const PreparedScene&     m_scene;
    std::vector<MeshBatches> m_meshes;
};

const PatchedBatches& patchedBatchesOf(const PreparedScene& scene);

}  // namespace zscope
