// How a benchmark with other renderers in it is shown: every run, then scene by scene how many times as fast as each
// peer the fastest preset was, and the geometric mean of that.
#pragma once

#include <span>
#include <string>

#include "core/measure/bench.h"

namespace zscope::cli {

/// A shaded picture is held against llvmpipe, ids and depth against Embree, medians against medians of the same scene
/// with as many threads. A preset whose picture was wrong does not count.
std::string peerTablesOf(std::span<const BenchRow> rows);

}  // namespace zscope::cli
