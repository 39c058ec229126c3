// SPDX-License-Identifier: GPL-3.0-or-later
// How many nodes of each verdict there are on each depth of the hierarchy: a stacked bar per depth, its total above it.
#pragma once

#include <array>
#include <vector>

#include <QWidget>

namespace zscope::ui {

class DepthChart final : public QWidget {
    Q_OBJECT

public:
    explicit DepthChart(QWidget* parent = nullptr);

    void  present(const std::vector<std::array<std::size_t, 6>>& counts);
    QSize sizeHint() const override { return {320, 54 + 2 * fontMetrics().height()}; }
    QSize minimumSizeHint() const override { return {120, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    QString textOf(std::size_t depth) const;
    int     columnWidth() const;

    std::vector<std::array<std::size_t, 6>> m_counts;  // per depth, by NodeVerdict
    std::size_t                             m_highest = 0;
};

}  // namespace zscope::ui
