#include "core/plain/edge_table.h"

#include <algorithm>
#include <array>
#include <new>

namespace zscope::plain {

bool Edge::isLeftOf(const Edge& other) const
{
    if (crossing.x() != other.crossing.x()) return crossing.x() < other.crossing.x();
    __extension__ using Wide = __int128;
    const Wide here          = Wide{crossing.fraction()} * other.crossing.dy(),
               there         = Wide{other.crossing.fraction()} * crossing.dy();
    if (here != there) return here < there;
    return closes() && !other.closes();
}

void EdgeTable::clear(int firstLine, int endLine, std::uint64_t memory)
{
    m_firstLine = firstLine;
    m_endLine   = endLine;
    m_memory    = memory;
    m_polygons.clear();
    m_edges.clear();
    m_places.clear();
}

void EdgeTable::add(const Polygon& polygon, Inside inside, std::span<const ScreenSide> sides, double top,
                    const ChosenRules& rules)
{
    const auto part = static_cast<std::uint32_t>(m_polygons.size());
    m_polygons.push_back(polygon);
    for (const ScreenSide& side : sides) {
        if (rules.isSkippedAsHorizontal(side.xa, side.xb)) continue;  // a fault
        const double upper = std::min(side.ya, side.yb);
        // firstLineOfTriangle(): with a fault, a line late
        const int from  = upper == top ? rules.firstLineOfTriangle(upper) : firstLineFrom(upper);
        const int first = std::max(m_firstLine, from),
                  end   = std::min(m_endLine, firstLineFrom(std::max(side.ya, side.yb)));
        if (first >= end) continue;
        Edge edge;
        edge.side      = side;
        edge.polygon   = part;
        edge.firstLine = first;
        edge.lastLine  = end - 1;
        edge.winding   = inside == Inside::EvenOdd ? 1u << 31 : edge.closes() ? 1u : ~0u;
        edge.crossing  = edge.closes()
                             ? EdgeStepper<std::int64_t>(side.xa, side.ya, side.xb, side.yb, first, edge.lastLine)
                             : EdgeStepper<std::int64_t>(side.xb, side.yb, side.xa, side.ya, first, edge.lastLine);
        if (rules.stepsByWholeSubpixels()) edge.crossing.stepByWholeSubpixels();  // a fault
        m_edges.push_back(edge);
    }
    if (bytes() > m_memory) throw std::bad_alloc();
}

void EdgeTable::add(const ScreenTriangle& triangle, const ChosenRules& rules)
{
    const auto &                    x = triangle.x, &y = triangle.y;
    const std::array<ScreenSide, 3> sides{
        {{x[0], y[0], x[1], y[1]}, {x[1], y[1], x[2], y[2]}, {x[2], y[2], x[0], y[0]}}};
    add({triangle.depth, triangle.id, triangle.patterned}, Inside::EvenOdd, sides, std::min({y[0], y[1], y[2]}), rules);
}

void EdgeTable::fillBuckets()
{
    const auto bucketOf = [this](const Edge& edge) { return static_cast<std::size_t>(edge.firstLine - m_firstLine); };
    m_buckets.assign(static_cast<std::size_t>(m_endLine - m_firstLine) + 1, 0);
    for (const Edge& edge : m_edges) ++m_buckets[bucketOf(edge) + 1];
    for (std::size_t line = 1; line < m_buckets.size(); ++line) m_buckets[line] += m_buckets[line - 1];
    std::vector<std::uint32_t> next(m_buckets.begin(), m_buckets.end() - 1);  // free place of each bucket
    m_places.resize(m_edges.size());
    for (std::uint32_t i = 0; i < m_edges.size(); ++i) m_places[next[bucketOf(m_edges[i])]++] = i;
}

std::span<const std::uint32_t> EdgeTable::startingAt(int line) const
{
    const auto bucket = static_cast<std::size_t>(line - m_firstLine);
    return std::span(m_places).subspan(m_buckets[bucket], m_buckets[bucket + 1] - m_buckets[bucket]);
}

std::size_t EdgeTable::bytes() const
{
    return m_polygons.capacity() * sizeof(Polygon) + m_edges.capacity() * sizeof(Edge)
           + (m_places.capacity() + m_buckets.capacity()) * sizeof(std::uint32_t);
}

}  // namespace zscope::plain
