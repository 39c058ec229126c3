#include "core/measure/bench_summary.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "core/frame/shortcuts.h"
#include "core/measure/face_figures.h"
#include "core/measure/verify.h"

namespace zscope {
namespace {

/// What compare() would find, if every pixel is known to be the same.
ErrorFigures figuresOfEqual(const Picture& reference)
{
    ErrorFigures figures;
    figures.pixels  = reference.ids.values().size();
    figures.covered = static_cast<std::uint64_t>(
        std::ranges::count_if(reference.ids.values(), [](std::int64_t id) { return id >= 0; }));
    return figures;
}

}  // namespace

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
    row.frames    = reports.size();
    row.bestMs    = reports.front().frameMs;
    row.q1Ms      = at(0.25).frameMs;
    row.medianMs  = at(0.5).frameMs;
    row.q3Ms      = at(0.75).frameMs;
    for (const StageTime& stage : at(0.5).stages) row.stageMs[static_cast<std::size_t>(stage.stage)] = stage.ms;
    for (const NamedCount& part : at(0.5).bytes) row.bytes += part.value;
    row.tallies = at(0.5).tally.named();

    std::vector<double> times(reports.size());
    for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
        std::ranges::transform(reports, times.begin(),
                               [stage](const FrameReport& report) { return report.stages[stage].ms; });
        std::ranges::sort(times);
        const auto quantile       = [&times](double p) { return times[quantileRank(times.size(), p)]; };
        row.stageQuartiles[stage] = {quantile(0.25), quantile(0.5), quantile(0.75)};
    }
}

std::vector<BenchAlgorithm> ladderOf(const BenchAlgorithm& algorithm)
{
    std::vector<ShortcutSet> rungs{ShortcutSet()};
    const auto               climb = [&](ShortcutSet set) {
        if (std::ranges::find(rungs, set) == rungs.end()) rungs.push_back(set);
    };
    const ShortcutSet can = applicable(ShortcutSet::all(), algorithm.pipeline);
    for (const bool isAlone : {true, false})
        for (int i = 0; i < kShortcutCount; ++i) {
            const auto shortcut = static_cast<Shortcut>(i);
            if (can.has(shortcut)) climb(isAlone ? with({}, shortcut) : without(ShortcutSet::all(), shortcut));
        }
    climb(ShortcutSet::all());
    std::vector<BenchAlgorithm> all;
    for (const ShortcutSet set : rungs) all.push_back({algorithm.name, algorithm.pipeline, algorithm.claim, set});
    return all;
}

std::optional<std::string> whyNotOnEqualTerms(std::span<const BenchAlgorithm> algorithms, ShortcutSet shortcuts)
{
    const auto standsAlone = [](const BenchAlgorithm& each) { return !hasFastText(each.pipeline); };
    const auto isFast      = [&](const BenchAlgorithm& each) {
        return !standsAlone(each) && each.shortcuts.value_or(shortcuts).has(Shortcut::Lanes);
    };
    const auto plain = std::ranges::find_if(algorithms, standsAlone);
    if (plain == algorithms.end() || std::ranges::none_of(algorithms, isFast)) return std::nullopt;
    return fmt::format("{} has no fast text, and the others have one: compare their times with --shortcuts none",
                       plain->name);
}

DrawRequest drawRequestOf(const BenchRequest& request, std::shared_ptr<const PreparedScene> scene,
                          const BenchAlgorithm& algorithm, int threads, Simd simd, bool shade)
{
    return {.scene       = std::move(scene),
            .camera      = request.camera,
            .faceCulling = request.faceCulling,
            .pipeline    = algorithm.pipeline,
            .threads     = threads,
            .simd        = simd,
            .shortcuts   = algorithm.shortcuts.value_or(request.shortcuts),
            .shade       = shade,
            .memoryLimit = request.memoryLimit,
            .cancel      = request.progress.cancel};
}

std::vector<bool> shadingsOf(BenchPictures pictures)
{
    if (pictures == BenchPictures::Both) return {true, false};
    return {pictures == BenchPictures::Shaded};
}

Result<Done> ViewTruth::find(const BenchRequest& request, const Camera& camera, std::uint64_t seed)
{
    m_camera    = camera;
    m_isSampled = request.samples.has_value();
    if (m_isSampled) {
        m_points     = randomPixels(camera, *request.samples, seed);
        auto samples = referenceSamples(*request.scene, camera, request.faceCulling, m_points, request.progress);
        if (!samples) return samples.error();
        m_samples = *std::move(samples);
        return Done{};
    }
    auto picture = referencePicture(*request.scene, camera, request.faceCulling, request.progress);
    if (!picture) return picture.error();
    m_picture = *std::move(picture);
    return Done{};
}

std::uint64_t ViewTruth::differing(const Picture& picture) const
{
    if (!m_isSampled) return differingPixels(m_picture, picture);
    std::uint64_t differing = 0;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const auto [x, y] = m_points[i];
        differing += !(SampleTruth{picture.ids.at(x, y), picture.depth.at(x, y)} == m_samples[i]);
    }
    return differing;
}

Result<ErrorFigures> ViewTruth::figuresOf(const BenchRequest& request, bool byFace, const Picture& picture,
                                          std::uint64_t differing) const
{
    const Scene& scene = *request.scene;
    if (!m_isSampled) {
        if (byFace) return compareByFace(scene, m_camera, request.faceCulling, m_picture, picture, request.progress);
        return differing == 0 ? figuresOfEqual(m_picture) : compare(m_picture, picture);
    }
    std::vector<PixelPair> pixels;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const auto [x, y] = m_points[i];
        pixels.push_back({m_samples[i].id, picture.ids.at(x, y), m_samples[i].depth, picture.depth.at(x, y)});
    }
    if (byFace)
        return compareByFace(scene, m_camera, request.faceCulling, std::move(pixels), m_points, picture.ids.values(),
                             request.progress);
    return compare(pixels, picture.ids.values());
}

Result<ViewTruth::Judgement> ViewTruth::judge(const BenchRequest& request, const BenchAlgorithm& algorithm,
                                              const Picture& picture) const
{
    const bool          byFace  = drawsFaces(algorithm.pipeline);
    const std::uint64_t differ  = differing(picture);
    const auto          figures = figuresOf(request, byFace, picture, differ);
    if (!figures) return figures.error();
    const std::uint64_t wrong = !byFace                                 ? differ
                                : algorithm.claim == Claim::ExactByFace ? figures->wrongCoverage()
                                                                        : figures->wrongPixels();
    return Judgement{wrong, *figures};
}

}  // namespace zscope
