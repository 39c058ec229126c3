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

    const Scene&                  scene() const { return *m_scene; }
    std::shared_ptr<const Scene>  share() const { return m_scene; }
    const MeshBatches&            batchesOf(MeshId mesh) const { return m_batches[mesh.value]; }
    std::uint64_t                 bytes() const;  // of the batches
    const Derived&                derived() const { return m_derived; }

private:
    std::shared_ptr<const Scene> m_scene;
    std::vector<MeshBatches>     m_batches;  // one per mesh
    Derived                      m_derived;
};

}  // namespace zscope
