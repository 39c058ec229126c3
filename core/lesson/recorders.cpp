#include "core/lesson/recorders.h"

#include <algorithm>
#include <numeric>

namespace zscope {

namespace {

/// The edge as a lesson shows it on line y, one that it crosses.
EdgeRow rowOf(const EdgeTable& table, const ActiveEdge& edge, int y)
{
    const ScreenTriangle& part = table.parts()[edge.polygon()];
    const std::size_t     a = edge.side(), b = (a + 1u) % 3;
    auto dx = static_cast<std::int64_t>(part.x[b]) - static_cast<std::int64_t>(part.x[a]);
    auto dy = static_cast<std::int64_t>(part.y[b]) - static_cast<std::int64_t>(part.y[a]);
    if (dy < 0) dx = -dx, dy = -dy;
    const std::int64_t common   = std::gcd(dx, dy);
    const auto         crossing = edge.stepper<std::int64_t>(part, y, y);

    EdgeRow row;
    row.polygon    = part.id;
    row.xSubpixels = crossing.x();
    row.x          = (static_cast<double>(crossing.x()) +
             static_cast<double>(crossing.fraction()) / static_cast<double>(crossing.dy())) / kSubpixels;
    row.dx         = {dx / common, dy / common};
    row.firstLine  = EdgeTable::linesOf(part, edge.side()).first;
    row.lastLine   = edge.lastLine();
    return row;
}

}  // namespace

void SweepRecorder::observe(const EdgeTableReady& e) { m_table = &e.table; }

void SweepRecorder::beginLineIfOver()
{
    if (!m_lineIsOver) return;
    m_lineIsOver = false;
    m_entered.clear();
    m_left.clear();
    m_spans.clear();
}

void SweepRecorder::observe(const EdgeLeft& e)
{
    beginLineIfOver();
    m_left.push_back(e.edge);
    m_left.back().setPolygon(e.part);
}

void SweepRecorder::observe(const EdgeEntered& e)
{
    beginLineIfOver();
    m_entered.push_back(e.edge);
    m_entered.back().setPolygon(e.part);
}

void SweepRecorder::observe(const ScanlineReady& e)
{
    beginLineIfOver();
    m_y = e.y;
    m_active.assign(e.active.begin(), e.active.end());
    for (ActiveEdge& edge : m_active) edge.setPolygon(e.polygons[edge.polygon()].part);
    m_polygons.clear();
    for (const ActivePolygon& polygon : e.polygons.rows())
        if (polygon.edges > 0) m_polygons.push_back(polygon.id);
}

void SweepRecorder::observe(const SpanFilled& e) { m_spans.push_back({e.x0, e.x1, e.triangle}); }

std::optional<SweepState> SweepRecorder::state() const
{
    if (!m_table) return std::nullopt;
    SweepState state;
    state.y     = m_y;
    state.spans = m_spans;
    for (const ActiveEdge& edge : m_active) state.activeEdges.push_back(rowOf(*m_table, edge, m_y));
    state.activePolygons = m_polygons;
    std::ranges::sort(state.activePolygons);
    // Not std::ranges::unique: clang 14 cannot compile the standard library's.
    state.activePolygons.erase(std::unique(state.activePolygons.begin(), state.activePolygons.end()),
                               state.activePolygons.end());
    for (const ActiveEdge& edge : m_entered) state.entered.push_back(rowOf(*m_table, edge, m_y));
    for (const ActiveEdge& edge : m_left) state.left.push_back(rowOf(*m_table, edge, edge.lastLine()));
    for (int y = m_table->firstLine(); y < m_table->endLine(); ++y)
        state.edgesStarting.push_back(static_cast<int>(m_table->startingAt(y).size()));
    return state;
}

void TriangleRecorder::observe(const TriangleReached& e)
{
    m_triangle.emplace();
    m_triangle->triangle = e.triangle.id;
    for (std::size_t i = 0; i < 3; ++i) m_triangle->corners[i] = {e.triangle.x[i] / kSubpixels, e.triangle.y[i] / kSubpixels};
}

void TriangleRecorder::observe(const PixelTested& e)
{
    if (m_triangle) m_triangle->pixelsWon += e.won;
}

void PixelRecorder::observe(const PixelTested& e)
{
    PixelState pixel{e.x, e.y, e.triangle, e.depth, e.won, std::nullopt, 0, e.keep};
    if (e.rivalRank != 0) {
        pixel.rival      = TriangleId{e.rivalRank - 1};
        pixel.rivalDepth = e.rivalDepth;
    }
    m_pixel = pixel;
}

}  // namespace zscope
