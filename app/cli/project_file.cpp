#include "app/cli/project_file.h"

#include <filesystem>
#include <system_error>

namespace zscope::cli {

std::optional<std::string> findProjectFile(std::string_view relative)
{
    namespace fs       = std::filesystem;
    const auto isThere = [](const fs::path& path) {
        std::error_code trouble;
        return fs::is_regular_file(path, trouble);
    };
    if (isThere(relative)) return std::string(relative);
    std::error_code trouble;
    for (fs::path folder                                = fs::read_symlink("/proc/self/exe", trouble).parent_path();
         !trouble && folder.has_relative_path(); folder = folder.parent_path())
        if (isThere(folder / relative)) return (folder / relative).lexically_normal().string();
    return std::nullopt;
}

}  // namespace zscope::cli
