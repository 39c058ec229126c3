#include "app/cli/grade_command.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "app/cli/sandbox/bubblewrap.h"
#include "app/cli/sandbox/sandbox.h"

namespace zscope::cli {

namespace fs = std::filesystem;

namespace {

bool isBelow(const fs::path& path, const fs::path& folder)
{
    const fs::path relative = path.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

/// The sandbox has these for every program.
bool isShownAnyway(const fs::path& path)
{
    return std::ranges::any_of(std::initializer_list<const char*>{"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64",
                                                                  "/libx32", "/opt", "/dev", "/proc"},
                               [&](const char* system) { return path == system || isBelow(path, system); });
}

/// Words as a shell would roughly see them; quotes and operators end a word.
std::vector<std::string> wordsOf(const std::string& command)
{
    std::vector<std::string> words{""};
    for (const char c : command) {
        if (std::string_view(" \t\n'\"|&;<>()$`\\").find(c) != std::string_view::npos)
            words.emplace_back();
        else
            words.back() += c;
    }
    std::erase(words, "");
    return words;
}

}  // namespace

Result<Done> checkGradeCommand(const std::string& command, bool hasSubmissions)
{
    if (command.find("{out}") == std::string::npos)
        return Error{Trouble::Usage, "--program needs {out}, the folder that the program writes its results to"};
    const bool names = command.find("{submission}") != std::string::npos;
    if (names && !hasSubmissions)
        return Error{Trouble::Usage, "--program has {submission}, but there is no --submissions"};
    if (!names && hasSubmissions)
        return Error{Trouble::Usage, "--program needs {submission}: without it all submissions would run the same"};
    return Done{};
}

bool isTooMuchToShow(const std::string& path)
{
    const fs::path folder = fs::path(path).lexically_normal();
    const char*    home   = std::getenv("HOME");
    return folder == folder.root_path() || folder == "/tmp" || folder == "/home" || folder == "/etc" || folder == "/var"
           || (home && (folder == fs::path(home).lexically_normal() || isBelow(home, folder)));
}

std::string withPaths(std::string command, const std::vector<Placeholder>& placeholders)
{
    for (const Placeholder& each : placeholders)
        for (std::size_t at = 0; (at = command.find(each.name, at)) != std::string::npos; at += each.value.size())
            command.replace(at, each.name.size(), each.value);
    return command;
}

std::vector<std::string> pathsNamedBy(const std::string& command)
{
    std::vector<std::string> paths;
    for (const std::string& word : wordsOf(command)) {
        std::error_code trouble;
        fs::path        show;
        if (word.starts_with('/')) {
            const fs::path named = fs::path(word).lexically_normal();
            if (!fs::exists(named, trouble) || isShownAnyway(named)) continue;
            show = fs::is_directory(named, trouble) ? named : named.parent_path();
            if (isTooMuchToShow(show)) show = fs::is_directory(named, trouble) ? fs::path() : named;
        } else if (word.find('/') == std::string::npos) {
            const auto program = findOnPath(word);
            if (!program || isShownAnyway(*program)) continue;
            const fs::path folder = fs::path(*program).parent_path();  // "bin"; libraries lie beside it
            show                  = isTooMuchToShow(folder.parent_path()) ? folder : folder.parent_path();
        }
        if (!show.empty() && std::ranges::find(paths, show.string()) == paths.end()) paths.push_back(show.string());
    }
    std::ranges::sort(paths);  // a folder before what lies in it
    return paths;
}

std::vector<std::string> filesNamedBy(const std::string& command)
{
    std::vector<std::string> files = wordsOf(command);
    std::error_code          trouble;
    std::erase_if(files, [&](const std::string& word) { return !fs::is_regular_file(word, trouble); });
    return files;
}

std::string plainNameOf(const std::string& path, const std::string& otherwise)
{
    const fs::path file = fs::path(path).filename();
    if (isPlainWord(file.string()) && !file.string().starts_with('-')) return file.string();
    const std::string ending = file.extension().string();
    return otherwise + (isPlainWord(ending) ? ending : "");
}

}  // namespace zscope::cli
