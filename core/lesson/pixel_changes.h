// Which steps change a pixel, and where a run stops that has breakpoints. Both run the frame once more with an
// observer; nothing is logged.
//
// Changed    the picture of step K shows another id or another depth at the pixel than that of step K - 1, or a blended
//            colour
// Hit        step K is the first of its grain whose state shows that the run has come to a breakpoint, see Breakpoint
// Cost       one run of plain text, up to the step found
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/frame/renderer.h"
#include "core/lesson/explanation.h"

namespace zscope {

/// What one step did to one pixel.
struct PixelChange {
    StepIndex    step;
    std::int64_t idBefore = -1, id = -1;  // -1 is background
    float        depthBefore = 0, depth = 0;
    bool         isBlended = false;  // transparent surfaces were laid over its colour

    friend bool operator==(const PixelChange&, const PixelChange&) = default;
};
/// In the order of the steps; the first is the "first step that changed this pixel". Errors: Usage (no such grain, no
/// such pixel), Limit, Cancelled.
Result<std::vector<PixelChange>> changesOfPixel(const DrawRequest& request, Grain grain, PixelPosition pixel);

struct Breakpoint {
    enum class On {
        Line,   // a sweep reaches it; another method begins a triangle's pixels on it
        Pixel,  // somebody's depth is tested there, or it is filled, or blended
        Node,   // it is judged, or drawn unasked
        // it is set up and does not go on, or is hidden, or its pixels begin; of a sweep: an edge of it enters, or a
        // span is its own
        Triangle,
    };
    On            on       = On::Line;
    int           line     = 0;
    PixelPosition pixel    = {};
    NodeName      node     = {};
    TriangleId    triangle = {};

    friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

enum class Direction { Forward, Back };

struct Stop {
    StepIndex   step;
    std::size_t breakpoint = 0;  // which of those given; the first of several

    friend bool operator==(const Stop&, const Stop&) = default;
};
/// The first step after `from` that hits a breakpoint, or the last one before it; nothing if there is none. Without
/// `from` the search starts before the first step, or behind the last. Errors: Usage (no such grain), Limit, Cancelled.
Result<std::optional<Stop>> nextStop(const DrawRequest& request, Grain grain, std::optional<StepIndex> from,
                                     std::span<const Breakpoint> breakpoints, Direction direction);

}  // namespace zscope
