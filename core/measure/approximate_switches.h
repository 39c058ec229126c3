// What to time when the question is what exactness costs: an algorithm, and the same with one exactness given up at a
// time.
//
// Switches   every choice of an Approximation but the first of its kind, each alone. One that the algorithm cannot have
//            is tried on the presets in their order, so that none is missing: edges=accumulated needs an edge walk
// Text       plain text draws all of them, or fast text does: an algorithm without a fast text stands alone
// Left out   what a still picture's ids and depths do not show: last-pyramid errs in motion, transparency in colours
#pragma once

#include <vector>

#include "core/measure/bench.h"

namespace zscope {

/// Every preset that can run and has a fast text, in the order of presets().
std::vector<BenchAlgorithm> presetsToTime();

/// `base` without any approximation or fault, then one algorithm per switch, named as nameOf() does.
std::vector<BenchAlgorithm> approximateSwitches(Pipeline base);

}  // namespace zscope
