// Other renderers, timed on the same triangles through the same camera, for `bench --peers`.
//
// Optional   each is in the program only if its library was there when it was built; peers() lists all of them
// Fair       what a user of the peer would do once is not timed (buffers, trees); every frame is drawn from scratch to
//            the last pixel; of the peer's own settings the fastest counts; back faces are culled as the request says
// Scenes     opaque ones: a scene with transparent surfaces, cut-outs or reliefs is refused
// Pictures   are compared with ours. Both peers calculate in float32 and neither snaps corners as we do, so pixels
//            beside edges differ, and so do surfaces that nearly coincide
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope::cli {

struct PeerRequest {
    const Scene& scene;
    Camera       camera;
    FaceCulling  faceCulling = FaceCulling::None;
    int          threads     = 1;   // cores it may use
    int          warmUp      = 3;   // frames before the timed ones
    int          frames      = 30;  // timed, at least 1
    double       leastMs     = 0;   // that the timed frames take together, by more of them if need be
    Progress     progress    = {};
};

struct PeerRun {
    std::vector<double> frameMs;      // in the order drawn, at the peer's fastest setting
    double              buildMs = 0;  // buffers and trees, once
    std::string         setting;      // which one that was, and how instances were drawn
    Grid<float>         depth;        // near/z; 0 is background
    Grid<std::int64_t>  ids;          // ours, -1 is background; empty: the peer gives none
};

struct Peer {
    std::string_view name;  // of its rows: "peer:embree"
    std::string_view title;
    std::string_view package;  // that holds its library
    bool             shades;   // false: ids and depth only
    /// nullptr: built without it. Errors: Input (a scene it cannot draw, a library that is gone), Limit, Cancelled.
    Result<PeerRun> (*run)(const PeerRequest& request);
};
std::span<const Peer> peers();

/// How a peer's picture differs from ours.
struct PeerDifference {
    std::uint64_t pixels      = 0;  // id differs; without ids: coverage, or a distance by more than 1 %
    std::uint64_t besideEdges = 0;  // of these: what the peer shows is shown by us at one of the eight pixels around
};
PeerDifference differenceOf(const PeerRun& peer, const Grid<std::int64_t>& ids, const Grid<float>& depth);

/// Why no peer can draw it, in one sentence; empty if they can.
std::string explainUndrawable(const Scene& scene);

}  // namespace zscope::cli
