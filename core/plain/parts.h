// The table of parts that a method calls: what the method does in each place is chosen at run time, so the method is
// compiled once. Methods know only the table; plainParts() fills it.
//
// Calls      through a pointer, once per batch, node or line, never per pixel
#pragma once

#include <span>

#include "core/cull/cull_events.h"
#include "core/geometry/set_up.h"
#include "core/hierarchy/node_memory.h"
#include "core/plain/pass.h"
#include "core/plain/placed_node.h"
#include "core/plain/work.h"

namespace zscope::plain {

class TreeVisit;

struct Parts {
    /// False only of a batch that cannot win a pixel of the stripe.
    bool (*mayBeSeen)(Call, const BatchPlace&);
    /// Leaves the batch's triangles that reach pixels of the stripe in Scratch::triangles.
    void (*setUp)(Call, const BatchPlace&);
    /// Turns Scratch::triangles into pixels, by the pass.
    DrawnTriangles (*draw)(Call, const Pass&);

    /// Hierarchical methods.
    Verdict (*judge)(Call, const Pass&, TreeVisit&, PlacedNode&);
    void (*push)(Call, std::span<const PlacedNode>);  // the last one is visited first
    bool (*pop)(Call, PlacedNode&);                   // false: none waits

    /// Sweeps.
    void (*enterEdges)(Call);          // of Scratch::triangles
    void (*resolveLine)(Call, int y);  // decides who is seen on line y, given Scratch::active
};

/// The plain parts, with the draw and resolveLine of a z-buffer by half-spaces.
Parts plainParts();

}  // namespace zscope::plain
