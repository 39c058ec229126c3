#include "app/cli/sandbox/supervisor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/cli/sandbox/process_tree.h"

namespace zscope::cli {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto   kSampleEvery     = 10ms;  // memory and time
constexpr auto   kSampleFast      = 2ms;   // once half of the memory is in use
constexpr auto   kFolderEvery     = 50ms;
constexpr auto   kLookForCancel   = 50ms;
constexpr double kLongestEnding   = 20;  // seconds in which all processes must have ended
constexpr int    kNicer           = 5;   // the program gives way to its supervisor
constexpr int    kSignalsOfShells = 64;  // a shell's status 128 + n stands for signal n

class Pipe {
public:
    Pipe() { m_open = ::pipe2(m_ends.data(), O_CLOEXEC) == 0; }
    ~Pipe()
    {
        closeRead();
        closeWrite();
    }
    Pipe(const Pipe&)            = delete;
    Pipe& operator=(const Pipe&) = delete;

    bool isOpen() const { return m_open; }
    int  read() const { return m_ends[0]; }
    int  write() const { return m_ends[1]; }
    void closeRead() { close(0); }
    void closeWrite() { close(1); }

private:
    void close(std::size_t end)
    {
        if (m_open && m_ends[end] >= 0) ::close(std::exchange(m_ends[end], -1));
    }
    std::array<int, 2> m_ends{-1, -1};
    bool               m_open = false;
};

/// What the supervisor writes to its caller; the kept text follows. Smaller than what a pipe holds.
struct Report {
    enum class What { Ended, Cancelled, NotStarted, NotEnded };
    What          what       = What::Ended;
    int           reason     = 0;  // errno of NotStarted
    Ending        ending     = Ending::Exited;
    int           status     = 0;
    double        seconds    = 0;
    std::uint64_t peakMemory = 0;
    int           outlived   = 0;
    std::uint32_t kept       = 0;
};

/// Everything below happens in the supervisor.
class Supervisor {
public:
    Supervisor(const Program& program, const Limits& limits, const Pipe& lifeline, const Pipe& report)
        : m_program(program), m_limits(limits), m_lifeline(lifeline), m_report(report)
    {}

    [[noreturn]] void run()
    {
        ::setsid();
        ::prctl(PR_SET_CHILD_SUBREAPER, 1);
        for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) ::signal(signal, SIG_IGN);
        ::signal(SIGCHLD, SIG_DFL);
        // Other runs' pipes would stay open here as long as this one takes.
        for (int file = 3, last = static_cast<int>(::sysconf(_SC_OPEN_MAX)); file < std::min(last, 4096); ++file)
            if (file != m_lifeline.read() && file != m_report.write()) ::close(file);

        Pipe text, started;
        start(text, started);
        if (m_result.what == Report::What::Ended) watch(text.read());
        if (!endDescendants(kLongestEnding)) m_result.what = Report::What::NotEnded;
        readText(text.read());
        if (m_result.ending == Ending::Exited || m_result.ending == Ending::Signalled) judgeWhatIsLeft();
        m_result.kept = static_cast<std::uint32_t>(m_text.size());
        send(&m_result, sizeof m_result);
        send(m_text.data(), m_text.size());
        ::_exit(0);
    }

private:
    void start(Pipe& text, Pipe& started)
    {
        m_start = Clock::now();
        m_child = text.isOpen() && started.isOpen() ? ::fork() : -1;
        if (m_child == 0) becomeTheProgram(text, started);
        int reason = m_child < 0 ? errno : 0;
        text.closeWrite();
        started.closeWrite();
        // The pipe closes by itself when the program has been started.
        if (m_child > 0 && ::read(started.read(), &reason, sizeof reason) <= 0) reason = 0;
        if (reason != 0) m_result = {.what = Report::What::NotStarted, .reason = reason};
        ::fcntl(text.read(), F_SETFL, O_NONBLOCK);
    }

