// SPDX-License-Identifier: GPL-3.0-or-later
// What the comparison panel says: a sentence and the figures below it. No widgets.
#pragma once

#include <vector>

#include <QString>

#include "ui/session/snapshot.h"

namespace zscope::ui {

struct CompareFigure {
    QString name, value;
    bool    isWrong = false;  // another surface or none, not only another depth

    friend bool operator==(const CompareFigure&, const CompareFigure&) = default;
};
struct CompareWords {
    QString                    verdict;
    bool                       isWrong = false;
    std::vector<CompareFigure> figures;
};
/// `result` is of the pictures on show.
CompareWords wordsOf(const Comparison& result);

}  // namespace zscope::ui
