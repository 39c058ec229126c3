#include "core/measure/error_figures.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

namespace zscope {

namespace {

/// The smallest value that at least `share` of all values do not exceed; sorts partly. 0 of nothing.
template <class Value>
Value percentile(std::vector<Value>& values, double share)
{
    if (values.empty()) return Value{};
    const double rank  = std::ceil(share * static_cast<double>(values.size()));
    const auto   place = static_cast<std::ptrdiff_t>(std::max(rank - 1, 0.0));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

RelativeDistance distribution(std::vector<double>& distances)
{
    if (distances.empty()) return {};
    double sum = 0;
    for (const double d : distances) sum += d * d;
    return {.rms = std::sqrt(sum / static_cast<double>(distances.size())),
            .p99 = percentile(distances, 0.99),
            .max = *std::ranges::max_element(distances)};
}

double relativeDistance(const PixelPair& p)
{
    if (p.referenceDepth == p.testDepth) return 0;  // also 0 / 0
    return std::abs(static_cast<double>(p.referenceDepth) / static_cast<double>(p.testDepth) - 1);
}

/// The definition would rather show the reference's sample than the test's: (Z, -id) is larger.
bool showsSomethingBehind(const PixelPair& p)
{
    if (p.testId < 0) return true;
    if (p.referenceDepth != p.testDepth) return p.testDepth < p.referenceDepth;
    return p.testId > p.referenceId;
}

/// Per visible triangle of the reference: whether all its pixels show something behind it.
void countLost(std::span<const PixelPair> pixels, std::span<const std::int64_t> testIds, ErrorFigures& figures)
{
    std::vector<std::pair<std::int64_t, bool>> visible;  // id, this pixel shows something behind it
    for (const PixelPair& p : pixels) {
        if (p.referenceId >= 0 && p.referenceId != p.testId)
            visible.emplace_back(p.referenceId, showsSomethingBehind(p));
    }
    std::ranges::sort(visible);  // of one id, `false` comes first
    std::vector<std::int64_t> shown(testIds.begin(), testIds.end());
    std::ranges::sort(shown);
    for (std::size_t i = 0; i < visible.size(); ++i) {
        const auto [id, behind] = visible[i];
        if (i > 0 && visible[i - 1].first == id) continue;
        if (std::ranges::binary_search(shown, id)) continue;
        ++figures.lostTriangles;
        if (behind) ++figures.falseCulls;
    }
}

}  // namespace

std::uint32_t stepsBetween(float a, float b)
{
    const auto place = [](float depth) { return std::bit_cast<std::uint32_t>(depth + 0.0f); };
    assert(a >= 0 && b >= 0);
    return place(a) > place(b) ? place(a) - place(b) : place(b) - place(a);
}

ErrorFigures compare(std::span<const PixelPair> pixels, std::span<const std::int64_t> testIds)
{
    ErrorFigures               figures;
    std::vector<std::uint32_t> steps;
    std::vector<double>        sameSurface, wrongSurface;
    std::uint64_t              exact = 0;

    for (const PixelPair& p : pixels) {
        const bool inReference = p.referenceId >= 0;
        const bool inTest      = p.testId >= 0;
        const bool sameBits =
            std::bit_cast<std::uint32_t>(p.referenceDepth) == std::bit_cast<std::uint32_t>(p.testDepth);
        ++figures.pixels;
        figures.covered += inReference;
        figures.holes += inReference && !inTest;
        figures.spills += !inReference && inTest;
        figures.depthBitsDiffer += !sameBits;
        if (!inReference || !inTest) continue;

        const std::uint32_t apart = stepsBetween(p.referenceDepth, p.testDepth);
        if (p.referenceId == p.testId) {
            exact += sameBits;
            steps.push_back(apart);
            sameSurface.push_back(relativeDistance(p));
        } else {
            ++(apart <= kNearTieSteps ? figures.nearTies : figures.realWrongSurface);
            wrongSurface.push_back(relativeDistance(p));
        }
    }

    if (!steps.empty()) {
        figures.exactShare    = static_cast<double>(exact) / static_cast<double>(steps.size());
        figures.maxDepthSteps = *std::ranges::max_element(steps);
        figures.p99DepthSteps = percentile(steps, 0.99);
    }
    figures.distanceOnSameSurface  = distribution(sameSurface);
    figures.distanceOnWrongSurface = distribution(wrongSurface);
    countLost(pixels, testIds, figures);
    return figures;
}

ErrorFigures together(std::span<const ErrorFigures> pictures)
{
    ErrorFigures all;
    double       same = 0, other = 0, exact = 0, sameSquares = 0, otherSquares = 0;
    for (const ErrorFigures& each : pictures) {
        all.pixels += each.pixels;
        all.covered += each.covered;
        all.holes += each.holes;
        all.spills += each.spills;
        all.nearTies += each.nearTies;
        all.realWrongSurface += each.realWrongSurface;
        all.depthBitsDiffer += each.depthBitsDiffer;
        all.lostTriangles += each.lostTriangles;
        all.falseCulls += each.falseCulls;
        all.p99DepthSteps      = std::max(all.p99DepthSteps, each.p99DepthSteps);
        all.maxDepthSteps      = std::max(all.maxDepthSteps, each.maxDepthSteps);
        const auto keepLargest = [](RelativeDistance& to, const RelativeDistance& from) {
            to.p99 = std::max(to.p99, from.p99);
            to.max = std::max(to.max, from.max);
        };
        keepLargest(all.distanceOnSameSurface, each.distanceOnSameSurface);
        keepLargest(all.distanceOnWrongSurface, each.distanceOnWrongSurface);
        const auto onSame  = static_cast<double>(each.covered - each.holes - each.wrongSurface()),
                   onOther = static_cast<double>(each.wrongSurface());
        same += onSame;
        other += onOther;
        exact += each.exactShare * onSame;
        sameSquares += each.distanceOnSameSurface.rms * each.distanceOnSameSurface.rms * onSame;
        if (onOther > 0) otherSquares += each.distanceOnWrongSurface.rms * each.distanceOnWrongSurface.rms * onOther;
    }
    if (same > 0) all.exactShare = exact / same;
    if (same > 0) all.distanceOnSameSurface.rms = std::sqrt(sameSquares / same);
    if (other > 0) all.distanceOnWrongSurface.rms = std::sqrt(otherSquares / other);
    return all;
}

ErrorFigures compare(const Picture& reference, const Picture& test)
{
    assert(reference.ids.width() == test.ids.width() && reference.ids.height() == test.ids.height());
    std::vector<PixelPair> pixels(reference.ids.values().size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i] = {.referenceId    = reference.ids.values()[i],
                     .testId         = test.ids.values()[i],
                     .referenceDepth = reference.depth.values()[i],
                     .testDepth      = test.depth.values()[i]};
    }
    return compare(pixels, test.ids.values());
}

}  // namespace zscope
