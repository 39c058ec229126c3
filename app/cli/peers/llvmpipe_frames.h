// The part of the comparison with llvmpipe that calls OpenGL. Runs in a process of its own (llvmpipe_peer.h).
#pragma once

#include "app/cli/peers/peer.h"

namespace zscope::cli {

/// With the settings that the environment has. The setting's name is left to the caller.
Result<PeerRun> drawFramesByLlvmpipe(const PeerRequest& request);

}  // namespace zscope::cli
