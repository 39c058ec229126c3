#include "core/check/conventions.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/check/exact_triangle.h"

namespace zscope::check {
namespace {

constexpr std::int64_t kFull = 256;  // what one agreement is worth

/// What a pixel is worth that one side covers and the other leaves empty. Where the reference leaves nothing empty, a
/// value is background if it is a right surface at fewer than half of its pixels.
std::int64_t worthOfDisagreement(const Truth& truth)
{
    return truth.covered == truth.picture.ids.values().size() ? kFull * 3 / 2 : 0;
}

std::uint64_t keyOf(double value)
{
    return std::isnan(value) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(value + 0.0);
}
std::uint64_t keyOf(std::int64_t value) { return static_cast<std::uint64_t>(value); }

bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }
bool isSame(std::int64_t a, std::int64_t b) { return a == b; }

template <class T>
bool isBackgroundValue(T value, const std::optional<T>& background)
{
    return background && isSame(value, *background);
}

/// The row of the file that holds row y of the picture.
int fileRow(int y, int height, Rows rows) { return rows == Rows::TopDown ? y : height - 1 - y; }

template <class T>
bool isUniform(const Grid<T>& grid)
{
    return std::ranges::all_of(grid.values(), [&](T value) { return isSame(value, grid.values().front()); });
}

/// What may stand for "empty" in a file, the likeliest first; nothing: no value does.
template <class T>
std::vector<std::optional<T>> backgroundsOf(const Grid<T>& file, const Truth& truth, Rows rows, std::vector<T> usual)
{
    const int                                        width = file.width(), height = file.height();
    std::unordered_map<std::uint64_t, std::uint64_t> onEmpty;
    std::optional<T>                                 best;
    std::uint64_t                                    most = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (truth.picture.ids.at(x, y) >= 0) continue;
            const T             value = file.at(x, fileRow(y, height, rows));
            const std::uint64_t count = ++onEmpty[keyOf(value)];
            if (count > most) most = count, best = value;
        }
    std::vector<std::optional<T>> candidates;
    if (best) {
        candidates.push_back(best);
        std::uint64_t onCovered = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                onCovered += truth.picture.ids.at(x, y) >= 0 && isSame(file.at(x, fileRow(y, height, rows)), *best);
        if (2 * onCovered <= truth.covered) return candidates;
    }
    T largest = file.values().front();
    for (const T value : file.values())
        if (value > largest) largest = value;
    usual.push_back(largest);
    if (!best) candidates.push_back(std::nullopt);
    for (const T value : usual) {
        const bool isThere = std::ranges::any_of(file.values(), [&](T other) { return isSame(other, value); });
        const bool isNew   = std::ranges::none_of(
              candidates, [&](const std::optional<T>& known) { return known && isSame(*known, value); });
        if (isThere && isNew) candidates.emplace_back(value);
    }
    return candidates;
}

/// Adds up score(x, y, row of the file) over the picture.
template <class Score>
std::int64_t sumOver(int width, int height, Rows rows, const Score& score)
{
    std::int64_t sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) sum += score(x, y, fileRow(y, height, rows));
    return sum;
}

/// Of a depth that is `excess` tolerances off.
std::int64_t worthOf(double excess)
{
    if (excess <= 1) return kFull;
    if (!(excess < 1e30)) return 0;
    return static_cast<std::int64_t>(static_cast<double>(kFull) * 0.25 / (1 + std::log2(excess)));
}

struct DepthFit {
    std::int64_t          score = -1;
    std::optional<double> background;
    DepthMeaning          meaning = DepthMeaning::NearOverZ;
};

std::int64_t depthScore(const ForeignDepth& file, const Truth& truth, Rows rows, DepthMeaning meaning,
                        const std::optional<double>& background)
{
    const DepthScale   scale(truth.camera, meaning);
    const std::int64_t disagreement = worthOfDisagreement(truth);
    return sumOver(file.values.width(), file.values.height(), rows, [&](int x, int y, int row) {
        const double found     = file.values.at(x, row);
        const bool   isCovered = truth.picture.ids.at(x, y) >= 0, isShown = !isBackgroundValue(found, background);
        if (isCovered != isShown) return disagreement;
        if (!isCovered) return kFull;
        const double     depth = truth.picture.depth.at(x, y);
        const DepthValue value = scale.of(depth, x, y);
        const double     most  = toleranceOf(value, depth, truth.slack.at(x, y), file.resolution);
        return kFull + worthOf(std::abs(found - value.value) / most);
    });
}

