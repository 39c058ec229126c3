// The transparent pass: after a stripe's opaque pixels have their colours, its transparent surfaces are blended over
// them.
//
// Idea       the same sweep as the scanline algorithm, over the transparent triangles only; each line's fragments are
//            put in order and blended (core/sweep/blend_line.h)
// Runs       only in a scene that has transparent triangles, and only in a frame that is shaded
// Promise    ids and depth are not touched; with BlendOrder::Sorted a pixel's colour depends on nothing but the
//            surfaces there
// Cost       that of a scanline frame of these triangles, and sorting the fragments of each pixel
#if defined(ZSCOPE_BLEND_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_BLEND_INL_H
#undef ZSCOPE_BLEND_INL_H
#else
#define ZSCOPE_BLEND_INL_H
#endif

#include "core/fast/lanes/enter_edges-inl.h"
#include "core/fast/lanes/sweep-inl.h"
#include "core/fast/visit/submitted-inl.h"
#include "core/frame/pipeline.h"
#include "core/geometry/transparent_surfaces.h"
#include "core/shade/colour_table.h"
#include "core/sweep/blend_line.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// Enters each transparent triangle of a batch in the edge table, with its paint.
struct EnterTransparent {
    const Scene&       scene;
    const ColourTable& colours;
    BlendScratch&      scratch;

    void operator()(const TriangleList& triangles) const
    {
        EdgeEntry{scratch.edges}(triangles);
        for (std::size_t i = 0; i < triangles.count; ++i) scratch.paints.push_back(paintOf(triangles[i]));
    }

private:
    Paint paintOf(const ScreenTriangle& part) const
    {
        const TriangleId    id       = part.id;
        const InstanceId    instance = scene.instanceOf(id);
        const Mesh&         mesh     = scene.meshOf(instance);
        const std::uint32_t triangle = id.value - scene.firstTriangle[instance.value];
        return {colours.isComplete() ? colours.data()[id.value + 1] : colourOf(scene, instance, triangle),
                mesh.materialOf(mesh.trianglePolygon[triangle]).opacity,
                part.counterClockwise != scene.instances[instance.value].toWorld.isMirrored()};
    }
};

/// Blends the stripe's transparent surfaces over `colour`.
inline void blendStripe(const TransparentSurfaces& surfaces, const ColourTable& colours, BlendOrder order,
                        const LaneRules& rules, const Stripe& stripe, StripeScratch& scratch, StageClock& clock,
                        GridView<std::uint32_t> colour)
{
    BlendScratch& blend = scratch.blend;
    blend.edges.clear(stripe.firstRow, stripe.endRow, stripe.visible.width(),
                      stripe.shortcuts.has(Shortcut::SharedSides) ? EdgeTable::Sides::OfWide : EdgeTable::Sides::All,
                      stripe.memory);
    blend.paints.clear();
    clock.countAllAs(Stage::Shade);
    Tally       ofSweep;  // what is counted is the blending, not the sweep beneath it
    const Tally before    = scratch.tally;
    const auto  batchesOf = [&surfaces](MeshId mesh) -> const MeshBatches& { return surfaces.of(mesh); };
    visitTriangles(batchesOf, stripe, scratch, clock, EnterTransparent{stripe.scene.scene(), colours, blend}, rules);
    blend.edges.fillBuckets();
    scratch.tally = before;
    BlendLine resolve(stripe.visible, colour, order, blend, rules, scratch.tally);
    sweep(blend.edges, blend.active, blend.polygons, resolve, stripe.progress, ofSweep);
    clock.lap(Stage::Shade);
    clock.countAllAs(std::nullopt);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_BLEND_INL_H