    [[noreturn]] void becomeTheProgram(const Pipe& text, const Pipe& started)
    {
        const auto limit = [](auto resource, std::uint64_t value) {
            const rlimit both{value, value};
            ::setrlimit(resource, &both);
        };
        std::vector<char*> arguments;
        for (const std::string& argument : m_program.arguments)
            arguments.push_back(const_cast<char*>(argument.c_str()));
        arguments.push_back(nullptr);
        ::setsid();
        limit(RLIMIT_CORE, 0);
        limit(RLIMIT_FSIZE, m_limits.output);
        [[maybe_unused]] const int priority = ::nice(kNicer);
        const int                  nothing  = ::open("/dev/null", O_RDONLY);
        ::dup2(nothing, STDIN_FILENO);
        ::dup2(text.write(), STDOUT_FILENO);
        ::dup2(text.write(), STDERR_FILENO);
        for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
        sigset_t none;
        ::sigemptyset(&none);
        ::sigprocmask(SIG_SETMASK, &none, nullptr);
        if (::chdir(m_program.startsIn.c_str()) == 0) ::execv(arguments.front(), arguments.data());
        const int                      reason = errno;
        [[maybe_unused]] const ssize_t told   = ::write(started.write(), &reason, sizeof reason);
        ::_exit(127);
    }

    /// Until the program has ended or must be ended.
    void watch(int text)
    {
        auto folderNext = m_start;
        while (true) {
            const bool            fast = m_result.peakMemory > m_limits.memory / 2;
            std::array<pollfd, 2> ready{pollfd{m_lifeline.read(), POLLIN, 0}, pollfd{text, POLLIN, 0}};
            ::poll(ready.data(), m_textIsOpen ? 2 : 1, static_cast<int>((fast ? kSampleFast : kSampleEvery).count()));
            if (ready[1].revents != 0) readText(text);
            if (cancelled()) {
                m_result.what = Report::What::Cancelled;
                return;
            }
            if (m_textBytes > m_limits.output) return endsBy(Ending::TooMuchOutput);
            if (hasEnded()) return;
            if (!isWithinMemory()) return;
            const auto now = Clock::now();
            if (now >= folderNext) {
                if (bytesIn(m_program.watchedFolder, m_limits.output) > m_limits.output)
                    return endsBy(Ending::TooMuchOutput);
                folderNext = Clock::now() + kFolderEvery;
            }
            if (secondsSince(m_start) > m_limits.seconds) return endsBy(Ending::TimedOut);
        }
    }

