// "Why this pixel" and "why is this triangle missing": the frame runs once more, by plain text, and
// recorders note what becomes of the triangles concerned.
//
// Promise    the winner is the picture's; the list holds every triangle that covers the pixel by the definition, and
//            what the run tested there besides. The steps named are those of Replay for the same request
// Cost       one run for any number of pixels; the definition's walk over the instances that can reach one of them;
//            memory per triangle that meets a pixel, not per triangle of the scene
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/frame/renderer.h"
#include "core/lesson/explanation.h"

namespace zscope {

struct ObservedMethod;  // core/frame/observed_run.h

/// One answer per pixel, in their order; repeats allowed. Errors: Usage (a pixel outside the picture, what the renderer
/// refuses), Limit, Cancelled. `method` is explained in place of the pipeline's.
Result<std::vector<PixelExplanation>> explainPixels(const DrawRequest& request, std::span<const PixelPosition> pixels,
                                                    const Progress&       progress = {},
                                                    const ObservedMethod* method   = nullptr);
Result<PixelExplanation> explainPixel(const DrawRequest& request, PixelPosition pixel, const Progress& progress = {});
/// Errors likewise; Usage also if the scene has no such triangle.
Result<TriangleExplanation> explainTriangle(const DrawRequest& request, TriangleId triangle,
                                            const Progress& progress = {}, const ObservedMethod* method = nullptr);

std::string explanationToJson(const PixelExplanation& explanation);
std::string explanationToJson(const TriangleExplanation& explanation);
/// For reading: a line per triangle and its events below it.
std::string explanationToText(const PixelExplanation& explanation);
std::string explanationToText(const TriangleExplanation& explanation);

}  // namespace zscope
