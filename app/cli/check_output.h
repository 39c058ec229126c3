// A judgement (core/check/check.h) in the forms that people, scripts and courses read.
//
// JUnit       one test suite of three cases: coverage, surface, depth; what the files do not show is skipped. A trace
//             is a fourth case
// Gradescope  results.json: the same cases, one point each for what is shown, none for a case with wrong pixels or rows
#pragma once

#include <string>
#include <string_view>

#include "app/cli/json.h"
#include "core/check/check.h"

namespace zscope::cli {

/// What was judged: a picture, a trace, or both.
struct Judged {
    const check::CheckAnswer* picture = nullptr;
    const check::TraceAnswer* trace   = nullptr;
    const check::Trace*       rows    = nullptr;  // of the trace

    bool        isRight() const { return (!picture || picture->isRight()) && (!trace || trace->isRight()); }
    std::string sentence() const;
};

Json        jsonOf(const check::CheckAnswer& answer);
Json        jsonOf(const Judged& judged);
std::string textOf(const Judged& judged);

/// What one case of a report says.
struct CheckCase {
    std::string_view name;
    bool             isJudged = false;  // the files show it
    std::uint64_t    wrong    = 0;      // of them
    std::string_view what     = "pixel";
};
std::vector<CheckCase> casesOf(const Judged& judged);

/// `name` is what was checked: a scene, a submission.
std::string junitOf(const Judged& judged, const std::string& name);
std::string gradescopeOf(const Judged& judged, const std::string& name);

}  // namespace zscope::cli
