#include "core/measure/bench.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/stopwatch.h"
#include "core/frame/shortcuts.h"
#include "core/measure/bench_summary.h"
#include "core/measure/frame_quota.h"
#include "core/measure/series_json.h"

namespace zscope {
namespace {

/// One bench: the scene made ready, the truth about it, and the objects every run uses again.
class Bench {
public:
    explicit Bench(const BenchRequest& request) : m_request(request) {}

    Result<std::vector<BenchRow>> run()
    {
        Stopwatch watch;
        m_scene   = std::make_shared<const PreparedScene>(m_request.scene);
        m_buildMs = watch.lap();

        if (m_request.verify)
            if (const auto done = m_truth.find(m_request, m_request.camera, 1); !done) return done.error();
        std::vector<Run>        runs;
        const std::vector<bool> shades = shadingsOf(m_request.pictures);
        const std::size_t       count =
            m_request.algorithms.size() * m_request.threads.size() * m_request.simd.size() * shades.size();
        for (const BenchAlgorithm& algorithm : m_request.algorithms) {
            std::vector<NamedCount> counters;
            if (m_request.count) {
                auto work = Renderer().count(drawRequest(algorithm, 1, Simd::Scalar, true));
                if (!work) return work.error();
                counters = std::move(work->counters);
            }
            m_judged.reset();
            for (const int threads : m_request.threads)
                for (const Simd simd : m_request.simd)
                    for (const bool shade : shades) {
                        m_request.progress.at(static_cast<double>(runs.size()) / static_cast<double>(count),
                                              algorithm.name);
                        Result<Run> run = prepare(algorithm, threads, simd, shade);
                        if (!run) return run.error();
                        run->row.counters = counters;
                        runs.push_back(*std::move(run));
                        if (m_request.rounds > 1) continue;
                        if (const auto done = timeRound(runs.back(), 0); !done) return done.error();
                        finish(runs.back());
                    }
        }
        if (m_request.rounds > 1)
            if (const auto done = timeInTurn(runs); !done) return done.error();
        std::vector<BenchRow> rows;
        for (Run& run : runs) rows.push_back(std::move(run.row));
        return rows;
    }

private:
    struct Judged {
        Picture              picture;
        ViewTruth::Judgement judgement;
    };

    /// One algorithm with one thread count and vector target, and what it keeps from frame to frame.
    struct Run {
        DrawRequest               draw;
        BenchRow                  row;
        BenchAlgorithm            algorithm;
        std::unique_ptr<Renderer> renderer = std::make_unique<Renderer>();
        std::vector<FrameReport>  reports  = {};  // of the timed frames
    };

    DrawRequest drawRequest(const BenchAlgorithm& algorithm, int threads, Simd simd, bool shade) const
    {
        return drawRequestOf(m_request, m_scene, algorithm, threads, simd, shade);
    }

    /// Draws and judges the first picture, and warms up.
    Result<Run> prepare(const BenchAlgorithm& algorithm, int threads, Simd simd, bool shade)
    {
        Run       run{.draw = drawRequest(algorithm, threads, simd, shade), .row = {}, .algorithm = algorithm};
        BenchRow& row = run.row;
        row.shaded    = shade;
        row.scene     = m_request.scene->name;
        row.algorithm = algorithm.name;
        row.claim     = algorithm.claim;
        row.triangles = m_request.scene->triangleCount();
        row.pixels =
            static_cast<std::uint64_t>(run.draw.camera.width) * static_cast<std::uint64_t>(run.draw.camera.height);
        row.buildMs = m_buildMs;
        row.load    = m_request.load;

        const Result<FrameReport> first = run.renderer->draw(run.draw, m_frame);
        if (!first) return first.error();
        row.threads   = first->threads;
        row.simd      = first->simd;
        row.shortcuts = run.draw.shortcuts;
        if (const auto done = judge(algorithm, row); !done) return done.error();
        bool isTrial = first->isTrial;
        for (int frame = 0; frame < m_request.warmUp || isTrial; ++frame) {
            const auto report = run.renderer->draw(run.draw, m_frame);
            if (!report) return report.error();
            isTrial = report->isTrial;
        }
        return run;
    }

    /// The frames of one round.
    Result<Done> timeRound(Run& run, int round)
    {
        const auto before = [this](int each) {
            return static_cast<int>(std::int64_t{m_request.frames} * each / m_request.rounds);
        };
        std::vector<double> ms;
        for (FrameQuota quota(before(round + 1) - before(round), m_request.leastMs / m_request.rounds);
             quota.wantsMore();) {
            Result<FrameReport> report = run.renderer->draw(run.draw, m_frame);
            if (!report) return report.error();
            quota.drawn(report->frameMs);
            ms.push_back(report->frameMs);
            run.reports.push_back(*std::move(report));
        }
        if (round + 1 == m_request.rounds)
            if (const auto done = judge(run.algorithm, run.row); !done) return done.error();
        std::ranges::sort(ms);
        run.row.roundMs.push_back(ms[quantileRank(ms.size(), 0.5)]);
        return Done{};
    }

