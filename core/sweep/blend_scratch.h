// Memory of the transparent pass (core/sweep/blend_line.h): a sweep of its own, and the fragments of a part of a line.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sweep/active_edges.h"
#include "core/sweep/active_polygons.h"
#include "core/sweep/edge_table.h"

namespace zscope {

/// What a transparent part lays over what is behind it.
struct Paint {
    std::uint32_t colour;   // 0xAARRGGBB
    float         opacity;  // 0 to 1
    bool          front;    // it faces the viewer
};

/// Of one thread, reused from frame to frame.
struct BlendScratch {
    struct Span {
        std::uint32_t part;    // of the edge table
        int           x0, x1;  // pixels [x0, x1)
    };
    struct Fragment {
        int           x;
        float         depth;
        std::uint32_t part;  // of the edge table
        std::uint32_t rank;  // triangle id + 1
    };

    EdgeTable                  edges;
    ActiveEdges                active;
    ActivePolygons             polygons;
    std::vector<Paint>         paints;     // one per part
    std::vector<Span>          spans;      // of the line at hand
    std::vector<Fragment>      found;      // of a part of it, as they were found
    std::vector<Fragment>      fragments;  // the same, column by column
    std::vector<std::uint32_t> columns;    // where each column's begin in `fragments`

    std::size_t bytes() const
    {
        return edges.bytes() + active.bytes() + polygons.bytes() + paints.capacity() * sizeof(Paint)
               + spans.capacity() * sizeof(Span) + (found.capacity() + fragments.capacity()) * sizeof(Fragment)
               + columns.capacity() * sizeof(std::uint32_t);
    }
};

}  // namespace zscope
