// Memory that begins on a cache line, so that no vector that is stored at a multiple of its width lies in two.
//
// Errors     std::bad_alloc
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace zscope {

/// An allocator for std::vector.
template <class T>
struct CacheAligned {
    using value_type = T;

    static constexpr std::align_val_t kLine{64};

    CacheAligned() = default;
    template <class Other>
    CacheAligned(const CacheAligned<Other>&)
    {}

    T*   allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), kLine)); }
    void deallocate(T* block, std::size_t) { ::operator delete(block, kLine); }

    friend bool operator==(const CacheAligned&, const CacheAligned&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, CacheAligned<T>>;

}  // namespace zscope
