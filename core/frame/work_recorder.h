// Counts the work of a frame. Every triangle of the scene ends in exactly one of the counters from
// triangles_transparent to triangles_drawn, so that triangles_in is their sum. A depth pre-pass is counted apart. What
// can be said of a node or of the triangles in it is counted again per depth of its tree.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/stages.h"
#include "core/cull/cull_events.h"
#include "core/depth/visibility_buffer.h"
#include "core/frame/frame_events.h"
#include "core/frame/frame_work.h"
#include "core/geometry/geometry_events.h"
#include "core/plain/active_edges.h"
#include "core/probe/recorders.h"
#include "core/scan/pixel_events.h"
#include "core/scene/scene.h"
#include "core/sweep/blend_events.h"

namespace zscope {

class WorkRecorder {
public:
    using Events = Wants<StageStarted, TransparentLeftOut, BatchOutside, BatchTransformed, TriangleSetUp, FaceSetUpAs,
                         NodeRecalled, NodeJudged, NodeDrawn, TriangleHidden, TrianglePassed, TriangleReached,
                         CellUpdated, plain::EdgeTableReady, plain::LineReady, SpanFilled, PixelTested, TileTested,
                         FragmentsJudged, PixelBlended>;

    explicit WorkRecorder(const Scene& scene) : m_scene(scene) {}

    void observe(const StageStarted& e)
    {
        m_inPrepass = e.stage == Stage::Prepass;
        m_here      = nullptr;
    }

    void observe(const TransparentLeftOut& e) { add(SetUp::Transparent, e.triangles); }
    void observe(const BatchOutside& e)
    {
        if (m_inPrepass) return;
        ++m_batchesOutside;
        add(SetUp::Outside, e.triangles);
    }
    void observe(const BatchTransformed& e)
    {
        ++m_batches;
        m_vertices += e.vertices;
    }
    void observe(const TriangleSetUp& e)
    {
        ++m_setUp;
        if (m_inPrepass) {
            m_drawnInPrepass += e.fate == SetUp::Drawn;
            return;
        }
        add(e.fate, 1);
        if (m_here) m_here->trianglesDrawn += e.fate == SetUp::Drawn;
        m_clipped += e.cut;
        m_wide += e.wide;
    }

    void observe(const FaceSetUpAs& e)
    {
        ++m_polygons[static_cast<std::size_t>(e.how)];
        m_polygonsDrawn += e.isDrawn;
    }

    /// What is drawn ahead of a node's verdict is no longer there to be outside or hidden with it.
    void observe(const NodeRecalled& e)
    {
        DepthWork& work = at(e.place);
        ++work.nodesRecalled;
        m_here                  = &work;
        const std::uint32_t own = e.place.node.size();
        for (const TreeNode* node = &e.place.node; node; node = node->parent) m_ahead[{e.place.instance, node}] += own;
        m_ahead[{e.place.instance, nullptr}] += own;
    }
    void observe(const NodeJudged& e)
    {
        if (m_inPrepass) return;
        DepthWork& work = at(e.place);
        ++work.nodesVisited;
        if (e.query) ask(*e.query, &work);
        switch (e.verdict) {
            case Verdict::Outside: {
                const std::uint64_t triangles = trianglesBelow(e.place);
                ++work.nodesOutside;
                work.trianglesOutside += triangles;
                add(SetUp::Outside, triangles);
                break;
            }
            case Verdict::Hidden:
                ++work.nodesHidden;
                work.trianglesHiddenByNode += trianglesBelow(e.place);
                break;
            case Verdict::Entered:
                ++work.nodesEntered;
                break;
            case Verdict::Small:
                ++work.nodesDropped;
                work.trianglesDropped += trianglesBelow(e.place);
                break;
        }
    }
    void observe(const NodeDrawn& e)
    {
        if (m_inPrepass) return;
        DepthWork& work = at(e.place);
        ++work.nodesDrawn;
        m_here = &work;
    }
    /// A triangle is hidden if all its parts are; the parts come one after another.
    void observe(const TriangleHidden& e)
    {
        ask(e.query, m_here);
        if (m_lastPart == e.triangle) return;
        m_lastPart       = e.triangle;
        m_lastPartHidden = true;
        countHidden(1);
    }
    void observe(const TrianglePassed& e) { ask(e.query, m_here); }
    void observe(const TriangleReached& e)
    {
        if (m_inPrepass) return;
        if (m_lastPart == e.triangle.id && m_lastPartHidden) countHidden(-1);
        m_lastPart       = e.triangle.id;
        m_lastPartHidden = false;
    }

    void observe(const CellUpdated& e)
    {
        const auto above = static_cast<std::size_t>(e.write.level - Pyramid::kTileLevel);
        while (m_levels.size() <= above)
            m_levels.push_back({.level = Pyramid::kTileLevel + static_cast<int>(m_levels.size())});
        ++m_levels[above].cellsWritten;
        m_levels[above].cellsChanged += e.write.after != e.write.before;
    }

