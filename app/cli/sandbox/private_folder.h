// A folder for one run of an untrusted program, which may write into "work", "out" and "tmp" in it.
//
// Promise    removed with all that is in it, whatever rights the program has given its files
// Links      are never followed: not when bytes are counted, not when the folder is removed
#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"

namespace zscope::cli {

class PrivateFolder {
public:
    /// In the system's folder for temporary files. Errors: Output.
    static Result<PrivateFolder> create();

    PrivateFolder(PrivateFolder&& other) noexcept;
    PrivateFolder& operator=(PrivateFolder&&) = delete;
    ~PrivateFolder();

    const std::string& path() const { return m_path; }
    std::string        out() const { return m_path + "/out"; }

private:
    explicit PrivateFolder(std::string path) : m_path(std::move(path)) {}

    std::string m_path;  // empty: moved away
};

/// What a folder holds, in bytes; a file or folder counts at least 256. Counting ends once `enough` is exceeded.
std::uint64_t bytesIn(const std::string& folder, std::uint64_t enough);

}  // namespace zscope::cli