    Result<Done> timeInTurn(std::vector<Run>& runs)
    {
        for (int round = 0; round < m_request.rounds; ++round)
            for (std::size_t i = 0; i < runs.size(); ++i) {
                Run& run = runs[round % 2 == 0 ? i : runs.size() - 1 - i];
                m_request.progress.at(static_cast<double>(round) / static_cast<double>(m_request.rounds),
                                      run.row.algorithm);
                // What another run has left in the caches is none of this one's business.
                if (const auto report = run.renderer->draw(run.draw, m_frame); !report) return report.error();
                if (const auto done = timeRound(run, round); !done) return done.error();
            }
        for (Run& run : runs) finish(run);
        return Done{};
    }

    void finish(Run& run)
    {
        run.row.chosen = run.reports.back().chosen;
        summarise(std::move(run.reports), run.row);
        run.reports = {};
        run.renderer.reset();
        if (m_request.finished) m_request.finished(run.row);
    }

    /// The frame just drawn, if the run is verified: the row keeps the worst.
    Result<Done> judge(const BenchAlgorithm& algorithm, BenchRow& row)
    {
        if (!m_request.verify) return Done{};
        const auto judgement = judgementOf(algorithm);
        if (!judgement) return judgement.error();
        row.samples = m_request.samples.value_or(0);
        if (row.wrongPixels && *row.wrongPixels >= judgement->wrong) return Done{};
        row.wrongPixels = judgement->wrong;
        row.figures     = judgement->figures;
        return Done{};
    }

    Result<ViewTruth::Judgement> judgementOf(const BenchAlgorithm& algorithm)
    {
        Picture    picture = pictureOf(m_frame.visible);
        const bool isDear  = drawsFaces(algorithm.pipeline);
        if (isDear && m_judged && differingPixels(m_judged->picture, picture) == 0) return m_judged->judgement;
        auto judgement = m_truth.judge(m_request, algorithm, picture);
        if (judgement && isDear && !m_judged) m_judged = Judged{std::move(picture), *judgement};
        return judgement;
    }

