#include "app/cli/sandbox/private_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

namespace zscope::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kLeastPerEntry = 256;  // bytes: so that a million empty files are a flood, too

/// A program may have taken all rights to its folders away; they are still this user's.
fs::directory_iterator openFolder(const fs::path& folder)
{
    std::error_code        trouble;
    fs::directory_iterator entries(folder, trouble);
    if (!trouble) return entries;
    ::fchmodat(AT_FDCWD, folder.c_str(), S_IRWXU, AT_SYMLINK_NOFOLLOW);
    return fs::directory_iterator(folder, trouble);
}

/// Calls `visit(path, status)` for each entry, folders before what they hold, until it says false.
template <class Visit>
void forEachEntry(const std::string& folder, const Visit& visit)
{
    std::vector<fs::path> waiting{folder};
    while (!waiting.empty()) {
        std::error_code        trouble;
        fs::directory_iterator entries = openFolder(std::exchange(waiting.back(), {}));
        waiting.pop_back();
        for (; entries != fs::directory_iterator(); entries.increment(trouble)) {
            struct stat status {};
            if (::lstat(entries->path().c_str(), &status) != 0) continue;  // removed meanwhile
            if (!visit(entries->path(), status)) return;
            if (S_ISDIR(status.st_mode)) waiting.push_back(entries->path());
        }
    }
}

}  // namespace

Result<PrivateFolder> PrivateFolder::create()
{
    std::error_code trouble;
    std::string     path = (fs::temp_directory_path(trouble) / "zscope-run-XXXXXX").string();
    if (trouble || !::mkdtemp(path.data()))
        return Error{Trouble::Output,
                     fmt::format("no folder for temporary files can be made: {}",
                                 trouble ? trouble.message() : std::string(std::strerror(errno))),
                     path};
    PrivateFolder folder(path);
    for (const char* name : {"/work", "/out", "/tmp"})
        if (::mkdir((path + name).c_str(), S_IRWXU) != 0)
            return Error{Trouble::Output, std::string(std::strerror(errno)), path + name};
    return folder;
}

PrivateFolder::PrivateFolder(PrivateFolder&& other) noexcept : m_path(std::exchange(other.m_path, {})) {}

PrivateFolder::~PrivateFolder()
{
    if (m_path.empty()) return;
    std::error_code trouble;
    fs::remove_all(m_path, trouble);
    if (!trouble) return;
    forEachEntry(m_path, [](const fs::path& path, const struct stat& status) {
        if (S_ISDIR(status.st_mode)) ::fchmodat(AT_FDCWD, path.c_str(), S_IRWXU, AT_SYMLINK_NOFOLLOW);
        return true;
    });
    fs::remove_all(m_path, trouble);
}

std::uint64_t bytesIn(const std::string& folder, std::uint64_t enough)
{
    std::uint64_t bytes = 0;
    forEachEntry(folder, [&](const fs::path&, const struct stat& status) {
        bytes += std::max(kLeastPerEntry, S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0);
        return bytes <= enough;
    });
    return bytes;
}

}  // namespace zscope::cli
