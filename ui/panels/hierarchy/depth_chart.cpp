// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/hierarchy/depth_chart.h"

#include <algorithm>
#include <numeric>

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/verdicts.h"

namespace zscope::ui {
namespace {

std::size_t totalOf(const std::array<std::size_t, 6>& counts)
{
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

constexpr int kLabelWidth = 44;

}  // namespace

DepthChart::DepthChart(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    setFont(small);
    spoken(*this, [this] { setAccessibleName(tr("Nodes per depth")); });
}

void DepthChart::present(const std::vector<std::array<std::size_t, 6>>& counts)
{
    m_counts  = counts;
    m_highest = 0;
    QStringList spoken;
    for (std::size_t depth = 0; depth < counts.size(); ++depth) {
        m_highest = std::max(m_highest, totalOf(counts[depth]));
        spoken << textOf(depth);
    }
    setAccessibleDescription(spoken.join("; "));
    update();
}

QString DepthChart::textOf(std::size_t depth) const
{
    QStringList parts;
    for (const NodeVerdict verdict : kVerdicts)
        if (const std::size_t n = m_counts[depth][static_cast<std::size_t>(verdict)]; n > 0)
            parts << grouped(n) + ' ' + nameOf(verdict);
    return tr("Depth %1: %2").arg(depth).arg(parts.join(QStringLiteral(", ")));
}

int DepthChart::columnWidth() const
{
    return m_counts.empty() ? 0 : std::clamp((width() - kLabelWidth) / static_cast<int>(m_counts.size()), 8, 64);
}

void DepthChart::paintEvent(QPaintEvent*)
{
    if (m_counts.empty()) return;
    const Theme& theme = themeOf(palette());
    QPainter     painter(this);
    const int    line = fontMetrics().height(), wide = columnWidth();
    const int    top = line + 1, bottom = height() - line - 2;
    painter.setPen(theme.softText);
    painter.drawText(QRect(0, bottom + 2, kLabelWidth, line), Qt::AlignLeft | Qt::AlignVCenter, tr("depth"));
    painter.setPen(theme.border);
    painter.drawLine(kLabelWidth, bottom, kLabelWidth + wide * static_cast<int>(m_counts.size()), bottom);
    for (std::size_t depth = 0; depth < m_counts.size(); ++depth) {
        const int left = kLabelWidth + wide * static_cast<int>(depth);
        double    y    = bottom;
        for (const NodeVerdict verdict : kVerdicts) {
            const std::size_t n = m_counts[depth][static_cast<std::size_t>(verdict)];
            if (n == 0) continue;
            const double high = std::max(1.5, static_cast<double>(n) / static_cast<double>(m_highest) * (bottom - top));
            QColor       fill = colourOf(verdict, theme);
            if (verdict == NodeVerdict::Waiting || verdict == NodeVerdict::Outside) fill.setAlpha(150);
            painter.fillRect(QRectF(left + 2, y - high, wide - 4, high), fill);
            y -= high;
        }
        const QString total = grouped(totalOf(m_counts[depth]));
        if (fontMetrics().horizontalAdvance(total) <= wide - 2) {
            painter.setPen(theme.text);
            // slivers of rare verdicts add to the height
            painter.drawText(QRectF(left, std::max(y - line, 0.0), wide, line), Qt::AlignCenter, total);
        }
        painter.setPen(theme.softText);
        painter.drawText(QRect(left, bottom + 2, wide, line), Qt::AlignCenter, QString::number(depth));
    }
}

bool DepthChart::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int   wide = columnWidth();
    const int   at   = wide > 0 && help->pos().x() >= kLabelWidth ? (help->pos().x() - kLabelWidth) / wide : -1;
    if (at < 0 || at >= static_cast<int>(m_counts.size()))
        QToolTip::hideText();
    else
        QToolTip::showText(help->globalPos(), textOf(static_cast<std::size_t>(at)), this);
    return true;
}

}  // namespace zscope::ui
