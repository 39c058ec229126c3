#include "core/measure/path_bench.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "core/base/stopwatch.h"
#include "core/measure/bench_summary.h"

namespace zscope {
namespace {

/// The counters of a series: what a frame's work can be told by, whatever the method.
constexpr std::array<std::string_view, 7> kTold{"triangles_drawn", "triangles_hidden", "triangles_hidden_by_node",
                                                "nodes_visited",   "pyramid_queries",  "fragments_tested",
                                                "fragments_shaded"};

class PathBench {
public:
    PathBench(const BenchRequest& request, const PathRequest& path) : m_request(request), m_path(path) {}

    Result<std::vector<BenchRow>> run()
    {
        Stopwatch watch;
        m_scene   = std::make_shared<const PreparedScene>(m_request.scene);
        m_buildMs = watch.lap();
        m_steps   = m_path.cameras.size() * static_cast<std::size_t>(m_request.rounds + 1);
        for (const BenchAlgorithm& algorithm : m_request.algorithms)
            for (const int threads : m_request.threads)
                for (const Simd simd : m_request.simd)
                    for (const bool shade : shadingsOf(m_request.pictures))
                        m_runs.push_back(runOf(algorithm, threads, simd, shade));
        if (const auto done = verifyAll(); !done) return done.error();
        if (m_request.count)
            if (const auto done = countAll(); !done) return done.error();
        for (int pass = 0; pass < m_request.rounds; ++pass)
            for (Run& each : m_runs)
                if (const auto done = timePass(each, pass); !done) return done.error();
        std::vector<BenchRow> rows;
        for (Run& each : m_runs) rows.push_back(finished(each));
        return rows;
    }

private:
    struct Run {
        const BenchAlgorithm*                 algorithm;
        DrawRequest                           draw;
        BenchRow                              row;
        Series                                series   = {};
        std::unique_ptr<Renderer>             renderer = std::make_unique<Renderer>();
        std::vector<ErrorFigures>             figures  = {};  // of every frame
        std::vector<std::vector<FrameReport>> passes   = {};  // every frame of every pass
    };

    Run runOf(const BenchAlgorithm& algorithm, int threads, Simd simd, bool shade) const
    {
        Run run{.algorithm = &algorithm,
                .draw      = drawRequestOf(m_request, m_scene, algorithm, threads, simd, shade),
                .row       = {}};
        run.series.frames.resize(m_path.cameras.size());
        BenchRow& row = run.row;
        row.scene     = m_request.scene->name;
        row.algorithm = algorithm.name;
        row.claim     = algorithm.claim;
        row.shaded    = shade;
        row.triangles = m_request.scene->triangleCount();
        row.pixels    = static_cast<std::uint64_t>(m_path.cameras.front().width)
                     * static_cast<std::uint64_t>(m_path.cameras.front().height);
        row.buildMs = m_buildMs;
        row.load    = m_request.load;
        return run;
    }

    void tell(std::size_t step, const std::string& what) const
    {
        m_request.progress.at(static_cast<double>(step) / static_cast<double>(m_steps), what);
    }

    Result<FrameReport> draw(Run& run, std::size_t frame)
    {
        run.draw.camera = m_path.cameras[frame];
        return run.renderer->draw(run.draw, m_frame);
    }

    /// Every run draws every frame once, in order, whether or not it is judged: from here on each has a past.
    Result<Done> verifyAll()
    {
        for (std::size_t frame = 0; frame < m_path.cameras.size(); ++frame) {
            tell(frame, "reference");
            if (m_request.verify)
                if (const auto done = m_truth.find(m_request, m_path.cameras[frame], frame + 1); !done)
                    return done.error();
            for (Run& run : m_runs) {
                const auto report = draw(run, frame);
                if (!report) return report.error();
                run.row.threads   = report->threads;
                run.row.simd      = report->simd;
                run.row.shortcuts = report->shortcuts;
                if (!m_request.verify) continue;
                if (const auto done = judge(run, frame); !done) return done.error();
            }
        }
        return Done{};
    }

    /// Of the frame just drawn.
    Result<Done> judge(Run& run, std::size_t frame)
    {
        const auto judgement = m_truth.judge(m_request, *run.algorithm, pictureOf(m_frame.visible));
        if (!judgement) return judgement.error();
        SeriesFrame& told = run.series.frames[frame];
        told.covered      = judgement->figures.covered;
        told.wrongPixels  = judgement->wrong;
        run.figures.push_back(judgement->figures);
        return Done{};
    }

