// The two levels of a scene's hierarchy: one tree over the instances, and one tree per mesh over its triangles, shared
// by all instances of the mesh. Made on first request and kept between frames; see PreparedScene::derived().
#pragma once

#include <memory>
#include <vector>

#include "core/geometry/prepared_scene.h"
#include "core/hierarchy/tree.h"

namespace zscope {

class SceneTrees {
public:
    static constexpr std::uint32_t kInstanceLeaf = 4;
    static constexpr std::uint32_t kTriangleLeaf = 512;

    SceneTrees(const Scene& scene, TreeKind kind);

    const Tree& instances() const { return *m_instances; }
    /// A token that no other trees have or will have, for as long as anybody holds it.
    std::weak_ptr<const void> identity() const { return m_identity; }
    /// The tree of a mesh; made by the first thread that asks.
    const Tree& mesh(MeshId mesh) const;

    std::uint64_t bytes() const;

private:
    const Scene&                                m_scene;
    std::shared_ptr<const void>                 m_identity = std::make_shared<char>();
    TreeKind                                    m_kind;
    std::unique_ptr<const Tree>                 m_instances;
    mutable std::mutex                          m_mutex;
    mutable std::vector<std::unique_ptr<Tree>>  m_meshes;
    std::unique_ptr<std::atomic<const Tree*>[]> m_ready;  // the same, readable without the lock
};

/// The scene's trees of one kind.
const SceneTrees& treesOf(const PreparedScene& scene, TreeKind kind);

}  // namespace zscope