DepthFit fitDepth(const ForeignDepth& file, const Truth& truth, Rows rows, const std::optional<DepthMeaning>& given)
{
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    DepthFit         best;
    for (const auto& background : backgroundsOf<double>(file.values, truth, rows, {0, 1, -1, kInfinity, std::nan("")}))
        for (const DepthMeaning meaning : kDepthMeanings) {
            if (given ? *given != meaning : !DepthScale(truth.camera, meaning).isPossible()) continue;
            if (file.resolution.format == DepthNumberFormat::Fixed && !fitsFractions(meaning)) continue;
            const std::int64_t score = depthScore(file, truth, rows, meaning, background);
            if (score > best.score) best = {score, background, meaning};
        }
    return best;
}

struct IdFit {
    std::int64_t                score = -1;
    std::optional<std::int64_t> background;
    IdKind                      kind = IdKind::Triangles;
    int                         from = 0;
};

/// What it is worth that the triangles of a file's ids may cover the pixels in which they stand, seen or not: a file
/// whose surfaces are all wrong still shows by this what its numbers mean. Judged at about kMostSamples pixels.
std::int64_t coverScore(const ForeignIds& file, const Truth& truth, Rows rows,
                        const std::optional<std::int64_t>& background, IdKind kind, int from)
{
    constexpr std::int64_t kMostSamples = 4096;
    const std::int64_t     pixels       = std::int64_t{file.values.width()} * file.values.height();
    const std::int64_t     stride       = (pixels + kMostSamples - 1) / kMostSamples;
    const auto             triangles    = static_cast<std::int64_t>(truth.scene->scene().triangleCount());
    const auto             mayCover     = [&](std::int64_t id, int x, int y) {
        return ExactTriangle(truth.scene->scene(), truth.camera, TriangleId{static_cast<std::uint32_t>(id)},
                                             truth.halfStep)
            .placeOf(x, y)
            .isPossible;
    };
    std::int64_t score = 0;
#pragma omp parallel for reduction(+ : score)
    for (std::int64_t i = 0; i < pixels; i += stride) {
        const int          x = static_cast<int>(i % file.values.width()), y = static_cast<int>(i / file.values.width());
        const std::int64_t found = file.values.at(x, fileRow(y, file.values.height(), rows)), id = found - from;
        if (isBackgroundValue(found, background)) continue;
        if (id < 0 || id >= (kind == IdKind::Triangles ? triangles : truth.faces.count())) continue;
        const auto [first, end] = kind == IdKind::Triangles ? truth.faces.surfaceOf(id) : truth.faces.trianglesOf(id);
        bool covers             = false;
        for (std::int64_t t = first; t < end && !covers; ++t) covers = mayCover(t, x, y);
        if (covers) score += kFull * stride;
    }
    return score;
}

IdFit fitIds(const ForeignIds& file, const Truth& truth, const Grid<std::int64_t>& faces, Rows rows,
             const Conventions& given)
{
    IdFit              best;
    const std::int64_t disagreement = worthOfDisagreement(truth);
    const auto         triangles    = static_cast<std::int64_t>(truth.scene->scene().triangleCount());
    const auto         isRight      = [&](std::int64_t shown, std::int64_t id, IdKind kind) {
        if (kind == IdKind::Faces || shown < 0 || shown >= triangles) return shown == id;
        return truth.faces.areOneSurface(id, shown);
    };
    const std::vector<std::optional<std::int64_t>> backgrounds =
        file.areColours ? std::vector<std::optional<std::int64_t>>{-1}
                        : backgroundsOf<std::int64_t>(file.values, truth, rows, {0, 1, -1});
    for (const auto& background : backgrounds)
        for (const IdKind kind : {IdKind::Triangles, IdKind::Faces})
            for (const int from : {0, 1}) {
                if (given.ids && *given.ids != kind) continue;
                if (file.areColours ? from != 0 : given.idsFrom && *given.idsFrom != from) continue;
                const Grid<std::int64_t>& right = kind == IdKind::Triangles ? truth.picture.ids : faces;
                const std::int64_t        score =
                    coverScore(file, truth, rows, background, kind, from)
                    + sumOver(file.values.width(), file.values.height(), rows, [&](int x, int y, int row) {
                          const std::int64_t found = file.values.at(x, row), id = right.at(x, y);
                          const bool         isCovered = id >= 0, isShown = !isBackgroundValue(found, background);
                          if (isCovered != isShown) return disagreement;
                          return !isCovered ? kFull : isRight(found - from, id, kind) ? 2 * kFull : kFull;
                      });
                if (score > best.score) best = {score, background, kind, from};
            }
    return best;
}

