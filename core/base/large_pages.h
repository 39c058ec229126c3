// Memory that is walked over in all directions: asked for in large pages, of which the processor can keep all addresses
// at hand.
//
// Pages      blocks of kLeast bytes and more begin on a border of large pages, and the system is asked to use them; it
//            may decline
// Errors     std::bad_alloc
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace zscope {

/// An allocator for std::vector.
template <class T>
struct LargePages {
    using value_type = T;

    static constexpr std::size_t kPage = std::size_t{2} << 20, kLeast = 2 * kPage;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>&)
    {}

    T* allocate(std::size_t count)
    {
        const bool        isLarge   = count >= kLeast / sizeof(T);
        const std::size_t alignment = isLarge ? kPage : std::max(alignof(T), alignof(std::max_align_t));
        if (count > (std::size_t{PTRDIFF_MAX} - kPage) / sizeof(T)) throw std::bad_alloc();
        const std::size_t bytes = (count * sizeof(T) + alignment - 1) / alignment * alignment;
        void* const       block = std::aligned_alloc(alignment, bytes);
        if (!block) throw std::bad_alloc();
        if (isLarge) madvise(block, bytes, MADV_HUGEPAGE);
        return static_cast<T*>(block);
    }
    void deallocate(T* block, std::size_t) { std::free(block); }

    friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

}  // namespace zscope
