// Times algorithms along a camera path: every frame is verified first, then timed, then counted.
//
// Verified   frame after frame, by all algorithms, each with a renderer that has drawn the frames before: what a method
//            takes over from the frame before is judged where it is used. The row's wrong pixels and figures are those
//            of all frames together
// Timed      the whole path in turn, algorithm after algorithm, as many passes as asked for; before each pass the first
//            frame is drawn a few times, so that a pass begins like the others and no trial of a measured choice is
//            timed at its start
// Row        quantiles over all timed frames; stages of the median frame; counters: the mean over the frames; roundMs:
//            the median frame of each pass; `series`: frame by frame
// Memory     one renderer per run, all alive; one reference picture
#pragma once

#include <vector>

#include "core/measure/bench.h"

namespace zscope {

struct PathRequest {
    std::vector<Camera> cameras;    // at least one, all of one size
    std::vector<int>    cuts = {};  // rising places in `cameras`
};

/// Of `request` the camera and `frames` are not used; `rounds` are the passes. Errors: as bench().
Result<std::vector<BenchRow>> benchPath(const BenchRequest& request, const PathRequest& path);

}  // namespace zscope
