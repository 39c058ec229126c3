// A frame drawn by one thread over one stripe, with a probe: the serial driver around the same kernels that draw at
// full speed. A probe that stops unwinds through here.
//
// Measured   what chooses by measuring is drawn by its first choice: see repeatable()
// Coherence  a method that takes something over from the frame before has that frame drawn first, unobserved
// Promise    a run that is not stopped leaves the very picture that Renderer::draw() makes
#if defined(ZSCOPE_SERIAL_RUN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_SERIAL_RUN_INL_H
#undef ZSCOPE_SERIAL_RUN_INL_H
#else
#define ZSCOPE_SERIAL_RUN_INL_H
#endif

#include <optional>

#include "core/base/memory.h"
#include "core/frame/blend-inl.h"
#include "core/frame/drivers-inl.h"
#include "core/frame/frame_plan.h"
#include "core/frame/kernels.h"
#include "core/frame/renderer.h"
#include "core/probe/probe.h"
#include "core/shade/shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// Of a picture that is background so far.
inline Painter painterOf(const DrawRequest& request, Frame& frame)
{
    frame.colour.reset(request.camera.width, request.camera.height, kBackgroundColour);
    return {request.scene->scene(), coloursOf(*request.scene), frame.colour.view(),
            operationsOf(request.pipeline.cost)};
}

inline void shadeWhole(const DrawRequest& request, Frame& frame)
{
    shadeRows(painterOf(request, frame), frame.visible, 0, request.camera.height);
}

/// What a method with coherence takes over from the frame before: one of the same request, so that the run that follows
/// depends on its inputs only.
inline void drawUnobserved(const DrawRequest& request, const Stripe& whole, StripeScratch& scratch, StageClock& clock)
{
    if (request.pipeline.usesExactRules())
        return kernelsOf(resolved(Simd::Auto)).drawStripe(request.pipeline, whole, scratch, clock);
    const ChosenRules rules(request.pipeline.approximation, request.pipeline.fault, request.camera);
    drawStripeByRulesOf(resolved(Simd::Auto))(request.pipeline, rules, whole, scratch, clock);
}

/// `frame` and `scratch` stay as the run left them, finished or not.
template <class Probe>
void runSerially(const DrawRequest& asked, Frame& frame, StripeScratch& scratch, const Probe& probe)
{
    const DrawRequest request = repeatable(asked);
    const Camera&     camera  = request.camera;
    const Projection  projection(camera);
    frame.visible.resize(camera.width, camera.height, {request.pipeline.approximation.format, camera.near, camera.far});
    frame.visible.clearRows(0, camera.height);

    const bool             withFragments = request.shade && shadesFragments(request.pipeline.depth);
    std::optional<Painter> painter;
    if (withFragments) painter.emplace(painterOf(request, frame));
    StageClock   clock;
    const Stripe whole{*request.scene,
                       projection,
                       request.faceCulling,
                       frame.visible,
                       0,
                       camera.height,
                       {.report = {}, .cancel = request.cancel},
                       painter ? &*painter : nullptr,
                       effectiveMemoryLimit(request.memoryLimit)};
    if (request.pipeline.coherence != Coherence::None && !probe.isOnTheWay())
        drawUnobserved(request, whole, scratch, clock);
    if (request.pipeline.usesExactRules())
        drawStripe(request.pipeline, whole, scratch, clock, ExactRules{}, probe);
    else
        drawStripe(request.pipeline, whole, scratch, clock,
                   ChosenRules(request.pipeline.approximation, request.pipeline.fault, camera), probe);
    const TransparentSurfaces* surfaces = toBeBlended(request);
    if (request.shade && (!withFragments || surfaces)) {
        probe(StageStarted{Stage::Shade});
        if (!withFragments) shadeWhole(request, frame);
        if (surfaces)
            blendStripe(*surfaces, coloursOf(*request.scene), request.pipeline.transparency, rulesOfBlending(request),
                        whole, scratch, clock, frame.colour.view(), probe);
        probe(StageFinished{Stage::Shade});
    }
    probe(FrameFinished{});
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_SERIAL_RUN_INL_H
