#include "core/lesson/layers.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/shade/colour_table.h"

namespace zscope {
namespace {

Grid<std::uint32_t> shaded(const Frame& frame)
{
    return frame.colour;
}

std::uint32_t grey(std::uint32_t level)
{
    return 0xFF000000u | level << 16 | level << 8 | level;
}

/// Nearest and farthest depth of the picture, background apart.
struct DepthRange {
    float farthest = std::numeric_limits<float>::infinity();
    float nearest  = 0;
};

DepthRange depthRange(const VisibilityBuffer& visible)
{
    DepthRange range;
    for (int y = 0; y < visible.height(); ++y) {
        for (int x = 0; x < visible.width(); ++x) {
            if (visible.rankRow(y)[x] == 0) continue;
            range.farthest = std::min(range.farthest, visible.depthRow(y)[x]);
            range.nearest  = std::max(range.nearest, visible.depthRow(y)[x]);
        }
    }
    return range;
}

/// Linear in near/z from the farthest (dark) to the nearest (light); background black.
Grid<std::uint32_t> depth(const Frame& frame)
{
    constexpr double kDarkest = 40, kLightest = 255;

    const VisibilityBuffer& visible = frame.visible;
    const DepthRange        range   = depthRange(visible);
    const double            extent  = static_cast<double>(range.nearest) - static_cast<double>(range.farthest);
    Grid<std::uint32_t>     picture(visible.width(), visible.height(), grey(0));
    for (int y = 0; y < visible.height(); ++y) {
        for (int x = 0; x < visible.width(); ++x) {
            if (visible.rankRow(y)[x] == 0) continue;
            const double above = static_cast<double>(visible.depthRow(y)[x]) - static_cast<double>(range.farthest);
            const double part  = extent > 0 ? above / extent : 1.0;
            picture.at(x, y)   = grey(static_cast<std::uint32_t>(kDarkest + (kLightest - kDarkest) * part + 0.5));
        }
    }
    return picture;
}

/// A colour per id, far apart for ids that follow each other, never as light as the background.
std::uint32_t colourOfId(std::uint32_t rank)
{
    std::uint32_t bits = rank * 0x9E3779B9u;  // 2^32 / golden ratio: neighbours land far apart
    bits ^= bits >> 15;
    bits *= 0x85EBCA6Bu;
    bits ^= bits >> 13;
    const auto part = [bits](int shift) { return 40u + ((bits >> shift) & 0xFFu) * 3u / 4u; };
    return 0xFF000000u | part(0) << 16 | part(8) << 8 | part(16);
}

Grid<std::uint32_t> ids(const Frame& frame)
{
    const VisibilityBuffer& visible = frame.visible;
    Grid<std::uint32_t>     picture(visible.width(), visible.height(), kBackgroundColour);
    for (int y = 0; y < visible.height(); ++y)
        for (int x = 0; x < visible.width(); ++x)
            if (const std::uint32_t rank = visible.rankRow(y)[x]; rank != 0) picture.at(x, y) = colourOfId(rank);
    return picture;
}

constexpr std::array kLayers{
    Layer{"shaded", "Flat shading by one directional light", shaded},
    Layer{"depth", "near/z, from dark (far) to light (near), stretched to the picture's range", depth},
    Layer{"ids", "One colour per triangle", ids},
};

}  // namespace

std::span<const Layer> layers()
{
    return kLayers;
}

const Layer* findLayer(std::string_view word)
{
    const auto found = std::ranges::find(kLayers, word, &Layer::word);
    return found == kLayers.end() ? nullptr : &*found;
}

}  // namespace zscope
