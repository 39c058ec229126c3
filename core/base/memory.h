// How much memory a piece of work may take, asked before anything is allocated.
//
// Limit      bytes; 0 stands for the default, three quarters of the machine's memory
#pragma once

#include <cstdint>

#include <unistd.h>

namespace zscope {

/// The limit itself, or the default where it is 0.
inline std::uint64_t effectiveMemoryLimit(std::uint64_t limit)
{
    if (limit != 0) return limit;
    const long pages = ::sysconf(_SC_PHYS_PAGES);
    const long bytes = ::sysconf(_SC_PAGESIZE);
    if (pages <= 0 || bytes <= 0) return std::uint64_t{1} << 30;  // a machine that does not tell: 1 GiB
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(bytes) / 4 * 3;
}

}  // namespace zscope
