// What a program wrote into a folder, judged.
//
// Files       out.zdump, depth.npy, ids.npy and picture.png, as far as they are there: regular files only, never links
// Verdict     WroteNothing: none is there. Unreadable: one cannot be used; the detail says why
// Errors      Limit, Cancelled
#pragma once

#include <string>

#include "app/cli/grade.h"
#include "app/cli/json.h"
#include "core/check/check.h"

namespace zscope::cli {

struct GradeJudgement {
    GradeVerdict verdict = GradeVerdict::Right;
    std::string  detail;
    Json         check = nullptr;
};

/// One thread at a time may use a checker.
Result<GradeJudgement> judgeFolder(const std::string& folder, check::Checker& checker, check::CheckRequest request);

}  // namespace zscope::cli
