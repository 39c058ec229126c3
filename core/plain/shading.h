// The fragment shader for one fragment.
//
// Chain      a cost of operations is a chain of dependent operations on 32-bit integers, five a round, that begins with
//            the pixel and the triangle; its last bit becomes the last bit of blue, so that none can be left out
// Source     the mixing step is Bob Jenkins' one-at-a-time hash, Dr. Dobb's Journal, 1997
#pragma once

#include <cstdint>

#include "core/base/tally.h"
#include "core/shade/painter.h"

namespace zscope::plain {

/// 0xAARRGGBB of triangle `rank` - 1 at the pixel (x, y); rank 0 is background, which costs nothing.
inline std::uint32_t colourOfFragment(const Painter& painter, std::uint32_t rank, int x, int y)
{
    constexpr int       kOperationsPerRound = 5;
    const std::uint32_t base                = painter.baseColour(rank);
    if (rank == 0 || painter.operations == 0) return base;
    std::uint32_t chain =
        (static_cast<std::uint32_t>(x) + (static_cast<std::uint32_t>(y) << 16)) ^ (rank * 0x9E3779B1u);
    for (int done = 0; done < painter.operations; done += kOperationsPerRound) {
        chain += chain << 10;
        chain ^= chain >> 6;
        chain += 0x7F4A7C15u;
    }
    return base ^ (chain >> 31);
}

/// The stripe's lines once they are finished: each pixel from the triangle that won it.
inline void shadeLines(const Painter& painter, const VisibilityBuffer& visible, int first, int end, Tally& tally)
{
    for (int y = first; y < end; ++y)
        for (int x = 0; x < visible.width(); ++x) {
            const std::uint32_t rank = visible.rankAt(x, y);
            painter.colour.at(x, y)  = colourOfFragment(painter, rank, x, y);
            tally.add(Unit::Fragments, rank != 0);
        }
}

}  // namespace zscope::plain
