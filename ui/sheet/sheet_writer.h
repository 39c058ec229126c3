// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison sheet of core as a picture or a PDF page, drawn by Qt, in the language of the window.
//
// File       PDF if the name ends so, else PNG with the command in a text chunk; complete or absent
// Needs      a QApplication; no window
#pragma once

#include <optional>

#include <QString>

#include "core/measure/comparison_sheet.h"

namespace zscope::ui {

/// The trouble as a sentence, or nothing.
std::optional<QString> writeSheet(const QString& file, const zscope::Comparison& comparison, const Scene& scene, const SheetWords& words);

}  // namespace zscope::ui
