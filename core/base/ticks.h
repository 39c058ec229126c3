// The processor's own clock, for whoever reads it thousands of times a frame.
//
// Ticks      run evenly where the processor's counter is invariant, as on any x86-64 of the last fifteen years; how
//            long one is nobody says here: measure some interval by a clock of the library as well (StageClock)
// Cost       some 8 ns where the processor's counter can be read (x86-64: rdtsc), else what the library's clock costs
#pragma once

#include <chrono>
#include <cstdint>

namespace zscope {

inline std::uint64_t ticksNow()
{
#if defined(__x86_64__)
    return __builtin_ia32_rdtsc();
#else
    return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

}  // namespace zscope
