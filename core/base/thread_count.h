// How many threads may be asked for: one bound for the command line, for experiments and for frames.
#pragma once

namespace zscope {

inline constexpr int kMaxThreads = 256;

}  // namespace zscope
