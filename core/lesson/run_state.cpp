#include "core/lesson/run_state.h"

#include <algorithm>

#include "core/frame/frame_plan.h"

namespace zscope {
namespace {

/// The stored levels of the pyramid as the run left them.
std::vector<Grid<float>> cellsOf(const Pyramid& pyramid)
{
    std::vector<Grid<float>> cells;
    for (int level = Pyramid::kTileLevel; level < pyramid.levels(); ++level) {
        const GridView<const float> stored = pyramid.stored(level);
        Grid<float>&                copy   = cells.emplace_back(stored.width, stored.height);
        for (int y = 0; y < stored.height; ++y) std::ranges::copy(stored.row(y), copy.view().row(y).begin());
    }
    return cells;
}

}  // namespace

StepState stateOf(const RunRecorders& recorders, const EventKind* last, const DrawRequest& request,
                  const Pyramid* pyramid)
{
    const Pipeline pipeline = repeatable(request).pipeline;
    StepState      state;
    state.algorithm     = nameOf(request.pipeline);
    state.events        = recorders.steps.seen(Grain::Pixel);
    state.stage         = recorders.stage.stage();
    state.sweep         = recorders.sweep.state();
    const bool hasCells = pipeline.upkeep != Upkeep::None || pipeline.depth == DepthMoment::ZCull;
    state.hierarchy     = recorders.hierarchy.state(request.camera.width, request.camera.height, hasCells);
    if (state.hierarchy && pipeline.order != Order::Submitted)
        state.hierarchy->tree = pipeline.order == Order::Octree ? TreeKind::Octree : TreeKind::Bvh;
    if (state.hierarchy && hasCells && pyramid) state.hierarchy->cells = cellsOf(*pyramid);
    state.triangle = recorders.triangle.state();
    state.span     = recorders.pixel.span();
    state.interval = recorders.interval.state();
    if (last == &kEventKind<PixelTested>) state.pixel = recorders.pixel.pixel();
    if (last == &kEventKind<TileTested>) state.tile = recorders.pixel.tile();
    if (last == &kEventKind<PixelBlended>) state.blend = recorders.pixel.blend();
    return state;
}

}  // namespace zscope
