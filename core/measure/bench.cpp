#include "core/measure/bench.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/stopwatch.h"
#include "core/measure/face_figures.h"
#include "core/measure/reference.h"

namespace zscope {
namespace {

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

/// Fills the timing part of a row from the timed frames.
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

/// What compare() would find, if every pixel is known to be the same.
ErrorFigures figuresOfEqual(const Picture& reference)
{
    ErrorFigures figures;
    figures.pixels  = reference.ids.values().size();
    figures.covered = static_cast<std::uint64_t>(std::ranges::count_if(reference.ids.values(), [](std::int64_t id) { return id >= 0; }));
    return figures;
}

/// One bench: the scene made ready, the truth about it, and the objects every run uses again.
class Bench {
public:
    explicit Bench(const BenchRequest& request) : m_request(request) {}

    Result<std::vector<BenchRow>> run()
    {
        Stopwatch watch;
        m_scene   = std::make_shared<const PreparedScene>(m_request.scene);
        m_buildMs = watch.lap();

        if (m_request.verify) {
            auto picture =
                referencePicture(*m_request.scene, m_request.camera, m_request.faceCulling, m_request.progress);
            if (!picture) return picture.error();
            m_reference = *std::move(picture);
        }
        std::vector<BenchRow> rows;
        std::vector<bool>     shades;
        if (m_request.pictures != BenchPictures::Unshaded) shades.push_back(true);
        if (m_request.pictures != BenchPictures::Shaded) shades.push_back(false);
        const std::size_t runs = m_request.algorithms.size() * m_request.threads.size() * m_request.simd.size() * shades.size();
        for (const BenchAlgorithm& algorithm : m_request.algorithms) {
            std::vector<NamedCount> counters;
            if (m_request.count) {
                auto work = m_renderer.count(drawRequest(algorithm, 1, Simd::Scalar, true));
                if (!work) return work.error();
                counters = std::move(work->counters);
            }
            m_judged.reset();
            for (const int threads : m_request.threads)
                for (const Simd simd : m_request.simd)
                    for (const bool shade : shades) {
                        m_request.progress.at(static_cast<double>(rows.size()) / static_cast<double>(runs), algorithm.name);
                        Result<BenchRow> row = time(algorithm, threads, simd, shade);
                        if (!row) return row.error();
                        row->counters = counters;
                        if (m_request.finished) m_request.finished(*row);
                        rows.push_back(*std::move(row));
                    }
        }
        return rows;
    }

private:
    struct Judgement {
        std::uint64_t wrong = 0;
        ErrorFigures  figures;
    };
    struct Judged {
        Picture   picture;
        Judgement judgement;
    };

    DrawRequest drawRequest(const BenchAlgorithm& algorithm, int threads, Simd simd, bool shade) const
    {
        return {.scene       = m_scene,
                .camera      = m_request.camera,
                .faceCulling = m_request.faceCulling,
                .pipeline    = algorithm.pipeline,
                .threads     = threads,
                .simd        = simd,
                .shade       = shade,
                .memoryLimit = m_request.memoryLimit,
                .cancel      = m_request.progress.cancel};
    }

    Result<BenchRow> time(const BenchAlgorithm& algorithm, int threads, Simd simd, bool shade)
    {
        const DrawRequest draw = drawRequest(algorithm, threads, simd, shade);
        BenchRow          row;
        row.shaded    = shade;
        row.scene     = m_request.scene->name;
        row.algorithm = algorithm.name;
        row.claim     = algorithm.claim;
        row.triangles = m_request.scene->triangleCount();
        row.pixels    = static_cast<std::uint64_t>(draw.camera.width) * static_cast<std::uint64_t>(draw.camera.height);
        row.buildMs   = m_buildMs;
        row.load      = m_request.load;

        const Result<FrameReport> first = m_renderer.draw(draw, m_frame);
        if (!first) return first.error();
        row.threads = first->threads;
        row.simd    = first->simd;
        if (m_reference) {
            const auto judgement = judge(algorithm);
            if (!judgement) return judgement.error();
            row.wrongPixels = judgement->wrong;
            row.figures     = judgement->figures;
        }
        for (int frame = 0; frame < m_request.warmUp; ++frame)
            if (const auto report = m_renderer.draw(draw, m_frame); !report) return report.error();
        for (bool isTrial = first->isTrial; isTrial;) {
            const auto report = m_renderer.draw(draw, m_frame);
            if (!report) return report.error();
            isTrial = report->isTrial;
        }

        std::vector<FrameReport> reports;
        for (int frame = 0; frame < m_request.frames; ++frame) {
            Result<FrameReport> report = m_renderer.draw(draw, m_frame);
            if (!report) return report.error();
            reports.push_back(*std::move(report));
        }
        row.chosen = reports.back().chosen;
        summarise(std::move(reports), row);
        return row;
    }

