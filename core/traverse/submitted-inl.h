// Order "as submitted": instance after instance in load order, batch after batch, triangle after triangle
// (core/geometry/batches.h says in which order the triangles of a large mesh stand).
//
// Promise    skips only what cannot touch a pixel centre of the stripe (StripeVolume)
// Cost       five planes per instance, per batch those that the instance crosses and a cone of normals; transform and set-up of
//            what is left
#if defined(ZSCOPE_SUBMITTED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_SUBMITTED_INL_H
#undef ZSCOPE_SUBMITTED_INL_H
#else
#define ZSCOPE_SUBMITTED_INL_H
#endif

#include "core/depth/hidden_squares-inl.h"
#include "core/geometry/set_up-inl.h"
#include "core/geometry/stripe_volume.h"
#include "core/geometry/transform-inl.h"
#include "core/probe/probe.h"
#include "core/traverse/stripe.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// Pixels of a batch's reach that are worth a look for each of its triangles.
inline constexpr std::uint64_t kWorthLooking = 16;

/// Transforms one batch and leaves its screen triangles in `scratch.triangles`. `asksPixels`: at full speed those may be left out that can win no
/// pixel any more, all of whose pixels hold something nearer than the batch comes. Whoever listens sees them drawn, and lose.
template <class Rules, class Probe>
LeftOut setUpBatch(const BatchPlace& place, InstanceId instance, const Stripe& stripe, StripeScratch& scratch, StageClock& clock, const Rules& rules,
                   const Probe& probe, [[maybe_unused]] bool asksPixels = false)
{
    transformBatch(place.mesh, place.batch, place.toWorld, stripe.projection, rules, scratch.vertices);
    probe(BatchTransformed{instance, place.batch.vertexCount});
    clock.lap(Stage::Transform);

    scratch.triangles.clear();
    const PixelBox region = stripe.region();
    LeftOut        leftOut;
    if (!scratch.vertices.plain)
        setUpCarefully(place, stripe.projection, stripe.culling, region, rules, scratch.triangles, probe);
    else if constexpr (Rules::kExact && !Probe::listens) {
        const BatchReach reach  = asksPixels ? reachOf(scratch.vertices, place.batch.vertexCount, region) : BatchReach{};
        const auto       pixels = static_cast<std::uint64_t>(reach.pixels.x1 - reach.pixels.x0) * static_cast<std::uint64_t>(reach.pixels.y1 - reach.pixels.y0);
        const bool       looks  = !reach.pixels.isEmpty() && pixels <= kWorthLooking * place.batch.triangleCount;
        switch (looks ? HiddenSquaresFinder::find(stripe.visible, reach.pixels, reach.nearest, scratch.hidden) : HiddenPart::Nothing) {
        case HiddenPart::Everything: leftOut = {place.batch.triangleCount, pixels}; break;
        case HiddenPart::Squares:
            leftOut = PlainSetUp(place, scratch.vertices, stripe.culling, region, rules, scratch.triangles, probe, HiddenBoxes(scratch.hidden)).run();
            break;
        case HiddenPart::Nothing: PlainSetUp(place, scratch.vertices, stripe.culling, region, rules, scratch.triangles, probe).run(); break;
        }
    } else {
        PlainSetUp(place, scratch.vertices, stripe.culling, region, rules, scratch.triangles, probe).run();
    }
    clock.lap(Stage::Setup);
    return leftOut;
}

/// True if the batch need not be set up, because all of its triangles are culled as back faces; their fates are told then.
template <class Rules, class Probe>
bool isCulledAsBack(const BatchPlace& place, const BackFaces& backs, const PlacedView& view, const Stripe& stripe, const Rules&, const Probe& probe)
{
    if (!Rules::kExact || stripe.culling != FaceCulling::Back || !place.batch.cone.promises()) return false;
    if (!backs.hold(place.batch.cone, view(place.batch.bounds))) return false;
    if constexpr (Probe::listens)
        for (std::uint32_t t = 0; t < place.batch.triangleCount; ++t)
            probe(TriangleSetUp{place.idOf(place.batch.firstTriangle + t), SetUp::BackFacing, false, false});
    return true;
}

