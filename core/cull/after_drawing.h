// How the pyramid is kept true, triangle by triangle.
#pragma once

namespace zscope {

/// What becomes of the pyramid when a triangle has been drawn.
enum class AfterDrawing {
    Nothing,           // depths are final: there was a pre-pass, or there is no pyramid
    MarkStale,         // queries bring cells up to date
    Push,              // tiles and their ancestors at once, tile by tile
    PushFromFarthest,  // all tiles first, then their ancestors from the triangle's farthest corner on
    Cover,             // two depths and a mask per tile
};

}  // namespace zscope
