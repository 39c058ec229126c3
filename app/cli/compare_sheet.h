// The comparison sheet as a picture, and as a PDF page whose text can be searched.
//
// Text       needs a TextPainter; without one the picture holds pictures and bars only, and the command says so
// PDF        by Cairo, letters embedded; a build without Cairo has no PDF (kHasPdf)
#pragma once

#include <string>

#include "app/cli/sheet_text.h"
#include "core/measure/comparison_sheet.h"

namespace zscope::cli {

/// `text`: nullptr if there is none.
Grid<std::uint32_t> composeSheet(const Comparison& comparison, const Scene& scene, const SheetWords& words,
                                 TextPainter* text);

extern const bool kHasPdf;
/// Errors: Output.
Result<Done> writePdfSheet(const std::string& path, const Comparison& comparison, const Scene& scene,
                           const SheetWords& words, TextPainter& text);

}  // namespace zscope::cli
