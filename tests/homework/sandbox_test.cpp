// Programs that crash, hang, flood, pry and leave children behind: each ends as the sandbox says, and nothing of it is
// left.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "app/cli/sandbox/process_tree.h"
#include "app/cli/sandbox/sandbox.h"

namespace zscope::cli {

void PrintTo(const Ending& ending, std::ostream* out) { *out << "ending " << static_cast<int>(ending); }

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr Limits kSmall{.seconds = 20, .memory = std::uint64_t{128} << 20, .output = 1 << 20, .processes = 64};

/// What the hostile program is called here: other tests run theirs at the same time.
std::string hostile() { return fmt::format("hostile-{}", ::getpid()); }

/// Processes that run it, whatever has become of their parents.
std::set<std::string> hostileProcesses()
{
    std::set<std::string> found;
    std::error_code       trouble;
    for (const auto& entry : fs::directory_iterator("/proc", trouble)) {
        std::string name;
        std::getline(std::ifstream(entry.path() / "comm") >> std::ws, name);
        if (name == hostile()) found.insert(entry.path().string());
    }
    return found;
}

class SandboxTest : public testing::TestWithParam<Confinement> {
protected:
    void SetUp() override
    {
        if (GetParam() != Confinement::Sandbox) return;
        static const std::optional<std::string> why = whyNoSandbox();
        if (why) GTEST_SKIP() << *why;
    }

    /// Runs "hostile DEED WHERE"; {out} in `where` is the program's folder. Nothing of it may be left.
    Outcome run(const std::string& deed, std::string where = "", const Limits& limits = kSmall)
    {
        Outcome outcome;
        {
            auto folder = PrivateFolder::create();
            if (!folder) throw std::runtime_error(folder.error().text());
            m_folder               = folder->path();
            const std::string root = rootOf(GetParam(), *folder);
            if (const auto out = where.find("{out}"); out != std::string::npos) where.replace(out, 5, root + "/out");
            const Job job{.command     = fmt::format("{}/{} {} '{}'", root, hostile(), deed, where),
                          .shown       = {{ZSCOPE_HOSTILE, hostile()}},
                          .confinement = GetParam(),
                          .limits      = limits};
            auto      ended = cli::run(job, *folder);
            if (!ended) throw std::runtime_error(ended.error().text());
            outcome = *ended;
        }
        EXPECT_FALSE(fs::exists(m_folder)) << "a folder is left";
        return outcome;
    }
    void TearDown() override { EXPECT_EQ(hostileProcesses(), std::set<std::string>{}); }

