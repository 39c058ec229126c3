// The memory of one thread that draws by plain text, reused frame after frame.
#pragma once

#include <cstdint>
#include <vector>

#include "core/depth/pyramid.h"
#include "core/geometry/face_set_up.h"
#include "core/geometry/screen_triangle.h"
#include "core/hierarchy/node_memory.h"
#include "core/plain/active_edges.h"
#include "core/plain/edge_table.h"
#include "core/plain/placed_node.h"

namespace zscope::plain {

/// A transparent fragment of the line at hand.
struct BlendFragment {
    int           x;
    float         depth;
    std::uint32_t polygon;  // index into EdgeTable::polygons()
    std::uint32_t rank;     // triangle id + 1
};

/// The pixels [x0, x1) that a polygon of the edge table covers on the line at hand.
struct LineSpan {
    std::uint32_t polygon;
    int           x0, x1;
};

struct Scratch {
    std::vector<dvec3>          view;       // the batch's vertices in view space
    std::vector<ScreenTriangle> triangles;  // the batch's triangles that reach pixels of the stripe
    EdgeTable                   edges;      // sweeps
    ActiveEdges                 active;
    std::vector<LineSpan>       spans;      // of the line at hand
    std::vector<std::uint32_t>  open;       // of intervals: the polygons between two neighbouring edges, by their place
    FaceScratch                 faces;      // sweeps over whole faces
    std::vector<BlendFragment>  fragments;  // transparent surfaces
    std::vector<PlacedNode>     nodes;      // hierarchical methods: the nodes that wait, the next one on top
    Pyramid                     pyramid;
    NodeMemory                  memory;  // of two-pass: what the last frame saw
};

}  // namespace zscope::plain