    /// Of the frame just drawn.
    Result<Judgement> judge(const BenchAlgorithm& algorithm)
    {
        Picture             picture = pictureOf(m_frame.visible);
        const std::uint64_t differ  = differingPixels(*m_reference, picture);
        if (!drawsFaces(algorithm.pipeline))
            return Judgement{differ, differ == 0 ? figuresOfEqual(*m_reference) : compare(*m_reference, picture)};
        if (m_judged && differingPixels(m_judged->picture, picture) == 0) return m_judged->judgement;
        const auto figures = compareByFace(*m_request.scene, m_request.camera, m_request.faceCulling, *m_reference, picture, m_request.progress);
        if (!figures) return figures.error();
        const Judgement judgement{algorithm.claim == Claim::ExactByFace ? figures->wrongCoverage() : figures->wrongPixels(), *figures};
        if (!m_judged) m_judged = Judged{std::move(picture), judgement};
        return judgement;
    }

    const BenchRequest&                  m_request;
    std::shared_ptr<const PreparedScene> m_scene;
    double                               m_buildMs = 0;
    std::optional<Picture>               m_reference;
    std::optional<Judged>                m_judged;  // the first picture of the algorithm at hand, if it draws faces
    Renderer                             m_renderer;
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

Result<std::vector<BenchRow>> bench(const BenchRequest& request)
{
    assert(request.frames >= 1 && request.warmUp >= 0);
    return Bench(request).run();
}

std::string benchToCsv(std::span<const BenchRow> rows)
{
    std::string csv = "scene,algorithm,threads,simd,verified,wrong_pixels,best_ms,median_ms,q1_ms,q3_ms,"
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

namespace {

using Json = nlohmann::ordered_json;

std::string_view wordOf(Claim claim)
{
    return claim == Claim::Exact ? "exact" : claim == Claim::ExactByFace ? "exact-by-face" : "approximate";
}

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
    Json list  = Json::array();
    for (const BenchRow& row : rows) {
        Json stages = Json::object();
        for (const Stage stage : kStages) stages[std::string(wordOf(stage))] = row.stageMs[static_cast<std::size_t>(stage)];
        Json quartiles = Json::object();
        for (const Stage stage : kStages) {
            const StageQuartiles& of = row.stageQuartiles[static_cast<std::size_t>(stage)];
            quartiles[std::string(wordOf(stage))] = Json{{"q1", of.q1}, {"median", of.median}, {"q3", of.q3}};
        }
        Json counters = Json::object();
        for (const NamedCount& counter : row.counters) counters[counter.name] = counter.value;
        list.push_back({{"scene", row.scene},
                        {"algorithm", row.algorithm},
                        {"claim", wordOf(row.claim)},
                        {"chosen", row.chosen.empty() ? Json(nullptr) : Json(row.chosen)},
                        {"threads", row.threads},
                        {"simd", wordOf(row.simd)},
                        {"shaded", row.shaded},
                        {"verified", row.wrongPixels ? Json(*row.wrongPixels == 0) : Json(nullptr)},
                        {"wrong_pixels", row.wrongPixels ? Json(*row.wrongPixels) : Json(nullptr)},
                        {"figures", row.figures ? toJson(*row.figures) : Json(nullptr)},
                        {"best_ms", row.bestMs},
                        {"median_ms", row.medianMs},
                        {"q1_ms", row.q1Ms},
                        {"q3_ms", row.q3Ms},
                        {"triangles", row.triangles},
                        {"pixels", row.pixels},
                        {"read_ms", row.load.readMs},
                        {"parse_ms", row.load.parseMs},
                        {"check_ms", row.load.checkMs},
                        {"build_ms", row.buildMs},
                        {"bytes", row.bytes},
                        {"stages", std::move(stages)},
                        {"stage_quartiles", std::move(quartiles)},
                        {"counters", std::move(counters)}});
    }
    return list.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace zscope
