// The command of grade: what it names, and its words replaced by paths.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace zscope::cli {

/// Errors: Usage. {out} is missing; {submission} is there without --submissions.
Result<Done> checkGradeCommand(const std::string& command, bool hasSubmissions);

/// Every {name} of the list replaced by its value.
struct Placeholder {
    std::string_view name;  // with its braces
    std::string      value;
};
std::string withPaths(std::string command, const std::vector<Placeholder>& placeholders);

/// What the command needs beside the system's own programs: folders that it names by absolute paths, the folders of
/// such files, and those of programs that PATH has elsewhere. Of a whole home only the file.
std::vector<std::string> pathsNamedBy(const std::string& command);

/// The regular files that words of the command name, absolute or from the current folder.
std::vector<std::string> filesNamedBy(const std::string& command);

/// A home, what holds one, or a folder of the system: no program should be shown all of it.
bool isTooMuchToShow(const std::string& folder);

/// A folder or file as a name that needs no quotes in a shell: its own name, else `otherwise` with its ending.
std::string plainNameOf(const std::string& path, const std::string& otherwise);

}  // namespace zscope::cli
