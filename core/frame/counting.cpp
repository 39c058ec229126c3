// Counting: the frame again, serially, with the work recorder as its only listener.
#define HWY_COMPILE_ONLY_SCALAR

#include "core/frame/serial_run-inl.h"
#include "core/frame/work_recorder.h"

namespace zscope {

Result<FrameWork> Renderer::count(const DrawRequest& request)
{
    const Result<FramePlan> plan = planFrame(request);
    if (!plan) return plan.error();
    try {
        Frame         frame;
        StripeScratch scratch;
        WorkRecorder  work(request.scene->scene());
        DrawRequest   cheaply = request;  // which fragments are shaded does not depend on what that costs
        cheaply.pipeline.cost = ShadingCost::None;
        cheaply.shade         = shadesFragments(request.pipeline.depth) || toBeBlended(request);
        HWY_STATIC_DISPATCH(runSerially)(cheaply, frame, scratch, Listening(work));
        if (request.cancel && request.cancel->load()) return Error{Trouble::Cancelled, "counting was cancelled"};
        if (!shadesFragments(request.pipeline.depth)) work.shadedOnce(frame.visible);
        return work.work();
    } catch (const std::bad_alloc&) {
        return Error{Trouble::Limit, "there is not enough memory to count this frame"};
    }
}

}  // namespace zscope
