#include "core/plain/enter_faces.h"

#include "core/geometry/face_batches.h"
#include "core/geometry/stripe_volume.h"

namespace zscope::plain {

namespace {

/// Reports what set-up finds.
struct Tell {
    const Work& work;

    bool isHeard() const { return work.observer != nullptr; }

    template <class Event>
    void operator()(const Event& event) const
    {
        work.tell(event);
    }
    void operator()(TriangleSetUp event) const
    {
        event.isFlipped = work.rules.takesFrontsForBacks();  // a fault
        work.tell(event);
    }
};

/// Takes what set-up makes of a face.
struct Enter {
    Work& work;

    void operator()(const ScreenTriangle& triangle) const { work.scratch.edges.add(triangle, work.rules); }
    void operator()(const ScreenFace& face, std::span<const ScreenSide> sides) const
    {
        const Inside inside = face.isMended ? Inside::EvenOdd : Inside::AnyWinding;
        work.scratch.edges.add({face.depth, face.id, face.patterned}, inside, sides, face.top, work.rules);
    }
};

}  // namespace

void enterFaces(Work& work)
{
    const Stripe&      stripe = work.stripe;
    const Scene&       scene  = stripe.scene.scene();
    const SceneFaces&  faces  = facesOf(stripe.scene);
    const StripeVolume volume(stripe.projection, stripe.visible.width(), stripe.firstRow, stripe.endRow);
    const Tell         tell{work};
    const Enter        enter{work};
    work.clock.lap(Stage::Build);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance&    instance = scene.instances[i];
        const FaceBatches& mesh     = faces.of(instance.mesh);
        const PlacedView   view(stripe.projection, instance.toWorld);
        const auto         all       = static_cast<std::uint32_t>(scene.meshOf(InstanceId{i}).triangles.size());
        const auto         inBatches = static_cast<std::uint32_t>(mesh.points.triangleCount());
        work.tell(TransparentLeftOut{InstanceId{i}, all - inBatches});
        if (volume.misses(view(mesh.points.bounds))) {
            work.tell(BatchOutside{InstanceId{i}, inBatches});
            continue;
        }
        const Affine* toWorld = instance.toWorld.isIdentity() ? nullptr : &instance.toWorld;
        for (std::uint32_t b = 0; b < mesh.points.batches.size() && !work.isCancelled(); ++b) {
            const Batch& batch = mesh.points.batches[b];
            if (mesh.points.batches.size() > 1 && volume.misses(view(batch.bounds))) {
                work.tell(BatchOutside{InstanceId{i}, batch.triangleCount});
                continue;
            }
            if (work.leavesOut(Checkpoint::Batch)) continue;
            work.tell(BatchTransformed{InstanceId{i}, batch.vertexCount});
            work.tally.add(Unit::Batches);
            work.tally.add(Unit::Vertices, batch.vertexCount);
            work.tally.add(Unit::TrianglesSetUp, batch.triangleCount);
            const FacePlace place{mesh, b, toWorld, scene.firstTriangle[i]};
            FaceSetUp(place, stripe.projection, stripe.culling, stripe.region(), work.scratch.faces, enter, work.rules,
                      tell)
                .carefully();
            work.clock.lap(Stage::Setup);
        }
    }
    work.clock.lap(Stage::Cull);
}

}  // namespace zscope::plain
