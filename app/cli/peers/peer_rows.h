// Other renderers as rows of a benchmark.
#pragma once

#include <string>
#include <vector>

#include "app/cli/peers/peer.h"
#include "core/measure/bench.h"

namespace zscope::cli {

/// Whether there is anybody to compare with. Errors: Usage that names the packages to install, if no peer is in this
/// program.
Result<Done> checkPeers();
/// "built without peer:embree (libembree-dev)", one for each that is missing while others are there.
std::vector<std::string> missingPeers();

/// Every peer that is there with every thread count of the request: the scene and camera, the frames and what is drawn
/// are those of the request; peers that draw ids and depth only are left out where only shaded pictures are timed, and
/// the reverse. `chosen` is the peer's fastest setting, `wrongPixels` counts the pixels that differ from our picture,
/// and the counters tell how many of them lie beside edges. What a frame took is in the stage `other`.
Result<std::vector<BenchRow>> benchPeers(const BenchRequest& request);

/// Whether the row is a peer's.
inline bool isPeer(const BenchRow& row) { return row.algorithm.starts_with("peer:"); }

}  // namespace zscope::cli
