// The active edge table: the edges that cross the current line, from left to right.
//
// Order      by the exact crossing with the line's centre; the order of edges that meet in one point is not defined
// Cost       per line: one pass to step, drop and re-sort (insertion: neighbours rarely change places), and a merge of
//            the newcomers
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/scan/edge_stepper.h"
#include "core/sweep/edge_table.h"
#include "core/sweep/sweep_events.h"

namespace zscope {

class ActiveEdges {
public:
    void clear() { m_edges.clear(); }

    /// Drops the edges whose last line lies above y.
    template <class Probe>
    void retireBefore(int y, const Probe& probe)
    {
        const auto isOver = [&](const ActiveEdge& edge) {
            if (edge.lastLine >= y) return false;
            probe(EdgeLeft{edge});
            return true;
        };
        m_edges.erase(std::remove_if(m_edges.begin(), m_edges.end(), isOver), m_edges.end());
    }

    /// Adds the edges of the table's bucket for line y, each in its place.
    template <class Probe>
    void admit(const EdgeTable& table, int y, const Probe& probe)
    {
        const std::span<const EdgeStart> starting = table.startingAt(y);
        if (starting.empty()) return;
        const auto before = static_cast<std::ptrdiff_t>(m_edges.size());
        for (const EdgeStart& start : starting) {
            m_edges.push_back(activate(table.parts()[start.part], start, y));
            probe(EdgeEntered{m_edges.back()});
        }
        std::sort(m_edges.begin() + before, m_edges.end(), isLeftOf);
        std::inplace_merge(m_edges.begin(), m_edges.begin() + before, m_edges.end(), isLeftOf);
    }

    /// Moves every edge to the next line and restores the order: edges that cross between two lines change places.
    void advanceToNextLine()
    {
        for (ActiveEdge& edge : m_edges) edge.crossing.nextLine();
        for (std::size_t i = 1; i < m_edges.size(); ++i) {
            if (!isLeftOf(m_edges[i], m_edges[i - 1])) continue;
            const ActiveEdge moving = m_edges[i];
            std::size_t      place  = i;
            for (; place > 0 && isLeftOf(moving, m_edges[place - 1]); --place) m_edges[place] = m_edges[place - 1];
            m_edges[place] = moving;
        }
    }

    std::span<const ActiveEdge> view() const { return m_edges; }
    std::size_t                 bytes() const { return m_edges.capacity() * sizeof(ActiveEdge); }

private:
    static bool isLeftOf(const ActiveEdge& a, const ActiveEdge& b) { return a.crossing.isLeftOf(b.crossing); }

    static ActiveEdge activate(const ScreenTriangle& part, const EdgeStart& start, int y)
    {
        std::size_t top = start.side, bottom = (start.side + 1) % 3;
        if (part.y[bottom] < part.y[top]) std::swap(top, bottom);
        const auto lines = EdgeTable::linesOf(part, start.side);
        return {EdgeStepper(part.x[top], part.y[top], part.x[bottom], part.y[bottom], y, lines.end - 1), start.part,
                start.side, lines.end - 1};
    }

    std::vector<ActiveEdge> m_edges;  // from left to right
};

}  // namespace zscope
