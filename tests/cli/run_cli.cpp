#include "tests/cli/run_cli.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace zscope::cli_test {

namespace fs = std::filesystem;

namespace {

/// A temporary file without a name that a child writes into.
class Capture {
public:
    Capture() : m_file(std::tmpfile()) {}
    ~Capture() { std::fclose(m_file); }
    Capture(const Capture&)            = delete;
    Capture& operator=(const Capture&) = delete;

    int         descriptor() const { return ::fileno(m_file); }
    std::string text() const
    {
        std::string text;
        std::rewind(m_file);
        std::array<char, 4096> part;
        while (const std::size_t n = std::fread(part.data(), 1, part.size(), m_file)) text.append(part.data(), n);
        return text;
    }

private:
    std::FILE* m_file;
};

pid_t start(const std::vector<std::string>& arguments, int out, int err)
{
    std::vector<char*> argv{const_cast<char*>("zscope-cli")};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child != 0) return child;
    ::signal(SIGHUP, SIG_DFL);  // tests that run under nohup ignore it
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    ::execv(ZSCOPE_CLI, argv.data());
    ::_exit(127);
}

int statusOf(pid_t child)
{
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? 1000 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// Whether the process has installed a handler for the signal (the mask of caught signals in /proc).
bool catches(pid_t process, int signal)
{
    std::istringstream lines(contentsOf("/proc/" + std::to_string(process) + "/status"));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("SigCgt:")) return (std::strtoull(line.c_str() + 7, nullptr, 16) >> (signal - 1) & 1) != 0;
    return false;
}

}  // namespace

Answer run(const std::vector<std::string>& arguments)
{
    const Capture out, err;
    const int     status = statusOf(start(arguments, out.descriptor(), err.descriptor()));
    return {status, out.text(), err.text()};
}

Answer runInto(const std::string& outFile, const std::vector<std::string>& arguments)
{
    const Capture err;
    const int     out    = ::open(outFile.c_str(), O_WRONLY);
    const int     status = statusOf(start(arguments, out, err.descriptor()));
    ::close(out);
    return {status, "", err.text()};
}

Answer runAndSignal(const std::vector<std::string>& arguments, int signal, int milliseconds)
{
    using namespace std::chrono_literals;
    const Capture out, err;
    const pid_t   child = start(arguments, out.descriptor(), err.descriptor());
    for (int turn = 0; turn < 2000 && !catches(child, signal); ++turn) std::this_thread::sleep_for(5ms);
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(child, signal);
    const int status = statusOf(child);
    return {status, out.text(), err.text()};
}

Answer runIntoFifoAndSignal(const std::string& fifo, const std::vector<std::string>& arguments, int signal)
{
    EXPECT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    const int     in = ::open(fifo.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const Capture out, err;
    const pid_t   child = start(arguments, out.descriptor(), err.descriptor());
    pollfd        ready{in, POLLIN, 0};
    EXPECT_EQ(::poll(&ready, 1, 60'000), 1);
    ::kill(child, signal);
    ::fcntl(in, F_SETFL, 0);
    std::string            text;
    std::array<char, 4096> part;
    for (ssize_t n = 0; (n = ::read(in, part.data(), part.size())) > 0;)
        text.append(part.data(), static_cast<std::size_t>(n));
    ::close(in);
    return {statusOf(child), text, err.text()};
}

std::string contentsOf(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void Cli::SetUp()
{
    std::string pattern = (fs::temp_directory_path() / "zscope-cli-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    m_folder = pattern;
}

void Cli::TearDown() { fs::remove_all(m_folder); }

std::string Cli::write(const std::string& name, const std::string& contents) const
{
    std::ofstream(path(name), std::ios::binary) << contents;
    return path(name);
}

std::size_t Cli::filesInFolder() const
{
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
}

void expectFitsSchema(const std::string& report)
{
    const std::string schemas = std::string(ZSCOPE_SOURCE_DIR) + "/tests/check/";
    const bool        isXml   = report.ends_with(".xml");
    const std::string judge =
        isXml ? "xmllint --noout --schema '" + schemas + "junit.xsd' '" + report + "'"
              : "python3 -c 'import json, sys, jsonschema; jsonschema.validate(*(json.load(open(name)) for name in "
                "sys.argv[1:]))' '"
                    + report + "' '" + schemas + "gradescope.schema.json'";
    EXPECT_EQ(std::system((judge + " > '" + report + ".log' 2>&1").c_str()), 0) << judge << '\n'
                                                                                << contentsOf(report + ".log") << '\n'
                                                                                << contentsOf(report);
}

}  // namespace zscope::cli_test
