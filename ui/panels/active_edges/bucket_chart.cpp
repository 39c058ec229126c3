// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/active_edges/bucket_chart.h"

#include <algorithm>

#include <QPainter>

#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

std::vector<int> gathered(const std::vector<int>& counts, int columns)
{
    const auto size = static_cast<std::size_t>(std::max(columns, 1));
    if (counts.size() <= size) return counts;
    std::vector<int> bars(size, 0);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        int& bar = bars[i * size / counts.size()];
        bar      = std::max(bar, counts[i]);
    }
    return bars;
}

BucketChart::BucketChart(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    spoken(*this, [this] {
        setAccessibleName(tr("Edge table"));
        setToolTip(tr("How many edges start on each line of the picture: the buckets of the edge table"));
    });
}

void BucketChart::present(const Snapshot& shown)
{
    const SweepState* sweep = shown.sweep();
    m_counts                = sweep ? sweep->edgesStarting : std::vector<int>{};
    m_line                  = sweep ? sweep->y : -1;
    m_bars                  = gathered(m_counts, width());
    m_highest               = m_counts.empty() ? 0 : *std::ranges::max_element(m_counts);
    if (m_line >= 0 && m_line < static_cast<int>(m_counts.size()))
        setAccessibleDescription(counted(static_cast<unsigned>(m_counts[static_cast<std::size_t>(m_line)]),
                                         tr("1 edge starts on the current line"),
                                         tr("%1 edges start on the current line")));
    update();
}

void BucketChart::resizeEvent(QResizeEvent*) { m_bars = gathered(m_counts, width()); }

void BucketChart::paintEvent(QPaintEvent*)
{
    const Theme& theme = themeOf(palette());
    QPainter     painter(this);
    const int    label = fontMetrics().height() + 2;
    const QRect  chart = rect().adjusted(0, 2, 0, -label);
    painter.fillRect(QRect(chart.left(), chart.bottom(), chart.width(), 1), theme.border);
    const QRect labels(0, chart.bottom() + 2, width(), label);
    painter.setPen(theme.softText);
    if (m_bars.empty() || m_highest == 0) {
        painter.drawText(labels, Qt::AlignLeft | Qt::AlignVCenter, tr("The edge table is empty"));
        return;
    }
    const double across = static_cast<double>(chart.width()) / static_cast<double>(m_bars.size());
    const double now    = m_counts.empty() ? -1 : (m_line + 0.5) * chart.width() / static_cast<double>(m_counts.size());
    for (std::size_t i = 0; i < m_bars.size(); ++i) {
        const double left   = static_cast<double>(i) * across;
        const double height = m_bars[i] == 0 ? 0 : std::max(1.0, m_bars[i] * (chart.height() - 2.0) / m_highest);
        QColor       colour = theme.idle;
        if (m_line >= 0 && left > now) colour = theme.border;  // still waiting
        painter.fillRect(QRectF(left, chart.bottom() - height, std::max(across, 1.0), height), colour);
    }
    if (m_line >= 0) {
        painter.fillRect(QRectF(now - 1, chart.top(), 2, chart.height()), theme.now);
        const QString here = tr("line %1: %2")
                                 .arg(grouped(static_cast<unsigned>(m_line)),
                                      grouped(static_cast<unsigned>(m_counts[static_cast<std::size_t>(m_line)])));
        painter.setPen(theme.text);
        const int half = fontMetrics().horizontalAdvance(here) / 2;
        const int at   = std::clamp(static_cast<int>(now) - half, 0, std::max(0, width() - 2 * half - 2));
        painter.drawText(QRect(at, labels.top(), 2 * half + 2, label), Qt::AlignCenter, here);
        painter.setPen(theme.softText);
        if (at > fontMetrics().horizontalAdvance("0") + kStep)
            painter.drawText(labels, Qt::AlignLeft | Qt::AlignVCenter, "0");
        const QString last = grouped(m_counts.size() - 1);
        if (at + 2 * half + kStep < width() - fontMetrics().horizontalAdvance(last))
            painter.drawText(labels, Qt::AlignRight | Qt::AlignVCenter, last);
        return;
    }
    painter.drawText(labels, Qt::AlignLeft | Qt::AlignVCenter, tr("edges that start on each line; none is active yet"));
}

}  // namespace zscope::ui
