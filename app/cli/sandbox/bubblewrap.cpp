#include "app/cli/sandbox/bubblewrap.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>

#include <unistd.h>

namespace zscope::cli {

namespace fs = std::filesystem;

namespace {

/// Parts of /etc without which programs do not start: where libraries are, which of several programs a name means, and
/// the settings of languages. Nothing that is secret.
std::vector<std::string> settingsOfPrograms()
{
    std::vector<std::string> files;
    for (const char* name : {"alternatives", "ld.so.cache", "ld.so.conf", "ld.so.conf.d", "nsswitch.conf", "passwd",
                             "group", "localtime", "fonts"})
        files.push_back(std::string("/etc/") + name);
    std::error_code        trouble;
    fs::directory_iterator entries("/etc", trouble);
    for (; !trouble && entries != fs::directory_iterator(); entries.increment(trouble)) {
        const std::string name = entries->path().filename().string();
        for (const std::string_view language : {"java", "python", "mono", "dotnet", "ghc", "node"})
            if (name.starts_with(language)) files.push_back(entries->path().string());
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace

std::optional<std::string> findOnPath(const std::string& program)
{
    const char*        path = std::getenv("PATH");
    std::istringstream folders(path ? path : "/usr/bin:/bin");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path  file = fs::path(folder) / program;
        std::error_code trouble;
        if (folder.starts_with('/') && fs::is_regular_file(file, trouble) && ::access(file.c_str(), X_OK) == 0)
            return file.string();
    }
    return std::nullopt;
}

std::optional<std::string> findBubblewrap() { return findOnPath("bwrap"); }

std::vector<std::string> bubblewrapWords(const std::string& bubblewrap, const Job& job, const PrivateFolder& folder)
{
    const std::string        root = kSandboxRoot;
    std::vector<std::string> words{bubblewrap};
    const auto add = [&words](std::initializer_list<std::string> more) { words.insert(words.end(), more); };

    add({"--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL"});
    for (const char* system : {"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/opt"})
        add({"--ro-bind-try", system, system});
    for (const std::string& file : settingsOfPrograms()) add({"--ro-bind-try", file, file});

    // Devices and the root are file systems in memory: whatever is written there would not be seen, so nothing may be.
    add({"--dev", "/dev", "--bind", folder.path() + "/tmp", "/dev/shm", "--remount-ro", "/dev", "--proc", "/proc"});
    add({"--bind", folder.path() + "/tmp", "/tmp"});
    for (const char* name : {"/work", "/out"}) add({"--bind", folder.path() + name, root + name});
    for (const std::string& path : job.alsoShown) add({"--ro-bind", path, path});  // it may lie in /tmp
    if (!job.startsIn.empty()) add({"--ro-bind", job.startsIn, job.startsIn});
    for (const Shown& shown : job.shown) add({"--ro-bind", shown.path, root + "/" + shown.name});
    add({"--remount-ro", "/"});

    const char* path = std::getenv("PATH");
    add({"--clearenv", "--setenv", "PATH", path ? path : "/usr/bin:/bin", "--setenv", "HOME", root + "/work"});
    add({"--setenv", "TMPDIR", "/tmp", "--setenv", "LANG", "C.UTF-8"});
    add({"--chdir", job.startsIn.empty() ? root + "/work" : job.startsIn, "--", "/bin/sh", "-c", job.command});
    return words;
}

}  // namespace zscope::cli
