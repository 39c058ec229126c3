// Runs an untrusted program under limits, and says how it ended.
//
// Sandbox    bubblewrap: no network, no other processes; the program may read the system's programs and libraries and
//            what the job shows, and write into a private folder. Without bubblewrap the limits below hold, too, but
//            the program may read and write what the user may
// Limits     time by the wall clock; memory of the whole process tree; bytes that are written, files and text together;
//            processes at once
// Ending     children that outlive the program are ended. When run() returns, no process of the program is left
// Threads    run() may be called from several threads at once
// Memory     is sampled every few milliseconds: a fast program may exceed its limit by what it takes in that time
// Errors     Limit where no process or pipe can be made; Cancelled, after all processes have been ended
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/sandbox/private_folder.h"
#include "core/base/result.h"

namespace zscope::cli {

struct Limits {
    double        seconds   = 10;
    std::uint64_t memory    = std::uint64_t{2} << 30;  // bytes
    std::uint64_t output    = std::uint64_t{1} << 28;  // bytes
    int           processes = 256;
};

/// The program is ended when its tree comes this close to the limit of memory.
inline constexpr double kMemoryReached = 0.95;

enum class Confinement { Sandbox, LimitsOnly };

/// A file or folder that the program may read: "scene/bunny.obj" is rootOf(...) + "/scene/bunny.obj".
struct Shown {
    std::string path;  // absolute
    std::string name;
};

struct Job {
    std::string              command;           // for /bin/sh
    std::vector<Shown>       shown       = {};  // by names of their own
    std::vector<std::string> alsoShown   = {};  // absolute; in the sandbox at the same path
    std::string              startsIn    = {};  // absolute, for reading; empty: root + "/work", which it may write
    Confinement              confinement = Confinement::Sandbox;
    Limits                   limits      = {};
};

enum class Ending { Exited, Signalled, TimedOut, TooMuchMemory, TooManyProcesses, TooMuchOutput };

struct Outcome {
    Ending        ending     = Ending::Exited;
    int           status     = 0;   // exit status, or the signal's number
    double        seconds    = 0;   // until the program itself ended
    std::uint64_t peakMemory = 0;   // bytes, of the process tree
    int           outlived   = 0;   // processes that were still there when the program had exited
    std::string   text       = {};  // the first kKeptText bytes of what it wrote to standard output and standard error
};
inline constexpr std::size_t kKeptText = 4096;

/// Where the program finds its folders: rootOf() + "/out" is what it writes its results to, "/work" is where it starts.
std::string rootOf(Confinement confinement, const PrivateFolder& folder);

/// Links what is shown into `folder`, unless it is mounted, and runs the command.
Result<Outcome> run(const Job& job, const PrivateFolder& folder, const std::atomic<bool>* cancel = nullptr);

/// Why there is no sandbox on this machine, in one sentence; nothing: there is one. Tries it.
std::optional<std::string> whyNoSandbox();

/// Whether a shell takes the word as it is: letters, digits and ". _ / + - : , = @ %".
bool isPlainWord(std::string_view word);

}  // namespace zscope::cli
