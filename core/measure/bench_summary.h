// What bench() and benchPath() have in common: how a picture is held against the truth, and how frames become a row.
#pragma once

#include <cstdint>
#include <vector>

#include "core/measure/bench.h"

namespace zscope {

/// Pixels whose id or depth bits differ.
std::uint64_t differingPixels(const Picture& reference, const Picture& test);

/// What compare() would find, if every pixel is known to be the same.
ErrorFigures figuresOfEqual(const Picture& reference);

/// Fills the timing part of a row from its timed frames, of which there is at least one.
void summarise(std::vector<FrameReport> reports, BenchRow& row);

/// The request for one frame of a run.
DrawRequest drawRequestOf(const BenchRequest& request, std::shared_ptr<const PreparedScene> scene, const BenchAlgorithm& algorithm, int threads, Simd simd,
                          bool shade);

/// Whether shaded pictures are timed, ids and depth alone, or one after the other.
std::vector<bool> shadingsOf(BenchPictures pictures);

}  // namespace zscope
