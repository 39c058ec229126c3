#include "app/cli/sandbox/process_tree.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

#include <dirent.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace zscope::cli {
namespace {

/// Empty: the process is gone, or the kernel has no such file.
std::string textOf(const std::string& path)
{
    std::string text;
    const int   file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return text;
    std::array<char, 4096> part;
    for (ssize_t n = 0; (n = ::read(file, part.data(), part.size())) > 0;)
        text.append(part.data(), static_cast<std::size_t>(n));
    ::close(file);
    return text;
}

/// The names in a folder of /proc that are numbers.
std::vector<pid_t> numbersIn(const std::string& folder)
{
    std::vector<pid_t> numbers;
    DIR*               entries = ::opendir(folder.c_str());
    if (!entries) return numbers;
    while (const dirent* entry = ::readdir(entries))
        if (const long number = std::strtol(entry->d_name, nullptr, 10); number > 0)
            numbers.push_back(static_cast<pid_t>(number));
    ::closedir(entries);
    return numbers;
}

std::vector<pid_t> childrenOf(pid_t process)
{
    std::vector<pid_t> children;
    const std::string  tasks = "/proc/" + std::to_string(process) + "/task/";
    for (const pid_t thread : numbersIn(tasks)) {
        const std::string text = textOf(tasks + std::to_string(thread) + "/children");
        const char*       at   = text.c_str();
        for (char* end = nullptr;; at = end) {
            const long child = std::strtol(at, &end, 10);
            if (end == at || child <= 0) break;
            children.push_back(static_cast<pid_t>(child));
        }
    }
    return children;
}

/// Kernels without lists of children: every process says who its parent is.
std::multimap<pid_t, pid_t> parentsAndChildren()
{
    std::multimap<pid_t, pid_t> all;
    for (const pid_t process : numbersIn("/proc")) {
        const std::string text = textOf("/proc/" + std::to_string(process) + "/stat");
        const std::size_t name = text.rfind(')');  // "pid (name) state parent ..."
        if (name != std::string::npos && name + 4 < text.size())
            all.emplace(static_cast<pid_t>(std::strtol(text.c_str() + name + 4, nullptr, 10)), process);
    }
    return all;
}

bool kernelListsChildren()
{
    const std::string self = std::to_string(::getpid());
    return ::access(("/proc/" + self + "/task/" + self + "/children").c_str(), R_OK) == 0;
}

std::uint64_t residentOf(pid_t process)
{
    const std::string text  = textOf("/proc/" + std::to_string(process) + "/statm");  // size resident ... in pages
    const std::size_t space = text.find(' ');
    if (space == std::string::npos) return 0;
    return std::strtoull(text.c_str() + space, nullptr, 10) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

}  // namespace

std::vector<pid_t> descendantsOf(pid_t root, std::size_t atMost)
{
    const bool                        listed = kernelListsChildren();
    const std::multimap<pid_t, pid_t> all    = listed ? std::multimap<pid_t, pid_t>() : parentsAndChildren();
    std::vector<pid_t>                found{root};
    for (std::size_t i = 0; i < found.size() && found.size() <= atMost; ++i) {
        std::vector<pid_t> children;
        if (listed)
            children = childrenOf(found[i]);
        else
            for (auto [at, end] = all.equal_range(found[i]); at != end; ++at) children.push_back(at->second);
        for (const pid_t child : children)
            if (std::ranges::find(found, child) == found.end()) found.push_back(child);  // a number may be used again
    }
    found.erase(found.begin());
    return found;
}

std::uint64_t treeMemory(const std::vector<pid_t>& processes)
{
    std::uint64_t bytes = 0;
    for (const pid_t process : processes) bytes += residentOf(process);
    return bytes;
}

std::uint64_t treeMemorySharedOnce(const std::vector<pid_t>& processes)
{
    std::uint64_t bytes = 0;
    for (const pid_t process : processes) {
        const std::string text  = textOf("/proc/" + std::to_string(process) + "/smaps_rollup");
        const std::size_t share = text.find("\nPss:");
        bytes += share == std::string::npos ? residentOf(process)
                                            : std::strtoull(text.c_str() + share + 5, nullptr, 10) * 1024;
    }
    return bytes;
}

bool endDescendants(double seconds)
{
    using Clock     = std::chrono::steady_clock;
    const auto last = Clock::now() + std::chrono::duration<double>(seconds);
    while (true) {
        for (const pid_t process : descendantsOf(::getpid(), 1'000'000)) ::kill(process, SIGKILL);
        while (true) {
            const pid_t gone = ::waitpid(-1, nullptr, WNOHANG);
            if (gone < 0) return true;  // no child is left, so nothing below one either
            if (gone == 0) break;
        }
        if (Clock::now() > last) return false;
        ::usleep(1000);
    }
}

}  // namespace zscope::cli