/// Calls visit(instance, batch, toWorld) for every batch that may reach the stripe; the batches of a mesh are
/// `batchesOf(mesh)`, `batch` is an index into them, `toWorld` nullptr for the identity.
template <class BatchesOf, class Visit, class Rules, class Probe>
void visitBatches(const Stripe& stripe, StageClock& clock, const BatchesOf& batchesOf, const Visit& visit, const Rules& rules, const Probe& probe)
{
    const Scene&       scene = stripe.scene.scene();
    const StripeVolume volume(stripe.projection, stripe.visible.width(), stripe.firstRow, stripe.endRow);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        if (stripe.progress.cancelled()) return;
        const Instance&    instance = scene.instances[i];
        const MeshBatches& mesh     = batchesOf(instance.mesh);
        const PlacedView   placed(stripe.projection, instance.toWorld);
        const auto         all = static_cast<std::uint32_t>(mesh.triangleCount());
        probe(TransparentLeftOut{InstanceId{i}, static_cast<std::uint32_t>(scene.meshOf(InstanceId{i}).triangles.size()) - all});
        StripeVolume::Planes open = StripeVolume::kAll;
        if (volume.misses(placed(mesh.bounds), open)) {
            probe(BatchOutside{InstanceId{i}, all});
            continue;
        }
        const Affine*   toWorld = instance.toWorld.isIdentity() ? nullptr : &instance.toWorld;
        const BackFaces backs(placed, stripe.projection);
        for (std::uint32_t b = 0; b < mesh.batches.size(); ++b) {
            if (stripe.progress.cancelled()) return;
            StripeVolume::Planes asked = open;
            if (open != 0 && mesh.batches.size() > 1 && volume.misses(placed(mesh.batches[b].bounds), asked)) {
                probe(BatchOutside{InstanceId{i}, mesh.batches[b].triangleCount});
                continue;
            }
            if (probe.leavesOut(Checkpoint::Batch)) continue;
            const BatchPlace place{mesh, mesh.batches[b], toWorld, scene.firstTriangle[i]};
            const bool       isBack = isCulledAsBack(place, backs, placed, stripe, rules, probe);
            clock.lap(Stage::Cull);
            if (!isBack) visit(InstanceId{i}, b, toWorld);
        }
    }
    clock.lap(Stage::Cull);
}

/// Hands the screen triangles of every batch that may reach the stripe to `consume(triangles)`; the batches of a mesh are
/// `batchesOf(mesh)`.
template <class BatchesOf, class Consume, class Rules, class Probe>
void visitTriangles(const BatchesOf& batchesOf, const Stripe& stripe, StripeScratch& scratch, StageClock& clock,
                    const Consume& consume, const Rules& rules, const Probe& probe)
{
    const Scene& scene = stripe.scene.scene();
    const auto   visit = [&](InstanceId instance, std::uint32_t b, const Affine* toWorld) {
        const MeshBatches& mesh = batchesOf(scene.instances[instance.value].mesh);
        setUpBatch(BatchPlace{mesh, mesh.batches[b], toWorld, scene.firstTriangle[instance.value]}, instance, stripe, scratch, clock, rules, probe);
        consume(scratch.triangles);
    };
    visitBatches(stripe, clock, batchesOf, visit, rules, probe);
}

/// The same for the opaque triangles.
template <class Consume, class Rules, class Probe>
void visitAsSubmitted(const Stripe& stripe, StripeScratch& scratch, StageClock& clock, const Consume& consume,
                      const Rules& rules, const Probe& probe)
{
    const auto batchesOf = [&](MeshId mesh) -> const MeshBatches& { return stripe.scene.batchesOf(mesh); };
    visitTriangles(batchesOf, stripe, scratch, clock, consume, rules, probe);
}

/// Hands the faces that may reach the stripe, as they were read, to `consume(face, sides)`, and those that are triangles or
/// drawn as such to `consume(triangle)`.
template <class Consume, class Rules, class Probe>
void visitFacesAsSubmitted(const Stripe& stripe, StripeScratch& scratch, StageClock& clock, const Consume& consume,
                           const Rules& rules, const Probe& probe)
{
    const Scene&      scene = stripe.scene.scene();
    const SceneFaces& faces = facesOf(stripe.scene);
    clock.lap(Stage::Build);
    const auto batchesOf = [&](MeshId mesh) -> const MeshBatches& { return faces.of(mesh).points; };
    const auto visit     = [&](InstanceId instance, std::uint32_t b, const Affine* toWorld) {
        const FacePlace place{faces.of(scene.instances[instance.value].mesh), b, toWorld, scene.firstTriangle[instance.value]};
        const bool      fits = place.points().vertexCount <= kBatchVertices;  // a single face may have more
        if (fits) transformBatch(place.mesh.points, place.points(), toWorld, stripe.projection, rules, scratch.vertices);
        probe(BatchTransformed{instance, place.points().vertexCount});
        clock.lap(Stage::Transform);
        FaceSetUp faceSetUp(place, stripe.projection, stripe.culling, stripe.region(), scratch.faces, consume, rules, probe);
        if (fits && scratch.vertices.plain)
            faceSetUp.plainly(scratch.vertices);
        else
            faceSetUp.carefully();
        clock.lap(Stage::Setup);
    };
    visitBatches(stripe, clock, batchesOf, visit, rules, probe);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_SUBMITTED_INL_H
