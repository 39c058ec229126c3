// Embree 3: one ray through every pixel centre to the nearest triangle, its id and depth written down.
//
// Settings   packets of 8, packets of 16, streams of 256: the fastest in a short trial is timed
// Instances  are written out as one mesh, which is faster to trace (a thousand balls: by a quarter); a scene of more
//            than kMostWrittenOut triangles is traced through Embree's own instances, unless one of them mirrors its
//            mesh
// Culling    Embree is not compiled for it here. Its filter, which costs time, is only used where more than a pixel in
//            a thousand would show a back face without it
// Source     Wald, Woop, Benthin, Johnson, Ernst: Embree: A Kernel Framework for Efficient CPU Ray Tracing, SIGGRAPH
//            2014
#pragma once

#include "app/cli/peers/peer.h"

namespace zscope::cli {

inline constexpr std::uint64_t kMostWrittenOut = 8'000'000;  // about 1.5 GiB of trees

Result<PeerRun> traceByEmbree(const PeerRequest& request);

}  // namespace zscope::cli
