#include "core/plain/active_edges.h"

#include <algorithm>

#include "core/plain/work.h"

namespace zscope::plain {

void ActiveEdges::begin(const EdgeTable& table)
{
    m_edges.clear();
    m_spans.assign(table.polygons().size(), {});
}

void ActiveEdges::retireBefore(int y, Work& work)
{
    std::erase_if(m_edges, [&](const Edge& edge) {
        if (edge.lastLine >= y) return false;
        work.tell(EdgeLeft{edge});
        return true;
    });
}

void ActiveEdges::admit(std::span<const Edge> starting, Work& work)
{
    for (const Edge& edge : starting) {
        m_edges.push_back(edge);
        work.tell(EdgeEntered{edge});
    }
}

void ActiveEdges::sortByX(Work& work)
{
    if (!work.rules.sortsActiveEdges()) return;  // a fault
    std::ranges::stable_sort(m_edges, [](const Edge& a, const Edge& b) { return a.isLeftOf(b); });
}

void ActiveEdges::advance()
{
    for (Edge& edge : m_edges) edge.crossing.nextLine();
}

int firstPixelRightOf(const Edge& edge, int width, const ChosenRules& rules)
{
    return std::clamp(rules.firstPixel(edge.crossing.firstPixel(), edge.crossing.x()), 0, width);
}

}  // namespace zscope::plain