    void observe(const plain::EdgeTableReady& e) { m_edges += e.table.edgeCount(); }
    void observe(const plain::LineReady& e) { m_edgeLines += e.active.size(); }
    void observe(const SpanFilled&) { ++m_spans; }
    void observe(const PixelTested& e)
    {
        m_fragmentsShaded += e.shaded;
        m_fragmentsDiscarded += e.discarded;
        m_fragmentsMoved += e.moved;
        m_fragmentsMovedBehind += e.moved && !e.won;
        if (e.keep == Keep::DepthOnly) {
            ++m_prepassPixels;
            return;
        }
        ++m_pixelsTested;
        m_pixelsWon += e.won;
    }

    void observe(const TileTested& e) { m_tilesRejected += e.rejected; }

    /// The picture is finished, and each of its pixels that shows a triangle is shaded now.
    void shadedOnce(const VisibilityBuffer& visible)
    {
        for (int y = 0; y < visible.height(); ++y)
            for (int x = 0; x < visible.width(); ++x) m_fragmentsShaded += visible.rankAt(x, y) != 0;
    }
    void observe(const FragmentsJudged& e)
    {
        m_transparentFragments += e.found;
        m_transparentHidden += e.hidden;
    }
    void observe(const PixelBlended&) { ++m_pixelsBlended; }

    FrameWork work() const
    {
        FrameWork work{counts(), m_levels, {}};
        for (const auto& tree : m_depths) work.depths.insert(work.depths.end(), tree.begin(), tree.end());
        return work;
    }

private:
    std::vector<NamedCount> counts() const
    {
        return {{"triangles_in", m_scene.triangleCount()},
                {"triangles_transparent", fate(SetUp::Transparent)},
                {"triangles_outside", fate(SetUp::Outside)},
                {"triangles_clipped_away", fate(SetUp::ClippedAway)},
                {"triangles_back_facing", fate(SetUp::BackFacing)},
                {"triangles_degenerate", fate(SetUp::Degenerate)},
                {"triangles_no_pixel_centre", fate(SetUp::NoPixelCentre)},
                {"triangles_out_of_range", fate(SetUp::OutOfRange)},
                {"triangles_hidden_by_node", total(&DepthWork::trianglesHiddenByNode)},
                {"triangles_hidden", m_hidden},
                {"triangles_dropped_with_node", total(&DepthWork::trianglesDropped)},
                {"triangles_drawn", fate(SetUp::Drawn) - m_hidden},
                {"triangle_set_ups", m_setUp},
                {"triangles_clipped", m_clipped},
                {"triangles_wide", m_wide},
                {"batches_drawn", m_batches},
                {"batches_outside", m_batchesOutside},
                {"vertices_transformed", m_vertices},
                {"nodes_recalled", total(&DepthWork::nodesRecalled)},
                {"nodes_visited", total(&DepthWork::nodesVisited)},
                {"nodes_outside", total(&DepthWork::nodesOutside)},
                {"nodes_hidden", total(&DepthWork::nodesHidden)},
                {"nodes_entered", total(&DepthWork::nodesEntered)},
                {"nodes_drawn", total(&DepthWork::nodesDrawn)},
                {"nodes_dropped", total(&DepthWork::nodesDropped)},
                {"pyramid_queries", m_queries},
                {"pyramid_cells_read", m_cells},
                {"updates", m_levels.empty() ? 0 : m_levels.front().cellsWritten},
                {"pyramid_writes", total(&LevelWork::cellsWritten)},
                {"pyramid_levels_updated", total(&LevelWork::cellsChanged)},
                {"polygons_set_up", m_polygons[0] + m_polygons[1] + m_polygons[2] + m_polygons[3]},
                {"polygons_drawn", m_polygonsDrawn},
                {"polygons_that_are_triangles", m_polygons[static_cast<std::size_t>(FaceSetUpAs::How::Triangle)]},
                {"polygons_by_outline", m_polygons[static_cast<std::size_t>(FaceSetUpAs::How::Outline)]},
                {"polygons_by_ears_unlike_turns", m_polygons[static_cast<std::size_t>(FaceSetUpAs::How::UnlikeTurns)]},
                {"polygons_by_ears_thin", m_polygons[static_cast<std::size_t>(FaceSetUpAs::How::Thin)]},
                {"edges", m_edges},
                {"active_edge_lines", m_edgeLines},
                {"spans", m_spans},
                {"prepass_triangles_drawn", m_drawnInPrepass},
                {"prepass_pixels_tested", m_prepassPixels},
                {"pixels_tested", m_pixelsTested},
                {"pixels_won", m_pixelsWon},
                {"tiles_rejected", m_tilesRejected},
                {"fragments_tested", m_prepassPixels + m_pixelsTested},
                {"fragments_shaded", m_fragmentsShaded},
                {"fragments_discarded", m_fragmentsDiscarded},
                {"fragments_moved", m_fragmentsMoved},
                {"fragments_moved_and_hidden", m_fragmentsMovedBehind},
                {"fragments_transparent", m_transparentFragments},
                {"fragments_transparent_hidden", m_transparentHidden},
                {"pixels_blended", m_pixelsBlended}};
    }

