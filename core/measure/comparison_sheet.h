// The comparison sheet: one column per algorithm with its picture, where it differs, its figures, its stages as bars
// and its counters; above them the scene, the machine and the version, below them the command that makes it again. What
// is where is decided here; on what it is drawn, a picture or a page, by whoever has letters.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/grid.h"
#include "core/measure/compare.h"

namespace zscope {

/// Pixels, or on a page 1/96 inch; x to the right, y down. Colours 0xAARRGGBB, opaque.
class SheetCanvas {
public:
    virtual ~SheetCanvas() = default;

    /// Called once, before anything is drawn: a white sheet.
    virtual void begin(int width, int height) = 0;
    /// Of a line of text at a size (of the em); also before begin(). 0 where text cannot be drawn.
    virtual int width(std::string_view utf8, int size) = 0;
    /// y is the base line.
    virtual void text(int x, int y, std::string_view utf8, int size, std::uint32_t colour) = 0;
    /// The same for a name, which is the same in every language.
    virtual void name(int x, int y, std::string_view utf8, int size, std::uint32_t colour)
    {
        text(x, y, utf8, size, colour);
    }
    virtual void fill(int x0, int y0, int x1, int y1, std::uint32_t colour) = 0;
    /// The whole picture in a place that is at most as large.
    virtual void picture(int x, int y, int width, int height, const Grid<std::uint32_t>& pixels) = 0;
};

struct SheetWords {
    std::string scene;    // name, triangles, size of the picture
    std::string machine;  // processor, cores, version
    std::string command;
};

void drawSheet(const Comparison& comparison, const Scene& scene, const SheetWords& words, SheetCanvas& canvas);

/// What was compared on what, as the sheet says it. `command` makes it again.
SheetWords sheetWordsOf(const Comparison& comparison, const Scene& scene, const Camera& camera, std::string command);

}  // namespace zscope
