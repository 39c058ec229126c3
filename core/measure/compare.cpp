#include "core/measure/compare.h"

#include <algorithm>
#include <array>
#include <bit>
#include <new>

#include "core/frame/auto_choice.h"
#include "core/measure/face_figures.h"
#include "core/measure/reference.h"

namespace zscope {

namespace {

constexpr std::array kDifferences{
    // after Okabe and Ito, so that nobody's eyes confuse them
    DifferenceEntry{DrawnDifference::OnlyFirst, "only the first shows a triangle", 0xFF0072B2u},
    DifferenceEntry{DrawnDifference::OnlySecond, "only the second shows a triangle", 0xFFE69F00u},
    DifferenceEntry{DrawnDifference::OtherSurface, "another triangle", 0xFFD55E00u},
    DifferenceEntry{DrawnDifference::Depth, "the same triangle, another depth", 0xFFCC79A7u},
    DifferenceEntry{DrawnDifference::Colour, "another colour only", 0xFF009E73u},
};

/// Ids as they are compared: of triangles, or of their faces.
std::int64_t comparedId(std::int64_t id, const Scene& scene, bool byFace)
{
    return byFace && id >= 0 ? std::int64_t{scene.firstOfFace(TriangleId{static_cast<std::uint32_t>(id)}).value} : id;
}

DrawnDifference differenceAt(const Frame& first, const Frame& second, int x, int y, const Scene& scene, bool byFace)
{
    const std::int64_t a = first.visible.idAt(x, y), b = second.visible.idAt(x, y);
    if ((a < 0) != (b < 0)) return a >= 0 ? DrawnDifference::OnlyFirst : DrawnDifference::OnlySecond;
    if (a != b && comparedId(a, scene, byFace) != comparedId(b, scene, byFace)) return DrawnDifference::OtherSurface;
    if (byFace) return DrawnDifference::None;
    const auto bits = [x, y](const Frame& frame) { return std::bit_cast<std::uint32_t>(frame.visible.depthAt(x, y)); };
    if (bits(first) != bits(second)) return DrawnDifference::Depth;
    return first.colour.at(x, y) != second.colour.at(x, y) ? DrawnDifference::Colour : DrawnDifference::None;
}

/// Grey and light, so that the differences stand out.
std::uint32_t faded(std::uint32_t colour)
{
    const std::uint32_t r = colour >> 16 & 0xFFu, g = colour >> 8 & 0xFFu, b = colour & 0xFFu;
    const std::uint32_t level = 160 + (r * 3 + g * 6 + b) / 10 * 95 / 255;
    return 0xFF000000u | level << 16 | level << 8 | level;
}

Picture byFaces(Picture picture, const Scene& scene)
{
    for (std::int64_t& id : picture.ids.values()) id = comparedId(id, scene, true);
    return picture;
}

bool wasCancelled(const CompareRequest& request) { return request.progress.cancelled(); }

/// Draws until what is measured has made up its mind, then the timed frames; the picture of the last stays.
Result<Done> drawTimed(const DrawRequest& draw, int frames, ComparedAlgorithm& compared)
{
    Renderer renderer;
    for (int trial = 0; trial < AutoChoice::kMostTrialFrames; ++trial) {
        const auto report = renderer.draw(draw, compared.frame);
        if (!report) return report.error();
        if (!report->isTrial) break;
    }
    std::vector<FrameReport> reports;
    for (int i = 0; i < frames; ++i) {
        auto report = renderer.draw(draw, compared.frame);
        if (!report) return report.error();
        reports.push_back(*std::move(report));
    }
    std::ranges::stable_sort(reports, {}, &FrameReport::frameMs);
    const auto at   = [&reports](double p) -> FrameReport& { return reports[quantileRank(reports.size(), p)]; };
    compared.bestMs = reports.front().frameMs;
    compared.q1Ms   = at(0.25).frameMs;
    compared.q3Ms   = at(0.75).frameMs;
    const auto work = renderer.count(draw);
    if (!work) return work.error();
    compared.counters = work->counters;
    compared.report   = std::move(at(0.5));
    return Done{};
}

}  // namespace

bool Comparison::areAllEqual() const { return std::ranges::all_of(algorithms, &ComparedAlgorithm::isEqualToFirst); }

Result<Comparison> compareAlgorithms(const CompareRequest& request)
try {
    if (request.algorithms.empty())
        return Error{Trouble::Usage, "there is nothing to compare: name at least one algorithm"};
    const Scene&           scene = request.scene->scene();
    std::optional<Picture> reference;
    if (request.useReference) {
        auto picture = referencePicture(scene, request.camera, request.faceCulling, request.progress);
        if (!picture) return picture.error();
        reference = *std::move(picture);
    }
    Comparison             comparison;
    std::optional<Picture> first;
    const bool             onEqualTerms = !whyNotOnEqualTerms(request.algorithms, request.shortcuts);
    for (const BenchAlgorithm& algorithm : request.algorithms) {
        request.progress.at(
            static_cast<double>(comparison.algorithms.size()) / static_cast<double>(request.algorithms.size()),
            algorithm.name);
        ComparedAlgorithm& compared = comparison.algorithms.emplace_back();
        compared.algorithm          = algorithm;
        DrawRequest draw;
        draw.scene       = request.scene;
        draw.camera      = request.camera;
        draw.faceCulling = request.faceCulling;
        draw.pipeline    = algorithm.pipeline;
        draw.threads     = request.threads;
        draw.simd        = request.simd;
        draw.shortcuts   = onEqualTerms ? request.shortcuts : ShortcutSet();
        draw.memoryLimit = request.memoryLimit;
        draw.cancel      = request.progress.cancel;
        if (const auto done = drawTimed(draw, std::max(1, request.frames), compared); !done) return done.error();
        if (wasCancelled(request)) return Error{Trouble::Cancelled, "the comparison was cancelled"};

        const Picture picture = pictureOf(compared.frame.visible);
        if (reference) {
            auto figures = drawsFaces(algorithm.pipeline) ? compareByFace(scene, request.camera, request.faceCulling,
                                                                          *reference, picture, request.progress)
                                                          : Result<ErrorFigures>(compare(*reference, picture));
            if (!figures) return figures.error();
            compared.againstReference = *std::move(figures);
        }
        if (!first) first = picture;
        const ComparedAlgorithm& leader = comparison.algorithms.front();
        const bool               byFace = drawsFaces(algorithm.pipeline) || drawsFaces(leader.algorithm.pipeline);
        compared.againstFirst =
            byFace ? compare(byFaces(*first, scene), byFaces(picture, scene)) : compare(*first, picture);
        bool isEqual = compared.againstFirst.wrongPixels() == 0;
        if (!byFace) {
            const std::span<const std::uint32_t> a = leader.frame.colour.values(), b = compared.frame.colour.values();
            for (std::size_t i = 0; i < a.size(); ++i) compared.coloursDiffer += a[i] != b[i];
            isEqual = compared.againstFirst.isExact() && compared.coloursDiffer == 0;
        }
        compared.isEqualToFirst = isEqual;
    }
    return comparison;
} catch (const std::bad_alloc&) {
    return Error{Trouble::Limit, "there is not enough memory to compare these pictures"};
}

std::span<const DifferenceEntry> differences() { return kDifferences; }

Grid<std::uint32_t> paintDifference(const Frame& first, const Frame& second, const Scene& scene, bool byFace)
{
    Grid<std::uint32_t> picture(first.visible.width(), first.visible.height());
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const DrawnDifference found = differenceAt(first, second, x, y, scene, byFace);
            const auto            entry = std::ranges::find(kDifferences, found, &DifferenceEntry::difference);
            picture.at(x, y)            = entry == kDifferences.end() ? faded(first.colour.at(x, y)) : entry->colour;
        }
    return picture;
}

}  // namespace zscope
