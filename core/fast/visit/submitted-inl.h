// Order "as submitted": instance after instance in load order, batch after batch, triangle after triangle
// (core/geometry/batches.h says in which order the triangles of a large mesh stand).
//
// Promise    skips only what cannot touch a pixel centre of the stripe (StripeVolume)
// Cost       five planes per instance, per batch those that the instance crosses and a cone of normals, at full speed
//            those of its patches, too, and their places on the screen where the batch crosses the stripe's border;
//            transform and set-up of what is left
#if defined(ZSCOPE_SUBMITTED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_SUBMITTED_INL_H
#undef ZSCOPE_SUBMITTED_INL_H
#else
#define ZSCOPE_SUBMITTED_INL_H
#endif

#include <bit>
#include <cstdint>
#include <optional>

#include "core/fast/hidden_squares/hidden_squares-inl.h"
#include "core/fast/lanes/set_up-inl.h"
#include "core/fast/lanes/transform-inl.h"
#include "core/fast/patches/patches-inl.h"
#include "core/fast/skipped_questions/sampled_questions.h"
#include "core/fast/stripe_scratch.h"
#include "core/fast/two_level_pyramid/wide_pyramid-inl.h"
#include "core/geometry/stripe_volume.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// Pixels of a batch's reach that are worth a look for each of its triangles.
inline constexpr std::uint64_t kWorthLooking = 16;

/// The vertices of some patches are transformed by themselves if that leaves out one in so many of their batch's.
inline constexpr std::size_t kWorthChoosing = 8;

/// Of vertices that may lie anywhere.
inline constexpr ScreenVertices::Reach kAnyReach{-ScreenVertices::kNowhere / 2, -ScreenVertices::kNowhere / 2,
                                                 ScreenVertices::kNowhere / 2, ScreenVertices::kNowhere / 2};

/// Where the vertices of patches lie whose pixels lie in the box, as PatchReach finds it in the region.
inline ScreenVertices::Reach reachAround(const PixelBox& box, const PixelBox& region)
{
    // A box that may have been cut at the region's edge says nothing of what lies beyond. Else they lie between the
    // centres before its first pixels and behind its last.
    if (box.x0 <= region.x0 || box.y0 <= region.y0 || box.x1 >= region.x1 || box.y1 >= region.y1) return kAnyReach;
    return {256 * box.x0 - 128, 256 * box.y0 - 128, 256 * box.x1 + 128, 256 * box.y1 + 128};
}

/// What of a batch may be seen, asked before any of its vertices is transformed.
struct BatchSeen {
    PatchBits             patches;
    HiddenPart            hidden;             // Squares: they are known of these patches
    LeftOut               leftOut;            // patches, because nothing of them can be seen
    ScreenVertices::Reach reach = kAnyReach;  // of the patches' vertices
};

/// The same of patches with so many pixels that the pyramid is asked about them, one by one if that is often answered
/// with "hidden".
inline BatchSeen seenOfLarge(const PatchReach& reach, const WidePyramid& pyramid, SampledQuestions& questions)
{
    BatchSeen  seen{reach.patches(), HiddenPart::Nothing, {}};
    const auto leaveOut = [&seen](PatchBits patches, const PixelBox& pixels) {
        seen.patches &= ~patches;
        seen.leftOut.triangles += static_cast<std::uint32_t>(std::popcount(patches)) * kPatchTriangles;
        seen.leftOut.pixels += pixels.area();
    };
    if (!questions.isWorthIt()) return seen;
    if (pyramid.hides(reach.pixels(), reach.nearest(), WholeBox{})) {
        leaveOut(reach.patches(), reach.pixels());
        questions.answered(true);
        return seen;
    }
    for (PatchBits left = reach.patches(); left != 0; left &= left - 1) {
        const auto patch  = static_cast<std::size_t>(std::countr_zero(left));
        const bool hidden = pyramid.hides(reach.pixelsOf(patch), reach.nearestOf(patch), WholeBox{});
        if (hidden) leaveOut(PatchBits{1} << patch, reach.pixelsOf(patch));
        questions.answered(hidden);
    }
    return seen;
}

