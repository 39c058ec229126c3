#include "core/plain/active_edges.h"

#include <algorithm>

#include "core/plain/work.h"

namespace zscope::plain {

void ActiveEdges::begin(const EdgeTable& table)
{
    m_edges.clear();
    m_spans.assign(table.polygons().size(), {});
}

void ActiveEdges::retireBefore(int y, Call work)
{
    m_changes = {};
    std::erase_if(m_edges, [&](const Edge& edge) {
        if (edge.lastLine >= y) return false;
        ++m_changes.left;
        m_changes.polygonLeft = edge.polygon;
        m_changes.lastLine    = edge.lastLine;
        work->tell(EdgeLeft{edge});
        return true;
    });
}

void ActiveEdges::admit(const EdgeTable& table, int y, Call work)
{
    for (const std::uint32_t place : table.startingAt(y)) {
        m_edges.push_back(table.edge(place));
        ++m_changes.entered;
        m_changes.polygonEntered = m_edges.back().polygon;
        work->tell(EdgeEntered{m_edges.back()});
    }
}

void ActiveEdges::sortByX(Call work)
{
    work->tally.add(Unit::ActiveEdges, m_edges.size());
    if (!work->rules.sortsActiveEdges()) return;  // a fault
    std::ranges::stable_sort(m_edges, [](const Edge& a, const Edge& b) { return a.isLeftOf(b); });
}

void ActiveEdges::advance()
{
    for (Edge& edge : m_edges) edge.crossing.nextLine();
}

std::size_t ActiveEdges::bytes() const
{
    return m_edges.capacity() * sizeof(Edge) + m_spans.capacity() * sizeof(PolygonSpan);
}

int firstPixelRightOf(const Edge& edge, int width, const ChosenRules& rules)
{
    const int first = rules.firstPixel(edge.crossing.firstPixel(), edge.crossing.x());  // a fault truncates x
    return std::clamp(first, 0, width);
}

}  // namespace zscope::plain
