#include "core/io/read_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/quotable.h"

namespace zscope {

namespace fs = std::filesystem;

namespace {

class Descriptor {  // closes what it owns
public:
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor()
    {
        if (m_number >= 0) ::close(m_number);
    }
    Descriptor(const Descriptor&)            = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int         number() const { return m_number; }

private:
    int m_number;
};

/// What the operating system says about errno, as a clause.
std::string reason(int code) { return std::generic_category().message(code); }

const char* kindOf(mode_t mode)
{
    if (S_ISDIR(mode)) return "a directory";
    if (S_ISFIFO(mode)) return "a FIFO";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

std::string megabytes(std::uint64_t bytes)
{
    return bytes >= (1u << 20) ? fmt::format("{} MiB", bytes >> 20) : fmt::format("{} bytes", bytes);
}

/// Of ASCII letters; others are compared as they are.
bool isSameButForCase(std::string_view a, std::string_view b)
{
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::ranges::equal(a, b, {}, small, small);
}

bool isWithin(const fs::path& root, const fs::path& path)
{
    return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

/// The folder's entry whose name differs from `name` only in the case of its letters, among its first entries.
fs::path entryInOtherCase(const fs::path& folder, const fs::path& name)
{
    constexpr int   kMostEntries = 4096;
    int             entries      = 0;
    std::error_code trouble;
    for (auto entry = fs::directory_iterator(folder, trouble);
         !trouble && entry != fs::directory_iterator() && entries < kMostEntries; entry.increment(trouble), ++entries)
        if (isSameButForCase(entry->path().filename().string(), name.string())) return entry->path().filename();
    return {};
}

/// A path below `root` that exists and differs from `written` only in the case of its letters; else empty.
fs::path inOtherCase(const fs::path& root, const fs::path& written)
{
    fs::path        found;
    std::error_code trouble;
    for (const fs::path& part : written.lexically_normal()) {
        const fs::path folder = fs::canonical(root / found, trouble);
        if (trouble || !isWithin(root, folder)) return {};
        const fs::path next = fs::exists(folder / part, trouble) ? part : entryInOtherCase(folder, part);
        if (next.empty()) return {};
        found /= next;
    }
    return found;
}

std::string withSlashes(std::string path)
{
    std::ranges::replace(path, '\\', '/');
    return path;
}

/// The real path of `written` below the real path `root`. What leads out as written is not looked at.
std::optional<std::string> realBelow(const fs::path& root, const fs::path& written)
{
    if (written.is_absolute() || !isWithin(root, (root / written).lexically_normal())) return std::nullopt;
    std::error_code trouble;
    const fs::path  real = fs::canonical(root / written, trouble);
    return trouble || !isWithin(root, real) ? std::nullopt : std::optional(real.string());
}

/// Why there is no such path.
std::string whyNotBelow(const fs::path& root, const std::string& relative)
{
    const std::string shown = quotable(relative, 200);
    if (isAbsolutePath(relative))
        return fmt::format("the path '{}' is absolute; it must be relative to the file that names it", shown);
    const fs::path  written  = withSlashes(relative);
    const bool      leadsOut = !isWithin(root, (root / written).lexically_normal());
    std::error_code trouble;
    const fs::path  real = leadsOut ? fs::path() : fs::canonical(root / written, trouble);
    if (leadsOut || !real.empty())
        return fmt::format("the path '{}' leads out of the folder of the file that names it", shown);
    const fs::path other = inOtherCase(root, written);
    return fmt::format("'{}' cannot be opened: {}{}", shown, trouble.message(),
                       other.empty() ? ""
                                     : fmt::format("; '{}' would fit, but for the case of its letters",
                                                   quotable(other.string(), 200)));
}

}  // namespace

Result<std::string> readRegularFile(const std::string& path, std::uint64_t maxBytes)
{
    if (path.empty()) return inputError("the name of a file is missing", path);
    if (path.find('\0') != std::string::npos) return inputError("the name of the file holds a zero byte", path.c_str());

    // Asked before opening, since opening alone can wait (FIFO) or have effects (a device); asked again on what was
    // opened, since the name may have been given to something else in between.
    struct stat named {};
    if (::stat(path.c_str(), &named) != 0) return inputError("cannot be opened: " + reason(errno), path);
    if (!S_ISREG(named.st_mode)) return inputError(fmt::format("is {}, not a file", kindOf(named.st_mode)), path);

    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (file.number() < 0) return inputError("cannot be opened: " + reason(errno), path);
    struct stat opened {};
    if (::fstat(file.number(), &opened) != 0) return inputError("cannot be read: " + reason(errno), path);
    if (!S_ISREG(opened.st_mode)) return inputError(fmt::format("is {}, not a file", kindOf(opened.st_mode)), path);

    const auto size = static_cast<std::uint64_t>(opened.st_size);
    if (size > maxBytes) {
        const std::string most = megabytes(maxBytes),
                          all  = megabytes(size) == most ? fmt::format("{} bytes", size) : megabytes(size);
        return Error{Trouble::Limit, fmt::format("has {}, and at most {} are read", all, most), path};
    }
    std::string text;
    try {
        text.resize(static_cast<std::size_t>(size));
    } catch (const std::bad_alloc&) {
        return Error{Trouble::Limit, fmt::format("has {}, more than there is memory for", megabytes(size)), path};
    }
    std::size_t filled = 0;
    while (filled < text.size()) {
        const ssize_t got =
            ::read(file.number(), text.data() + filled, std::min<std::size_t>(text.size() - filled, 1u << 26));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return inputError("cannot be read: " + reason(errno), path);
        if (got == 0) return inputError("became shorter while it was read", path);
        filled += static_cast<std::size_t>(got);
    }
    char    more = 0;
    ssize_t extra;
    while ((extra = ::read(file.number(), &more, 1)) < 0 && errno == EINTR) {}
    if (extra > 0) return inputError("does not end where its size says (it grows, or is made by the system)", path);
    return text;
}

std::optional<std::string> findInside(const std::string& folder, const std::string& relative)
{
    std::error_code trouble;
    const fs::path  root = fs::canonical(folder, trouble);
    if (trouble || relative.empty() || relative.find('\0') != std::string::npos) return std::nullopt;
    if (auto path = realBelow(root, relative)) return path;
    return relative.find('\\') == std::string::npos ? std::nullopt : realBelow(root, withSlashes(relative));
}

Result<std::string> pathInside(const std::string& folder, const std::string& relative)
{
    if (relative.empty()) return Error{Trouble::Input, "the name of a file is empty"};
    if (relative.find('\0') != std::string::npos) return Error{Trouble::Input, "the name of a file holds a zero byte"};
    if (auto path = findInside(folder, relative)) return *std::move(path);
    std::error_code trouble;
    const fs::path  root = fs::canonical(folder, trouble);
    if (trouble) return Error{Trouble::Input, fmt::format("the folder cannot be read: {}", trouble.message()), folder};
    return Error{Trouble::Input, whyNotBelow(root, relative)};
}

bool isAbsolutePath(std::string_view path)
{
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return path.starts_with('/') || path.starts_with('\\') || (path.size() > 1 && path[1] == ':' && isLetter(path[0]));
}

bool hasEnding(std::string_view name, std::string_view ending)
{
    return name.size() >= ending.size() && isSameButForCase(name.substr(name.size() - ending.size()), ending);
}

Result<std::string> folderOf(const std::string& path)
{
    std::error_code trouble;
    const fs::path  parent = fs::path(path).parent_path();
    const fs::path  real   = fs::canonical(parent.empty() ? fs::path(".") : parent, trouble);
    if (trouble) return Error{Trouble::Input, fmt::format("its folder cannot be read: {}", trouble.message()), path};
    return real.string();
}

}  // namespace zscope
