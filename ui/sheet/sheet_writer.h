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

/// The trouble as a sentence, or nothing. `camera`: the camera.json that the command names, if it names one; it goes
/// into the file, as a text chunk of the picture or a file attached to the page.
std::optional<QString> writeSheet(const QString& file, const zscope::Comparison& comparison, const Scene& scene,
                                  const SheetWords& words, const std::optional<Camera>& camera);

}  // namespace zscope::ui
