// The comparison sheet: one column per algorithm with its picture, where it differs, its figures and its stages as bars; above
// them the scene, the machine and the version, below them the command that makes it again.
//
// Text       needs a TextPainter; without one the sheet holds pictures and bars only, and the command says so
#pragma once

#include <string>

#include "app/cli/sheet_text.h"
#include "core/measure/compare.h"

namespace zscope::cli {

struct SheetWords {
    std::string scene;    // name, triangles, size of the picture
    std::string machine;  // processor, cores, version
    std::string command;
};

/// `text`: nullptr if there is none.
Grid<std::uint32_t> composeSheet(const Comparison& comparison, const Scene& scene, const SheetWords& words, TextPainter* text);

}  // namespace zscope::cli
