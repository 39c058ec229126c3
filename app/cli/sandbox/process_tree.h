// The processes below this one, as /proc has them.
//
// Use        in a process that is a "child subreaper": then whatever its children started stays below it, orphans too
// Memory     sum of the resident sets; what is shared counts once per process (treeMemory) or once (sharedOnce)
#pragma once

#include <cstdint>
#include <vector>

#include <sys/types.h>

namespace zscope::cli {

/// All processes below `root`, without itself; parents before children. Stops at `atMost`.
std::vector<pid_t> descendantsOf(pid_t root, std::size_t atMost);

/// Bytes. The second is exact and slow: the kernel goes through the tables of pages.
std::uint64_t treeMemory(const std::vector<pid_t>& processes);
std::uint64_t treeMemorySharedOnce(const std::vector<pid_t>& processes);

/// Ends everything below this process and waits until it is gone. False: something is still there after `seconds`.
bool endDescendants(double seconds);

}  // namespace zscope::cli