/// Leaves the squares that are hidden of the batch in `scratch.hidden`.
inline BatchSeen seenOf(const BatchPlace& place, const PlacedView& view, const Stripe& stripe, StripeScratch& scratch,
                        SampledQuestions& patchQuestions)
{
    const PatchReach reach(place.mesh, place.batch, place.patches, view, stripe.projection, stripe.region());
    const auto       triangles = [](PatchBits patches) {
        return static_cast<std::uint32_t>(std::popcount(patches)) * kPatchTriangles;
    };
    if (reach.patches() == 0) return {0, HiddenPart::Nothing, {}};
    const std::uint64_t pixels = reach.pixels().area();
    if (pixels > kWorthLooking * triangles(reach.patches()))
        return seenOfLarge(reach, WidePyramid(scratch.pyramid), patchQuestions);
    const HiddenPart part = HiddenSquaresFinder::find(stripe.visible, reach.pixels(), reach.nearest(), scratch.hidden);
    if (part == HiddenPart::Everything) return {0, part, {triangles(reach.patches()), pixels}};
    const ScreenVertices::Reach around = reachAround(reach.pixels(), stripe.region());
    if (part == HiddenPart::Nothing) return {reach.patches(), part, {}, around};
    const PatchBits hidden = reach.hiddenAmong(HiddenBoxes(scratch.hidden));
    LeftOut         leftOut{triangles(hidden), 0};
    for (PatchBits left = hidden; left != 0; left &= left - 1)
        leftOut.pixels += reach.pixelsOf(static_cast<std::size_t>(std::countr_zero(left))).area();
    return {reach.patches() & ~hidden, part, leftOut, around};
}

/// How many triangles of the batch set-up looks at: whole patches of them.
inline std::uint64_t trianglesIn(const BatchPlace& place)
{
    const PatchBits patches = place.patches & place.batch.patches();
    return std::min<std::uint64_t>(place.batch.triangleCount,
                                   kPatchTriangles * static_cast<std::uint64_t>(std::popcount(patches)));
}

/// Transforms one batch and leaves its screen triangles in `scratch.triangles`.
inline void setUpBatch(const BatchPlace& place, const Stripe& stripe, StripeScratch& scratch, StageClock& clock,
                       const LaneRules& rules)
{
    const std::uint64_t groups =
        place.patches == kAllPatches ? ~std::uint64_t{0} : vertexGroupsOf(place.mesh, place.batch, place.patches);
    if (kWorthChoosing * kVertexGroup * static_cast<std::size_t>(std::popcount(groups))
        > (kWorthChoosing - 1) * place.batch.vertexCount)
        transformBatch(place.mesh, place.batch, place.toWorld, stripe.projection, rules, scratch.vertices);
    else
        transformGroups(place.mesh, place.batch, groups, place.toWorld, stripe.projection, rules, scratch.vertices);
    clock.lap(Stage::Transform);
    scratch.tally.add(Unit::Batches);
    scratch.tally.add(Unit::Vertices, place.batch.vertexCount);
    scratch.tally.add(Unit::TrianglesSetUp, trianglesIn(place));
    scratch.triangles.clear();
    BatchSetUp(place, scratch.vertices, stripe.projection, stripe.culling, stripe.region(), rules, scratch.triangles)
        .run();
    clock.lap(Stage::Setup);
}

/// The same at full speed, but for what can win no pixel any more, because all of its pixels hold something nearer than
/// the batch comes, or its patch. The pyramid is a wide one; corners stand and depths are stored as the definition
/// says.
inline LeftOut setUpSeen(const BatchPlace& whole, const PlacedView& view, const Stripe& stripe, StripeScratch& scratch,
                         SampledQuestions& patchQuestions, StageClock& clock, const LaneRules& rules)
{
    scratch.triangles.clear();
    BatchSeen seen = seenOf(whole, view, stripe, scratch, patchQuestions);
    clock.lap(Stage::Setup);
    if (seen.patches == 0) return seen.leftOut;

    BatchPlace place = whole;
    place.patches    = seen.patches;
    transformGroups(place.mesh, place.batch, vertexGroupsOf(place.mesh, place.batch, place.patches), place.toWorld,
                    stripe.projection, rules, scratch.vertices, KnownReach{seen.reach});
    clock.lap(Stage::Transform);
    scratch.tally.add(Unit::Batches);
    scratch.tally.add(Unit::Vertices, place.batch.vertexCount);
    scratch.tally.add(Unit::TrianglesSetUp, trianglesIn(place));
    const PixelBox region = stripe.region();
    if (seen.hidden == HiddenPart::Squares) {
        const LeftOut more = BatchSetUp(place, scratch.vertices, stripe.projection, stripe.culling, region, rules,
                                        scratch.triangles, HiddenBoxes(scratch.hidden))
                                 .run();
        seen.leftOut.triangles += more.triangles, seen.leftOut.pixels += more.pixels;
    } else {
        BatchSetUp(place, scratch.vertices, stripe.projection, stripe.culling, region, rules, scratch.triangles).run();
    }
    clock.lap(Stage::Setup);
    return seen.leftOut;
}

