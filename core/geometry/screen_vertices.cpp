#include "core/geometry/screen_vertices.h"

namespace zscope {

// Here, and not among the kernels, because for wider instruction sets compilers would make gather instructions of it.
void ScreenVertices::fetchSnapped(const std::uint16_t* places, std::size_t count, std::uint64_t* out) const
{
    for (std::size_t i = 0; i < count; ++i) out[i] = snapped[places[i]];
}

}  // namespace zscope
