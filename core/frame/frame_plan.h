// What is decided before a frame is drawn: whether the request can be met at all, with how many threads and lanes,
// and which stages the frame needs.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/frame/renderer.h"
#include "core/geometry/rules.h"
#include "core/geometry/transparent_surfaces.h"
#include "core/shade/colour_table.h"

namespace zscope {

struct FramePlan {
    int  threads = 1;
    Simd simd    = Simd::Scalar;
};

/// Errors: Usage (composition, SIMD target, thread count), Limit (memory).
Result<FramePlan> planFrame(const DrawRequest& request);

/// The request that stands for this one in a run that must depend on its inputs only: a measured choice becomes the
/// first one, which nothing has been measured for. Others stay as they are.
DrawRequest repeatable(const DrawRequest& request);

struct StageReason {
    bool        runs;
    std::string why;  // one clause
};
StageReason reasonFor(Stage stage, const DrawRequest& request);

/// Whether the frame, at full speed, draws batches that stand patch by patch (PatchedBatches).
bool drawsPatchedBatches(const DrawRequest& request);

/// Whether the frame is drawn by the plain text of core/method and core/plain: so it is with one lane.
bool isPlain(const DrawRequest& request);

/// How the frame's depths are stored at full speed: where nothing but the triangles' own depths is compared, above the
/// last picture of `visible`, so that what that left need not be emptied (core/base/depth_format.h).
DepthEncoding encodingOf(const DrawRequest& request, const VisibilityBuffer& visible);

/// From the world to the picture, by the rules.
Projection projectionOf(const DrawRequest& request, const ChosenRules& rules, double depthScale = 1);

/// The scene's transparent surfaces if this frame blends them: it is shaded, and there are any; else nullptr.
const TransparentSurfaces* toBeBlended(const DrawRequest& request);
/// The rules they are drawn by: the request's approximations, as far as a sweep can follow them, and no fault.
ChosenRules rulesOfBlending(const DrawRequest& request);

/// The scene's colours, made on the first frame that shades.
const ColourTable& coloursOf(const PreparedScene& scene);

}  // namespace zscope