/// True if the batch need not be set up, because all of its triangles are culled as back faces.
inline bool isCulledAsBack(const BatchPlace& place, const BackFaces& backs, const PlacedView& view,
                           const Stripe& stripe, const LaneRules& rules)
{
    return stripe.shortcuts.has(Shortcut::FacingCones) && !rules.movesCorners() && stripe.culling == FaceCulling::Back
           && backs.mayHold(place.batch.cone) && backs.hold(place.batch.cone, view(place.batch.bounds));
}

/// The patches of the batch that may show a front, if back faces are culled; none of a batch that is seen from behind
/// as a whole.
inline PatchBits patchesTowardsEye(const BatchPlace& place, const BackFaces& backs, const PlacedView& view,
                                   const Stripe& stripe)
{
    const bool hasPatches = !place.mesh.patches.empty();
    if (!stripe.shortcuts.has(Shortcut::FacingCones)) return kAllPatches;
    if (stripe.culling != FaceCulling::Back || !(hasPatches || backs.mayHold(place.batch.cone))) return kAllPatches;
    const std::optional<BehindQuestion> asked = backs.question(view(place.batch.bounds));
    if (!asked) return kAllPatches;
    if (asked->holdsOf(place.batch.cone)) return 0;
    return hasPatches ? towardsEye(place.mesh, place.batch, *asked) : kAllPatches;
}

/// Those that are to be set up, of a batch that crosses the stripe's border or does not.
inline PatchBits patchesWanted(const BatchPlace& place, const BackFaces& backs, const PlacedView& view,
                               const Stripe& stripe, bool crossesBorder, const LaneRules& rules)
{
    if (rules.movesCorners()) return kAllPatches;
    const PatchBits wanted    = patchesTowardsEye(place, backs, view, stripe);
    const bool      asksReach = crossesBorder && stripe.shortcuts.has(Shortcut::PatchReach);
    if (!asksReach || wanted == 0 || place.mesh.patches.empty()) return wanted;
    return PatchReach(place.mesh, place.batch, wanted, view, stripe.projection, stripe.region()).patches();
}

/// Calls visit(instance, batch, toWorld, patches) for every batch of which `patches` may reach the stripe; the batches
/// of a mesh are `batchesOf(mesh)`, `batch` is an index into them, `toWorld` nullptr for the identity.
template <class BatchesOf, class Visit>
void visitBatches(const Stripe& stripe, StageClock& clock, const BatchesOf& batchesOf, const Visit& visit,
                  const LaneRules& rules)
{
    const Scene&       scene = stripe.scene.scene();
    const StripeVolume volume(stripe.projection, stripe.visible.width(), stripe.firstRow, stripe.endRow);
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        if (stripe.progress.cancelled()) return;
        const Instance&      instance = scene.instances[i];
        const MeshBatches&   mesh     = batchesOf(instance.mesh);
        const PlacedView     placed(stripe.projection, instance.toWorld);
        StripeVolume::Planes open = StripeVolume::kAll;
        if (volume.misses(placed(mesh.bounds), open)) continue;
        const Affine*   toWorld = instance.toWorld.isIdentity() ? nullptr : &instance.toWorld;
        const BackFaces backs(placed, stripe.projection, instance.toWorld.isMirrored());
        for (std::uint32_t b = 0; b < mesh.batches.size(); ++b) {
            if (stripe.progress.cancelled()) return;
            StripeVolume::Planes asked = open;
            if (open != 0 && mesh.batches.size() > 1 && volume.misses(placed(mesh.batches[b].bounds), asked)) continue;
            const BatchPlace place{mesh, mesh.batches[b], toWorld, scene.firstTriangle[i]};
            const PatchBits  patches = patchesWanted(place, backs, placed, stripe, asked != 0, rules);
            clock.lap(Stage::Cull);
            if (patches != 0) visit(InstanceId{i}, b, toWorld, patches);
        }
    }
    clock.lap(Stage::Cull);
}

