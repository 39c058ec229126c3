// Compositions that have a textbook name.
#pragma once

#include <array>

#include "core/frame/pipeline.h"

namespace zscope {

inline constexpr std::array kPresets{
    Preset{"zbuffer", "Z-buffer: every triangle, every pixel it covers", {.scan = Scan::HalfSpace}},
    Preset{"edge-walk", "Z-buffer with edges walked from line to line", {.scan = Scan::EdgeWalk}},
    Preset{"scanline", "Scanline z-buffer with edge table and active edge table", {.scan = Scan::SweepZLine}},
    Preset{"interval", "Interval scanline: the nearest polygon between two edges, without a z-buffer", {.scan = Scan::SweepIntervals}},
};

}  // namespace zscope
