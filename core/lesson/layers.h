// A frame's values as pictures: what `--show` and the window can put in place of the shaded colours.
//
// Growing    a layer is one entry in layers.cpp
// Promise    the same frame gives the same picture
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/grid.h"
#include "core/frame/renderer.h"

namespace zscope {

struct Layer {
    std::string_view word;
    std::string_view title;
    /// 0xAARRGGBB, opaque. The frame must have been drawn with shading.
    Grid<std::uint32_t> (*paint)(const Frame& frame);
};
std::span<const Layer> layers();                        // [0] is the shaded picture
const Layer*           findLayer(std::string_view word);  // nullptr: no layer has this name

}  // namespace zscope