/// Hands the screen triangles of every batch that may reach the stripe to `consume(triangles)`; the batches of a mesh
/// are `batchesOf(mesh)`.
template <class BatchesOf, class Consume>
void visitTriangles(const BatchesOf& batchesOf, const Stripe& stripe, StripeScratch& scratch, StageClock& clock,
                    const Consume& consume, const LaneRules& rules)
{
    const Scene& scene = stripe.scene.scene();
    const auto   visit = [&](InstanceId instance, std::uint32_t b, const Affine* toWorld, PatchBits patches) {
        const MeshBatches& mesh = batchesOf(scene.instances[instance.value].mesh);
        setUpBatch(BatchPlace{mesh, mesh.batches[b], toWorld, scene.firstTriangle[instance.value], patches}, stripe,
                     scratch, clock, rules);
        consume(scratch.triangles);
    };
    visitBatches(stripe, clock, batchesOf, visit, rules);
}

/// Batches that stand patch by patch, where back faces are culled; else nullptr.
inline const PatchedBatches* patchedFor(const Stripe& stripe, const LaneRules& rules)
{
    const bool areWanted = stripe.shortcuts.has(Shortcut::PatchedBatches) && !rules.movesCorners();
    return areWanted && stripe.culling == FaceCulling::Back ? &patchedBatchesOf(stripe.scene) : nullptr;
}

/// visitTriangles() of the opaque ones.
template <class Consume>
void visitAsSubmitted(const Stripe& stripe, StripeScratch& scratch, StageClock& clock, const Consume& consume,
                      const LaneRules& rules)
{
    const PatchedBatches* patched   = patchedFor(stripe, rules);
    const auto            batchesOf = [&](MeshId mesh) -> const MeshBatches& {
        return patched ? patched->of(mesh) : stripe.scene.batchesOf(mesh);
    };
    visitTriangles(batchesOf, stripe, scratch, clock, consume, rules);
}

/// Hands the faces that may reach the stripe, as they were read, to `consume(face, sides)`, and those that are
/// triangles or drawn as such to `consume(triangle)`; of a mesh whose faces are triangles all, to `consume(triangles)`,
/// batch by batch.
template <class Consume>
void visitFacesAsSubmitted(const Stripe& stripe, StripeScratch& scratch, StageClock& clock, const Consume& consume,
                           const LaneRules& rules)
{
    const Scene&          scene       = stripe.scene.scene();
    const SceneFaces&     faces       = facesOf(stripe.scene);
    const bool            byTriangles = faces.someAreTriangles();
    const PatchedBatches* patched     = byTriangles ? patchedFor(stripe, rules) : nullptr;
    clock.lap(Stage::Build);
    const auto areTriangles = [&](MeshId mesh) { return byTriangles && faces.of(mesh).areTriangles(); };
    const auto batchesOf    = [&](MeshId mesh) -> const MeshBatches& {
        return !areTriangles(mesh) ? faces.of(mesh).points : patched ? patched->of(mesh) : stripe.scene.batchesOf(mesh);
    };
    const auto visit = [&](InstanceId instance, std::uint32_t b, const Affine* toWorld, PatchBits patches) {
        const MeshId mesh = scene.instances[instance.value].mesh;
        if (areTriangles(mesh)) {
            const MeshBatches& triangles = batchesOf(mesh);
            setUpBatch(
                BatchPlace{triangles, triangles.batches[b], toWorld, scene.firstTriangle[instance.value], patches},
                stripe, scratch, clock, rules);
            consume(scratch.triangles);
            return;
        }
        const FacePlace place{faces.of(mesh), b, toWorld, scene.firstTriangle[instance.value]};
        const bool      fits = place.points().vertexCount <= kBatchVertices;  // a single face may have more
        if (fits)
            transformBatch(place.mesh.points, place.points(), toWorld, stripe.projection, rules, scratch.vertices);
        scratch.tally.add(Unit::Batches);
        scratch.tally.add(Unit::Vertices, place.points().vertexCount);
        scratch.tally.add(Unit::TrianglesSetUp, place.points().triangleCount);
        clock.lap(Stage::Transform);
        FaceSetUp faceSetUp(place, stripe.projection, stripe.culling, stripe.region(), scratch.faces, consume, rules,
                            NoReport());
        if (fits && scratch.vertices.plain)
            faceSetUp.plainly(scratch.vertices);
        else
            faceSetUp.carefully();
        clock.lap(Stage::Setup);
    };
    visitBatches(stripe, clock, batchesOf, visit, rules);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_SUBMITTED_INL_H
