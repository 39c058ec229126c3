// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/fuzzy.h"

#include <algorithm>
#include <vector>

namespace zscope::ui {

std::optional<int> fuzzyScore(const QString& query, const QString& text)
{
    constexpr int kLetter = 1, kWordStart = 8, kSideBySide = 9, kNone = -1'000'000;

    QString wanted = query.toLower();
    wanted.remove(' ');
    if (wanted.isEmpty()) return 0;
    const QString   lower  = text.toLower();
    const qsizetype n      = lower.size();
    const auto      starts = [&](qsizetype at) { return at == 0 || !lower[at - 1].isLetterOrNumber(); };

    // best[j]: the best score of the letters so far, of which the last lies at j.
    std::vector<int> best(static_cast<std::size_t>(n), kNone);
    for (qsizetype i = 0; i < wanted.size(); ++i) {
        std::vector<int> next(static_cast<std::size_t>(n), kNone);
        int              before = i == 0 ? 0 : kNone;  // the best that ends anywhere before j
        for (qsizetype j = 0; j < n; ++j) {
            const auto at = static_cast<std::size_t>(j);
            if (lower[j] == wanted[i]) {
                int from = before;
                if (i > 0 && j > 0 && best[at - 1] > kNone) from = std::max(from, best[at - 1] + kSideBySide);
                if (from > kNone) next[at] = from + kLetter + (starts(j) ? kWordStart : 0);
            }
            if (i > 0) before = std::max(before, best[at]);
        }
        best = std::move(next);
    }
    const int found = best.empty() ? kNone : *std::ranges::max_element(best);
    if (found <= kNone) return {};
    return found * 100 - static_cast<int>(std::min<qsizetype>(n, 99));
}

}  // namespace zscope::ui
