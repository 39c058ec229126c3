// A frame's values as pictures: what `--show` and the window can put in place of the shaded colours.
//
// Growing    a layer is one entry in layers.cpp
// Promise    the same frame gives the same picture
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/grid.h"
#include "core/frame/renderer.h"

namespace zscope {

/// Which depths become the darkest and the lightest colour. Depth is near/z: the nearest is the largest.
struct DepthRange {
    bool  isAutomatic   = true;  // from the farthest to the nearest of the picture; the two below are not used then
    float farthest      = 0;
    float nearest       = 1;
    bool  isLogarithmic = false;  // equal ratios, not equal differences, are equal steps of colour

    friend bool operator==(const DepthRange&, const DepthRange&) = default;
};
/// The automatic range of a picture made fixed; { 0, 0 } if it shows nothing.
DepthRange fixedRange(const DepthRange& range, const VisibilityBuffer& visible);
/// Where a depth lies in a fixed range: 0 the farthest, 1 the nearest, limited to both.
double partOf(float depth, const DepthRange& range);
/// The depths of the picture in so many equal parts of its own farthest to its own nearest, on the scale of `range`.
std::vector<std::uint64_t> depthHistogram(const VisibilityBuffer& visible, const DepthRange& range, int parts);

/// The colour of a pixel that was tested so often, once and more; from kMostTests on it stays the same.
inline constexpr int kMostTests = 12;
std::uint32_t        heatOfTests(std::uint32_t tests);

/// Of a triangle by its id plus 1: far apart for ids that follow each other, never as light as the background.
std::uint32_t colourOfId(std::uint32_t rank);

/// What a layer is painted from.
struct LayerSource {
    const Frame&               frame;            // drawn with shading
    const Grid<std::uint32_t>* tests = nullptr;  // StepState::tests, for the layers that need them
    DepthRange                 range = {};
};

struct Layer {
    std::string_view word;
    std::string_view title;
    bool             needsTests;  // only a step knows them, the finished picture's last one too
    /// 0xAARRGGBB, opaque.
    Grid<std::uint32_t> (*paint)(const LayerSource& source);
};
std::span<const Layer> layers();                          // [0] is the shaded picture
const Layer*           findLayer(std::string_view word);  // nullptr: no layer has this name

}  // namespace zscope
