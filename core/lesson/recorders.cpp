#include "core/lesson/recorders.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace zscope {

namespace {

/// The edge as a lesson shows it on line y, one that it crosses.
EdgeRow rowOf(const plain::EdgeTable& table, const plain::Edge& edge, int y)
{
    const ScreenSide& side = edge.side;
    auto              dx   = static_cast<std::int64_t>(side.xb) - static_cast<std::int64_t>(side.xa);
    auto              dy   = static_cast<std::int64_t>(side.yb) - static_cast<std::int64_t>(side.ya);
    if (dy < 0) dx = -dx, dy = -dy;
    const std::int64_t common   = std::gcd(dx, dy);
    const auto         crossing = edge.closes() ? EdgeStepper<std::int64_t>(side.xa, side.ya, side.xb, side.yb, y, y)
                                                : EdgeStepper<std::int64_t>(side.xb, side.yb, side.xa, side.ya, y, y);

    EdgeRow row;
    row.polygon    = table.polygons()[edge.polygon].id;
    row.xSubpixels = crossing.x();
    row.x          = (static_cast<double>(crossing.x())
             + static_cast<double>(crossing.fraction()) / static_cast<double>(crossing.dy()))
            / kSubpixels;
    row.dx        = {dx / common, dy / common};
    row.firstLine = edge.firstLine;
    row.lastLine  = edge.lastLine;
    return row;
}

}  // namespace

void SweepRecorder::observe(const plain::EdgeTableReady& e) { m_table = &e.table; }

void SweepRecorder::beginLineIfOver()
{
    if (!m_lineIsOver) return;
    m_lineIsOver = false;
    m_entered.clear();
    m_left.clear();
    m_spans.clear();
}

void SweepRecorder::observe(const plain::EdgeLeft& e)
{
    beginLineIfOver();
    m_left.push_back(e.edge);
}

void SweepRecorder::observe(const plain::EdgeEntered& e)
{
    beginLineIfOver();
    m_entered.push_back(e.edge);
}

void SweepRecorder::observe(const plain::LineReady& e)
{
    beginLineIfOver();
    m_y = e.y;
    m_active.assign(e.active.begin(), e.active.end());
}

void SweepRecorder::observe(const SpanFilled& e) { m_spans.push_back({e.x0, e.x1, e.triangle}); }

std::optional<SweepState> SweepRecorder::state() const
{
    if (!m_table) return std::nullopt;
    SweepState state;
    state.y     = m_y;
    state.spans = m_spans;
    for (const plain::Edge& edge : m_active) state.activeEdges.push_back(rowOf(*m_table, edge, m_y));
    for (const plain::Edge& edge : m_active) state.activePolygons.push_back(m_table->polygons()[edge.polygon].id);
    std::ranges::sort(state.activePolygons);
    // Not std::ranges::unique: clang 14 cannot compile the standard library's.
    state.activePolygons.erase(std::unique(state.activePolygons.begin(), state.activePolygons.end()),
                               state.activePolygons.end());
    for (const plain::Edge& edge : m_entered) state.entered.push_back(rowOf(*m_table, edge, m_y));
    for (const plain::Edge& edge : m_left) state.left.push_back(rowOf(*m_table, edge, edge.lastLine));
    for (int y = m_table->firstLine(); y < m_table->endLine(); ++y)
        state.edgesStarting.push_back(static_cast<int>(m_table->startingAt(y).size()));
    return state;
}

void TriangleRecorder::observe(const TriangleReached& e)
{
    m_triangle.emplace();
    m_triangle->triangle = e.triangle.id;
    for (std::size_t i = 0; i < 3; ++i)
        m_triangle->corners[i] = {e.triangle.x[i] / kSubpixels, e.triangle.y[i] / kSubpixels};
}

void TriangleRecorder::observe(const PixelTested& e)
{
    if (m_triangle) m_triangle->pixelsWon += e.won;
}

void PixelRecorder::observe(const PixelTested& e)
{
    PixelState pixel{e.x, e.y,    e.triangle, e.depth,     e.won,       std::nullopt,
                     0,   e.keep, e.shaded,   e.discarded, std::nullopt};
    if (e.moved) pixel.unmovedDepth = e.unmovedDepth;
    if (e.rivalRank != 0) {
        pixel.rival      = TriangleId{e.rivalRank - 1};
        pixel.rivalDepth = e.rivalDepth;
    }
    m_pixel = pixel;
}

