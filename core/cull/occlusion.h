// What a stream method asks of the pyramid, and what it tells it.
#pragma once

#include "core/cull/cull_events.h"
#include "core/depth/pyramid_told.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

/// What becomes of the pyramid when a triangle has been drawn.
enum class AfterDrawing {
    Nothing,           // depths are final: there was a pre-pass, or there is no pyramid
    MarkStale,         // queries bring cells up to date
    Push,              // tiles and their ancestors at once, tile by tile
    PushFromFarthest,  // all tiles first, then their ancestors from the triangle's farthest corner on
};

struct Occlusion {
    Pyramid* pyramid       = nullptr;  // nullptr: there is none, and the rest is false
    bool     asksNodes     = false;    // is this node hidden?
    bool     asksTriangles = false;    // is this triangle hidden?
    bool     asksByShape   = false;    // of a triangle only what it covers, not its whole box
    AfterDrawing afterDrawing = AfterDrawing::Nothing;
};

/// Tells a probe of the cells that the pyramid writes.
template <class Probe>
auto tellingOfCells(const Probe& probe)
{
    if constexpr (Probe::listens)
        return [&probe](const CellWrite& write) { probe(CellUpdated{write}); };
    else
        return Untold{};
}

/// The side of its box on which a triangle's farthest corner lies.
inline PushOrder fromFarthestCorner(const ScreenTriangle& triangle)
{
    std::size_t farthest = 0;
    const auto  depthAt  = [&triangle](std::size_t i) { return triangle.depth.a * triangle.x[i] + triangle.depth.b * triangle.y[i]; };
    for (const std::size_t i : {1u, 2u})
        if (depthAt(i) < depthAt(farthest)) farthest = i;
    return {.fromRight  = triangle.x[farthest] > 0.5 * kSubpixels * (triangle.box.x0 + triangle.box.x1),
            .fromBottom = triangle.y[farthest] > 0.5 * kSubpixels * (triangle.box.y0 + triangle.box.y1)};
}

/// Lets the pyramid know that a triangle's pixels have been drawn.
template <class Probe>
void keepTrue(const Occlusion& occlusion, const ScreenTriangle& triangle, const Probe& probe)
{
    switch (occlusion.afterDrawing) {
    case AfterDrawing::Nothing: return;
    case AfterDrawing::MarkStale: return occlusion.pyramid->touched(triangle.box);
    case AfterDrawing::Push: return occlusion.pyramid->push(triangle.box, tellingOfCells(probe));
    case AfterDrawing::PushFromFarthest:
        return occlusion.pyramid->pushFrom(triangle.box, fromFarthestCorner(triangle), tellingOfCells(probe));
    }
}

}  // namespace zscope
