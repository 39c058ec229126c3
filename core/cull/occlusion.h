// What a stream method asks of the pyramid, and what it tells it.
#pragma once

#include <span>

#include "core/base/shortcut.h"
#include "core/cull/after_drawing.h"
#include "core/cull/cull_events.h"
#include "core/depth/pyramid_told.h"
#include "core/geometry/screen_triangle.h"

namespace zscope {

struct Occlusion {
    Pyramid* pyramid       = nullptr;  // nullptr: there is none, and the rest is false
    bool     asksNodes     = false;    // is this node hidden?
    bool     asksTriangles = false;    // is this triangle hidden?
    bool     asksByShape   = false;    // of a triangle only what it covers, not its whole box
    // of compact triangles, before they are set up, all pixels of their boxes
    bool         asksPixels   = false;
    AfterDrawing afterDrawing = AfterDrawing::Nothing;
};

/// The side of its box on which a triangle's farthest corner lies.
inline PushOrder fromFarthestCorner(const ScreenTriangle& triangle)
{
    std::size_t farthest = 0;
    const auto  depthAt  = [&triangle](std::size_t i) {
        return triangle.depth.a * triangle.x[i] + triangle.depth.b * triangle.y[i];
    };
    for (const std::size_t i : {1u, 2u})
        if (depthAt(i) < depthAt(farthest)) farthest = i;
    return {.fromRight  = triangle.x[farthest] > 0.5 * kSubpixels * (triangle.box.x0 + triangle.box.x1),
            .fromBottom = triangle.y[farthest] > 0.5 * kSubpixels * (triangle.box.y0 + triangle.box.y1)};
}

/// A depth that no fragment of a plane is beyond, over `pixels`: that of the corner where the plane is farthest. Each
/// rounding of a fragment's depth keeps order, so the corner's own arithmetic bounds all others'.
template <class Rules>
float farthestOver(const DepthPlane& plane, const PixelBox& pixels, const Rules& rules)
{
    if (rules.depthNumbers() != DepthNumbers::Float64 || rules.interpolatesDistance())
        return rules.stored(plane.farthest);
    const double x = plane.a < 0 ? pixels.x1 - 0.5 : pixels.x0 + 0.5,
                 y = plane.b < 0 ? pixels.y1 - 0.5 : pixels.y0 + 0.5;
    const double z = plane.a * x + (plane.b * y + plane.c);
    return rules.stored(z > plane.farthest ? std::min(z, double{plane.nearest}) : double{plane.farthest});
}

/// What scan conversion by tiles asks and tells the pyramid, where stale cells wait for a query; nobody if there is
/// none that does.
struct TileUpkeep {
    Pyramid* pyramid;  // or nullptr
    // nobody reads the visibility buffer's pixels while it is drawn to, unless they know of planes
    bool        takesPlanes;
    ShortcutSet shortcuts;

    /// True if tiles are asked about, and drawnTile() wants to hear of them.
    bool isKept() const { return pyramid && shortcuts.has(Shortcut::StoredTiles) && pyramid->takesTiles(); }
    /// Of the tile that holds (x, y), if isKept().
    bool hides(int x, int y, float nearest) const { return pyramid->hidesTile(x, y, nearest); }
    void drawnTile(int x, int y, float farthest) const { pyramid->drawnTile(x, y, farthest, Untold{}); }
    /// The same of tiles side by side, the first of which holds (x, y).
    void drawnTiles(int x, int y, std::span<const float> farthest) const
    {
        pyramid->drawnTiles(x, y, farthest, Untold{});
    }
    void touched(const PixelBox& box) const
    {
        if (pyramid) pyramid->touched(box);
    }
};

/// Lets the pyramid know that a triangle's pixels have been drawn.
template <class Rules>
void keepTrue(const Occlusion& occlusion, const ScreenTriangle& triangle, const Rules& rules)
{
    switch (occlusion.afterDrawing) {
        case AfterDrawing::Nothing:
            return;
        case AfterDrawing::MarkStale:
            return occlusion.pyramid->touched(triangle.box);
        case AfterDrawing::Push:
            return occlusion.pyramid->push(triangle.box, Untold{});
        case AfterDrawing::PushFromFarthest:
            return occlusion.pyramid->pushFrom(triangle.box, fromFarthestCorner(triangle), Untold{});
        case AfterDrawing::Cover:
            if (triangle.wide || triangle.patterned) return;  // what it covers, or how far back, is not known here
            return occlusion.pyramid->cover(
                triangle.box, TriangleCover(triangle, rules.notOwned()),
                [&](const PixelBox& pixels) { return farthestOver(triangle.depth, pixels, rules); }, Untold{});
    }
}

}  // namespace zscope
