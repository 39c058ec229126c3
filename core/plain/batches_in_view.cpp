#include "core/plain/batches_in_view.h"

namespace zscope::plain {

BatchesInView::BatchesInView(Work& work, const TransparentSurfaces* transparent)
    : m_work(work), m_transparent(transparent), m_scene(work.stripe.scene.scene()),
      m_volume(work.stripe.projection, work.stripe.visible.width(), work.stripe.firstRow, work.stripe.endRow)
{}

void BatchesInView::toNext()
{
    m_place.reset();
    while (!m_work.isCancelled()) {
        if (!m_mesh || m_nextBatch == m_mesh->batches.size()) {
            if (!entersNextInstance()) return;
            continue;
        }
        const Batch&         batch    = m_mesh->batches[m_nextBatch++];
        const InstanceId     instance = {m_nextInstance - 1};
        StripeVolume::Planes open     = m_open;
        if (m_open != 0 && m_mesh->batches.size() > 1 && m_volume.misses((*m_view)(batch.bounds), open)) {
            m_work.tell(BatchOutside{instance, batch.triangleCount});
            continue;
        }
        if (m_work.leavesOut(Checkpoint::Batch)) continue;
        const Affine& toWorld = m_scene.instances[instance.value].toWorld;
        m_place.emplace(BatchPlace{*m_mesh, batch, toWorld.isIdentity() ? nullptr : &toWorld,
                                   m_scene.firstTriangle[instance.value]});
        m_work.clock.lap(Stage::Cull);
        return;
    }
}

/// False after the last one. An instance outside the stripe has no batch.
bool BatchesInView::entersNextInstance()
{
    if (m_nextInstance == m_scene.instances.size()) {
        m_work.clock.lap(Stage::Cull);
        return false;
    }
    const InstanceId id{m_nextInstance++};
    const Instance&  instance = m_scene.instances[id.value];
    m_mesh                    = &batchesOf(instance.mesh);
    m_nextBatch               = 0;
    m_view.emplace(m_work.stripe.projection, instance.toWorld);
    const auto all       = static_cast<std::uint32_t>(m_scene.meshOf(id).triangles.size());
    const auto inBatches = static_cast<std::uint32_t>(m_mesh->triangleCount());
    if (!m_transparent) m_work.tell(TransparentLeftOut{id, all - inBatches});
    m_open = StripeVolume::kAll;
    if (m_volume.misses((*m_view)(m_mesh->bounds), m_open)) {
        m_work.tell(BatchOutside{id, inBatches});
        m_nextBatch = static_cast<std::uint32_t>(m_mesh->batches.size());
    }
    return true;
}

}  // namespace zscope::plain
