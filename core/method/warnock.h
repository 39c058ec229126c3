// Area subdivision: a window of the picture is decided as a whole where that is simple, else it is divided in four,
// down to a single pixel.
//
// Simple     no triangle meets the window; one that surrounds it is nearest at all its corners; or it is one pixel
// Nearest    depth is affine on the screen, so what leads at the four corners leads everywhere between. Where rounding,
//            or the limits of a triangle's depths, could matter, the window is divided: a lead is at least kLead of the
//            depth. At a pixel the depth test decides, ties included
// Patterns   a triangle with holes or a relief surrounds nothing
// Cost       follows the edges in the picture, not its area: along them windows are divided down to pixels
// Memory     holds all triangles in view, and for each open window the list of triangles that meet it. Throws
//            std::bad_alloc beyond the limit
// Source     Warnock: A Hidden Surface Algorithm for Computer Generated Halftone Pictures, University of Utah, 1969
#pragma once

#include <span>

#include "core/plain/parts.h"

namespace zscope::plain {

/// Decides the window that is the whole stripe.
void subdivide(Work& work, const Parts& parts);

enum class WindowVerdict { Empty, Surrounded, Pixel, Divided };

/// A window has been decided and drawn, or is about to be divided.
struct WindowJudged {
    static constexpr Grain                 grain = Grain::Query;
    PixelBox                               window;
    WindowVerdict                          verdict;
    std::span<const ScreenTriangle* const> meeting;  // valid only during the call, as the next
    const ScreenTriangle*                  leader;   // nullptr: none surrounds it in front of all others

    About       about() const;
    std::string sentence(const Telling& telling) const;
    void        mean(Meanings& to) const;
};

}  // namespace zscope::plain
