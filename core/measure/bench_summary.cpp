#include "core/measure/bench_summary.h"

#include <algorithm>
#include <bit>

namespace zscope {

std::uint64_t differingPixels(const Picture& reference, const Picture& test)
{
    const auto ids = reference.ids.values(), testIds = test.ids.values();
    const auto depth = reference.depth.values(), testDepth = test.depth.values();

    std::uint64_t differing = 0;
    for (std::size_t i = 0; i < ids.size(); ++i)
        differing += ids[i] != testIds[i]
                     || std::bit_cast<std::uint32_t>(depth[i]) != std::bit_cast<std::uint32_t>(testDepth[i]);
    return differing;
}

void summarise(std::vector<FrameReport> reports, BenchRow& row)
{
    std::ranges::sort(reports, {}, &FrameReport::frameMs);
    const auto at = [&reports](double p) -> const FrameReport& { return reports[quantileRank(reports.size(), p)]; };
    row.bestMs    = reports.front().frameMs;
    row.q1Ms      = at(0.25).frameMs;
    row.medianMs  = at(0.5).frameMs;
    row.q3Ms      = at(0.75).frameMs;
    for (const StageTime& stage : at(0.5).stages) row.stageMs[static_cast<std::size_t>(stage.stage)] = stage.ms;
    for (const NamedCount& part : at(0.5).bytes) row.bytes += part.value;

    std::vector<double> times(reports.size());
    for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
        std::ranges::transform(reports, times.begin(), [stage](const FrameReport& report) { return report.stages[stage].ms; });
        std::ranges::sort(times);
        const auto quantile = [&times](double p) { return times[quantileRank(times.size(), p)]; };
        row.stageQuartiles[stage] = {quantile(0.25), quantile(0.5), quantile(0.75)};
    }
}

ErrorFigures figuresOfEqual(const Picture& reference)
{
    ErrorFigures figures;
    figures.pixels  = reference.ids.values().size();
    figures.covered = static_cast<std::uint64_t>(std::ranges::count_if(reference.ids.values(), [](std::int64_t id) { return id >= 0; }));
    return figures;
}

DrawRequest drawRequestOf(const BenchRequest& request, std::shared_ptr<const PreparedScene> scene, const BenchAlgorithm& algorithm, int threads, Simd simd,
                          bool shade)
{
    return {.scene       = std::move(scene),
            .camera      = request.camera,
            .faceCulling = request.faceCulling,
            .pipeline    = algorithm.pipeline,
            .threads     = threads,
            .simd        = simd,
            .shade       = shade,
            .memoryLimit = request.memoryLimit,
            .cancel      = request.progress.cancel};
}

std::vector<bool> shadingsOf(BenchPictures pictures)
{
    if (pictures == BenchPictures::Both) return {true, false};
    return {pictures == BenchPictures::Shaded};
}

}  // namespace zscope
