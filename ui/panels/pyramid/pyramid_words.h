// SPDX-License-Identifier: GPL-3.0-or-later
// What the pyramid panel says of a step, as rich text: the last question and the last update. No widgets.
#pragma once

#include <QString>

#include "core/lesson/step_state.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

struct PyramidWords {
    QString question;  // empty: nothing has been asked yet
    QString update;    // empty: no cell has been written yet
};
PyramidWords wordsOf(const HierarchyState& hierarchy, float empty, const Theme& theme);

/// How the way up went: the levels from the tile to where it stopped, "3 → 4 → 5".
QString climbText(const std::vector<CellWrite>& climb);

/// A depth as the panel writes it; background by its name.
QString cellDepth(float value, float empty);

}  // namespace zscope::ui
