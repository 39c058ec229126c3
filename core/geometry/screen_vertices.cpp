#include "core/geometry/screen_vertices.h"

namespace zscope {

// Here, and not among the kernels, because for wider instruction sets compilers would make gather instructions of it.
void ScreenVertices::fetchSnapped(const std::array<const std::uint16_t*, 3>& places, std::size_t count,
                                  const std::array<std::uint64_t*, 3>& out) const
{
    const auto [firsts, seconds, thirds] = places;
    const auto [first, second, third]    = out;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t a = snapped(firsts[i]), b = snapped(seconds[i]), c = snapped(thirds[i]);
        first[i] = a, second[i] = b, third[i] = c;
    }
}

}  // namespace zscope