    void add(SetUp setUp, std::uint64_t triangles)
    {
        if (!m_inPrepass) m_fates[static_cast<std::size_t>(setUp)] += triangles;
    }
    std::uint64_t fate(SetUp setUp) const { return m_fates[static_cast<std::size_t>(setUp)]; }

    /// The list of the place's tree grows to its depth; all depths above have been visited before.
    DepthWork& at(const NodePlace& place)
    {
        auto& depths = m_depths[place.isInstanceTree ? 0 : 1];
        while (depths.size() <= static_cast<std::size_t>(place.node.depth))
            depths.push_back({.isInstanceTree = place.isInstanceTree, .depth = static_cast<int>(depths.size())});
        return depths[static_cast<std::size_t>(place.node.depth)];
    }
    std::uint64_t total(std::uint64_t DepthWork::*figure) const
    {
        std::uint64_t sum = 0;
        for (const auto& tree : m_depths)
            for (const DepthWork& work : tree) sum += work.*figure;
        return sum;
    }

    std::uint64_t total(std::uint64_t LevelWork::*figure) const
    {
        std::uint64_t sum = 0;
        for (const LevelWork& work : m_levels) sum += work.*figure;
        return sum;
    }

    /// Also a triangle whose next part turns out to be drawn was counted as drawn at set-up.
    void countHidden(int triangles)
    {
        m_hidden += static_cast<std::uint64_t>(triangles);
        if (!m_here) return;
        m_here->trianglesHidden += static_cast<std::uint64_t>(triangles);
        m_here->trianglesDrawn -= static_cast<std::uint64_t>(triangles);
    }

    void ask(const PyramidQuery& query, DepthWork* work)
    {
        const auto cells = static_cast<std::uint64_t>(query.cells);
        ++m_queries;
        m_cells += cells;
        if (!work) return;
        ++work->queries;
        work->cellsRead += cells;
    }

    /// Of those that are still to be drawn.
    std::uint64_t trianglesBelow(const NodePlace& place) const
    {
        if (!place.isInstanceTree) return place.node.size() - ahead(place.instance, &place.node);
        std::uint64_t triangles = 0;
        for (const std::uint32_t item : place.tree.allItems(place.node))
            triangles += m_scene.meshOf(InstanceId{item}).triangles.size() - ahead(InstanceId{item}, nullptr);
        return triangles;
    }
    std::uint64_t ahead(InstanceId instance, const TreeNode* node) const
    {
        if (m_ahead.empty()) return 0;
        const auto found = m_ahead.find({instance, node});
        return found == m_ahead.end() ? 0 : found->second;
    }

    const Scene&                         m_scene;
    bool                                 m_inPrepass = false;
    std::array<std::uint64_t, 8>         m_fates{};     // by SetUp
    std::vector<LevelWork>               m_levels;      // of the pyramid, from the tiles up
    std::array<std::uint64_t, 4>         m_polygons{};  // by FaceSetUpAs::How
    std::uint64_t                        m_polygonsDrawn = 0;
    std::array<std::deque<DepthWork>, 2> m_depths;          // instance tree, mesh trees; [depth]
    DepthWork*                           m_here = nullptr;  // of the node whose triangles are being drawn, if any
    /// Triangles drawn ahead of the visit, below each node of an instance's mesh tree; nullptr: in the whole instance.
    std::map<std::pair<InstanceId, const TreeNode*>, std::uint64_t> m_ahead;
    std::optional<TriangleId>                                       m_lastPart;
    bool                                                            m_lastPartHidden = false;
    std::uint64_t m_setUp = 0, m_drawnInPrepass = 0, m_hidden = 0, m_queries = 0, m_cells = 0;
    std::uint64_t m_clipped = 0, m_wide = 0, m_batches = 0, m_batchesOutside = 0, m_vertices = 0;
    std::uint64_t m_edges = 0, m_edgeLines = 0, m_spans = 0, m_prepassPixels = 0, m_pixelsTested = 0, m_pixelsWon = 0;
    std::uint64_t m_tilesRejected = 0, m_fragmentsShaded = 0, m_fragmentsDiscarded = 0;
    std::uint64_t m_fragmentsMoved = 0, m_fragmentsMovedBehind = 0;
    std::uint64_t m_transparentFragments = 0, m_transparentHidden = 0, m_pixelsBlended = 0;
};

}  // namespace zscope
