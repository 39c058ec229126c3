// Mesa's llvmpipe through OSMesa: the picture as an application would draw it with OpenGL, one colour per triangle.
//
// Drawn      vertex and index buffers uploaded once, one draw call per instance with its matrix (all of them written
//            out as one mesh were not faster), depth test, culling as asked, into a frame buffer of its own that nobody
//            copies; a frame ends when glFinish() returns
// Vertices   shared as far as flat colours allow: each triangle's colour sits at its last corner, so a vertex may be
//            the last corner of one triangle only, and there are about as many vertices as triangles
// Settings   LP_NUM_THREADS: 0 (all in one thread); with several cores also one thread less than cores, and as many.
//            The fastest counts. Mesa reads it once per process, so every setting is a process of its own, forked
// Depth      the far plane at its place, 24 bits or more; read back as 1 - near/z scaled, so that it can be compared
#pragma once

#include "app/cli/peers/peer.h"

namespace zscope::cli {

Result<PeerRun> drawByLlvmpipe(const PeerRequest& request);

}  // namespace zscope::cli
