// Cheap counts that a run keeps of its own work while it is timed, so that a time can be divided by what was done.
//
// Plain      the units of plain text are the counters of an observed run, by the same names: one thread finds the same
//            numbers
// Shortcuts  have units of their own where they work on other things: windows, boxes of vertices
// Threads    each stripe has its own tally; what several stripes meet, like a batch, each of them counts
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/stages.h"

namespace zscope {

enum class Unit {
    Batches,         // set up
    Vertices,        // transformed, those of a pre-pass included
    TrianglesSetUp,  // looked at by set-up, whatever became of them; those of a pre-pass included
    Nodes,           // judged; not by a pre-pass
    Questions,       // to the pyramid
    CellsRead,       // of the pyramid, for these
    CellsWritten,
    Edges,        // entered in the edge table of a sweep
    ActiveEdges,  // each once per line
    Spans,
    PrepassPixels,  // tested by a pre-pass
    Pixels,         // tested otherwise
    PixelsWon,
    Fragments,    // shaded
    Transparent,  // fragments of transparent surfaces, hidden or not
    PixelsBlended,
    // of shortcuts alone
    TrianglesDrawn,  // turned into pixels, with their windows and tiles
    Windows,         // of 4 x 4 pixels that a triangle may cover
    PicturePixels,   // looked at when the picture is shaded
};

inline constexpr std::array<std::string_view, 19> kUnitWords{"batches_drawn",
                                                             "vertices_transformed",
                                                             "triangle_set_ups",
                                                             "nodes_visited",
                                                             "pyramid_queries",
                                                             "pyramid_cells_read",
                                                             "pyramid_writes",
                                                             "edges",
                                                             "active_edge_lines",
                                                             "spans",
                                                             "prepass_pixels_tested",
                                                             "pixels_tested",
                                                             "pixels_won",
                                                             "fragments_shaded",
                                                             "fragments_transparent",
                                                             "pixels_blended",
                                                             "triangle_fills",
                                                             "windows",
                                                             "picture_pixels"};

constexpr std::string_view wordOf(Unit unit) { return kUnitWords[static_cast<std::size_t>(unit)]; }

class Tally {
public:
    void add(Unit unit, std::uint64_t count = 1) { m_counts[static_cast<std::size_t>(unit)] += count; }
    void add(const Tally& other)
    {
        for (std::size_t i = 0; i < m_counts.size(); ++i) m_counts[i] += other.m_counts[i];
    }
    std::uint64_t of(Unit unit) const { return m_counts[static_cast<std::size_t>(unit)]; }

    /// Those that are not 0.
    std::vector<NamedCount> named() const
    {
        std::vector<NamedCount> all;
        all.reserve(m_counts.size() - static_cast<std::size_t>(std::ranges::count(m_counts, 0u)));
        for (std::size_t i = 0; i < m_counts.size(); ++i)
            if (m_counts[i] > 0) all.push_back({std::string(kUnitWords[i]), m_counts[i]});
        return all;
    }

private:
    std::array<std::uint64_t, kUnitWords.size()> m_counts{};
};

}  // namespace zscope
