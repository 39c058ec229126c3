#include "app/cli/grade_judge.h"

#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>

#include "app/cli/check_output.h"

namespace zscope::cli {
namespace {

struct ResultFile {
    const char*                name;
    std::optional<std::string> check::CheckRequest::*file;
};
constexpr std::array kResultFiles{
    ResultFile{"out.zdump", &check::CheckRequest::dump}, ResultFile{"depth.npy", &check::CheckRequest::depth},
    ResultFile{"ids.npy", &check::CheckRequest::ids}, ResultFile{"picture.png", &check::CheckRequest::picture}};

/// The folder's path differs from run to run.
std::string without(std::string text, const std::string& folder)
{
    for (std::size_t at = 0; (at = text.find(folder + '/', at)) != std::string::npos;)
        text.erase(at, folder.size() + 1);
    return text;
}

}  // namespace

Result<GradeJudgement> judgeFolder(const std::string& folder, check::Checker& checker, check::CheckRequest request)
{
    bool isThere = false;
    for (const ResultFile& each : kResultFiles) {
        const std::string path = folder + '/' + each.name;
        struct stat       status {};
        if (::lstat(path.c_str(), &status) != 0) continue;
        if (!S_ISREG(status.st_mode))
            return GradeJudgement{GradeVerdict::Unreadable, fmt::format("{} is not a regular file", each.name)};
        request.*each.file = path;
        isThere            = true;
    }
    if (!isThere)
        return GradeJudgement{GradeVerdict::WroteNothing,
                              "there is no out.zdump, depth.npy, ids.npy or picture.png in the folder {out}"};

    const Result<check::CheckAnswer> answer = checker.check(request);
    if (!answer) {
        const Error& error = answer.error();
        if (error.kind != Trouble::Input) return error;
        return GradeJudgement{GradeVerdict::Unreadable, without(error.text(), folder)};
    }
    const GradeVerdict verdict = !answer->isRight()             ? GradeVerdict::Wrong
                                 : answer->rounding.total() > 0 ? GradeVerdict::Rounding
                                                                : GradeVerdict::Right;
    return GradeJudgement{verdict, without(answer->sentence, folder), cli::jsonOf(*answer)};
}

}  // namespace zscope::cli
