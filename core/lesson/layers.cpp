#include "core/lesson/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/lesson/colour_maps.h"
#include "core/shade/colour_table.h"

namespace zscope {
namespace {

Grid<std::uint32_t> shaded(const LayerSource& source) { return source.frame.colour; }

/// Calls `each(depth)` for every pixel that shows something; depth as it is reported.
template <class Each>
void forEveryDepth(const VisibilityBuffer& visible, const Each& each)
{
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x)
            if (visible.rankAt(x, y) != 0) each(visible.depthAt(x, y));
}

/// From the farthest (dark) to the nearest (light); background near black.
Grid<std::uint32_t> depth(const LayerSource& source)
{
    constexpr std::uint32_t kBackground = 0xFF14161A;

    const VisibilityBuffer& visible = source.frame.visible;
    const DepthRange        range   = fixedRange(source.range, visible);
    Grid<std::uint32_t>     picture(visible.width(), visible.height(), kBackground);
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x)
            if (visible.rankAt(x, y) != 0) picture.at(x, y) = cividis(partOf(visible.depthAt(x, y), range));
    return picture;
}

/// How often each pixel's depth was tested, from once (nearly white) to kMostTests times and more (dark red).
Grid<std::uint32_t> tests(const LayerSource& source)
{
    const VisibilityBuffer& visible = source.frame.visible;
    Grid<std::uint32_t>     picture(visible.width(), visible.height(), kBackgroundColour);
    if (!source.tests) return picture;
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x)
            if (const std::uint32_t count = source.tests->at(x, y); count > 0) picture.at(x, y) = heatOfTests(count);
    return picture;
}

Grid<std::uint32_t> ids(const LayerSource& source)
{
    const VisibilityBuffer& visible = source.frame.visible;
    Grid<std::uint32_t>     picture(visible.width(), visible.height(), kBackgroundColour);
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x)
            if (const std::uint32_t rank = visible.rankAt(x, y); rank != 0) picture.at(x, y) = colourOfId(rank);
    return picture;
}

constexpr std::array kLayers{
    Layer{"shaded", "Flat shading by one directional light", false, shaded},
    Layer{"depth", "near/z, from dark (far) to light (near), stretched to the picture's range", false, depth},
    Layer{"ids", "One colour per triangle", false, ids},
    Layer{"tests", "How often each pixel's depth was tested: over-rendering", true, tests},
};

}  // namespace

std::uint32_t colourOfId(std::uint32_t rank)
{
    std::uint32_t bits = rank * 0x9E3779B9u;  // 2^32 / golden ratio: neighbours land far apart
    bits ^= bits >> 15;
    bits *= 0x85EBCA6Bu;
    bits ^= bits >> 13;
    const auto part = [bits](int shift) { return 40u + ((bits >> shift) & 0xFFu) * 3u / 4u; };
    return 0xFF000000u | part(0) << 16 | part(8) << 8 | part(16);
}

std::uint32_t heatOfTests(std::uint32_t tests) { return heat((tests - 0.5) / kMostTests); }

DepthRange fixedRange(const DepthRange& range, const VisibilityBuffer& visible)
{
    DepthRange fixed  = range;
    fixed.isAutomatic = false;
    if (!range.isAutomatic) return fixed;
    fixed.farthest = std::numeric_limits<float>::infinity();
    fixed.nearest  = 0;
    forEveryDepth(visible, [&](float each) {
        fixed.farthest = std::min(fixed.farthest, each);
        fixed.nearest  = std::max(fixed.nearest, each);
    });
    if (fixed.farthest > fixed.nearest) fixed.farthest = fixed.nearest;
    return fixed;
}

double partOf(float value, const DepthRange& range)
{
    const auto far = static_cast<double>(range.farthest), near = static_cast<double>(range.nearest),
               at = static_cast<double>(value);
    if (!(near > far)) return at >= near ? 1 : 0;
    if (!range.isLogarithmic || !(far > 0)) return std::clamp((at - far) / (near - far), 0.0, 1.0);
    return at > 0 ? std::clamp(std::log(at / far) / std::log(near / far), 0.0, 1.0) : 0;
}

std::vector<std::uint64_t> depthHistogram(const VisibilityBuffer& visible, const DepthRange& range, int parts)
{
    DepthRange                 whole = fixedRange({.isAutomatic = true, .isLogarithmic = range.isLogarithmic}, visible);
    std::vector<std::uint64_t> counts(static_cast<std::size_t>(parts), 0);
    forEveryDepth(visible, [&](float each) {
        ++counts[static_cast<std::size_t>(std::min(partOf(each, whole) * parts, parts - 1.0))];
    });
    return counts;
}

std::span<const Layer> layers() { return kLayers; }

const Layer* findLayer(std::string_view word)
{
    const auto found = std::ranges::find(kLayers, word, &Layer::word);
    return found == kLayers.end() ? nullptr : &*found;
}

}  // namespace zscope
