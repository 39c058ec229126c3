// Reading what a user named, without being led astray: only regular files, only so many bytes, only inside the
// folder that was meant.
//
// Errors     Input: missing, not readable, a directory, a FIFO, a device, changed while it was read, outside the
//            folder. Limit: more bytes than allowed
// Promise    opening never waits (a FIFO without a writer) and never has side effects (a device); at most maxBytes
//            are read
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace zscope {

Result<std::string> readRegularFile(const std::string& path, std::uint64_t maxBytes);

/// The real path (no links left in it) of `relative`, which must lie in `folder` or below once links are followed.
/// Absolute paths are refused. What is not there as written is looked for once more with '/' for every backslash, as
/// Windows writes paths.
std::optional<std::string> findInside(const std::string& folder, const std::string& relative);
/// The same with an error that says why there is none. It names `relative` as it was written, and a file whose name
/// differs only in the case of its letters.
Result<std::string> pathInside(const std::string& folder, const std::string& relative);

/// Whether a path is absolute, here or on Windows: "/a", "\a", "C:\a", "C:a".
bool isAbsolutePath(std::string_view path);

/// Whether the name ends in `ending`, given in small letters, in letters of either case.
bool hasEnding(std::string_view name, std::string_view ending);

/// The real path of the folder that holds `path`; "." for a bare name.
Result<std::string> folderOf(const std::string& path);

}  // namespace zscope
