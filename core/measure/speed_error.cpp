#include "core/measure/speed_error.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace zscope {

std::vector<std::size_t> nonDominated(std::span<const SpeedError> points)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [points](std::size_t a, std::size_t b) {
        return std::tie(points[a].ms, points[a].error) < std::tie(points[b].ms, points[b].error);
    });
    std::vector<std::size_t> kept;
    for (const std::size_t i : order) {
        if (!kept.empty()) {
            const SpeedError& last   = points[kept.back()];
            const bool        equals = points[i].ms == last.ms && points[i].error == last.error;
            if (!equals && points[i].error >= last.error) continue;
        }
        kept.push_back(i);
    }
    return kept;
}

}  // namespace zscope
