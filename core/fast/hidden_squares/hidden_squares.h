// Which boxes of pixels can show nothing of a batch any more, whatever it has in them: one bit per pixel and side of a
// square.
//
// Bit        of pixel (x, y) and side n: no pixel of the square [x, x + n) x [y, y + n) shows the batch, because what
//            is held there is nearer than the batch comes anywhere. Pixels outside its reach have nothing of it and
//            count as such
// Layout     words[level << levelShift | column << lineShift | line]; bit i of a word is pixel left + kWordPixels
//            column + i of line reach.y0 + line
// Frames     the picture as it stood when they were found; depths only grow, so what they say stays true
// Source     squares of one side from four of a smaller one: sparse tables, Bender, Farach-Colton: The LCA Problem
//            Revisited, LATIN 2000; what they are for: docs/performance.md, Hidden squares
#pragma once

#include <array>
#include <cstdint>

#include "core/geometry/pixel_box.h"

namespace zscope {

/// What is hidden of a batch, as far as somebody looked.
enum class HiddenPart { Nothing, Squares, Everything };

struct HiddenSquares {
    /// Side of a square per level, in pixels. Each is at most twice the one before.
    static constexpr std::array<int, 8> kSides{1, 2, 3, 4, 6, 8, 12, 16};
    static constexpr int                kWordPixels = 32;  // width of a column
    /// A larger reach is not looked at.
    static constexpr int kMostColumns = 8, kMostLines = 224;
    /// Words of a column: its lines, and room for whole vectors behind them.
    static constexpr int kColumnWords = 256;

    PixelBox reach;
    int      left = 0, lineShift = 0, levelShift = 0;
    int      levels = 0;  // the first so many sides have such squares; 0: the whole batch may be seen
    alignas(64) std::array<std::uint32_t, kSides.size() * kMostColumns * kColumnWords> words;
};

}  // namespace zscope
