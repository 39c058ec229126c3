#include "app/cli/outputs.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "core/io/file_writer.h"

namespace zscope::cli {
namespace {

namespace fs = std::filesystem;

/// The file that the name leads to. Nothing: it is no regular file, or cannot be looked at, which is told by whoever
/// opens it.
std::optional<fs::path> fileBehind(const std::string& name)
{
    std::error_code       trouble;
    const fs::file_status status = fs::status(name, trouble);
    if (fs::exists(status) && !fs::is_regular_file(status)) return std::nullopt;
    const Result<std::string> target = linkTarget(name);
    if (!target) return std::nullopt;
    // weakly_canonical() leaves a name alone of which nothing exists
    const fs::path whole = fs::absolute(*target, trouble);
    fs::path       real  = trouble ? fs::path() : fs::weakly_canonical(whole, trouble);
    return trouble ? std::nullopt : std::optional(std::move(real));
}

/// Creates the file and removes it, so that an error which would follow the drawing comes first. A device or a pipe is
/// left alone: opening it may wait.
Result<Done> checkCreation(const std::string& name)
{
    std::error_code       trouble;
    const fs::file_status status = fs::status(name, trouble);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) return Done{};
    const Result<FileWriter> file = FileWriter::create(name);
    return file ? Result<Done>(Done{}) : file.error();
}

}  // namespace

std::string endingOf(const std::string& path)
{
    std::string ending = fs::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return ending;
}

Result<Done> checkOutputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs)
{
    struct Target {
        const Output*           output;
        std::optional<fs::path> file;
    };
    std::vector<Target> targets;
    for (const Output& output : outputs) {
        if (!output.path) continue;
        if (output.path->empty())
            return Error{Trouble::Usage, fmt::format("{} wants the name of a file, not ''", output.option)};
        targets.push_back({&output, fileBehind(*output.path)});
        if (!targets.back().file) continue;
        const auto same = std::ranges::find(targets, targets.back().file, &Target::file);
        if (same->output != &output)
            return Error{Trouble::Usage,
                         fmt::format("{} and {} name the same file '{}': each output needs one of its own",
                                     same->output->option, output.option, *output.path)};
    }
    for (const std::string& input : inputs) {
        if (input.empty() || input.starts_with("builtin:")) continue;
        const auto file = fileBehind(input);
        if (!file) continue;
        const auto same = std::ranges::find(targets, file, &Target::file);
        if (same != targets.end())
            return Error{Trouble::Usage, fmt::format("{} would replace '{}', which is read: name another file",
                                                     same->output->option, input)};
    }
    for (const Output& output : outputs) {
        if (!output.path) continue;
        const std::string ending = endingOf(*output.path);
        if (!ending.empty() && !output.endings.empty()
            && std::ranges::find(output.endings, ending) == output.endings.end())
            return Error{Trouble::Usage, fmt::format("{} writes no {} file: let its name end in {}", output.option,
                                                     ending, fmt::join(output.endings, " or "))};
    }
    for (const Output& output : outputs)
        if (output.path)
            if (const auto checked = checkCreation(*output.path); !checked) return checked.error();
    return Done{};
}

}  // namespace zscope::cli
