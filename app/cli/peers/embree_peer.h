// Embree 3: one ray through every pixel centre to the nearest triangle, its id and depth written down.
//
// Settings   packets of 8, packets of 16, streams of 256: the fastest in a short trial is timed
// Instances  a scene of several is traced through Embree's own instances; one that mirrors any of them as one mesh
// Culling    Embree is not compiled for it here. Its filter, which costs time, is only used where more than a pixel in a
//            thousand would show a back face without it
// Source     Wald, Woop, Benthin, Johnson, Ernst: Embree: A Kernel Framework for Efficient CPU Ray Tracing, SIGGRAPH 2014
#pragma once

#include "app/cli/peers/peer.h"

namespace zscope::cli {

Result<PeerRun> traceByEmbree(const PeerRequest& request);

}  // namespace zscope::cli
