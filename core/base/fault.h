// Mistakes that published renderers make, to be switched on one at a time and looked at. An exact frame has none.
//
// Promise    a fault makes wrong pictures, never wrong memory accesses
// Growing    an enumerator here, its sentences in core/frame/faults.h, and one rule that consults it
#pragma once

namespace zscope {

enum class Fault {
    None,
    FirstLineRounded,    // scan: the first line of a triangle is rounded instead of rounded up
    HorizontalByX,       // scan: a side counts as horizontal if its x extent is nothing
    XTruncated,          // scan: a span begins and ends at the truncated x
    NoTopLeft,           // scan: a point on an edge belongs to both neighbours
    EdgesUnsorted,       // sweep: active edges stay in the order they came
    OneTestPerInterval,  // intervals: whoever is nearest at the left end gets the whole interval
    NearestInCells,      // pyramid: a cell holds the nearest of its children
    CornersOnly,         // pyramid: a query looks at the corners of its rectangle
    EmptyIsHidden,       // pyramid: a rectangle truncated to nothing counts as hidden
    OddPadded,           // pyramid: the last row and column of an odd level are padding
    EqualIsHidden,       // pyramid: what is as near as the cell counts as hidden
    NearRejected,        // clip: a triangle with any corner before the near plane is dropped
    CrossingDropped,     // clip: a triangle that crosses the border of the picture is dropped
    FarFirst,            // order: the farthest child is visited first, and who came first keeps a tie
};

}  // namespace zscope
