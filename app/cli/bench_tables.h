// What a benchmark prints: times as they were measured, or what a suite's question wants to see side by side.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/measure/bench.h"

namespace zscope::cli {

/// "verified", "12 wrong" or "not checked".
std::string pictureOf(const BenchRow& row);
/// What the time is for: "shaded" or "ids, depth".
std::string drawnOf(const BenchRow& row);

/// One line per run: every quantile and the main stages.
std::string benchTableOf(std::span<const BenchRow> rows);

/// One line per run: the median against that of the z-buffer in the same scene, with the same threads and target; every
/// stage that took time in any run; what was culled, and of how much: triangles in batches and nodes in view.
std::string suiteTableOf(std::span<const BenchRow> rows);
/// Of `bench --ladder`: each rung against all shortcuts, in the same rounds.
std::string ladderTableOf(std::span<const BenchRow> rows);

/// One line per run: the median against that of the baseline in the same scene with the same threads, timed in turn,
/// with the interval that the noise leaves; every stage that took time. A run whose picture is wrong although its
/// algorithm promises it has no times.
std::string experimentTableOf(std::span<const BenchRow> rows, std::string_view baseline);

/// One line per run along a camera path: the slowest frame, how many frames were wrong and the worst of them, how many
/// wrong frames followed each cut, and by what the frames were drawn where that was chosen.
std::string seriesTableOf(std::span<const BenchRow> rows);

}  // namespace zscope::cli
