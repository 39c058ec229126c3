// The active edge table: the edges that cross the current line, from left to right.
//
// Order      by the crossing with the line's centre, as finely as LineCrossing holds it, so that crossings less than a
//            hundred-thousandth of a subpixel apart may stand either way, which moves no pixel
// Cost       per line one pass to drop, step and re-sort, and one merge of the newcomers, from the right, in place.
//            Sorting is by insertion, as neighbours rarely change places, until that has moved more edges than sorting
//            the line outright would: never worse than n log n
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/sweep/active_edge.h"
#include "core/sweep/edge_table.h"
#include "core/sweep/sweep_events.h"

namespace zscope {

class ActiveEdges {
public:
    void clear() { m_edges.clear(); }

    /// Moves on to line y: edges whose last line lies above it leave, the others step, and those that have crossed
    /// change places.
    template <class Rules, class Probe>
    void advanceTo(int y, const EdgeTable& table, const Rules& rules, const Probe& probe)
    {
        std::size_t  kept = 0;
        NearlySorted order(m_edges, rules.sortsActiveEdges());
        for (const ActiveEdge& edge : m_edges) {
            if (edge.lastLine() < y) {
                probe(EdgeLeft{edge, edge.polygon()});
                continue;
            }
            ActiveEdge& stepped = m_edges[kept];
            stepped             = edge;
            if (stepped.isWide())
                stepped.placeWide(table.sideOf(stepped), y);
            else
                stepped.nextLine();
            order.include(kept++);
        }
        m_edges.erase(m_edges.begin() + static_cast<std::ptrdiff_t>(kept), m_edges.end());
        order.finish();
    }

    /// Adds the edges of the table's bucket for line y, each in its place.
    template <class Rules, class Probe>
    void admit(int y, const EdgeTable& table, const Rules& rules, const Probe& probe)
    {
        const std::span<const ActiveEdge> starting = table.startingAt(y);
        m_newcomers.assign(starting.begin(), starting.end());
        NearlySorted order(m_newcomers, rules.sortsActiveEdges());
        for (std::size_t i = 0; i < m_newcomers.size(); ++i) {
            probe(EdgeEntered{m_newcomers[i], m_newcomers[i].polygon()});
            order.include(i);
        }
        order.finish();
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
        NearlySorted(std::vector<ActiveEdge>& edges, bool sorts) : m_edges(edges), m_movesLeft(4 * edges.size()), m_sorts(sorts) {}

        /// The edges before `place` stand in order (or sorting by insertion has been given up): the one that stands there joins them.
        void include(std::size_t place)
        {
            if (place > 0 && m_edges[place].isLeftOf(m_edges[place - 1]) && m_sorts) moveLeft(place);
        }
        void finish()
        {
            if (m_movesLeft > 0 || !m_sorts) return;
            std::ranges::sort(m_edges, [](const ActiveEdge& a, const ActiveEdge& b) { return a.isLeftOf(b); });
        }

    private:
        void moveLeft(std::size_t place)
        {
            const ActiveEdge edge = m_edges[place];
            for (; place > 0 && edge.isLeftOf(m_edges[place - 1]) && m_movesLeft > 0; --place, --m_movesLeft) m_edges[place] = m_edges[place - 1];
            m_edges[place] = edge;
        }

        std::vector<ActiveEdge>& m_edges;
        std::size_t              m_movesLeft;
        bool                     m_sorts;
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