    static double secondsSince(Clock::time_point start)
    {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    void endsBy(Ending ending)
    {
        m_result.ending  = ending;
        m_result.seconds = secondsSince(m_start);
    }

    bool cancelled() const
    {
        pollfd lifeline{m_lifeline.read(), POLLIN, 0};
        return ::poll(&lifeline, 1, 0) > 0;
    }

    /// Orphans that have ended are taken away on the way.
    bool hasEnded()
    {
        int status = 0;
        for (pid_t gone = 0; (gone = ::waitpid(-1, &status, WNOHANG)) > 0;) {
            if (gone != m_child) continue;
            const int  code     = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
            const bool isSignal = code > 128 && code <= 128 + kSignalsOfShells;
            m_result.status     = isSignal ? code - 128 : code;
            endsBy(isSignal ? Ending::Signalled : Ending::Exited);
            m_result.outlived = static_cast<int>(descendantsOf(::getpid(), 1000).size());
            return true;
        }
        return false;
    }

    bool isWithinMemory()
    {
        const auto processes = descendantsOf(::getpid(), static_cast<std::size_t>(m_limits.processes) * 2);
        if (processes.size() > static_cast<std::size_t>(m_limits.processes)) {
            endsBy(Ending::TooManyProcesses);
            return false;
        }
        const double  most  = static_cast<double>(m_limits.memory) * kMemoryReached;
        std::uint64_t bytes = treeMemory(processes);
        if (static_cast<double>(bytes) >= most) bytes = treeMemorySharedOnce(processes);
        m_result.peakMemory = std::max(m_result.peakMemory, bytes);
        if (static_cast<double>(bytes) < most) return true;
        endsBy(Ending::TooMuchMemory);
        return false;
    }

    void readText(int text)
    {
        std::array<char, 65536> part;
        // Bounded, so that a flood does not keep the supervisor from looking at the rest.
        for (int turn = 0; turn < 64 && m_textIsOpen; ++turn) {
            const ssize_t n = ::read(text, part.data(), part.size());
            if (n < 0) return;  // nothing there now
            m_textIsOpen = n > 0;
            m_textBytes += static_cast<std::uint64_t>(n);
            m_text.append(part.data(), std::min(static_cast<std::size_t>(n), kKeptText - m_text.size()));
        }
    }

    /// The program has ended by itself: was it because it met a limit?
    void judgeWhatIsLeft()
    {
        rusage self{}, below{};
        ::getrusage(RUSAGE_SELF, &self);
        ::getrusage(RUSAGE_CHILDREN, &below);
        // The kernel's peak of the largest process, which no sample can miss. A fork begins with its parent's size, so
        // that a figure near this process's own says nothing.
        if (below.ru_maxrss > self.ru_maxrss + self.ru_maxrss / 8 + 1024)
            m_result.peakMemory = std::max(m_result.peakMemory, static_cast<std::uint64_t>(below.ru_maxrss) * 1024);
        if (static_cast<double>(m_result.peakMemory) >= static_cast<double>(m_limits.memory) * kMemoryReached) {
            m_result.ending = Ending::TooMuchMemory;
            return;
        }
        const bool filled = bytesIn(m_program.watchedFolder, m_limits.output) >= m_limits.output;
        const bool wrote  = m_textBytes > m_limits.output;
        if (filled || wrote || (m_result.ending == Ending::Signalled && m_result.status == SIGXFSZ))
            m_result.ending = Ending::TooMuchOutput;
    }

    void send(const void* data, std::size_t size) const
    {
        [[maybe_unused]] const ssize_t sent = ::write(m_report.write(), data, size);  // the caller may be gone
    }

    const Program&    m_program;
    const Limits&     m_limits;
    const Pipe&       m_lifeline;
    const Pipe&       m_report;
    Report            m_result;
    Clock::time_point m_start;
    pid_t             m_child      = -1;
    bool              m_textIsOpen = true;
    std::uint64_t     m_textBytes  = 0;
    std::string       m_text;
};

std::string readAll(int file)
{
    std::string            bytes;
    std::array<char, 4096> part;
    while (true) {
        const ssize_t n = ::read(file, part.data(), part.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return bytes;
        bytes.append(part.data(), static_cast<std::size_t>(n));
    }
}

Result<Outcome> outcomeOf(const std::string& bytes, const Program& program)
{
    Report report;
    if (bytes.size() < sizeof report) return Error{Trouble::Limit, "a program's supervisor was ended from outside"};
    std::memcpy(&report, bytes.data(), sizeof report);
    switch (report.what) {
        case Report::What::Ended:
            break;
        case Report::What::Cancelled:
            return Error{Trouble::Cancelled, "interrupted"};
        case Report::What::NotStarted:
            return Error{Trouble::Limit, fmt::format("'{}' cannot be started: {}", program.arguments.front(),
                                                     std::strerror(report.reason))};
        case Report::What::NotEnded:
            return Error{Trouble::Limit,
                         fmt::format("processes of a program did not end within {} seconds", kLongestEnding)};
    }
    return Outcome{report.ending,     report.status,   report.seconds,
                   report.peakMemory, report.outlived, bytes.substr(sizeof report, report.kept)};
}

}  // namespace

Result<Outcome> supervise(const Program& program, const Limits& limits, const std::atomic<bool>* cancel)
{
    Pipe lifeline, report;
    if (!lifeline.isOpen() || !report.isOpen())
        return Error{Trouble::Limit, fmt::format("no pipe can be made: {}", std::strerror(errno))};
    const pid_t supervisor = ::fork();
    if (supervisor < 0) return Error{Trouble::Limit, fmt::format("no process can be made: {}", std::strerror(errno))};
    if (supervisor == 0) {
        lifeline.closeWrite();
        report.closeRead();
        Supervisor(program, limits, lifeline, report).run();
    }
    lifeline.closeRead();
    report.closeWrite();
    // A closed lifeline ends the program.
    for (pollfd ready{report.read(), POLLIN, 0}; ::poll(&ready, 1, static_cast<int>(kLookForCancel.count())) <= 0;)
        if (cancel && cancel->load(std::memory_order_relaxed)) lifeline.closeWrite();
    const std::string bytes = readAll(report.read());
    while (::waitpid(supervisor, nullptr, 0) < 0 && errno == EINTR) {}
    return outcomeOf(bytes, program);
}

}  // namespace zscope::cli
