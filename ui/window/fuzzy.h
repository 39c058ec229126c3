// SPDX-License-Identifier: GPL-3.0-or-later
// Finds a command from a few of its letters. No widgets.
//
// Matches    all letters of the query in order, whatever their case; blanks in the query are skipped
// Score      higher is better: letters at the beginning of words and letters side by side count most, then short texts
#pragma once

#include <optional>

#include <QString>

namespace zscope::ui {

/// Nothing: no match. An empty query matches everything with 0.
std::optional<int> fuzzyScore(const QString& query, const QString& text);

}  // namespace zscope::ui