    std::string m_folder;
};

INSTANTIATE_TEST_SUITE_P(, SandboxTest, testing::Values(Confinement::Sandbox, Confinement::LimitsOnly),
                         [](const testing::TestParamInfo<Confinement>& test) {
                             return test.param == Confinement::Sandbox ? "InTheSandbox" : "WithoutASandbox";
                         });

TEST_P(SandboxTest, AProgramEndsAsItEnds)
{
    EXPECT_EQ(run("nothing").ending, Ending::Exited);
    const Outcome failed = run("status", "3");
    EXPECT_EQ(failed.ending, Ending::Exited);
    EXPECT_EQ(failed.status, 3);
    EXPECT_EQ(run("status", "255").status, 255);
}

TEST_P(SandboxTest, ACrashIsTheSignalThatEndedIt)
{
    const Outcome crash = run("crash");
    EXPECT_EQ(crash.ending, Ending::Signalled);
    EXPECT_EQ(crash.status, SIGSEGV);
    EXPECT_EQ(run("abort").status, SIGABRT);
}

TEST_P(SandboxTest, AnEndlessLoopTimesOut)
{
    Limits limits         = kSmall;
    limits.seconds        = 0.5;
    const Outcome outcome = run("loop", "", limits);
    EXPECT_EQ(outcome.ending, Ending::TimedOut);
    EXPECT_GE(outcome.seconds, 0.5);
    EXPECT_LT(outcome.seconds, 5);
}

TEST_P(SandboxTest, AFloodOfMemoryIsEndedNearItsLimit)
{
    for (const char* deed : {"memory", "memory-in-children"}) {
        const Outcome outcome = run(deed);
        EXPECT_EQ(outcome.ending, Ending::TooMuchMemory) << deed;
        EXPECT_GE(static_cast<double>(outcome.peakMemory), static_cast<double>(kSmall.memory) * kMemoryReached) << deed;
        EXPECT_LT(outcome.peakMemory, kSmall.memory * 4) << deed;
    }
}

TEST_P(SandboxTest, APeakThatDoesNotLastIsSeen) { EXPECT_EQ(run("memory-for-a-moment").ending, Ending::TooMuchMemory); }

TEST_P(SandboxTest, MemoryThatProcessesShareCountsOnce) { EXPECT_EQ(run("memory-shared").ending, Ending::Exited); }

TEST_P(SandboxTest, ABombOfForksIsEnded) { EXPECT_EQ(run("forks").ending, Ending::TooManyProcesses); }

TEST_P(SandboxTest, AFloodOfOutputIsEnded)
{
    const Outcome text = run("text");
    EXPECT_EQ(text.ending, Ending::TooMuchOutput);
    EXPECT_EQ(text.text.size(), kKeptText);
    EXPECT_EQ(text.text.substr(0, 26), "I must not write so much.\n");
    EXPECT_EQ(run("file", "{out}/flood").ending, Ending::TooMuchOutput);
    EXPECT_EQ(run("files", "{out}").ending, Ending::TooMuchOutput);
}

TEST_P(SandboxTest, AFolderWithoutRightsIsRemovedToo) { EXPECT_EQ(run("locked", "{out}").status, 0); }

TEST_P(SandboxTest, ChildrenThatOutliveTheProgramAreEnded)
{
    const Outcome outcome = run("daemon");
    EXPECT_EQ(outcome.ending, Ending::Exited);
    EXPECT_EQ(hostileProcesses(), std::set<std::string>{});
    if (GetParam() == Confinement::LimitsOnly) {
        EXPECT_GE(outcome.outlived, 1);  // bubblewrap has ended them itself
    }
}

TEST_P(SandboxTest, ACancelledRunLeavesNothing)
{
    std::atomic<bool> cancel{false};
    std::thread       user([&cancel] {
        std::this_thread::sleep_for(300ms);
        cancel = true;
    });
    {
        auto       folder = PrivateFolder::create();
        const Job  job{.command     = fmt::format("{}/{} loop", rootOf(GetParam(), *folder), hostile()),
                       .shown       = {{ZSCOPE_HOSTILE, hostile()}},
                       .confinement = GetParam()};
        const auto outcome = cli::run(job, *folder, &cancel);
        ASSERT_FALSE(outcome);
        EXPECT_EQ(outcome.error().kind, Trouble::Cancelled);
    }
    user.join();
}

TEST_P(SandboxTest, TwoAtOnceDoNotMeet)
{
    Limits shortTime  = kSmall;
    shortTime.seconds = 1;
    Outcome     loop;
    std::thread other([&] {
        auto      folder = PrivateFolder::create();
        const Job job{.command     = fmt::format("{}/{} loop", rootOf(GetParam(), *folder), hostile()),
                      .shown       = {{ZSCOPE_HOSTILE, hostile()}},
                      .confinement = GetParam(),
                      .limits      = shortTime};
        loop = *cli::run(job, *folder);
    });
    EXPECT_EQ(run("memory").ending, Ending::TooMuchMemory);
    EXPECT_EQ(run("nothing").ending, Ending::Exited);
    other.join();
    EXPECT_EQ(loop.ending, Ending::TimedOut);
}

class ClosedSandbox : public SandboxTest {};
INSTANTIATE_TEST_SUITE_P(, ClosedSandbox, testing::Values(Confinement::Sandbox),
                         [](const auto&) { return "InTheSandbox"; });

TEST_P(ClosedSandbox, HidesAndKeepsTheFilesOfOthers)
{
    std::string pattern = (fs::temp_directory_path() / "zscope-secret-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    const fs::path secret = fs::path(pattern) / "secret";
    std::ofstream(secret) << "the solution";
    EXPECT_EQ(run("read", secret.string()).status, 3);
    EXPECT_EQ(run("read", "/etc/shadow").status, 3);
    EXPECT_EQ(run("read", "/etc/passwd").status, 0);  // the deed itself works
    EXPECT_EQ(run("write", (fs::path(pattern) / "new").string()).status, 3);
    EXPECT_EQ(run("write", "/usr/zscope-new").status, 3);
    EXPECT_EQ(run("write", "/dev/zscope-new").status, 3);
    EXPECT_EQ(run("write", "/zscope-new").status, 3);
    EXPECT_EQ(run("write", "{out}/new").status, 0);
    fs::remove_all(pattern);
}

TEST_P(ClosedSandbox, HasNoNetwork)
{
    const int   listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family      = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size          = sizeof address;
    ASSERT_EQ(::bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
    ASSERT_EQ(::listen(listener, 4), 0);
    ASSERT_EQ(::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
    const std::string port = std::to_string(ntohs(address.sin_port));
    EXPECT_EQ(run("connect", port).status, 3);

    auto      folder = PrivateFolder::create();
    const Job outside{.command     = fmt::format("{}/{} connect {}", folder->path(), hostile(), port),
                      .shown       = {{ZSCOPE_HOSTILE, hostile()}},
                      .confinement = Confinement::LimitsOnly};
    EXPECT_EQ(cli::run(outside, *folder)->status, 0);  // the deed itself works
    ::close(listener);
}

TEST_P(ClosedSandbox, ShowsWhatTheJobNames)
{
    std::string pattern = (fs::temp_directory_path() / "zscope-shown-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    std::ofstream(fs::path(pattern) / "file") << "seen";
    auto       folder = PrivateFolder::create();
    const Job  job{.command = fmt::format("cat {}/file && ! touch {}/new", pattern, pattern), .alsoShown = {pattern}};
    const auto outcome = cli::run(job, *folder);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->text.substr(0, 4), "seen");
    EXPECT_EQ(outcome->status, 0);
    fs::remove_all(pattern);
}

TEST(PrivateFolders, CountWhatTheyHoldAndFollowNoLinks)
{
    std::string path;
    {
        auto folder = PrivateFolder::create();
        ASSERT_TRUE(folder);
        path = folder->path();
        std::ofstream(folder->out() + "/a") << std::string(1000, 'x');
        const std::uint64_t bytes = bytesIn(path, 1 << 30);
        EXPECT_EQ(bytes, 1000u + 3 * 256);
        std::ofstream(folder->out() + "/b") << 'x';
        fs::create_symlink("/usr", folder->out() + "/link");
        EXPECT_EQ(bytesIn(path, 1 << 30), bytes + 2 * 256);
        EXPECT_GT(bytesIn(path, 500), 500u);
    }
    EXPECT_FALSE(fs::exists(path));
    EXPECT_TRUE(fs::exists("/usr"));
}

}  // namespace
}  // namespace zscope::cli
