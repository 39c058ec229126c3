// What a sweep tells: the edge table complete, edges entering and leaving, lines ready and finished.
#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/screen_triangle.h"
#include "core/probe/grain.h"
#include "core/scan/edge_stepper.h"

namespace zscope {

class EdgeTable;

/// One row of the active edge table.
struct ActiveEdge {
    EdgeStepper   crossing;   // with the current line's centre
    std::uint32_t part : 30;  // index into EdgeTable::parts()
    std::uint32_t side : 2;   // from corner side to corner side + 1
    int           lastLine;   // inclusive
};

/// Every bucket of the edge table is filled; no line has been swept.
struct EdgeTableReady {
    const EdgeTable& table;  // valid until the run ends
};

struct EdgeEntered {
    const ActiveEdge& edge;  // valid only during the call
};

struct EdgeLeft {
    const ActiveEdge& edge;  // valid only during the call
};

/// The active edge table is complete for line y; nothing of that line has been drawn yet.
struct ScanlineReady {
    static constexpr Grain      grain = Grain::Span;
    int                         y;       // 0 is the top line
    std::span<const ActiveEdge> active;  // sorted by x; valid only during the call
};

/// Line y is drawn; the active edge table still stands at it.
struct ScanlineFinished {
    static constexpr Grain grain = Grain::Line;
    int                    y;
};

}  // namespace zscope
