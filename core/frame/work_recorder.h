// Counts the work of a frame. Every triangle of the scene ends in exactly one of the counters from
// triangles_transparent to triangles_drawn, so that triangles_in is their sum. A depth pre-pass is counted apart.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/stages.h"
#include "core/cull/cull_events.h"
#include "core/frame/frame_events.h"
#include "core/geometry/geometry_events.h"
#include "core/scan/pixel_events.h"
#include "core/scene/scene.h"
#include "core/sweep/edge_table.h"
#include "core/sweep/sweep_events.h"

namespace zscope {

class WorkRecorder {
public:
    explicit WorkRecorder(const Scene& scene) : m_scene(scene) {}

    void observe(const StageStarted& e) { m_inPrepass = e.stage == Stage::Prepass; }

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
        if (m_inPrepass) return;
        add(e.fate, 1);
        m_clipped += e.cut;
        m_wide += e.wide;
    }

    void observe(const NodeJudged& e)
    {
        if (m_inPrepass) return;
        ++m_nodes[static_cast<std::size_t>(e.verdict)];
        if (e.query) ask(*e.query);
        if (e.verdict == Verdict::Outside) add(SetUp::Outside, trianglesBelow(e.place));
        if (e.verdict == Verdict::Hidden) m_hiddenByNode += trianglesBelow(e.place);
    }
    /// A triangle is hidden if all its parts are; the parts come one after another.
    void observe(const TriangleHidden& e)
    {
        ask(e.query);
        if (m_lastPart == e.triangle) return;
        m_lastPart = e.triangle;
        m_lastPartHidden = true;
        ++m_hidden;
    }
    void observe(const TrianglePassed& e) { ask(e.query); }
    void observe(const TriangleReached& e)
    {
        if (m_inPrepass) return;
        if (m_lastPart == e.triangle.id && m_lastPartHidden) --m_hidden;
        m_lastPart       = e.triangle.id;
        m_lastPartHidden = false;
    }

    void observe(const EdgeTableReady& e) { m_edges += e.table.edgeCount(); }
    void observe(const ScanlineReady& e) { m_edgeLines += e.active.size(); }
    void observe(const SpanFilled&) { ++m_spans; }
    void observe(const PixelTested& e)
    {
        if (e.keep == Keep::DepthOnly) {
            ++m_prepassPixels;
            return;
        }
        ++m_pixelsTested;
        m_pixelsWon += e.won;
    }

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
                {"triangles_hidden_by_node", m_hiddenByNode},
                {"triangles_hidden", m_hidden},
                {"triangles_drawn", fate(SetUp::Drawn) - m_hidden},
                {"triangles_clipped", m_clipped},
                {"triangles_wide", m_wide},
                {"batches_drawn", m_batches},
                {"batches_outside", m_batchesOutside},
                {"vertices_transformed", m_vertices},
                {"nodes_outside", nodes(Verdict::Outside)},
                {"nodes_hidden", nodes(Verdict::Hidden)},
                {"nodes_entered", nodes(Verdict::Entered)},
                {"pyramid_queries", m_queries},
                {"pyramid_cells_read", m_cells},
                {"edges", m_edges},
                {"active_edge_lines", m_edgeLines},
                {"spans", m_spans},
                {"prepass_pixels_tested", m_prepassPixels},
                {"pixels_tested", m_pixelsTested},
                {"pixels_won", m_pixelsWon}};
    }

private:
    void add(SetUp setUp, std::uint64_t triangles)
    {
        if (!m_inPrepass) m_fates[static_cast<std::size_t>(setUp)] += triangles;
    }
    std::uint64_t fate(SetUp setUp) const { return m_fates[static_cast<std::size_t>(setUp)]; }
    std::uint64_t nodes(Verdict verdict) const { return m_nodes[static_cast<std::size_t>(verdict)]; }

    void ask(const PyramidQuery& query)
    {
        ++m_queries;
        m_cells += static_cast<std::uint64_t>(query.cells);
    }

    std::uint64_t trianglesBelow(const NodePlace& place) const
    {
        if (!place.isInstanceTree) return place.node.size();
        std::uint64_t triangles = 0;
        for (const std::uint32_t item : place.tree.allItems(place.node))
            triangles += m_scene.meshOf(InstanceId{item}).triangles.size();
        return triangles;
    }

    const Scene&                 m_scene;
    bool                         m_inPrepass = false;
    std::array<std::uint64_t, 8> m_fates{};  // by SetUp
    std::array<std::uint64_t, 3> m_nodes{};  // by Verdict
    std::optional<TriangleId>    m_lastPart;
    bool                         m_lastPartHidden = false;
    std::uint64_t m_hiddenByNode = 0, m_hidden = 0, m_queries = 0, m_cells = 0;
    std::uint64_t m_clipped = 0, m_wide = 0, m_batches = 0, m_batchesOutside = 0, m_vertices = 0;
    std::uint64_t m_edges = 0, m_edgeLines = 0, m_spans = 0, m_prepassPixels = 0, m_pixelsTested = 0, m_pixelsWon = 0;
};

}  // namespace zscope
