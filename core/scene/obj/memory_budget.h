// Keeps growing lists below a limit, the moment of copying them included.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace zscope::obj {

class MemoryBudget {
public:
    MemoryBudget(std::uint64_t limit, std::uint64_t used) : m_limit(limit), m_used(used) {}

    bool fits(std::uint64_t bytes) const { return bytes <= m_limit && m_used <= m_limit - bytes; }

    /// Counts bytes of something that stays; false if they would pass the limit.
    bool take(std::uint64_t bytes)
    {
        if (!fits(bytes)) return false;
        m_used += bytes;
        return true;
    }

    /// Makes room for `extra` more entries, doubling as vectors do; false if that would pass the limit.
    template <class T>
    bool makeRoom(std::vector<T>& list, std::size_t extra)
    {
        const std::size_t needed = list.size() + extra;
        if (needed <= list.capacity()) return true;
        const std::size_t before = list.capacity();
        const std::size_t after  = std::max(needed, 2 * before);
        if (!fits(after * sizeof(T))) return false;  // the old list is still there while it is copied
        list.reserve(after);
        m_used += (list.capacity() - before) * sizeof(T);
        return true;
    }

private:
    std::uint64_t m_limit, m_used;  // bytes
};

}  // namespace zscope::obj
