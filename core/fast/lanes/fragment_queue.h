// Fragments that wait to be shaded together: one lane each, whatever triangle they are of.
//
// Order      any: a colour is stored only if the fragment's triangle still holds the pixel, and who holds it last has
//            a fragment of its own in the queue, now or later
// Room       fixed; who adds makes room first (core/fast/lanes/fragment-inl.h)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/geometry/batches.h"

namespace zscope {

struct FragmentQueue {
    static constexpr std::size_t kRoom = 2048;
    template <class T>
    using Column = std::array<T, kRoom + kBatchPadding>;

    // Entry i is fragment i.
    alignas(64) Column<std::uint32_t> pixels;  // x + 65536 y
    alignas(64) Column<std::uint32_t> ranks;   // triangle id + 1
    std::size_t count = 0;
};

}  // namespace zscope
