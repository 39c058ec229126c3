#include "core/measure/verify.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <tuple>
#include <utility>

#include "core/geometry/transparent_surfaces.h"
#include "core/measure/cull_audit.h"
#include "core/measure/face_figures.h"

namespace zscope {

namespace {

/// The truth at all pixels, or at some.
struct Truth {
    Picture                                    picture;
    std::vector<PixelPosition>                 points;
    std::vector<SampleTruth>                   samples;
    std::map<ShadingCost, Grid<std::uint32_t>> colours = {};  // where something is transparent, as rows need them
};

Result<Truth> truthOf(const VerifyRequest& request)
{
    const Scene& scene = request.scene->scene();
    Truth        truth;
    if (request.samples) {
        truth.points = randomPixels(request.camera, *request.samples, request.sampleSeed);
        auto samples = referenceSamples(scene, request.camera, request.faceCulling, truth.points, request.progress);
        if (!samples) return samples.error();
        truth.samples = *std::move(samples);
    } else {
        auto picture = referencePicture(scene, request.camera, request.faceCulling, request.progress);
        if (!picture) return picture.error();
        truth.picture = *std::move(picture);
    }
    return truth;
}

bool judgesColours(const VerifyRequest& request)
{
    return !request.samples && !transparentSurfacesOf(*request.scene).isEmpty();
}

/// How the colours of a frame differ from those that its pipeline's shading gives: over the reference picture, or of a
/// method that draws whole faces over its own ids and depths, which figuresOf() judges.
Result<ColourFigures> coloursOf(Truth& truth, const VerifyRequest& request, const Pipeline& pipeline,
                                const Picture& shown, const Grid<std::uint32_t>& colours)
{
    const auto over = [&](const Picture& opaque) {
        return referenceColours(request.scene->scene(), request.camera, request.faceCulling, opaque, pipeline.cost,
                                request.progress);
    };
    if (drawsFaces(pipeline)) {
        const auto own = over(shown);
        if (!own) return own.error();
        return compareColours(*own, colours);
    }
    auto known = truth.colours.find(pipeline.cost);
    if (known == truth.colours.end()) {
        auto right = over(truth.picture);
        if (!right) return right.error();
        known = truth.colours.emplace(pipeline.cost, *std::move(right)).first;
    }
    return compareColours(known->second, colours);
}

Result<ErrorFigures> figuresOf(const Truth& truth, const VerifyRequest& request, const Pipeline& pipeline,
                               const Picture& test)
{
    const Scene& scene  = request.scene->scene();
    const bool   byFace = drawsFaces(pipeline);
    if (!request.samples) {
        if (!byFace) return compare(truth.picture, test);
        return compareByFace(scene, request.camera, request.faceCulling, truth.picture, test, request.progress);
    }
    std::vector<PixelPair> pixels;
    pixels.reserve(truth.points.size());
    for (std::size_t i = 0; i < truth.points.size(); ++i) {
        const auto [x, y] = truth.points[i];
        pixels.push_back({.referenceId    = truth.samples[i].id,
                          .testId         = test.ids.at(x, y),
                          .referenceDepth = truth.samples[i].depth,
                          .testDepth      = test.depth.at(x, y)});
    }
    if (!byFace) return compare(pixels, test.ids.values());
    return compareByFace(scene, request.camera, request.faceCulling, std::move(pixels), truth.points, test.ids.values(),
                         request.progress);
}

std::vector<std::int64_t> visibleIds(const Truth& truth)
{
    const auto                pixels = truth.picture.ids.values();
    std::vector<std::int64_t> ids(pixels.begin(), pixels.end());
    for (const SampleTruth& sample : truth.samples) ids.push_back(sample.id);
    return ids;
}

bool isWorse(const ErrorFigures& a, const ErrorFigures& b)
{
    return std::tuple(a.wrongPixels(), a.depthBitsDiffer) > std::tuple(b.wrongPixels(), b.depthBitsDiffer);
}

/// A measured choice may fall on a method that does.
bool remembersFrames(const Pipeline& pipeline)
{
    return pipeline.coherence != Coherence::None || pipeline.chooser == Chooser::Measured;
}

/// The same place, looking the other way.
Camera turnedAway(Camera camera)
{
    camera.right   = -camera.right;
    camera.forward = -camera.forward;
    return camera;
}

/// The same place, turned by a quarter of the picture's width.
Camera turnedAside(Camera camera)
{
    const double angle = std::atan(0.5 * camera.width / (camera.height * camera.focal));
    const dvec3  right = camera.right;
    camera.right       = std::cos(angle) * right + std::sin(angle) * camera.forward;
    camera.forward     = std::cos(angle) * camera.forward - std::sin(angle) * right;
    return camera;
}

/// What a frame that is judged again comes after: the same view (nothing), and for whoever remembers the frame before
/// also a cut, and a view from which the camera has just turned.
std::vector<std::optional<Camera>> viewsBefore(const DrawRequest& draw)
{
    if (!remembersFrames(draw.pipeline)) return {std::nullopt};
    return {std::nullopt, turnedAway(draw.camera), turnedAside(draw.camera)};
}

/// Draws the request again, after the view `before` if there is one, and keeps the worse of these figures and
/// `figures`.
Result<Done> judgeAgain(const Truth& truth, const VerifyRequest& request, Renderer& renderer, const DrawRequest& draw,
                        const std::optional<Camera>& before, Frame& frame, const Picture& first, ErrorFigures& figures)
{
    if (before) {
        DrawRequest other = draw;
        other.camera      = *before;
        if (const auto report = renderer.draw(other, frame); !report) return report.error();
    }
    if (const auto report = renderer.draw(draw, frame); !report) return report.error();
    const Picture again = pictureOf(frame.visible);
    if (again == first) return Done{};
    const auto worse = figuresOf(truth, request, draw.pipeline, again);
    if (!worse) return worse.error();
    if (isWorse(*worse, figures)) figures = *worse;
    return Done{};
}

bool skipsMoreThanBatches(const Pipeline& pipeline)
{
    return canAuditCulls(pipeline) && (pipeline.order != Order::Submitted || asksTriangles(pipeline.cull));
}

}  // namespace

std::vector<PixelPosition> randomPixels(const Camera& camera, std::uint64_t count, std::uint64_t seed)
{
    // The remainder of 64 random bits, not a distribution of the standard library: those differ between libraries.
    std::mt19937_64            bits(seed);
    const auto                 below = [&bits](int n) { return static_cast<int>(bits() % static_cast<unsigned>(n)); };
    std::vector<PixelPosition> points(count);
    for (PixelPosition& p : points) {
        p.x = below(camera.width);
        p.y = below(camera.height);
    }
    return points;
}

Result<std::vector<VerifyRow>> verify(const VerifyRequest& request)
{
    auto truth = truthOf(request);
    if (!truth) return truth.error();

    const std::vector<std::int64_t> visible = visibleIds(*truth);
    Frame                           frame;
    std::vector<VerifyRow>          rows;
    DrawRequest                     draw{.scene       = request.scene,
                                         .camera      = request.camera,
                                         .faceCulling = request.faceCulling,
                                         .pipeline    = {},
                                         .shade       = judgesColours(request),
                                         .memoryLimit = request.memoryLimit,
                                         .cancel      = request.progress.cancel};
    const std::size_t               total = request.algorithms.size() * request.threads.size() * request.simd.size();
    for (const Preset& algorithm : request.algorithms) {
        draw.pipeline = algorithm.pipeline;
        std::optional<CullAudit> audit;
        for (const int threads : request.threads) {
            draw.threads = threads;
            for (const Simd simd : request.simd) {
                draw.simd      = simd;
                draw.shortcuts = request.shortcuts;
                request.progress.at(static_cast<double>(rows.size()) / static_cast<double>(total), algorithm.name);
                Renderer   renderer;
                const auto report = renderer.draw(draw, frame);
                if (!report) return report.error();
                const Picture                first = pictureOf(frame.visible);
                std::optional<ColourFigures> colours;
                if (draw.shade) {
                    const auto judged = coloursOf(*truth, request, draw.pipeline, first, frame.colour);
                    if (!judged) return judged.error();
                    colours = *judged;
                }
                auto figures = figuresOf(*truth, request, draw.pipeline, first);
                if (!figures) return figures.error();
                for (const std::optional<Camera>& before : viewsBefore(draw)) {
                    const auto done = judgeAgain(*truth, request, renderer, draw, before, frame, first, *figures);
                    if (!done) return done.error();
                }
                if (!audit && skipsMoreThanBatches(draw.pipeline)) {
                    const auto audited = auditCulls(draw, frame.visible, visible);
                    if (!audited) return audited.error();
                    audit = *audited;
                }
                const std::uint64_t falseCulls = std::max(figures->falseCulls, audit ? audit->falseCulls.total() : 0);
                rows.push_back({.algorithm  = std::string(algorithm.name),
                                .claim      = algorithm.claim,
                                .threads    = report->threads,
                                .simd       = report->simd,
                                .figures    = *std::move(figures),
                                .falseCulls = falseCulls,
                                .colours    = colours});
            }
        }
    }
    return rows;
}

}  // namespace zscope
