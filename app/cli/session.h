// What every subcommand shares: where words go, how a run ends, and how it is interrupted.
//
// Output     results on standard output, diagnostics and progress on standard error
// Interrupt  the first SIGINT, SIGTERM or SIGHUP sets a flag that all long work looks at; a second one ends the program
#pragma once

#include <atomic>
#include <chrono>
#include <span>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace zscope::cli {

/// The exit statuses that scripts rely on.
enum class Exit : int {
    Done        = 0,
    CheckFailed = 1,
    Usage       = 2,
    Input       = 3,
    Output      = 4,
    Limit       = 5,
    Interrupted = 130,
};
Exit exitOf(Trouble trouble);

class Session {
public:
    explicit Session(std::span<char* const> arguments);

    /// Progress is shown on a terminal only; this silences it there too.
    void silence() { m_showsProgress = false; }

    /// Adds to the results. Whether they arrived is known at finish().
    void print(std::string_view text) const;
    /// "file:line: error: sentence"; gives back the status to end with.
    Exit fail(const Error& error);
    /// The first warnings, and how many more there are; none at all if `atMost` is 0.
    void warn(std::span<const Warning> warnings, std::size_t atMost);
    /// A remark on standard error that is no result and no problem.
    void note(std::string_view text);

    const std::atomic<bool>* cancel() const;
    bool                     interrupted() const { return cancel()->load(std::memory_order_relaxed); }
    Progress                 progress();

    /// This command line without the options that name outputs, quoted for a shell: what a picture carries.
    const std::string& reproducingCommand() const { return m_command; }

    /// Ends the run: makes sure that the results have reached standard output.
    Exit finish(Exit exit);

private:
    void showProgress(double fraction, std::string_view what);
    void clearProgress();

    std::string                           m_command;
    bool                                  m_showsProgress;
    bool                                  m_progressVisible = false;
    std::chrono::steady_clock::time_point m_lastProgress{};
};

/// Makes SIGINT, SIGTERM and SIGHUP set the flag of Session::cancel(), and a file that may not grow an error like any
/// other.
void catchInterrupts();

}  // namespace zscope::cli
