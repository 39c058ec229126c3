// The scene as submitted: instance after instance in load order, and of each the batches that may reach the stripe.
//
// Range      for (const BatchPlace& batch : BatchesInView(work)) ...
// Outside    a whole instance, or a batch, that cannot touch a pixel centre of the stripe is left out (StripeVolume)
// Replay     batches that a replayed run has drawn before are left out
#pragma once

#include <cstdint>
#include <iterator>
#include <optional>

#include "core/geometry/geometry_events.h"
#include "core/geometry/set_up.h"
#include "core/geometry/stripe_volume.h"
#include "core/geometry/transparent_surfaces.h"
#include "core/plain/work.h"

namespace zscope::plain {

class BatchesInView {
public:
    /// The batches of opaque triangles, or of `transparent` ones.
    explicit BatchesInView(Work& work, const TransparentSurfaces* transparent = nullptr);

    class Iterator {
    public:
        explicit Iterator(BatchesInView& batches) : m_batches(batches) { m_batches.toNext(); }
        const BatchPlace& operator*() const { return *m_batches.m_place; }
        Iterator&         operator++()
        {
            m_batches.toNext();
            return *this;
        }
        bool operator==(std::default_sentinel_t) const { return !m_batches.m_place; }

    private:
        BatchesInView& m_batches;
    };
    Iterator                begin() { return Iterator(*this); }
    std::default_sentinel_t end() const { return {}; }

private:
    void toNext();
    bool entersNextInstance();

    const MeshBatches& batchesOf(MeshId mesh) const
    {
        return m_transparent ? m_transparent->of(mesh) : m_work.stripe.scene.batchesOf(mesh);
    }

    Work&                      m_work;
    const TransparentSurfaces* m_transparent;
    const Scene&               m_scene;
    StripeVolume               m_volume;
    std::uint32_t              m_nextInstance = 0, m_nextBatch = 0;
    const MeshBatches*         m_mesh = nullptr;  // of the instance at hand
    std::optional<PlacedView>  m_view;            // likewise
    StripeVolume::Planes       m_open = 0;        // planes of the stripe that the instance crosses
    std::optional<BatchPlace>  m_place;
};

}  // namespace zscope::plain
