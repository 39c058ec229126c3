// What the reference pictures and the reference samples share: the walk over all triangles, the points in rows, and the
// rule that finds the winner. For core/measure only.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <omp.h>

#include "core/measure/definition.h"
#include "core/measure/reference.h"

namespace zscope::definition {

/// The winner is the largest (depth, -id), so a pixel is one number: depth is never negative, and the bits of such
/// floats are ordered like their values. 0 is background; every sample is more, because id < 2^32 - 1.
using Winner = std::uint64_t;

inline Winner winnerOf(float depth, std::uint32_t id)
{
    const float withoutMinusZero = depth + 0.0f;
    return static_cast<Winner>(std::bit_cast<std::uint32_t>(withoutMinusZero)) << 32 | ~id;
}

inline SampleTruth truthOf(Winner winner)
{
    if (winner == 0) return {};
    return {.id    = static_cast<std::int64_t>(~static_cast<std::uint32_t>(winner)),
            .depth = std::bit_cast<float>(static_cast<std::uint32_t>(winner >> 32))};
}

/// A maximum does not depend on the order of its terms, so threads may share one picture.
inline void offer(Winner& pixel, Winner sample)
{
    const std::atomic_ref<Winner> shared(pixel);
    Winner                        seen = shared.load(std::memory_order_relaxed);
    while (seen < sample && !shared.compare_exchange_weak(seen, sample, std::memory_order_relaxed)) {}
}

/// Calls body(id, fate, parts) for every triangle of the instances that are wanted, from several threads at once.
template <class Wanted, class Body>
Result<Done> forEachTriangle(const Scene& scene, const View& view, const Progress& progress, const Wanted& wanted,
                             const Body& body)
{
    const auto         total     = static_cast<std::int64_t>(scene.triangleCount());
    const std::int64_t chunkSize = std::clamp<std::int64_t>(total / 4096, 64, 4096);
    const std::int64_t chunks    = (total + chunkSize - 1) / chunkSize;
#pragma omp parallel for schedule(dynamic) if (chunks > 1)
    for (std::int64_t chunk = 0; chunk < chunks; ++chunk) {
        if (progress.cancelled()) continue;
        if (omp_get_thread_num() == 0) {
            progress.at(static_cast<double>(chunk) / static_cast<double>(chunks), "reference");
        }
        std::vector<Part> parts;
        const auto&       starts = scene.firstTriangle;
        std::int64_t      id     = chunk * chunkSize;
        const auto        end    = std::min(id + chunkSize, total);
        auto next = static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), id) - starts.begin());
        for (; id < end; ++next) {  // `next` is the instance after the one that holds id
            const InstanceId   instance{static_cast<std::uint32_t>(next - 1)};
            const std::int64_t start = starts[next - 1];
            const std::int64_t stop  = std::min<std::int64_t>(starts[next], end);
            if (id < stop && wanted(instance)) {
                for (; id < stop; ++id) {
                    const Fate fate = partsOf(scene, instance, static_cast<std::uint32_t>(id - start), view, parts);
                    body(static_cast<std::uint32_t>(id), fate, parts);
                }
            }
            id = stop;
        }
    }
    if (progress.cancelled()) return Error{Trouble::Cancelled, "the reference was cancelled"};
    return Done{};
}

/// The points of a picture in rows, so that those inside a box are found without looking at all of them.
class PointsByRow {
public:
    PointsByRow(std::span<const PixelPosition> points, int height) : m_points(points), m_rowStart(height + 1u, 0)
    {
        for (std::uint32_t i = 0; i < points.size(); ++i) m_order.push_back(i);
        std::ranges::sort(m_order, {}, [&](std::uint32_t i) { return std::pair(points[i].y, points[i].x); });
        for (const PixelPosition& p : points) ++m_rowStart[static_cast<std::size_t>(p.y) + 1];
        for (std::size_t y = 1; y < m_rowStart.size(); ++y) m_rowStart[y] += m_rowStart[y - 1];
    }

    /// Calls visit(index of the point) for the points inside the box; tells whether there was one.
    template <class Visit>
    bool within(const PixelBox& box, const Visit& visit) const
    {
        if (box.isEmpty()) return false;
        bool any = false;
        for (std::size_t i = m_rowStart[static_cast<std::size_t>(box.y0)];
             i < m_rowStart[static_cast<std::size_t>(box.y1) + 1]; ++i) {
            const std::uint32_t point = m_order[i];
            if (!box.holds(m_points[point].x, m_points[point].y)) continue;
            visit(point);
            any = true;
        }
        return any;
    }

private:
    std::span<const PixelPosition> m_points;
    std::vector<std::uint32_t>     m_order;     // points sorted by row
    std::vector<std::size_t>       m_rowStart;  // into m_order; height + 1 entries
};

inline constexpr auto everyInstance = [](InstanceId) { return true; };

}  // namespace zscope::definition
