// Reading what a user named, without being led astray: only regular files, only so many bytes, only inside the
// folder that was meant.
//
// Errors     Input: missing, not readable, a directory, a FIFO, a device, changed while it was read, outside the
//            folder. Limit: more bytes than allowed
// Promise    opening never waits (a FIFO without a writer) and never has side effects (a device); at most maxBytes
//            are read
#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"

namespace zscope {

Result<std::string> readRegularFile(const std::string& path, std::uint64_t maxBytes);

/// The real path (no links left in it) of `relative`, which must lie in `folder` or below once links are followed.
/// Absolute paths are refused. The error names `relative` as it was written.
Result<std::string> pathInside(const std::string& folder, const std::string& relative);

/// The real path of the folder that holds `path`; "." for a bare name.
Result<std::string> folderOf(const std::string& path);

}  // namespace zscope
