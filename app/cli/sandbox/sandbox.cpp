#include "app/cli/sandbox/sandbox.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "app/cli/sandbox/bubblewrap.h"
#include "app/cli/sandbox/supervisor.h"

namespace zscope::cli {

namespace fs = std::filesystem;

namespace {

Result<Done> linkShown(const Job& job, const PrivateFolder& folder)
{
    for (const Shown& shown : job.shown) {
        const fs::path  link = fs::path(folder.path()) / shown.name;
        std::error_code trouble;
        fs::create_directories(link.parent_path(), trouble);
        if (!trouble) fs::create_symlink(shown.path, link, trouble);
        if (trouble) return Error{Trouble::Output, trouble.message(), link.string()};
    }
    return Done{};
}

}  // namespace

std::string rootOf(Confinement confinement, const PrivateFolder& folder)
{
    return confinement == Confinement::Sandbox ? kSandboxRoot : folder.path();
}

Result<Outcome> run(const Job& job, const PrivateFolder& folder, const std::atomic<bool>* cancel)
{
    Program program{.startsIn = folder.path() + "/work", .watchedFolder = folder.path()};
    if (job.confinement == Confinement::Sandbox) {
        const auto bubblewrap = findBubblewrap();
        if (!bubblewrap) return Error{Trouble::Limit, "bubblewrap (the program bwrap) is not installed"};
        program.arguments = bubblewrapWords(*bubblewrap, job, folder);
    } else {
        if (const auto linked = linkShown(job, folder); !linked) return linked.error();
        if (!job.startsIn.empty()) program.startsIn = job.startsIn;
        program.arguments = {"/bin/sh", "-c", job.command};
    }
    return supervise(program, job.limits, cancel);
}

std::optional<std::string> whyNoSandbox()
{
    if (!findBubblewrap()) return "bubblewrap (the program bwrap) is not installed";
    const auto folder = PrivateFolder::create();
    if (!folder) return folder.error().text();
    const auto outcome = run({.command = "true", .limits = {.seconds = 30}}, *folder);
    if (!outcome) return outcome.error().text();
    if (outcome->ending == Ending::Exited && outcome->status == 0) return std::nullopt;
    const std::string firstLine = outcome->text.substr(0, outcome->text.find('\n'));
    return fmt::format("bubblewrap cannot make a sandbox here ({})", firstLine.empty() ? "it says nothing" : firstLine);
}

bool isPlainWord(std::string_view word)
{
    const auto isPlain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')
               || std::string_view("._/+-:,=@%").find(c) != std::string_view::npos;
    };
    return !word.empty() && std::ranges::all_of(word, isPlain);
}

}  // namespace zscope::cli
