// What a sweep tells: the edge table complete, edges entering and leaving, lines ready and finished.
#pragma once

#include <cstdint>
#include <span>

#include "core/probe/grain.h"
#include "core/sweep/active_edge.h"
#include "core/sweep/active_polygons.h"
#include "core/sweep/interval_reason.h"

namespace zscope {

class EdgeTable;

/// Every bucket of the edge table is filled; no line has been swept.
struct EdgeTableReady {
    const EdgeTable& table;  // valid until the run ends
};

struct EdgeEntered {
    const ActiveEdge& edge;  // valid only during the call
    std::uint32_t     part;  // index into EdgeTable::parts()
};

struct EdgeLeft {
    const ActiveEdge& edge;  // as it stood on its last line; valid only during the call
    std::uint32_t     part;
};

/// The active edge table is complete for line y; nothing of that line has been drawn yet.
struct ScanlineReady {
    static constexpr Grain      grain = Grain::Span;
    int                         y;       // 0 is the top line
    std::span<const ActiveEdge> active;  // sorted by x; valid only during the call
};

/// The pixels [x0, x1) between two neighbouring active edges of line y are decided; never empty.
struct IntervalResolved {
    static constexpr Grain         grain = Grain::Interval;
    int                            y, x0, x1;
    std::span<const std::uint32_t> open;  // parts of the edge table; valid only during the call, like the next
    const ActivePolygons&          polygons;
    const SweepPolygon*            winner;  // nullptr: the open polygons were compared pixel by pixel
    IntervalReason                 reason;
};

/// Line y is drawn; the active edge table still stands at it.
struct ScanlineFinished {
    static constexpr Grain grain = Grain::Line;
    int                    y;
};

}  // namespace zscope
