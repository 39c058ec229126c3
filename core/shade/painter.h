// What shading needs: the colours of the triangles, the picture to colour, and what a fragment shall cost.
//
// Colour     a fragment has the colour of its triangle. A cost of operations is a chain of dependent integer operations
//            on a seed of triangle and pixel; the last bit of the chain is the last bit of blue, so that nothing can be
//            left out, nobody sees it, and every moment of shading gives the same bits
// Borrows    everything
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/base/grid.h"
#include "core/shade/colour_table.h"

namespace zscope {

struct Painter {
    const Scene&            scene;
    const ColourTable&      table;
    GridView<std::uint32_t> colour;      // of the whole picture
    int                     operations;  // per fragment: 0, or a multiple of kOperationsPerRound
    // per tile of the visibility buffer: 0 if all of its colours are the background's;
    GridView<std::uint8_t> painted = {};
    // without data nothing is known of them

    /// The colour of a triangle before it has cost anything; rank 0 is the background.
    std::uint32_t baseColour(std::uint32_t rank) const
    {
        if (table.isComplete()) return table.data()[rank];
        if (rank == 0) return kBackgroundColour;
        const InstanceId instance = scene.instanceOf(TriangleId{rank - 1});
        return colourOf(scene, instance, rank - 1 - scene.firstTriangle[instance.value]);
    }
};

inline void clearColours(const Painter& painter, int firstRow, int endRow)
{
    for (int y = firstRow; y < endRow; ++y) std::ranges::fill(painter.colour.row(y), kBackgroundColour);
}

}  // namespace zscope
