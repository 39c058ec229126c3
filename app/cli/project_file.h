// Files that belong to the project and not to the user: found from where the program is run, or from where it was
// built.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace zscope::cli {

/// `relative` is meant from the root of the project. Looked for from the current folder first, then from every folder
/// above the program; nothing if it is in none of them.
std::optional<std::string> findProjectFile(std::string_view relative);

}  // namespace zscope::cli
