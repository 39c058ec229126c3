#include "app/cli/session.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include "app/cli/json.h"
#include "core/base/quotable.h"

namespace zscope::cli {
namespace {

// A signal handler can reach nothing but a static; this is the only one of the program.
std::atomic<bool> interruptRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait");

extern "C" void requestInterrupt(int signal)
{
    interruptRequested.store(true, std::memory_order_relaxed);
    std::signal(signal, SIG_DFL);
}

/// Options of the subcommands that make pictures; each takes a value.
constexpr std::array<std::string_view, 6> kOutputOptions{"-o", "--output", "--ids", "--depth", "--stats", "--state"};

/// Those of check, whose --ids and --depth are read.
constexpr std::array<std::string_view, 3> kReportOptions{"--report", "--junit", "--gradescope"};

/// JSON knows what UTF-8 is: where some of the text is not, it can be replaced or left out.
bool isUtf8(std::string_view text)
{
    const Json json(std::string{text});
    return json.dump(-1, ' ', false, Json::error_handler_t::replace)
           == json.dump(-1, ' ', false, Json::error_handler_t::ignore);
}

/// A word of any bytes in plain ASCII: $'...' with octal escapes.
std::string escapedForShell(std::string_view word)
{
    std::string escaped = "$'";
    for (const char c : word) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte >= 0x7F)
            escaped += fmt::format("\\{:03o}", byte);
        else
            escaped += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
    }
    return escaped + "'";
}

std::string quotedForShell(std::string_view word)
{
    if (!isUtf8(word) || printable(word) != word) return escapedForShell(word);
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+./:,@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string commandWithoutOutputs(std::span<char* const> arguments)
{
    const bool judges =
        std::ranges::any_of(arguments, [](const char* word) { return std::string_view(word) == "check"; });
    const auto  outputs = judges ? std::span<const std::string_view>(kReportOptions) : kOutputOptions;
    std::string command = "zscope-cli";
    for (std::size_t i = 1; i < arguments.size(); ++i) {
        const std::string_view word   = arguments[i];
        const std::string_view option = word.substr(0, word.find('='));
        if (word == "--quiet" || (word.starts_with("-o") && word.size() > 2)) continue;
        if (std::ranges::find(outputs, option) != outputs.end()) {
            if (option == word) ++i;  // its value is the next word
            continue;
        }
        command += ' ' + quotedForShell(word);
    }
    return command;
}

/// One line, whatever a file's name or text holds.
std::string diagnostic(const std::string& file, int line, std::string_view severity, std::string_view sentence)
{
    if (file.empty()) return printable(fmt::format("zscope-cli: {}: {}", severity, sentence)) + '\n';
    if (line <= 0) return printable(fmt::format("{}: {}: {}", file, severity, sentence)) + '\n';
    return printable(fmt::format("{}:{}: {}: {}", file, line, severity, sentence)) + '\n';
}

void toStandardError(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

Exit exitOf(Trouble trouble)
{
    switch (trouble) {
        case Trouble::Usage:
            return Exit::Usage;
        case Trouble::Input:
            return Exit::Input;
        case Trouble::Output:
            return Exit::Output;
        case Trouble::Limit:
            return Exit::Limit;
        case Trouble::Cancelled:
            break;
    }
    return Exit::Interrupted;
}

void catchInterrupts()
{
    std::signal(SIGINT, requestInterrupt);
    std::signal(SIGTERM, requestInterrupt);
    if (std::signal(SIGHUP, requestInterrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // as nohup wants it
    std::signal(SIGXFSZ, SIG_IGN);  // write() then says that the file is too large
}

Session::Session(std::span<char* const> arguments)
    : m_command(commandWithoutOutputs(arguments)), m_showsProgress(::isatty(STDERR_FILENO) == 1)
{}

const std::atomic<bool>* Session::cancel() const { return &interruptRequested; }

void Session::print(std::string_view text) const { std::fwrite(text.data(), 1, text.size(), stdout); }

Exit Session::fail(const Error& error)
{
    clearProgress();
    toStandardError(diagnostic(error.file, error.line, "error", error.sentence));
    return exitOf(error.kind);
}

void Session::warn(std::span<const Warning> warnings, std::size_t atMost)
{
    clearProgress();
    const std::size_t shown = std::min(atMost, warnings.size());
    for (const Warning& warning : warnings.first(shown))
        toStandardError(diagnostic(warning.file, warning.line, "warning", warning.sentence));
    if (shown < warnings.size() && atMost > 0)
        note(fmt::format("{} more warnings; 'zscope-cli info' lists them all", warnings.size() - shown));
}

void Session::note(std::string_view text)
{
    clearProgress();
    toStandardError(diagnostic({}, 0, "note", text));
}

Progress Session::progress()
{
    Progress progress;
    progress.cancel = cancel();
    if (m_showsProgress)
        progress.report = [this](double fraction, std::string_view what) { showProgress(fraction, what); };
    return progress;
}

void Session::showProgress(double fraction, std::string_view what)
{
    using namespace std::chrono_literals;
    const auto now = std::chrono::steady_clock::now();
    if (now - m_lastProgress < 100ms) return;
    m_lastProgress    = now;
    m_progressVisible = true;
    toStandardError(fmt::format("\r\x1b[K{:3.0f} %  {}", fraction * 100, what));
}

void Session::clearProgress()
{
    if (!m_progressVisible) return;
    m_progressVisible = false;
    toStandardError("\r\x1b[K");
}

Exit Session::finish(Exit exit)
{
    clearProgress();
    const bool arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    const int  reason  = errno;
    if (arrived) return exit;
    const Exit output =
        fail({Trouble::Output, "standard output cannot be written: " + std::generic_category().message(reason)});
    return exit == Exit::Done ? output : exit;
}

}  // namespace zscope::cli
