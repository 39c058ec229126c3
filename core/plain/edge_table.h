// The edge table: every edge of the scene, in the bucket of the first line it crosses; and the polygons that they
// bound.
//
// Edge       crosses the centres of the lines [firstLine, lastLine]; horizontal edges cross none and are not entered
// Position   exact: whole subpixels and a remainder (EdgeStepper), so that line 10,000 is as exact as line 0
// Band       the lines [firstLine, endLine) of the stripe; an edge that begins above them starts on the first
// Polygons   triangles after set-up (one that the near plane cut in two is two polygons with one id), or whole faces
// Cost       buckets hold places of edges, in the order of entry, and are filled by counting: no edge is moved
// Errors     std::bad_alloc where it would take more bytes than the stripe may
// Source     Wylie, Romney, Evans, Erdahl: Half-tone perspective drawings by computer, FJCC 1967
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/rules.h"
#include "core/geometry/screen_face.h"
#include "core/geometry/screen_triangle.h"
#include "core/scan/edge_stepper.h"

namespace zscope::plain {

/// A triangle after set-up, or a face as it was read.
struct Polygon {
    DepthPlane depth;
    TriangleId id;
    bool       patterned = false;  // it has holes or a relief

    // of transparent ones
    std::uint32_t colour  = 0;  // 0xAARRGGBB
    float         opacity = 1;
    bool          front   = true;  // it faces the viewer
};

/// A row of the edge table and of the active edge table.
struct Edge {
    EdgeStepper<std::int64_t> crossing;       // with the centre of the line at hand; in the table: of its first line
    ScreenSide                side;           // its ends, snapped
    std::uint32_t             polygon   = 0;  // index into EdgeTable::polygons()
    int                       firstLine = 0, lastLine = 0;  // inclusive
    std::uint32_t             winding = 0;  // what passing it from left to right adds to its polygon's winding

    bool closes() const { return side.ya < side.yb; }  // a triangle's right edges run down
    bool isLeftOf(const Edge& other) const;
};

/// What decides whether a place is inside a polygon: the winding, the sum over the polygon's edges left of the place,
/// modulo 2^32. The place is inside where it is not 0. EvenOdd: each edge adds 2^31, so the winding toggles between 0
/// and 2^31. AnyWinding: an edge that runs down adds 1, one that runs up subtracts 1.
enum class Inside : std::uint8_t { EvenOdd, AnyWinding };

class EdgeTable {
public:
    /// `memory`: bytes it may take.
    void clear(int firstLine, int endLine, std::uint64_t memory);

    /// Enters a polygon with its closed sides, of which `top` is the least y.
    void add(const Polygon& polygon, Inside inside, std::span<const ScreenSide> sides, double top,
             const ChosenRules& rules);
    void add(const ScreenTriangle& triangle, const ChosenRules& rules);
    /// Puts the edges into their buckets; call once, after the last add().
    void fillBuckets();

    int firstLine() const { return m_firstLine; }
    int endLine() const { return m_endLine; }
    /// The bucket of a line: places of edges, see edge().
    std::span<const std::uint32_t> startingAt(int line) const;
    const Edge&                    edge(std::uint32_t place) const { return m_edges[place]; }
    std::size_t                    edgeCount() const { return m_edges.size(); }
    std::span<const Polygon>       polygons() const { return m_polygons; }
    std::span<Polygon>             polygons() { return m_polygons; }
    std::size_t                    bytes() const;

private:
    int                        m_firstLine = 0, m_endLine = 0;
    std::uint64_t              m_memory = 0;
    std::vector<Polygon>       m_polygons;
    std::vector<Edge>          m_edges;    // in the order of entry
    std::vector<std::uint32_t> m_places;   // of edges, bucket by bucket
    std::vector<std::uint32_t> m_buckets;  // lines + 1 entries: where each bucket begins in m_places
};

}  // namespace zscope::plain
