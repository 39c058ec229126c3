// All runs of a grading: each submission with each scene, several side by side.
#pragma once

#include <vector>

#include "app/cli/grade.h"
#include "app/cli/session.h"
#include "core/base/result.h"

namespace zscope::cli {

/// Sorted by submission, then as the scenes were named. Errors: Usage, Input, Output, Limit, Cancelled.
Result<std::vector<GradeRow>> gradeAll(const GradeOptions& options, Session& session);

}  // namespace zscope::cli
