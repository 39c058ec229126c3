#include "app/cli/peers/peer_rows.h"

#include <algorithm>

#include <fmt/format.h>
#include <omp.h>

#include "core/frame/pipeline.h"

namespace zscope::cli {
namespace {

/// Our picture of the request, by an exact method that is quick on any scene.
Result<Picture> ownPicture(const BenchRequest& request)
{
    const auto hzb = std::ranges::find(presets(), "hzb-octree", &Preset::name);
    Renderer   renderer;
    Frame      frame;
    const auto drawn = renderer.draw({.scene       = std::make_shared<const PreparedScene>(request.scene),
                                      .camera      = request.camera,
                                      .faceCulling = request.faceCulling,
                                      .pipeline    = hzb->pipeline,
                                      .shade       = false,
                                      .memoryLimit = request.memoryLimit,
                                      .cancel      = request.progress.cancel},
                                     frame);
    if (!drawn) return drawn.error();
    return pictureOf(frame.visible);
}

bool isWanted(const Peer& peer, BenchPictures pictures)
{
    if (!peer.run) return false;
    return pictures == BenchPictures::Both || peer.shades == (pictures == BenchPictures::Shaded);
}

}  // namespace

Result<Done> checkPeers()
{
    if (std::ranges::any_of(peers(), [](const Peer& peer) { return peer.run != nullptr; })) return Done{};
    std::vector<std::string_view> packages;
    for (const Peer& peer : peers()) packages.push_back(peer.package);
    return Error{
        Trouble::Usage,
        fmt::format(
            "--peers has nobody to compare with: this program was built without Embree and OSMesa; install {} and "
            "build it again",
            fmt::join(packages, " and "))};
}

std::vector<std::string> missingPeers()
{
    std::vector<std::string> missing;
    for (const Peer& peer : peers())
        if (!peer.run) missing.push_back(fmt::format("built without {} ({})", peer.name, peer.package));
    return missing;
}

Result<std::vector<BenchRow>> benchPeers(const BenchRequest& request)
{
    if (const std::string why = explainUndrawable(*request.scene); !why.empty())
        return Error{Trouble::Input, why, request.scene->name};
    const Result<Picture> own = ownPicture(request);
    if (!own) return own.error();

    std::vector<BenchRow> rows;
    for (const Peer& peer : peers()) {
        if (!isWanted(peer, request.pictures)) continue;
        for (const int said : request.threads) {
            const int threads = said == 0 ? omp_get_num_procs() : said;
            request.progress.at(0, peer.name);
            Result<PeerRun> run = peer.run({.scene       = *request.scene,
                                            .camera      = request.camera,
                                            .faceCulling = request.faceCulling,
                                            .threads     = threads,
                                            .warmUp      = request.warmUp,
                                            .frames      = request.frames,
                                            .leastMs     = request.leastMs,
                                            .progress    = request.progress});
            if (!run) return run.error();
            const PeerDifference difference = differenceOf(*run, own->ids, own->depth);
            std::ranges::sort(run->frameMs);
            const auto at = [&run](double p) { return run->frameMs[quantileRank(run->frameMs.size(), p)]; };
            BenchRow   row;
            row.scene       = request.scene->name;
            row.algorithm   = peer.name;
            row.claim       = Claim::Approximate;  // it never promised our picture
            row.chosen      = run->setting;
            row.threads     = threads;
            row.simd        = Simd::Auto;
            row.frames      = run->frameMs.size();
            row.shaded      = peer.shades;
            row.wrongPixels = difference.pixels;
            row.bestMs      = run->frameMs.front();
            row.q1Ms        = at(0.25);
            row.medianMs    = at(0.5);
            row.q3Ms        = at(0.75);
            row.triangles   = request.scene->triangleCount();
            row.pixels =
                static_cast<std::uint64_t>(request.camera.width) * static_cast<std::uint64_t>(request.camera.height);
            row.buildMs                                         = run->buildMs;
            row.load                                            = request.load;
            row.stageMs[static_cast<std::size_t>(Stage::Other)] = row.medianMs;
            row.counters                                        = {{"pixels_that_differ", difference.pixels},
                                                                   {"of_them_beside_edges", difference.besideEdges}};
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

}  // namespace zscope::cli
