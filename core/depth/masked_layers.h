// Two depths and a mask per tile instead of its pixels: the reference layer bounds the whole tile, the working layer
// the pixels in its mask.
//
// Idea       a triangle joins the working layer; when the mask is full, the working layer becomes the reference. A
//            triangle far in front of the working layer begins a new one, and what the old one knew is forgotten
// Promise    the reference is never nearer than the farthest pixel of the tile: it is the least of depths that were
//            really offered to every pixel of it. What is forgotten costs culls and never makes false ones
// Cost       one mask and a few comparisons per triangle and tile; no pixel is read
// Source     Hasselgren, Andersson, Akenine-Moller: Masked Software Occlusion Culling, HPG 2016
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/base/grid.h"

namespace zscope {

class MaskedLayers {
public:
    void reset(int width, int height) { m_working.reset(width, height, {}); }

    /// A triangle no farther than `depth` has been drawn over the pixels `mask` of tile (x, y), whose reference is
    /// `reference`; `all` is the mask of the pixels that the tile has. The new reference, if it has one.
    std::optional<float> cover(int x, int y, std::uint64_t mask, std::uint64_t all, float depth, float reference)
    {
        if (mask == 0 || !(depth > reference)) return std::nullopt;  // the whole tile is known to be at least as near
        Working& working = m_working.at(x, y);
        if (working.mask == 0 || depth - working.depth > working.depth - reference) {
            working = {depth, mask};
        } else {
            working.depth = std::min(working.depth, depth);
            working.mask |= mask;
        }
        if (working.mask != all) return std::nullopt;
        const float full = working.depth;
        working          = {};
        return full;
    }

    std::size_t bytes() const { return m_working.values().size_bytes(); }

private:
    struct Working {
        float         depth = 0;  // of all pixels in the mask, at least
        std::uint64_t mask  = 0;  // bit 8 y + x of a tile; 0: there is no working layer
    };

    Grid<Working> m_working;
};

}  // namespace zscope
