// The active edge table: the edges that cross the line at hand, from left to right; and how far the line has come in
// each polygon.
//
// Line       retireBefore(y), admit(the bucket of y), sortByX(): the active edges stand at line y. advance() moves
//            every edge to the next line by its constant step
// Cost       per line a sort of what is nearly sorted
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/plain/edge_table.h"
#include "core/probe/about.h"
#include "core/probe/grain.h"
#include "core/probe/telling.h"

namespace zscope::plain {

struct Work;
class Call;

/// Where the pixels of a polygon begin on the line at hand.
struct PolygonSpan {
    int           from    = 0;  // while it is open: its first pixel
    std::uint32_t winding = 0;  // of its edges round the place that has been reached; 0: it is closed

    bool isOpen() const { return winding != 0; }
};

/// What has become of the active edges between a line and the one before.
struct EdgeChanges {
    std::size_t   entered = 0, left = 0;
    std::uint32_t polygonEntered = 0, polygonLeft = 0;  // of the last edge that did
    int           lastLine = 0;                         // of the last edge that left
};

class ActiveEdges {
public:
    /// No edge is active and every polygon of the table is closed.
    void begin(const EdgeTable& table);

    void retireBefore(int y, Call work);
    void admit(const EdgeTable& table, int y, Call work);
    void sortByX(Call work);
    void advance();

    std::span<const Edge> edges() const { return m_edges; }
    const EdgeChanges&    changes() const { return m_changes; }
    std::size_t           bytes() const;
    PolygonSpan&          spanOf(std::uint32_t polygon) { return m_spans[polygon]; }

private:
    std::vector<Edge>        m_edges;
    EdgeChanges              m_changes;
    std::vector<PolygonSpan> m_spans;  // one per polygon of the edge table
};

/// The first pixel whose centre is not left of the edge, in a line of `width` pixels.
int firstPixelRightOf(const Edge& edge, int width, const ChosenRules& rules);

// What a sweep reports.

/// Every bucket of the edge table is filled; no line has been swept.
struct EdgeTableReady {
    const EdgeTable& table;  // valid until the run ends
};
struct EdgeEntered {
    const Edge& edge;  // valid only during the call
};
struct EdgeLeft {
    const Edge& edge;  // as it would stand on line y; valid only during the call
};
/// The active edge table is complete for line y; nothing of that line has been drawn yet.
struct LineReady {
    static constexpr Grain   grain = Grain::Span;
    int                      y;       // 0 is the top line
    std::span<const Edge>    active;  // sorted by x; valid only during the call, like the next
    std::span<const Polygon> polygons;
    EdgeChanges              changes;

    About       about() const { return {.line = y}; }
    std::string sentence(const Telling& telling) const;
};
/// Line y is drawn; the active edge table still stands at it.
struct LineFinished {
    static constexpr Grain   grain = Grain::Line;
    int                      y;
    std::span<const Edge>    active;  // as for LineReady
    std::span<const Polygon> polygons;
    EdgeChanges              changes;
    std::uint64_t            spans;  // of the line

    About       about() const { return {.line = y}; }
    std::string sentence(const Telling& telling) const;
};

}  // namespace zscope::plain
