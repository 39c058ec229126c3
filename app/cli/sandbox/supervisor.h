// Starts a program and watches it in a process of its own, so that nothing which the program starts can get away: the
// supervisor is a "child subreaper" and ends what is left below it.
//
// Process    a fork of this one, which only makes system calls and allocates memory; it never returns to its caller
// Lifeline   the supervisor ends the program when the caller dies or gives up
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "app/cli/sandbox/sandbox.h"
#include "core/base/result.h"

namespace zscope::cli {

struct Program {
    std::vector<std::string> arguments = {};  // [0] is the file that is run
    std::string              startsIn;        // folder
    std::string              watchedFolder;   // whose bytes count as output
};

/// Errors: as run() in sandbox.h; Limit where the file cannot be run.
Result<Outcome> supervise(const Program& program, const Limits& limits, const std::atomic<bool>* cancel);

}  // namespace zscope::cli
