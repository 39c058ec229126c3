// The pyramid of one step, level by level, as pictures: what each cell holds, which cells lag behind their pixels, and
// what the last question and the last update had to do with them.
//
// Values     as the visibility buffer stores depth; larger is nearer, visible.empty() is background
// Levels     0 is the depth buffer. 1 and 2 are not stored: what is shown of them is what a question would read from
//            the pixels. From Pyramid::kTileLevel up, what the cells hold
// Lags       a stored cell that is farther than its pixels: it may still answer, and never wrongly
// Cost       a few passes over the picture
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/lesson/step_state.h"

namespace zscope {

struct PyramidLevel {
    int                 level    = 0;
    bool                isStored = false;
    Grid<float>         farthest;
    Grid<std::uint8_t>  lags;         // 1: the cell lags; empty where nothing is stored
    int                 lagging = 0;  // how many
    Grid<std::uint32_t> colours;      // of `farthest`, one range for all levels; background darker than all of them

    int width() const { return farthest.width(); }
    int height() const { return farthest.height(); }
    /// How many pixels of the picture a cell is wide.
    int cellSize() const { return 1 << level; }
};

struct PyramidPicture {
    std::vector<PyramidLevel> levels;                     // from 0 up; empty: the method keeps no pyramid, or none yet
    float                     empty    = 0;               // what background holds
    float                     farthest = 0, nearest = 0;  // of the pixels that show something; equal: none or one depth
};
PyramidPicture pyramidOf(const StepState& state);

/// Every depth as the buffer stores it: level 0.
Grid<float> storedDepths(const VisibilityBuffer& visible);
/// The level above: every cell the farthest of its 2 x 2 children.
Grid<float> farthestOfFour(const Grid<float>& below);

/// The colour of what nothing has been drawn to.
inline constexpr std::uint32_t kEmptyCell = 0xFF14161A;

/// The cells of a level that a box of pixels reaches into.
PixelBox cellsUnder(const PixelBox& pixels, int level);

}  // namespace zscope
