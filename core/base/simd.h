// The sets of vector instructions by name.
//
// Promise    every set gives the same bits
#pragma once

#include <span>
#include <string_view>

namespace zscope {

/// Scalar is one lane: the plain text.
enum class Simd { Auto, Scalar, Sse4, Avx2, Avx512 };

struct SimdEntry {
    Simd             target;
    std::string_view word;
    std::string_view title;
    bool             available;  // compiled in and supported by this machine
};
/// All that this build knows but Auto, from the narrowest to the widest.
std::span<const SimdEntry> simdTargets();
/// Auto becomes the widest available target; others stay.
Simd             resolved(Simd simd);
std::string_view wordOf(Simd simd);

}  // namespace zscope
