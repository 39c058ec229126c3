// The scanline algorithm: the picture is swept line by line; the active edge table holds what crosses the line.
//
// Idea       an edge enters the table on its first line, moves by a constant from line to line, and leaves after
//            its last; between a polygon's left and right edge lie its pixels
// Resolve    decides who is seen on the line, given the active edges (LineZBuffer, Intervals)
// Bands      a band of lines is swept on its own, with a table of its own
// Source     Wylie, Romney, Evans, Erdahl: Half-tone perspective drawings by computer, FJCC 1967
#if defined(ZSCOPE_SWEEP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_SWEEP_INL_H
#undef ZSCOPE_SWEEP_INL_H
#else
#define ZSCOPE_SWEEP_INL_H
#endif

#include "core/base/progress.h"
#include "core/base/tally.h"
#include "core/fast/lanes/line_zbuffer-inl.h"
#include "core/sweep/active_edges.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

template <class Resolve>
void sweep(const EdgeTable& edges, ActiveEdges& active, ActivePolygons& polygons, Resolve& resolve,
           const Progress& progress, Tally& tally)
{
    active.clear();
    polygons.begin(edges.parts());
    for (int y = edges.firstLine(); y < edges.endLine() && !progress.cancelled(); ++y) {
        active.advanceTo(y, edges);
        tally.add(Unit::ActiveEdges, active.view().size());
        resolve.line(y, active.view(), polygons);
    }
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_SWEEP_INL_H
