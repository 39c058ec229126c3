// What may have gone wrong in another renderer: the mistakes of the fault gallery and the approximations of numbers,
// and which wrong pixels each of them makes in this view.
//
// Name       a fault by its word ("x-truncated"), an approximation as axis=choice ("depth-format=fixed-16")
// Pairs      two of them at once: "x-truncated + box-short"
// Drawn      by the presets in which the mistake can happen, and by triangles that ask the pyramid in file order: first
//            by the gallery's own preset, by the others only where that is asked for
// Kept       the pixels that differ from the reference, so that many pictures of one view are compared with the same
// Growing    a fault that the gallery gains is a cause by itself; its lesson is a line in causes.cpp
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/check/judge.h"
#include "core/frame/pipeline.h"

namespace zscope::check {

struct CauseEntry {
    std::string           name;
    std::string           title;                // the gallery's, or the choice's
    std::string_view      lesson;               // file in resources/lessons without its ending; empty: none teaches it
    Fault                 fault = Fault::None;  // or a choice on an axis:
    std::string_view      axis = {}, choice = {};
    std::vector<Pipeline> pipelines = {};  // the one that shows it best first

    /// The pipeline with this mistake more; nothing if it cannot happen there.
    std::optional<Pipeline> addedTo(Pipeline pipeline) const;
};
/// In the order of the gallery, then of the axes.
const std::vector<CauseEntry>& causeEntries();
/// Both at once. It has no pipelines if they cannot happen together.
CauseEntry pairOf(const CauseEntry& a, const CauseEntry& b);

/// A pixel of a picture with a mistake where it differs from the reference.
struct SpoiltPixel {
    std::uint32_t pixel = 0;   // y * width + x
    Verdict       verdict;     // of coverage and surface; the same if only the depth differs
    std::int64_t  id    = -1;  // triangle
    float         depth = 0;   // near/z
};
using SpoiltPicture = std::vector<SpoiltPixel>;  // ascending by pixel

/// Draws the truth's view by a pipeline. Errors: what the renderer refuses, Limit, Cancelled.
Result<SpoiltPicture> drawSpoilt(const Truth& truth, const Pipeline& pipeline, const Progress& progress);

}  // namespace zscope::check
