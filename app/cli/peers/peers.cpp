#include <algorithm>
#include <array>
#include <cmath>

#include "app/cli/peers/embree_peer.h"
#include "app/cli/peers/llvmpipe_peer.h"
#include "app/cli/peers/peer.h"

namespace zscope::cli {
namespace {

#ifdef ZSCOPE_HAS_EMBREE
constexpr auto* kEmbree = &traceByEmbree;
#else
constexpr Result<PeerRun> (*kEmbree)(const PeerRequest&)   = nullptr;
#endif
#ifdef ZSCOPE_HAS_OSMESA
constexpr auto* kLlvmpipe = &drawByLlvmpipe;
#else
constexpr Result<PeerRun> (*kLlvmpipe)(const PeerRequest&) = nullptr;
#endif

constexpr std::array kPeers{
    Peer{"peer:llvmpipe", "Mesa's llvmpipe, a colour per triangle", "libosmesa6-dev", true, kLlvmpipe},
    Peer{"peer:embree", "Embree's primary rays, ids and depth", "libembree-dev", false, kEmbree},
};

/// Whether two depths are the same surface: distances less than 1 % apart.
bool alike(float a, float b) { return std::abs(a - b) <= 0.01f * std::max(a, b); }

/// Calls is(i) for the pixels around pixel (x, y), not itself; whether any answers yes.
template <class Is>
bool anyAround(const Grid<float>& grid, int x, int y, const Is& is)
{
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const int u = x + dx, v = y + dy;
            if ((dx != 0 || dy != 0) && u >= 0 && v >= 0 && u < grid.width() && v < grid.height() && is(u, v))
                return true;
        }
    return false;
}

}  // namespace

std::span<const Peer> peers() { return kPeers; }

PeerDifference differenceOf(const PeerRun& peer, const Grid<std::int64_t>& ids, const Grid<float>& depth)
{
    const bool     byId = !peer.ids.values().empty();
    PeerDifference difference;
    for (int y = 0; y < depth.height(); ++y)
        for (int x = 0; x < depth.width(); ++x) {
            const auto shows = [&](int u, int v) {
                return byId ? ids.at(u, v) == peer.ids.at(x, y)
                            : (depth.at(u, v) > 0) == (peer.depth.at(x, y) > 0)
                                  && alike(depth.at(u, v), peer.depth.at(x, y));
            };
            if (shows(x, y)) continue;
            ++difference.pixels;
            difference.besideEdges += anyAround(depth, x, y, shows);
        }
    return difference;
}

std::string explainUndrawable(const Scene& scene)
{
    for (const auto& mesh : scene.meshes)
        for (const Material& material : mesh->materials)
            if (material.opacity < 1 || material.isPatterned())
                return "other renderers are only compared on opaque scenes, and this one has transparent surfaces, "
                       "cut-outs or reliefs";
    return {};
}

}  // namespace zscope::cli
