#include "core/io/file_writer.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace zscope {
namespace {

constexpr int kTemporaryNames = 100;  // tries before "the folder is full of our leftovers" is believed
constexpr int kMaxLinks       = 40;   // as many as Linux follows

Error outputError(const std::string& path, const char* action, int reason)
{
    return {Trouble::Output, std::string(action) + ": " + std::generic_category().message(reason), path};
}

std::string temporaryName(const std::string& target, int attempt)
{
    const std::size_t slash  = target.find_last_of('/');
    const std::string folder = slash == std::string::npos ? "" : target.substr(0, slash + 1);
    // Not derived from the target's name, which may already be as long as a name can be.
    return folder + ".zscope-" + std::to_string(::getpid()) + "-" + std::to_string(attempt) + ".part";
}

}  // namespace

Result<std::string> linkTarget(const std::string& path)
{
    namespace fs = std::filesystem;
    std::error_code trouble;
    fs::path        target = path;
    for (int links = 0; fs::is_symlink(fs::symlink_status(target, trouble)); ++links) {
        if (links == kMaxLinks) return outputError(path, "cannot be created", ELOOP);
        const fs::path next = fs::read_symlink(target, trouble);
        if (trouble) return outputError(path, "cannot be created", trouble.value());
        target = target.parent_path() / next;  // an absolute `next` replaces the folder
    }
    return target.string();
}

Result<FileWriter> FileWriter::create(const std::string& path)
{
    FileWriter writer;
    writer.m_path = path;
    if (path.empty()) return Error{Trouble::Usage, "an output needs a file name"};

    struct stat existing {};
    const bool  exists = ::stat(path.c_str(), &existing) == 0;
    // A name that is too long is refused here: the temporary file's name is short and would not show it.
    if (!exists && errno != ENOENT) return outputError(path, "cannot be created", errno);
    if (exists && S_ISDIR(existing.st_mode)) return outputError(path, "cannot be written", EISDIR);

    if (exists && !S_ISREG(existing.st_mode)) {
        writer.m_file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (writer.m_file < 0) return outputError(path, "cannot be opened for writing", errno);
        return writer;
    }
    // Renaming would replace even a file that its owner has protected.
    if (exists && ::access(path.c_str(), W_OK) != 0) return outputError(path, "cannot be written", errno);

    Result<std::string> target = linkTarget(path);
    if (!target) return target.error();
    writer.m_target = *std::move(target);
    for (int attempt = 0; attempt < kTemporaryNames && writer.m_file < 0; ++attempt) {
        writer.m_temporary = temporaryName(writer.m_target, attempt);
        writer.m_file      = ::open(writer.m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (writer.m_file < 0 && errno != EEXIST) return outputError(path, "cannot be created", errno);
    }
    if (writer.m_file < 0) return outputError(path, "cannot be created", EEXIST);
    if (exists) ::fchmod(writer.m_file, existing.st_mode & 0777);
    return writer;
}

FileWriter::FileWriter(FileWriter&& other) noexcept
    : m_file(std::exchange(other.m_file, -1)), m_path(std::move(other.m_path)), m_target(std::move(other.m_target)),
      m_temporary(std::move(other.m_temporary)), m_buffer(std::move(other.m_buffer)), m_error(std::move(other.m_error))
{}

FileWriter& FileWriter::operator=(FileWriter&& other) noexcept
{
    if (this == &other) return *this;
    discard();
    m_file      = std::exchange(other.m_file, -1);
    m_path      = std::move(other.m_path);
    m_target    = std::move(other.m_target);
    m_temporary = std::move(other.m_temporary);
    m_buffer    = std::move(other.m_buffer);
    m_error     = std::move(other.m_error);
    return *this;
}

FileWriter::~FileWriter() { discard(); }

void FileWriter::discard()
{
    if (m_file < 0) return;
    ::close(std::exchange(m_file, -1));
    if (!m_temporary.empty()) ::unlink(m_temporary.c_str());
}

void FileWriter::fail(const char* action, int reason)
{
    if (!m_error) m_error = outputError(m_path, action, reason);
    m_buffer.clear();
}

void FileWriter::write(std::string_view bytes)
{
    assert(m_file >= 0);
    if (m_error) return;
    if (m_buffer.capacity() == 0) m_buffer.reserve(kWriteBuffer);
    while (!bytes.empty() && !m_error) {
        const std::size_t part = std::min(bytes.size(), kWriteBuffer - m_buffer.size());
        m_buffer.insert(m_buffer.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(part));
        bytes.remove_prefix(part);
        if (m_buffer.size() == kWriteBuffer) flush();
    }
}

void FileWriter::flush()
{
    std::size_t done = 0;
    while (done < m_buffer.size()) {
        const ssize_t wrote = ::write(m_file, m_buffer.data() + done, m_buffer.size() - done);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) return fail("cannot be written", errno);
        done += static_cast<std::size_t>(wrote);
    }
    m_buffer.clear();
}

Result<Done> FileWriter::commit()
{
    if (!m_error) flush();
    // A device or pipe cannot be synchronised; that is no fault of the contents.
    if (!m_error && !m_temporary.empty() && ::fsync(m_file) != 0) fail("cannot be written", errno);
    if (m_error) {
        discard();
        return *m_error;
    }
    if (::close(std::exchange(m_file, -1)) != 0) fail("cannot be written", errno);
    if (!m_error && !m_temporary.empty() && ::rename(m_temporary.c_str(), m_target.c_str()) != 0)
        fail("cannot be replaced", errno);
    if (m_error) {
        if (!m_temporary.empty()) ::unlink(m_temporary.c_str());
        return *m_error;
    }
    return Done{};
}

Result<Done> writeFile(const std::string& path, std::string_view contents)
{
    Result<FileWriter> file = FileWriter::create(path);
    if (!file) return file.error();
    file->write(contents);
    return file->commit();
}

}  // namespace zscope
