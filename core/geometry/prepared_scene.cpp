#include "core/geometry/prepared_scene.h"

#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <utility>

namespace zscope {

PreparedScene::PreparedScene(std::shared_ptr<const Scene> scene) : m_scene(std::move(scene))
{
    m_batches.reserve(m_scene->meshes.size());
    for (const auto& mesh : m_scene->meshes) m_batches.push_back(makeBatches(*mesh));
}

namespace {

std::uint64_t bytesOf(std::span<const MeshBatches> meshes)
{
    std::uint64_t total = 0;
    for (const MeshBatches& mesh : meshes) total += mesh.bytes();
    return total;
}

}  // namespace

std::uint64_t PreparedScene::bytes() const { return bytesOf(m_batches); }

PatchedBatches::PatchedBatches(const PreparedScene& scene) : m_scene(scene)
{
    m_meshes.resize(scene.scene().meshes.size());
    for (std::uint32_t mesh = 0; mesh < m_meshes.size(); ++mesh) {
        try {
            m_meshes[mesh] = patchedBatches(*scene.scene().meshes[mesh], scene.batchesOf(MeshId{mesh}));
        } catch (const std::bad_alloc&) {  // no picture needs them: the mesh's own are drawn
        }
    }
}

std::uint64_t PatchedBatches::bytes() const { return bytesOf(m_meshes); }

const PatchedBatches& patchedBatchesOf(const PreparedScene& scene)
{
    return scene.derived().get<PatchedBatches>([&scene] { return std::make_unique<PatchedBatches>(scene); });
}

}  // namespace zscope
