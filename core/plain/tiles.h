// The tiles of the pyramid that a box of pixels meets, for a depth test tile by tile; or the box as one. A tile of the
// pyramid has 8 x 8 pixels; the tiles of the visibility buffer, 64 x 8, are not meant.
#pragma once

#include <algorithm>
#include <vector>

#include "core/depth/pyramid.h"
#include "core/geometry/pixel_box.h"

namespace zscope::plain {

/// What the box has of each tile, line of tiles by line of tiles; the box itself if `byTiles` is false. Tiles are
/// counted from the top line of the stripe, which is a multiple of their side.
inline std::vector<PixelBox> tilesOf(const PixelBox& box, bool byTiles)
{
    if (!byTiles) return {box};
    constexpr int         kSide = 1 << Pyramid::kTileLevel;
    std::vector<PixelBox> tiles;
    for (int top = box.y0 & -kSide; top < box.y1; top += kSide)
        for (int left = box.x0 & -kSide; left < box.x1; left += kSide)
            tiles.push_back({std::max(left, box.x0), std::max(top, box.y0), std::min(left + kSide, box.x1),
                             std::min(top + kSide, box.y1)});
    return tiles;
}

}  // namespace zscope::plain
