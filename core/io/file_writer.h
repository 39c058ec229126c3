// Writes a file that is either complete or absent: nothing appears under the final name before commit().
//
// How        the bytes go to a new file in the same folder, which is flushed to disk and then renamed over the
//            target; without commit() it is removed
// Links      a symbolic link stays as it is: the file that it names is replaced, or created if it does not exist yet
// Devices    a target that exists and is no regular file (/dev/stdout, /dev/full, a pipe) is written directly: it
//            cannot be replaced and has no earlier contents to protect
// Memory     one buffer of kWriteBuffer bytes, whatever the size of the file
// Errors     Usage for a name that is empty; else Output with the target's name and the system's reason. The first one
//            sticks: later calls do nothing and commit() returns it
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace zscope {

inline constexpr std::size_t kWriteBuffer = std::size_t{1} << 18;

class FileWriter {
public:
    static Result<FileWriter> create(const std::string& path);

    FileWriter(FileWriter&& other) noexcept;
    FileWriter& operator=(FileWriter&& other) noexcept;
    ~FileWriter();  // without commit(): removes what was written

    void         write(std::string_view bytes);
    bool         failed() const { return m_error.has_value(); }
    Result<Done> commit();

private:
    FileWriter() = default;
    void flush();
    void fail(const char* action, int reason);
    void discard();

    // Either m_file is open and commit() has not happened, or m_file is -1.
    int                  m_file = -1;
    std::string          m_path;       // as the caller wrote it, for sentences
    std::string          m_target;     // what will be replaced; empty: written directly
    std::string          m_temporary;  // empty: written directly
    std::vector<char>    m_buffer;
    std::optional<Error> m_error;
};

/// The file that `path` names once all links are followed, whether or not it exists. Errors: Output.
Result<std::string> linkTarget(const std::string& path);

/// The whole file at once.
Result<Done> writeFile(const std::string& path, std::string_view contents);

}  // namespace zscope
