#include "core/geometry/prepared_scene.h"

#include <utility>

namespace zscope {

PreparedScene::PreparedScene(std::shared_ptr<const Scene> scene) : m_scene(std::move(scene))
{
    m_batches.reserve(m_scene->meshes.size());
    for (const auto& mesh : m_scene->meshes) m_batches.push_back(makeBatches(*mesh));
}

std::uint64_t PreparedScene::bytes() const
{
    std::uint64_t total = 0;
    for (const MeshBatches& mesh : m_batches) total += mesh.bytes();
    return total;
}

}  // namespace zscope
