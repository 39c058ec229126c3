// Which sides two screen triangles of a batch have in common. Such a side is one edge of the sweep, where the one
// closes and the other opens, so that nearly half of the edges of a surface need not be entered, sorted and stepped.
//
// Which      MeshBatches::beyond, where both triangles are in the list, are compact and show the same face: then they
//            lie on either side of it, and their corners are the same snapped ones. Any other side is one triangle's
// Cost       per batch two tables of its triangles, per side three loads
// Source     Baumgart: Winged Edge Polyhedron Representation, Stanford 1972, of which this is what a sweep needs
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/geometry/triangle_list.h"

namespace zscope {

class SharedSides {
public:
    static constexpr std::int32_t kNone = -1;

    explicit SharedSides(const TriangleList& triangles)
        : m_triangles(triangles), m_areKnown(triangles.batch && !triangles.mesh->beyond[0].empty())
    {
        if (!m_areKnown) return;
        for (auto& places : m_places) {
            std::fill_n(places.begin(), triangles.batch->triangleCount, std::int32_t{kNone});
            places[MeshBatches::kNobody] = kNone;
        }
        for (std::size_t i = 0; i < triangles.count; ++i)
            if (triangles.is(TriangleList::kCompact, i))
                m_places[isCounterClockwise(i)][triangles.placeInBatch(i)] = static_cast<std::int32_t>(i);
    }

    /// out[k][lane]: the triangle of the list beyond side k of triangle `at` + lane, or kNone. `count` lanes have
    /// triangles.
    template <std::size_t lanes>
    void beyond(std::size_t at, std::size_t count, std::array<std::array<std::int32_t, lanes>, 3>& out) const
    {
        for (auto& side : out) side.fill(kNone);
        if (!m_areKnown) return;
        const auto& columns = m_triangles.mesh->beyond;
        for (std::size_t lane = 0; lane < count; ++lane) {
            const std::size_t i = at + lane;
            if (!m_triangles.is(TriangleList::kCompact, i)) continue;
            const std::size_t t        = m_triangles.batch->firstTriangle + m_triangles.placeInBatch(i);
            const bool        isTurned = isCounterClockwise(i);  // the list holds its corners the other way round
            const auto&       places   = m_places[isTurned];
            out[0][lane]               = places[columns[isTurned ? 2 : 0][t]];
            out[1][lane]               = places[columns[1][t]];
            out[2][lane]               = places[columns[isTurned ? 0 : 2][t]];
        }
    }

private:
    bool isCounterClockwise(std::size_t i) const { return m_triangles.is(TriangleList::kCounterClockwise, i); }

    const TriangleList& m_triangles;
    bool                m_areKnown;
    // Where the batch's triangles stand in the list, and kNobody: the clockwise ones, then the counter-clockwise ones.
    std::array<std::array<std::int32_t, kBatchTriangles + 1>, 2> m_places;
};

}  // namespace zscope
