// Speed against error: which of several ways to draw are worth choosing, if both count.
//
// Dominated  another point is at least as good in both, and better in one. Of equal points none dominates the other
// Promise    along the answer time grows and error falls, strictly but for equal points
// Cost       n log n
// Source     docs/correctness.md, Speed against error
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace zscope {

struct SpeedError {
    double ms    = 0;  // of a frame
    double error = 0;  // any figure that is 0 for an exact picture; may be infinite, never NaN
};

/// Indices of the points that no other dominates, by rising time; equal points in the order they came.
std::vector<std::size_t> nonDominated(std::span<const SpeedError> points);

}  // namespace zscope