    const BenchRequest&                  m_request;
    std::shared_ptr<const PreparedScene> m_scene;
    double                               m_buildMs = 0;
    ViewTruth                            m_truth;
    std::optional<Judged>                m_judged;  // the first picture of the algorithm at hand, if it draws faces
    Frame                                m_frame;
};

/// A cell as RFC 4180 wants it.
std::string csvCell(const std::string& text)
{
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

}  // namespace

std::size_t quantileRank(std::size_t count, double p)
{
    assert(count > 0 && p > 0 && p <= 1);
    return static_cast<std::size_t>(std::ceil(p * static_cast<double>(count))) - 1;
}

PairedRatio pairedRatio(std::span<const double> roundMs, std::span<const double> baselineRoundMs)
{
    assert(!roundMs.empty() && roundMs.size() == baselineRoundMs.size());
    std::vector<double> ratios;
    for (std::size_t i = 0; i < roundMs.size(); ++i) ratios.push_back(roundMs[i] / baselineRoundMs[i]);
    std::ranges::sort(ratios);

    // The k-th smallest and the k-th largest hold the median but for 2 P(at most k - 1 of n fall on one side).
    const std::size_t n    = ratios.size();
    std::size_t       k    = 1;
    double            term = std::pow(0.5, static_cast<double>(n)), below = term;  // P(none), P(at most k - 1)
    for (std::size_t next = 1; 2 * next < n; ++next) {
        term *= static_cast<double>(n - next + 1) / static_cast<double>(next);
        below += term;
        if (2 * below > 0.05) break;
        k = next + 1;
    }
    return {ratios[quantileRank(n, 0.5)], ratios[k - 1], ratios[n - k]};
}

Result<std::vector<BenchRow>> bench(const BenchRequest& request)
{
    assert(request.frames >= 1 && request.leastMs >= 0 && request.warmUp >= 0 && request.rounds >= 1
           && request.rounds <= request.frames);
    if (const auto why = whyNotOnEqualTerms(request.algorithms, request.shortcuts)) return Error{Trouble::Usage, *why};
    return Bench(request).run();
}

std::string benchToCsv(std::span<const BenchRow> rows)
{
    std::string csv =
        "scene,algorithm,threads,simd,verified,wrong_pixels,best_ms,median_ms,q1_ms,q3_ms,"
        "triangles,pixels,build_ms,bytes";
    for (const Stage stage : kStages) csv += fmt::format(",{}", wordOf(stage));
    const bool tellsShaded = !std::ranges::all_of(rows, &BenchRow::shaded);
    csv += tellsShaded ? ",shaded\n" : "\n";
    for (const BenchRow& row : rows) {
        const std::string verified = row.wrongPixels ? (*row.wrongPixels == 0 ? "1" : "0") : "";
        const std::string wrong    = row.wrongPixels ? std::to_string(*row.wrongPixels) : "";
        csv += fmt::format("{},{},{},{},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{},{},{:.6f},{}", csvCell(row.scene),
                           csvCell(row.algorithm), row.threads, wordOf(row.simd), verified, wrong, row.bestMs,
                           row.medianMs, row.q1Ms, row.q3Ms, row.triangles, row.pixels, row.buildMs, row.bytes);
        for (const double ms : row.stageMs) csv += fmt::format(",{:.6f}", ms);
        if (tellsShaded) csv += row.shaded ? ",1" : ",0";
        csv += '\n';
    }
    return csv;
}

std::string_view wordOf(Claim claim)
{
    return claim == Claim::Exact ? "exact" : claim == Claim::ExactByFace ? "exact-by-face" : "approximate";
}

namespace {

using Json = nlohmann::ordered_json;

/// JSON knows no infinity: a word stands for it, as in cameras.
Json number(double value) { return std::isinf(value) ? Json("inf") : Json(value); }

Json toJson(const RelativeDistance& distance)
{
    return {{"rms", number(distance.rms)}, {"p99", number(distance.p99)}, {"max", number(distance.max)}};
}

Json toJson(const ErrorFigures& figures)
{
    return {{"covered", figures.covered},
            {"holes", figures.holes},
            {"spills", figures.spills},
            {"near_ties", figures.nearTies},
            {"real_wrong_surface", figures.realWrongSurface},
            {"depth_bits_differ", figures.depthBitsDiffer},
            {"exact_share", figures.exactShare},
            {"p99_depth_steps", figures.p99DepthSteps},
            {"max_depth_steps", figures.maxDepthSteps},
            {"distance_on_same_surface", toJson(figures.distanceOnSameSurface)},
            {"distance_on_wrong_surface", toJson(figures.distanceOnWrongSurface)},
            {"lost_triangles", figures.lostTriangles},
            {"false_culls", figures.falseCulls}};
}

}  // namespace

std::string benchToJson(std::span<const BenchRow> rows)
{
    Json list = Json::array();
    for (const BenchRow& row : rows) {
        Json stages = Json::object();
        for (const Stage stage : kStages)
            stages[std::string(wordOf(stage))] = row.stageMs[static_cast<std::size_t>(stage)];
        Json quartiles = Json::object();
        for (const Stage stage : kStages) {
            const StageQuartiles& of              = row.stageQuartiles[static_cast<std::size_t>(stage)];
            quartiles[std::string(wordOf(stage))] = Json{{"q1", of.q1}, {"median", of.median}, {"q3", of.q3}};
        }
        Json counters = Json::object();
        for (const NamedCount& counter : row.counters) counters[counter.name] = counter.value;
        Json tallies = Json::object();
        for (const NamedCount& tally : row.tallies) tallies[tally.name] = tally.value;
        list.push_back({{"scene", row.scene},
                        {"algorithm", row.algorithm},
                        {"claim", wordOf(row.claim)},
                        {"chosen", row.chosen.empty() ? Json(nullptr) : Json(row.chosen)},
                        {"threads", row.threads},
                        {"simd", wordOf(row.simd)},
                        {"shortcuts", wordsOf(row.shortcuts)},
                        {"shaded", row.shaded},
                        {"verified", row.wrongPixels ? Json(*row.wrongPixels == 0) : Json(nullptr)},
                        {"wrong_pixels", row.wrongPixels ? Json(*row.wrongPixels) : Json(nullptr)},
                        {"samples", row.samples},
                        {"figures", row.figures ? toJson(*row.figures) : Json(nullptr)},
                        {"best_ms", row.bestMs},
                        {"median_ms", row.medianMs},
                        {"q1_ms", row.q1Ms},
                        {"q3_ms", row.q3Ms},
                        {"frames", row.frames},
                        {"triangles", row.triangles},
                        {"pixels", row.pixels},
                        {"read_ms", row.load.readMs},
                        {"parse_ms", row.load.parseMs},
                        {"check_ms", row.load.checkMs},
                        {"build_ms", row.buildMs},
                        {"bytes", row.bytes},
                        {"stages", std::move(stages)},
                        {"stage_quartiles", std::move(quartiles)},
                        {"round_ms", row.roundMs},
                        {"series", row.series ? toJson(*row.series) : Json(nullptr)},
                        {"tallies", std::move(tallies)},
                        {"counters", std::move(counters)}});
    }
    return list.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace zscope
