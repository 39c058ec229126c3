// The active edge table: the edges that cross the current line, from left to right.
//
// Order      by the exact crossing with the line's centre; the order of edges that meet in one point is not defined. An
//            edge beyond the guard band counts as half a subpixel wherever it is not on a whole one, so inside one
//            subpixel it may stand on the wrong side of a neighbour, which moves no pixel
// Cost       per line one pass to drop, step and re-sort (insertion: neighbours rarely change places), and one merge of
//            the newcomers, from the right, in place
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/sweep/active_edge.h"
#include "core/sweep/active_polygons.h"
#include "core/sweep/edge_table.h"
#include "core/sweep/sweep_events.h"

namespace zscope {

class ActiveEdges {
public:
    void clear() { m_edges.clear(); }

    /// Moves on to line y: edges whose last line lies above it leave, the others step, and those that have crossed
    /// change places.
    template <class Probe>
    void advanceTo(int y, const EdgeTable& table, ActivePolygons& polygons, const Probe& probe)
    {
        std::size_t kept = 0;
        for (ActiveEdge edge : m_edges) {
            if (edge.lastLine() < y) {
                probe(EdgeLeft{edge, polygons[edge.polygon()].part});
                polygons.leave(edge.polygon());
                continue;
            }
            if (edge.isWide())
                edge.placeWide(table.parts()[polygons[edge.polygon()].part], y);
            else
                edge.nextLine();
            std::size_t place = kept++;
            for (; place > 0 && edge.isLeftOf(m_edges[place - 1]); --place) m_edges[place] = m_edges[place - 1];
            m_edges[place] = edge;
        }
        m_edges.erase(m_edges.begin() + static_cast<std::ptrdiff_t>(kept), m_edges.end());
    }

    /// Adds the edges of the table's bucket for line y, each in its place, and their polygons.
    template <class Probe>
    void admit(int y, const EdgeTable& table, ActivePolygons& polygons, const Probe& probe)
    {
        m_newcomers.clear();
        for (const std::uint32_t index : table.startingAt(y)) {
            m_newcomers.push_back(table.edge(index));
            const std::uint32_t part = m_newcomers.back().polygon();
            m_newcomers.back().setPolygon(polygons.enter(table.parts()[part], part));
            probe(EdgeEntered{m_newcomers.back(), part});
            for (std::size_t i = m_newcomers.size() - 1; i > 0 && m_newcomers[i].isLeftOf(m_newcomers[i - 1]); --i)
                std::swap(m_newcomers[i], m_newcomers[i - 1]);
        }
        mergeNewcomers();
    }

    std::span<const ActiveEdge> view() const { return m_edges; }
    std::size_t bytes() const { return (m_edges.capacity() + m_newcomers.capacity()) * sizeof(ActiveEdge); }

private:
    /// The rightmost of both lists goes to the end, and so on, until the newcomers are used up.
    void mergeNewcomers()
    {
        std::size_t old = m_edges.size(), fresh = m_newcomers.size();
        m_edges.insert(m_edges.end(), m_newcomers.begin(), m_newcomers.end());
        while (fresh > 0) {
            const std::size_t to = old + fresh - 1;
            if (old > 0 && m_newcomers[fresh - 1].isLeftOf(m_edges[old - 1]))
                m_edges[to] = m_edges[--old];
            else
                m_edges[to] = m_newcomers[--fresh];
        }
    }

    std::vector<ActiveEdge> m_edges;      // from left to right
    std::vector<ActiveEdge> m_newcomers;  // scratch
};

}  // namespace zscope
