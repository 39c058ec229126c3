// SPDX-License-Identifier: GPL-3.0-or-later
// The edge table's buckets along the height of the picture: how many edges start on each line, the current line
// marked.
#pragma once

#include <vector>

#include <QWidget>

#include "ui/session/snapshot.h"

namespace zscope::ui {

/// `counts` gathered into `columns` neighbouring groups, each as high as its highest count; all of them if there are
/// no more lines than columns.
std::vector<int> gathered(const std::vector<int>& counts, int columns);

class BucketChart final : public QWidget {
    Q_OBJECT

public:
    explicit BucketChart(QWidget* parent = nullptr);

    void  present(const Snapshot& shown);
    QSize sizeHint() const override { return {320, 56 + fontMetrics().height()}; }
    QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    std::vector<int> m_counts;  // per line
    std::vector<int> m_bars;    // per column of the chart
    int              m_highest = 0;
    int              m_line    = -1;
};

}  // namespace zscope::ui