    /// The counters of every view, once for all thread counts.
    Result<Done> countAll()
    {
        const Run* counted = nullptr;
        for (Run& run : m_runs) {
            if (counted && counted->algorithm == run.algorithm) {
                run.row.counters    = counted->row.counters;
                run.series.counters = counted->series.counters;
                for (std::size_t i = 0; i < run.series.frames.size(); ++i)
                    run.series.frames[i].counts = counted->series.frames[i].counts;
                continue;
            }
            for (std::size_t frame = 0; frame < m_path.cameras.size(); ++frame) {
                tell(m_path.cameras.size(), run.row.algorithm);
                DrawRequest alone = run.draw;
                alone.camera      = m_path.cameras[frame];
                const auto work   = Renderer().count(alone);
                if (!work) return work.error();
                note(run, work->counters, run.series.frames[frame]);
            }
            for (NamedCount& counter : run.row.counters)
                counter.value = (counter.value + m_path.cameras.size() / 2) / m_path.cameras.size();
            counted = &run;
        }
        return Done{};
    }

    /// Adds to the row's sums, by name: which counters there are depends on what the frame needed.
    static void note(Run& run, const std::vector<NamedCount>& counters, SeriesFrame& frame)
    {
        for (const NamedCount& counter : counters) {
            const auto known = std::ranges::find(run.row.counters, counter.name, &NamedCount::name);
            if (known == run.row.counters.end())
                run.row.counters.push_back(counter);
            else
                known->value += counter.value;
        }
        if (run.series.counters.empty()) run.series.counters.assign(kTold.begin(), kTold.end());
        for (const std::string& name : run.series.counters) {
            const auto of = std::ranges::find(counters, name, &NamedCount::name);
            frame.counts.push_back(of == counters.end() ? 0 : of->value);
        }
    }

    Result<Done> timePass(Run& run, int pass)
    {
        bool isTrial = true;
        for (int frame = 0; frame < m_request.warmUp || isTrial; ++frame) {
            const auto report = draw(run, 0);
            if (!report) return report.error();
            isTrial = report->isTrial;
        }
        std::vector<double>       ms;
        std::vector<FrameReport>& reports = run.passes.emplace_back();
        for (std::size_t frame = 0; frame < m_path.cameras.size(); ++frame) {
            tell(m_path.cameras.size() * static_cast<std::size_t>(pass + 1) + frame, run.row.algorithm);
            Result<FrameReport> report = draw(run, frame);
            if (!report) return report.error();
            ms.push_back(report->frameMs);
            reports.push_back(*std::move(report));
        }
        std::ranges::sort(ms);
        run.row.roundMs.push_back(ms[quantileRank(ms.size(), 0.5)]);
        return Done{};
    }

    BenchRow finished(Run& run)
    {
        Series& series = run.series;
        for (std::size_t frame = 0; frame < series.frames.size(); ++frame) {
            std::vector<std::size_t> order(run.passes.size());
            std::iota(order.begin(), order.end(), std::size_t{0});
            std::ranges::sort(order, {}, [&](std::size_t pass) { return run.passes[pass][frame].frameMs; });
            const FrameReport& median = run.passes[order[quantileRank(order.size(), 0.5)]][frame];
            SeriesFrame&       told   = series.frames[frame];
            told.ms                   = median.frameMs;
            for (const StageTime& stage : median.stages) told.stageMs[static_cast<std::size_t>(stage.stage)] = stage.ms;
            told.chosen = run.passes.back()[frame].chosen;
        }
        if (m_request.verify) {
            series.lags         = lagsOf(series.frames, m_path.cuts);
            run.row.samples     = m_request.samples.value_or(0);
            run.row.figures     = together(run.figures);
            run.row.wrongPixels = 0;
            for (const SeriesFrame& frame : series.frames) *run.row.wrongPixels += *frame.wrongPixels;
        }
        std::vector<FrameReport> all;
        for (std::vector<FrameReport>& pass : run.passes) std::ranges::move(pass, std::back_inserter(all));
        run.row.chosen = all.back().chosen;
        summarise(std::move(all), run.row);
        run.row.series = std::move(series);
        run.renderer.reset();
        if (m_request.finished) m_request.finished(run.row);
        return std::move(run.row);
    }

    const BenchRequest&                  m_request;
    const PathRequest&                   m_path;
    std::shared_ptr<const PreparedScene> m_scene;
    double                               m_buildMs = 0;
    std::size_t                          m_steps   = 1;  // of the progress: frames verified and timed
    std::vector<Run>                     m_runs;
    Frame                                m_frame;
    ViewTruth                            m_truth;  // about the frame at hand
};

}  // namespace

Result<std::vector<BenchRow>> benchPath(const BenchRequest& request, const PathRequest& path)
{
    assert(!path.cameras.empty() && request.rounds >= 1);
    if (const auto why = whyNotOnEqualTerms(request.algorithms, request.shortcuts)) return Error{Trouble::Usage, *why};
    return PathBench(request, path).run();
}

}  // namespace zscope
