// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/timeline/step_track.h"

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

int TrackScale::maximum() const
{
    return count - 1 <= static_cast<std::uint64_t>(kMost) ? static_cast<int>(count - 1) : kMost;
}

int TrackScale::positionOf(std::uint64_t step) const
{
    if (count - 1 <= static_cast<std::uint64_t>(kMost)) return static_cast<int>(std::min(step, count - 1));
    return static_cast<int>(std::llround(static_cast<double>(step) / static_cast<double>(count - 1) * kMost));
}

std::uint64_t TrackScale::stepOf(int position) const
{
    if (count - 1 <= static_cast<std::uint64_t>(kMost)) return static_cast<std::uint64_t>(position);
    return std::min(count - 1,
                    static_cast<std::uint64_t>(static_cast<double>(position) / kMost * static_cast<double>(count - 1)));
}

StepTrack::StepTrack(QWidget* parent) : QAbstractSlider(parent)
{
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMouseTracking(true);
    connect(this, &QAbstractSlider::valueChanged, this, [this](int position) {
        update();
        if (!m_presenting) emit stepChosen(m_scale.stepOf(position));
    });
    spoken(*this, [this] { setAccessibleName(tr("Step")); });
}

void StepTrack::present(std::uint64_t step, std::uint64_t count)
{
    m_presenting  = true;
    m_scale.count = std::max<std::uint64_t>(count, 1);
    setRange(0, m_scale.maximum());
    setPageStep(std::max(1, maximum() / 20));
    setValue(m_scale.positionOf(step));
    m_presenting = false;
    update();
}

void StepTrack::showMarks(const TrackMarks& marks)
{
    if (marks == m_marks) return;
    m_marks = marks;
    update();
}

double StepTrack::placeOf(std::uint64_t step) const
{
    if (maximum() <= 0) return width();
    return static_cast<double>(m_scale.positionOf(step)) / maximum() * width();
}

int StepTrack::positionAt(double x) const
{
    const double part = std::clamp(x / std::max(1, width() - 1), 0.0, 1.0);
    return static_cast<int>(std::llround(part * maximum()));
}

void StepTrack::paintEvent(QPaintEvent*)
{
    const Theme& theme = themeOf(palette());
    QPainter     painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track = QRectF(rect()).adjusted(0.5, 4.5, -0.5, -4.5);
    const double part  = maximum() > 0 ? static_cast<double>(value()) / maximum() : 1;
    painter.setPen(Qt::NoPen);
    QColor rest = theme.idle;
    rest.setAlpha(56);
    painter.setBrush(rest);
    painter.drawRoundedRect(track, 4, 4);
    painter.setBrush(theme.idle);
    painter.setClipRect(QRectF(0, 0, part * width(), height()));
    painter.drawRoundedRect(track, 4, 4);
    painter.setClipping(false);
    paintStages(painter, track);
    for (const std::uint64_t change : m_marks.changes) {  // a tick below
        const double x = std::clamp(placeOf(change), 1.0, width() - 1.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.picked);
        painter.drawRect(QRectF(x - 1, height() - 8, 2, 8));
    }
    for (const TrackMarks::Named& mark : m_marks.bookmarks) {  // a flag above
        const double x = std::clamp(placeOf(mark.step), 4.0, width() - 4.0);
        painter.setPen(QPen(theme.card, 1));
        painter.setBrush(theme.text);
        painter.drawPolygon(QPolygonF{{x - 5, 0}, {x + 5, 0}, {x, 10}});
    }
    painter.setPen(Qt::NoPen);
    const double at = std::clamp(part * width(), 3.0, width() - 3.0);
    painter.setBrush(theme.now);
    painter.drawRoundedRect(QRectF(at - 3, 0.5, 6, height() - 1), 3, 3);
    if (hasFocus()) {
        painter.setPen(theme.picked);
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(track, 4, 4);
    }
}

void StepTrack::paintStages(QPainter& painter, const QRectF& track) const
{
    const Theme& theme = themeOf(palette());
    QFont        small = font();
    small.setPointSizeF(small.pointSizeF() * 0.85);
    painter.setFont(small);
    for (std::size_t i = 0; i < m_marks.stages.size(); ++i) {
        const double from = i == 0 ? 0 : placeOf(m_marks.stages[i].step);
        const double to   = i + 1 < m_marks.stages.size() ? placeOf(m_marks.stages[i + 1].step) : width();
        if (i > 0) {
            painter.setPen(QPen(theme.card, 2));
            painter.drawLine(QPointF(from, track.top()), QPointF(from, track.bottom()));
        }
        const QString& name = m_marks.stages[i].name;
        const double   wide = painter.fontMetrics().horizontalAdvance(name) + 2 * kStep;
        if (to - from < wide) continue;
        // Where the handle would hide it, it makes room on the wider side.
        double       left = from, right = to;
        const double at = placeOf(m_scale.stepOf(value()));
        if (std::abs(at - (from + to) / 2) < wide / 2) {
            if (at - from > to - at)
                right = at - kStep / 2;
            else
                left = at + kStep / 2;
        }
        if (right - left < wide) continue;
        painter.setPen((left + right) / 2 < at ? theme.idleText : theme.text);
        painter.drawText(QRectF(left, track.top(), right - left, track.height()), Qt::AlignCenter, name);
    }
}

void StepTrack::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) setValue(positionAt(event->position().x()));
}

void StepTrack::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton) setValue(positionAt(event->position().x()));
}

void StepTrack::wheelEvent(QWheelEvent* event)
{
    const int notches = event->angleDelta().y() / 120;
    if (notches != 0) setValue(value() - notches);
    event->accept();
}

bool StepTrack::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) return QAbstractSlider::event(event);
    const auto*         help = static_cast<QHelpEvent*>(event);
    const std::uint64_t step = m_scale.stepOf(positionAt(help->pos().x()));
    QStringList         lines{tr("step %1").arg(grouped(step + 1))};
    const auto after = std::ranges::find_if(m_marks.stages, [&](const auto& stage) { return stage.step > step; });
    if (after != m_marks.stages.begin()) lines << tr("stage: %1").arg((after - 1)->name);
    for (const TrackMarks::Named& mark : m_marks.bookmarks)
        if (std::abs(placeOf(mark.step) - help->pos().x()) < 6) lines << QStringLiteral("\u2605 ") + mark.name;
    QToolTip::showText(help->globalPos(), lines.join('\n'), this);
    return true;
}

}  // namespace zscope::ui
