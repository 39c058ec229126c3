// Numbers as colours that can be read by every kind of colour vision: depth in a map whose lightness grows evenly,
// differences around white, how much in one hue.
//
// Colours    0xAARRGGBB, opaque
// Source     cividis: Nuñez, Anderton, Renslow, Optimizing colormaps with consideration for color vision deficiency,
//            2018
#pragma once

#include <cstdint>

namespace zscope {

/// Dark blue at 0, light yellow at 1; `part` outside [0, 1] is limited.
std::uint32_t cividis(double part);
/// Blue at -1, white at 0, vermilion at 1.
std::uint32_t diverging(double part);
/// White at 0, over orange, to dark red at 1.
std::uint32_t heat(double part);

}  // namespace zscope
