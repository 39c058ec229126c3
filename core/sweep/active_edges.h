// The active edge table: the edges that cross the current line, from left to right.
//
// Order      by the crossing with the line's centre, as finely as LineCrossing holds it, so that crossings less than a
//            hundred-thousandth of a subpixel apart may stand either way, which moves no pixel
// Cost       per line one pass that drops, steps and merges with the newcomers, from one list to another: what is read
//            was not just written. Sorting is by insertion, as neighbours rarely change places, until that has moved
//            more edges than sorting the line outright would: never worse than n log n
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/sweep/active_edge.h"
#include "core/sweep/edge_table.h"

namespace zscope {

class ActiveEdges {
public:
    void clear() { m_edges.count = 0; }

    /// Moves on to line y: edges whose last line lies above it leave, the others step, those of the table's bucket for
    /// the line enter, and all stand from left to right.
    void advanceTo(int y, const EdgeTable& table)
    {
        const std::span<const ActiveEdge> entering = inOrder(table, y);
        NearlySorted                      order(m_next, m_edges.count + entering.size());
        std::size_t                       entered = 0;
        const auto                        enter   = [&] {
            order.append(entering[entered], entering[entered].crossing());
            ++entered;
        };
        for (const ActiveEdge& edge : m_edges.view()) {
            if (edge.lastLine() < y) continue;
            const LineCrossing now =
                edge.isWide() ? ActiveEdge::placed(table.sideOf(edge), y) : edge.crossing().onNextLine();
            while (entered < entering.size() && entering[entered].crossing().isLeftOf(now)) enter();
            order.append(edge, now);
        }
        while (entered < entering.size()) enter();
        order.finish();
        std::swap(m_edges, m_next);
    }

    std::span<const ActiveEdge> view() const { return m_edges.view(); }
    std::size_t                 bytes() const { return m_edges.bytes() + m_next.bytes() + m_entering.bytes(); }

private:
    /// A vector that knows its size before it is filled, so that appending is storing.
    struct List {
        std::vector<ActiveEdge> edges;
        std::size_t             count = 0;

        void begin(std::size_t most)
        {
            if (edges.size() < most) edges.resize(2 * most);
            count = 0;
        }
        std::span<const ActiveEdge> view() const { return std::span(edges).first(count); }
        std::size_t                 bytes() const { return edges.capacity() * sizeof(ActiveEdge); }
    };

    /// Insertion sort that gives up, and sorts outright at the end, once it has moved four times as many edges as there
    /// are.
    class NearlySorted {
    public:
        /// Fills `list` anew with at most `most` edges.
        NearlySorted(List& list, std::size_t most) : m_list(list), m_movesLeft(4 * most + 1) { list.begin(most); }

        void append(const ActiveEdge& edge, LineCrossing crossing)
        {
            ActiveEdge* const place = m_list.edges.data() + m_list.count++;
            *place                  = edge;
            place->standAt(crossing);
            if (m_list.count > 1 && crossing.isLeftOf(place[-1].crossing())) moveLeft(m_list.count - 1);
        }
        void finish()
        {
            if (m_movesLeft > 0) return;
            std::ranges::sort(m_list.edges.begin(), m_list.edges.begin() + static_cast<std::ptrdiff_t>(m_list.count),
                              [](const ActiveEdge& a, const ActiveEdge& b) { return a.isLeftOf(b); });
        }

    private:
        void moveLeft(std::size_t place)
        {
            std::vector<ActiveEdge>& edges = m_list.edges;
            const ActiveEdge         edge  = edges[place];
            for (; place > 0 && edge.isLeftOf(edges[place - 1]) && m_movesLeft > 0; --place, --m_movesLeft)
                edges[place] = edges[place - 1];
            edges[place] = edge;
        }

        List&       m_list;
        std::size_t m_movesLeft;
    };

    /// The edges of a bucket, which stand by pixels, by their places.
    std::span<const ActiveEdge> inOrder(const EdgeTable& table, int y)
    {
        if (y + 1 < table.endLine())  // they lie anywhere in the table: those of the next line are fetched meanwhile
            for (const std::uint32_t edge : table.startingAt(y + 1)) __builtin_prefetch(&table[edge]);
        const std::span<const std::uint32_t> bucket = table.startingAt(y);
        NearlySorted                         order(m_entering, bucket.size());
        for (const std::uint32_t edge : bucket) order.append(table[edge], table[edge].crossing());
        order.finish();
        return m_entering.view();
    }

    List m_edges;     // from left to right
    List m_next;      // of the next line; scratch
    List m_entering;  // likewise
};

}  // namespace zscope
