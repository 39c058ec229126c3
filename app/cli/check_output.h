// A judgement (core/check/check.h) in the forms that people, scripts and courses read.
//
// JUnit       one test suite of three cases: coverage, surface, depth; what the files do not show is skipped
// Gradescope  results.json: the same three cases, one point each for what is shown, none for a case with wrong pixels
#pragma once

#include <string>
#include <string_view>

#include "app/cli/json.h"
#include "core/check/check.h"

namespace zscope::cli {

Json        jsonOf(const check::CheckAnswer& answer);
std::string textOf(const check::CheckAnswer& answer);

/// What one case of a report says.
struct CheckCase {
    std::string_view name;
    bool             isJudged = false;  // the files show it
    std::uint64_t    wrong    = 0;      // pixels
};
std::vector<CheckCase> casesOf(const check::CheckAnswer& answer);

/// `name` is what was checked: a scene, a submission.
std::string junitOf(const check::CheckAnswer& answer, const std::string& name);
std::string gradescopeOf(const check::CheckAnswer& answer, const std::string& name);

}  // namespace zscope::cli