std::uint32_t cornerColourOf(const Grid<std::uint32_t>& picture)
{
    const int                          right = picture.width() - 1, bottom = picture.height() - 1;
    const std::array<std::uint32_t, 4> corners{picture.at(0, 0), picture.at(right, 0), picture.at(0, bottom),
                                               picture.at(right, bottom)};
    return *std::ranges::max_element(corners, {},
                                     [&](std::uint32_t colour) { return std::ranges::count(corners, colour); });
}

/// A file of one value is empty, unless nothing of the picture is and the value is right at most pixels.
template <class T>
bool isEmptyFile(bool isUniform, const Truth& truth, const std::optional<T>& background)
{
    return isUniform && (truth.covered < truth.picture.ids.values().size() || background);
}

Grid<std::int64_t> faceGrid(const Truth& truth)
{
    Grid<std::int64_t> faces(truth.camera.width, truth.camera.height, -1);
#pragma omp parallel for schedule(dynamic)
    for (int y = 0; y < faces.height(); ++y)
        for (int x = 0; x < faces.width(); ++x)
            if (const std::int64_t id = truth.picture.ids.at(x, y); id >= 0) faces.at(x, y) = truth.faces.faceOf(id);
    return faces;
}

}  // namespace

bool isBackground(double depth, const std::optional<double>& background)
{
    return isBackgroundValue(depth, background);
}

std::vector<Reading> readingsOf(const Foreign& files, const Conventions& given,
                                const std::vector<std::shared_ptr<const Truth>>& truths)
{
    const bool           depthIsUniform = files.depth && isUniform(files.depth->values);
    const bool           idsAreUniform  = files.ids && isUniform(files.ids->values);
    std::vector<Reading> readings;
    for (const auto& truth : truths) {
        const Grid<std::int64_t> faces = files.ids ? faceGrid(*truth) : Grid<std::int64_t>();
        for (const Rows rows : {Rows::TopDown, Rows::BottomUp}) {
            if (given.rows && *given.rows != rows) continue;
            Reading reading;
            reading.truth      = truth;
            Conventions& found = reading.conventions;
            std::int64_t agree = 0;
            if (files.depth) {
                const DepthFit fit   = fitDepth(*files.depth, *truth, rows, given.depth);
                reading.isDepthEmpty = isEmptyFile(depthIsUniform, *truth, fit.background);
                agree += fit.score;
                reading.depthBackground = reading.isDepthEmpty ? files.depth->values.values().front() : fit.background;
                if (!reading.isDepthEmpty) found.depth = fit.meaning;
            }
            if (files.ids) {
                const IdFit fit     = fitIds(*files.ids, *truth, faces, rows, given);
                reading.areIdsEmpty = isEmptyFile(idsAreUniform, *truth, fit.background);
                agree += fit.score;
                reading.idBackground = reading.areIdsEmpty ? files.ids->values.values().front() : fit.background;
                if (!reading.areIdsEmpty) found.ids = fit.kind, found.idsFrom = fit.from;
            }
            if (files.picture) {
                const Grid<std::uint32_t>& picture = *files.picture;
                reading.pictureBackground          = cornerColourOf(picture);
                reading.isPictureEmpty             = std::ranges::all_of(
                                picture.values(), [&](std::uint32_t colour) { return colour == reading.pictureBackground; });
                agree += sumOver(picture.width(), picture.height(), rows, [&](int x, int y, int row) {
                    const bool isShown = picture.at(x, row) != reading.pictureBackground;
                    return (truth->picture.ids.at(x, y) >= 0) == isShown ? kFull : std::int64_t{0};
                });
            }
            const bool allEmpty = (!files.depth || reading.isDepthEmpty) && (!files.ids || reading.areIdsEmpty)
                                  && (!files.picture || reading.isPictureEmpty);
            if (!allEmpty) found.rows = rows, found.cull = truth->culling;
            reading.agreement = agree;
            readings.push_back(std::move(reading));
        }
    }
    const std::int64_t most = std::ranges::max_element(readings, {}, &Reading::agreement)->agreement;
    std::erase_if(readings, [most](const Reading& reading) { return reading.agreement < most - most / 50; });
    return readings;
}

std::string_view wordOf(Rows rows) { return rows == Rows::TopDown ? "top-down" : "bottom-up"; }
std::string_view wordOf(IdKind kind) { return kind == IdKind::Triangles ? "triangles" : "faces"; }

}  // namespace zscope::check
