// The words by which bubblewrap (the program bwrap) is asked for a sandbox.
//
// Shows      /usr, /bin, /lib*, /opt and what programs need of /etc, for reading, and what the job shows besides
// Hides      everything else: homes, other processes, the network, devices but the harmless ones
// Writable   /zscope/work, /zscope/out and /tmp, all of them in the private folder; no file system that lives in memory
// Source     bwrap(1)
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/sandbox/sandbox.h"

namespace zscope::cli {

/// What the program finds its folders below.
inline constexpr const char* kSandboxRoot = "/zscope";

/// The file that is run as bwrap; nothing: it is not on PATH.
std::optional<std::string> findBubblewrap();

/// bwrap and its arguments, up to and including the command.
std::vector<std::string> bubblewrapWords(const std::string& bubblewrap, const Job& job, const PrivateFolder& folder);

/// The file of that name in the folders of PATH.
std::optional<std::string> findOnPath(const std::string& program);

}  // namespace zscope::cli
