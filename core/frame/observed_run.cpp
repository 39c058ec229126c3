#include "core/frame/observed_run.h"

#include <optional>

#include "core/base/memory.h"
#include "core/fast/kernels.h"
#include "core/frame/frame_events.h"
#include "core/frame/frame_plan.h"
#include "core/frame/plain_stripe.h"
#include "core/geometry/displacement.h"
#include "core/plain/shading.h"
#include "core/plain/work.h"

namespace zscope {

namespace {

/// Of a picture that is background so far.
Painter painterOf(const DrawRequest& request, Frame& frame)
{
    frame.colour.reset(request.camera.width, request.camera.height, kBackgroundColour);
    return {request.scene->scene(), coloursOf(*request.scene), frame.colour.view(),
            operationsOf(request.pipeline.cost)};
}

}  // namespace

void shadePicture(const DrawRequest& request, Frame& frame)
{
    const Painter painter = painterOf(request, frame);
    Tally         uncounted;
    if (const Kernels* kernels = kernelsOf(resolved(Simd::Auto)))
        kernels->shadeRows(painter, frame.visible, 0, request.camera.height);
    else
        plain::shadeLines(painter, frame.visible, 0, request.camera.height, uncounted);
}

void drawObserved(const DrawRequest& asked, Frame& frame, plain::Scratch& scratch, Observer& observer,
                  FrameBefore before)
{
    const DrawRequest request  = repeatable(asked);
    const Pipeline&   pipeline = request.pipeline;
    const Camera&     camera   = request.camera;
    const ChosenRules rules(pipeline.approximation, pipeline.fault, camera);
    const Projection  projection = projectionOf(request, rules);
    frame.visible.resize(camera.width, camera.height, {pipeline.approximation.format, camera.near, camera.far});
    frame.visible.clearRows(0, camera.height);

    const bool             withFragments = request.shade && shadesFragments(pipeline.depth);
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
    Tally        tally;
    plain::Work  work{whole, rules, scratch, clock, tally};
    const bool   takesOver = pipeline.coherence != Coherence::None && before == FrameBefore::Drawn;
    if (takesOver && !observer.isOnTheWay()) drawPlainly(pipeline, work);
    work.observer = &observer;
    drawPlainly(pipeline, work);

    const TransparentSurfaces* surfaces = toBeBlended(request);
    if (request.shade && (!withFragments || surfaces)) {
        work.tell(StageStarted{Stage::Shade});
        if (!withFragments) shadePicture(request, frame);
        if (surfaces) {
            const ChosenRules blendRules = rulesOfBlending(request);
            plain::Scratch    blending;  // the edge table of the opaque picture stays
            plain::Work       blend{whole, blendRules, blending, clock, tally, &observer};
            blendPlainly(*surfaces, coloursOf(*request.scene), pipeline.transparency, blend, frame.colour.view());
        }
        work.call = SourceLine::here();
        work.tell(StageFinished{Stage::Shade});
    }
    work.call = SourceLine::here();
    work.tell(FrameFinished{});
}

}  // namespace zscope
