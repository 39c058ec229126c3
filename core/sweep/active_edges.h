// The active edge table: the edges that cross the current line, from left to right.
//
// Order      by the exact crossing with the line's centre; the order of edges that meet in one point is not defined. An
//            edge beyond the guard band counts as half a subpixel wherever it is not on a whole one, so inside one
//            subpixel it may stand on the wrong side of a neighbour, which moves no pixel
// Cost       per line one pass to drop, step and re-sort, and one merge of the newcomers, from the right, in place.
//            Sorting is by insertion, as neighbours rarely change places, until that has moved more edges than sorting
//            the line outright would: never worse than n log n
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
    template <class Rules, class Probe>
    void advanceTo(int y, const EdgeTable& table, ActivePolygons& polygons, const Rules& rules, const Probe& probe)
    {
        std::size_t kept = 0;
        NearlySorted order(m_edges.size(), rules.sortsActiveEdges());
        for (ActiveEdge edge : m_edges) {
            if (edge.lastLine() < y) {
                probe(EdgeLeft{edge, polygons[edge.polygon()].part});
                polygons.leave(edge.polygon());
                continue;
            }
            if (edge.isWide())
                edge.placeWide(table.side(edge.index()), y);
            else
                edge.nextLine();
            order.insert(m_edges, kept++, edge);
        }
        m_edges.erase(m_edges.begin() + static_cast<std::ptrdiff_t>(kept), m_edges.end());
        order.finish(m_edges);
    }

    /// Adds the edges of the table's bucket for line y, each in its place, and their polygons.
    template <class Rules, class Probe>
    void admit(int y, const EdgeTable& table, ActivePolygons& polygons, const Rules& rules, const Probe& probe)
    {
        m_newcomers.clear();
        for (const std::uint32_t index : table.startingAt(y)) {
            m_newcomers.push_back(table.edge(index));
            table.prefetchPart(m_newcomers.back().polygon());
        }
        table.prefetchEdgesOf(y + 1);
        NearlySorted order(m_newcomers.size(), rules.sortsActiveEdges());
        for (std::size_t i = 0; i < m_newcomers.size(); ++i) {
            ActiveEdge          edge = m_newcomers[i];
            const std::uint32_t part = edge.polygon();
            edge.setPolygon(polygons.enter(table.parts()[part], part));
            probe(EdgeEntered{edge, part});
            order.insert(m_newcomers, i, edge);
        }
        order.finish(m_newcomers);
        if (rules.sortsActiveEdges())
            mergeNewcomers();
        else
            m_edges.insert(m_edges.end(), m_newcomers.begin(), m_newcomers.end());
    }

    std::span<const ActiveEdge> view() const { return m_edges; }
    std::size_t bytes() const { return (m_edges.capacity() + m_newcomers.capacity()) * sizeof(ActiveEdge); }

private:
    /// Insertion sort that gives up, and sorts outright at the end, once it has moved four times as many edges as there are.
    class NearlySorted {
    public:
        NearlySorted(std::size_t count, bool sorts) : m_sorts(sorts), m_movesLeft(4 * count) {}

        /// The first `count` edges stand in order (or sorting by insertion has been given up): `edge` joins them.
        void insert(std::vector<ActiveEdge>& edges, std::size_t count, const ActiveEdge& edge)
        {
            std::size_t place = count;
            for (; place > 0 && m_sorts && edge.isLeftOf(edges[place - 1]) && m_movesLeft > 0; --place, --m_movesLeft)
                edges[place] = edges[place - 1];
            edges[place] = edge;
        }
        void finish(std::vector<ActiveEdge>& edges) const
        {
            if (m_movesLeft > 0 || !m_sorts) return;
            std::ranges::sort(edges, [](const ActiveEdge& a, const ActiveEdge& b) { return a.isLeftOf(b); });
        }

    private:
        bool        m_sorts;
        std::size_t m_movesLeft;
    };

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
