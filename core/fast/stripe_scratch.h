// The scratch memory of the thread that draws a stripe.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "core/base/stage_clock.h"
#include "core/base/tally.h"
#include "core/depth/pyramid.h"
#include "core/depth/visibility_buffer.h"
#include "core/fast/hidden_squares/hidden_squares.h"
#include "core/fast/lanes/fragment_queue.h"
#include "core/fast/skipped_questions/sampled_questions.h"
#include "core/fast/windows/window_list.h"
#include "core/geometry/face_set_up.h"
#include "core/geometry/prepared_scene.h"
#include "core/geometry/screen_vertices.h"
#include "core/geometry/stripe_volume.h"
#include "core/geometry/triangle_list.h"
#include "core/hierarchy/node_memory.h"
#include "core/hierarchy/tree.h"
#include "core/plain/stripe.h"
#include "core/sweep/active_edges.h"
#include "core/sweep/active_polygons.h"
#include "core/sweep/blend_scratch.h"
#include "core/sweep/edge_table.h"

namespace zscope {

/// An instance of a node that is being visited, waiting for its turn.
struct WaitingInstance {
    double     distance;  // squared, from the eye to its box
    InstanceId instance;
};

/// A batch of a node that is being drawn, likewise.
struct WaitingBatch {
    double        distance;
    std::uint32_t batch;  // into MeshBatches::batches
};

/// The last node that was asked about on the way down.
struct AskedNode {
    std::uint32_t size    = 0;
    bool          isDense = false;  // at full speed: its triangles' own pixels are looked at
};

/// A node of a mesh's tree that waits for its turn, and what is known of it from above.
struct WaitingNode {
    double               distance;  // squared, from the eye to its box
    const TreeNode*      node;
    StripeVolume::Planes open;  // planes of the stripe that it may cross
    AskedNode            above;
};

/// Scratch memory of one thread, reused frame after frame.
struct StripeScratch {
    ScreenVertices vertices;
    TriangleList   triangles;  // of the batch at hand
    WindowList     windows;    // likewise, of compact triangles
    SampleList     samples;    // likewise, of tiny ones
    FragmentQueue  fragments;  // likewise, of fragments that are shaded as they come
    // whether it is worth asking: of z-cull, about the tiles under a batch; after a pre-pass, about a triangle
    SampledQuestions questions;
    EdgeTable        edges;  // sweep methods only, like the next two
    ActiveEdges      active;
    ActivePolygons   polygons;
    FaceScratch      faces;    // methods that draw whole faces only
    Pyramid          pyramid;  // hierarchical methods only
    HiddenSquares    hidden;   // likewise, of the batch at hand
    BlendScratch     blend;    // scenes with transparent surfaces only
    NodeMemory       memory;   // methods with coherence only
    Tally            tally;    // of the frame

    std::vector<WaitingInstance> instances;  // hierarchical methods only, like the next
    std::vector<WaitingBatch>    batches;
    std::vector<WaitingNode>     nodes;  // likewise, a heap with the nearest first

    std::size_t bytes() const
    {
        return sizeof(*this) + windows.bytes() + samples.bytes() + edges.bytes() + active.bytes() + polygons.bytes()
               + faces.bytes() + instances.capacity() * sizeof(WaitingInstance)
               + batches.capacity() * sizeof(WaitingBatch) + nodes.capacity() * sizeof(WaitingNode) + pyramid.bytes()
               + blend.bytes() + memory.bytes();
    }
};

}  // namespace zscope
