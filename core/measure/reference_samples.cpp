#include <algorithm>
#include <functional>

#include "core/measure/reference.h"
#include "core/measure/reference_walk.h"

namespace zscope {

using namespace definition;

namespace {

std::vector<Bounds> boxesOfMeshes(const Scene& scene)
{
    std::vector<Bounds> boxes(scene.meshes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (const dvec3& p : scene.meshes[i]->positions) boxes[i].include(p);
    }
    return boxes;
}

}  // namespace

Result<std::vector<SampleTruth>> referenceSamples(const Scene& scene, const Camera& camera, FaceCulling faceCulling,
                                                  std::span<const PixelPosition> points, const Progress& progress)
{
    const View                view(camera, faceCulling);
    const PointsByRow         rows(points, camera.height);
    const std::vector<Bounds> boxes = boxesOfMeshes(scene);
    std::vector<Winner>       winners(points.size(), 0);

    const auto reachesAPoint = [&](InstanceId i) {
        const Instance& instance = scene.instances[i.value];
        return rows.within(reachOf(boxes[instance.mesh.value], instance.toWorld, view), [](auto) {});
    };
    const auto done = forEachTriangle(scene, view, progress, reachesAPoint,
                                      [&](std::uint32_t id, Fate, const std::vector<Part>& parts) {
                                          for (const Part& part : parts) {
                                              rows.within(part.box(), [&](std::uint32_t point) {
                                                  const PixelPosition p = points[point];
                                                  if (!part.covers(p.x, p.y)) return;
                                                  const float depth = part.depth(p.x, p.y);
                                                  if (depth >= view.farDepth)
                                                      offer(winners[point], winnerOf(depth, id));
                                              });
                                          }
                                      });
    if (!done) return done.error();

    std::vector<SampleTruth> truths;
    for (const Winner winner : winners) truths.push_back(truthOf(winner));
    return truths;
}

Result<std::vector<CoveringTriangle>> coveringTriangles(const Scene& scene, const Camera& camera,
                                                        FaceCulling faceCulling, PixelPosition pixel,
                                                        const Progress& progress)
{
    const View                    view(camera, faceCulling);
    const std::vector<Bounds>     boxes = boxesOfMeshes(scene);
    std::vector<CoveringTriangle> covering;

    const auto reachesThePixel = [&](InstanceId i) {
        const Instance& instance = scene.instances[i.value];
        return reachOf(boxes[instance.mesh.value], instance.toWorld, view).holds(pixel.x, pixel.y);
    };
    const auto done = forEachTriangle(
        scene, view, progress, reachesThePixel, [&](std::uint32_t id, Fate, const std::vector<Part>& parts) {
            for (const Part& part : parts) {
                if (!part.box().holds(pixel.x, pixel.y) || !part.covers(pixel.x, pixel.y)) continue;
                const float depth = part.depth(pixel.x, pixel.y);
#pragma omp critical(zscope_covering)
                covering.push_back({.triangle = TriangleId{id}, .depth = depth, .kept = depth >= view.farDepth});
            }
        });
    if (!done) return done.error();

    // Two parts of one triangle may cover the same pixel after snapping: its nearest sample stays.
    std::ranges::sort(covering, [](const CoveringTriangle& a, const CoveringTriangle& b) {
        return a.triangle != b.triangle ? a.triangle < b.triangle : a.depth > b.depth;
    });
    const auto sameTriangle = [](const auto& a, const auto& b) { return a.triangle == b.triangle; };
    covering.erase(std::unique(covering.begin(), covering.end(), sameTriangle), covering.end());
    std::ranges::stable_sort(covering, std::greater{}, &CoveringTriangle::depth);
    return covering;
}

}  // namespace zscope