void IntervalRecorder::observe(const plain::IntervalDecided& e)
{
    IntervalState interval{e.y, e.x0, e.x1, {}, std::nullopt, e.reason};
    for (const std::uint32_t part : e.open) interval.open.push_back(e.polygons[part].id);
    std::ranges::sort(interval.open);
    if (e.winner) interval.winner = e.winner->id;
    m_interval = std::move(interval);
}

void HierarchyRecorder::observe(const StageStarted& e)
{
    if (e.stage == Stage::Raster) *this = {};
}

NodeRow& HierarchyRecorder::rowOf(const NodePlace& place)
{
    const std::int64_t tree   = place.isInstanceTree ? -1 : std::int64_t{place.instance.value};
    const auto [known, isNew] = m_ids.try_emplace({tree, &place.node}, static_cast<int>(m_state.nodes.size()));
    if (!isNew) return m_state.nodes[static_cast<std::size_t>(known->second)];

    NodeRow row;
    row.id  = known->second;
    row.box = place.node.bounds;
    if (!place.isInstanceTree) row.instance = place.instance;
    if (place.node.depth > 0)
        row.parent = m_ids.at({tree, place.node.parent});
    else if (!place.isInstanceTree)
        row.parent = m_instanceNode;
    row.depth = row.parent < 0 ? 0 : m_state.nodes[static_cast<std::size_t>(row.parent)].depth + 1;
    row.path  = pathOf(place.node);
    m_state.nodes.push_back(std::move(row));
    return m_state.nodes.back();
}

NodeRow& HierarchyRecorder::rowWithAncestors(const NodePlace& place)
{
    if (place.node.parent) rowWithAncestors({place.isInstanceTree, place.instance, place.tree, *place.node.parent});
    return rowOf(place);
}

void HierarchyRecorder::observe(const NodeRecalled& e)
{
    m_instanceNode = rowWithAncestors({true, {}, e.instances, e.holder}).id;
    NodeRow& row   = rowWithAncestors(e.place);
    row.verdict    = NodeVerdict::Drawn;
    row.pass       = m_state.pass;
    m_state.now    = row.id;
    m_state.query.reset();
    m_state.asked.clear();
}

void HierarchyRecorder::observe(const NodeJudged& e)
{
    NodeRow&   row      = rowOf(e.place);
    const bool wasDrawn = row.verdict == NodeVerdict::Drawn;  // by the first of two passes
    if (!wasDrawn) row.pass = m_state.pass;
    row.verdict = e.verdict == Verdict::Outside  ? NodeVerdict::Outside
                  : e.verdict == Verdict::Hidden ? NodeVerdict::Hidden
                  : e.verdict == Verdict::Small  ? NodeVerdict::Small
                  : wasDrawn                     ? NodeVerdict::Drawn
                                                 : NodeVerdict::Entered;
    m_state.now = row.id;
    if (e.query) return;  // heard when it was asked
    m_state.query.reset();
    m_state.asked.clear();
    m_state.askedAbout.reset();
}

void HierarchyRecorder::observe(const NodeOpened& e)
{
    for (const TreeNode* child : e.children) rowOf({e.place.isInstanceTree, e.place.instance, e.place.tree, *child});
}

void HierarchyRecorder::observe(const NodeDrawn& e)
{
    NodeRow& row = rowOf(e.place);
    row.verdict  = NodeVerdict::Drawn;
    if (e.place.isInstanceTree) m_instanceNode = row.id;
}

void HierarchyRecorder::observe(const PyramidAsked& e)
{
    if (e.node) m_state.now = rowOf(*e.node).id;
    m_state.query = e.query;
    m_state.asked = e.node ? "node" : "triangle";
    m_state.askedAbout.reset();
    if (!e.node) m_state.askedAbout = e.triangle;
}

void HierarchyRecorder::observe(const CellUpdated& e)
{
    if (!m_state.climb.empty() && m_state.climb.back().level + 1 != e.write.level) m_state.climb.clear();
    m_state.climb.push_back(e.write);
    m_state.update = e.write;
}

std::optional<HierarchyState> HierarchyRecorder::state(int width, int height, bool hasPyramid) const
{
    if (m_state.nodes.empty() && !m_state.query && !hasPyramid) return std::nullopt;
    HierarchyState state = m_state;
    if (!hasPyramid) return state;
    for (;; width = (width + 1) / 2, height = (height + 1) / 2) {
        state.levels.push_back({width, height});
        if (width == 1 && height == 1) return state;
    }
}

}  // namespace zscope
