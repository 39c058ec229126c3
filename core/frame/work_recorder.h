// Counts the work of a frame. Every triangle of the scene ends in exactly one of the triangle counters, so that
// triangles_in is their sum.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/stages.h"
#include "core/geometry/geometry_events.h"
#include "core/scan/pixel_events.h"
#include "core/sweep/edge_table.h"
#include "core/sweep/sweep_events.h"

namespace zscope {

class WorkRecorder {
public:
    void observe(const InstanceReached& e)
    {
        ++m_instances;
        m_in += std::uint64_t{e.opaque} + e.transparent;
        fate(SetUp::Transparent) += e.transparent;
    }
    void observe(const BatchOutside& e)
    {
        ++m_batchesOutside;
        fate(SetUp::Outside) += e.triangles;
    }
    void observe(const BatchTransformed& e)
    {
        ++m_batches;
        m_vertices += e.vertices;
    }
    void observe(const TriangleSetUp& e)
    {
        ++fate(e.fate);
        m_clipped += e.clippedParts != 1 && e.fate != SetUp::ClippedAway;
        m_wide += e.wide;
    }
    void observe(const EdgeTableReady& e)
    {
        m_edges += e.table.edgeCount();
    }
    void observe(const ScanlineReady& e) { m_edgeLines += e.active.size(); }
    void observe(const SpanFilled&) { ++m_spans; }
    void observe(const PixelTested& e)
    {
        ++m_pixelsTested;
        m_pixelsWon += e.won;
    }

    std::vector<NamedCount> counts() const
    {
        return {{"triangles_in", m_in},
                {"triangles_transparent", fate(SetUp::Transparent)},
                {"triangles_outside", fate(SetUp::Outside)},
                {"triangles_clipped_away", fate(SetUp::ClippedAway)},
                {"triangles_back_facing", fate(SetUp::BackFacing)},
                {"triangles_degenerate", fate(SetUp::Degenerate)},
                {"triangles_no_pixel_centre", fate(SetUp::NoPixelCentre)},
                {"triangles_out_of_range", fate(SetUp::OutOfRange)},
                {"triangles_drawn", fate(SetUp::Drawn)},
                {"triangles_clipped", m_clipped},
                {"triangles_wide", m_wide},
                {"instances", m_instances},
                {"batches_drawn", m_batches},
                {"batches_outside", m_batchesOutside},
                {"vertices_transformed", m_vertices},
                {"edges", m_edges},
                {"active_edge_lines", m_edgeLines},
                {"spans", m_spans},
                {"pixels_tested", m_pixelsTested},
                {"pixels_won", m_pixelsWon}};
    }

private:
    std::uint64_t& fate(SetUp setUp) { return m_fates[static_cast<std::size_t>(setUp)]; }
    std::uint64_t  fate(SetUp setUp) const { return m_fates[static_cast<std::size_t>(setUp)]; }

    std::array<std::uint64_t, 8> m_fates{};  // by SetUp
    std::uint64_t m_in = 0, m_clipped = 0, m_wide = 0, m_instances = 0, m_batches = 0, m_batchesOutside = 0, m_vertices = 0;
    std::uint64_t m_edges = 0, m_edgeLines = 0, m_spans = 0, m_pixelsTested = 0, m_pixelsWon = 0;
};

}  // namespace zscope
