// The table of parts that a method calls: the function in each place is chosen at run time, so the method is compiled
// once.
//
// Calls      through a pointer, once per batch, node or line, never per pixel
// Filled     by plainParts(), core/frame/plain_stripe.cpp:
//            mayBeSeen    always true
//            setUp        setUpBatch, core/plain/set_up_batch.cpp
//            draw         drawEachTriangle, core/method/zbuffer.cpp
//            judge        judgeNode, core/plain/questions.cpp
//            push, pop    pushOnStack, popFromStack, core/method/hierarchical.cpp
//            enterEdges   enterTriangles, core/frame/plain_stripe.cpp
//            resolveLine  resolveByDepth, core/method/scanline.cpp. For interval and interval-polygon sweepLines()
//                         (core/frame/plain_stripe.cpp) replaces it by resolveByIntervals, core/method/intervals.cpp
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
    void (*resolveLine)(Call, int y);  // decides which polygon each pixel of line y shows, given Scratch::active
};

Parts plainParts();

}  // namespace zscope::plain
