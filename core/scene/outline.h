// The outline of one polygon in the plane, made ready for cutting: which way it goes round, and whether it crosses
// itself.
//
// Ring       corners in file order, equal neighbours merged
// Contacts   where a corner lies within another edge, the corner is inserted there; afterwards edges meet only in
//            corners, and edges that overlap (bridges) coincide
// Winding    of a place: how often the ring runs round it counter-clockwise. A ring that can be cut into triangles
//            has winding 0 and 1 only (or 0 and -1, when it is clockwise)
// Promise    all decisions exact; the winding test needs no sample points: from the outermost corner it follows the
//            ring and passes the winding of the left side of each edge from corner to corner
// Cost       contacts about n log n (see box_tree.h), winding n log n, skipped where no two corners coincide
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/affine.h"
#include "core/scene/box_tree.h"
#include "core/scene/orientation.h"

namespace zscope {

struct RingCorner {
    Point2        at;
    std::uint32_t vertex;
};

class Outline {
public:
    enum class Shape { NoArea, Convex, Other };
    enum class Turning { CounterClockwise, Clockwise, Tangled };  // Tangled: crosses itself, or winds more than once

    /// Projects the polygon and merges equal neighbours; repeats() holds those that went, in file order.
    Shape project(std::span<const dvec3> positions, std::span<const std::uint32_t> outline);
    /// Inserts contacts and finds the way round; afterwards the ring is counter-clockwise (mirrored if need be).
    Turning untangle();

    std::span<const RingCorner> ring() const { return m_ring; }
    struct Repeat {
        std::uint32_t before, vertex, after;  // a triangle without area in the plane
    };
    std::span<const Repeat> repeats() const { return m_repeats; }

private:
    struct Contact {
        std::uint32_t edge, corner;  // `corner` lies strictly inside the edge that starts at `edge`
    };
    struct Ray {
        std::uint32_t to;        // place at the other end
        std::uint32_t edge;      // that it is one end of
        bool          outgoing;  // the ring runs along it away from here
    };

    Shape   shape() const;
    bool    findContacts();
    void    insertContacts();
    bool    placesCoincide();
    Turning windingOfPlaces();
    Turning turningOfSimpleRing() const;

    std::vector<RingCorner>    m_ring, m_longer;
    std::vector<Repeat>        m_repeats;
    std::vector<Contact>       m_contacts;
    std::vector<Point2>        m_points;
    BoxTree                    m_edges;
    std::vector<std::uint32_t> m_order;       // corners sorted by position
    std::vector<std::uint32_t> m_place;       // of each corner: number of its position, in that order
    std::vector<Point2>        m_placeAt;     // position of each place
    std::vector<std::uint32_t> m_firstRay;    // places + 1 entries
    std::vector<Ray>           m_rays;        // by place, then counter-clockwise
    std::vector<int>           m_leftOfEdge;  // winding of the left side of each edge
    std::vector<char>          m_settled;     // places whose sectors are known
};

}  // namespace zscope
