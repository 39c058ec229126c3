// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/range_bar.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

#include "core/lesson/colour_maps.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int    kHigh       = 44;                             // of the histogram
constexpr int    kRow        = 26;                             // of the buttons
constexpr double kStepOfKeys = 0.02, kFineStepOfKeys = 0.002;  // of the whole range

}  // namespace

float RangeScale::depthAt(double part) const
{
    const auto far = static_cast<double>(whole.farthest), near = static_cast<double>(whole.nearest);
    if (whole.isLogarithmic && far > 0) return static_cast<float>(far * std::pow(near / far, part));
    return static_cast<float>(far + (near - far) * part);
}

RangeBar::RangeBar(Session& session, QWidget* parent)
    : QFrame(parent), m_session(session), m_fit(new QToolButton(this)), m_log(new QToolButton(this))
{
    setFocusPolicy(Qt::StrongFocus);
    setProperty("ownsArrows", true);
    setCursor(Qt::ArrowCursor);
    m_log->setCheckable(true);
    for (QToolButton* button : {m_fit, m_log}) {
        button->setFocusPolicy(Qt::TabFocus);
        button->setStyleSheet(QStringLiteral("padding: 1px 8px;"));
    }
    connect(m_fit, &QToolButton::clicked, this, [this] {
        DepthRange range  = m_session.now().look.range;
        range.isAutomatic = true;
        m_session.setDepthRange(range);
    });
    connect(m_log, &QToolButton::clicked, this, [this](bool on) {
        DepthRange range    = m_session.now().look.range;
        range.isLogarithmic = on;
        m_session.setDepthRange(range);
    });
    hide();
    spoken(*this, [this] {
        setAccessibleName(tr("Range of depths"));
        m_fit->setText(tr("Fit"));
        m_fit->setToolTip(tr("From the farthest to the nearest depth of the picture (N)"));
        m_log->setText(tr("Log"));
        m_log->setToolTip(tr("Equal ratios of depth, not equal differences, are equal steps of colour"));
    });
}

QSize RangeBar::sizeHint() const { return {300, 2 * kStep + kHigh + 6 + fontMetrics().height() + 4 + kRow}; }

QRect RangeBar::bars() const { return {kStep + 4, kStep, width() - 2 * kStep - 8, kHigh}; }

void RangeBar::resizeEvent(QResizeEvent*)
{
    const int top = height() - kRow - 4;
    m_log->setGeometry(width() - kStep - m_log->sizeHint().width(), top, m_log->sizeHint().width(), kRow - 4);
    m_fit->setGeometry(m_log->x() - 4 - m_fit->sizeHint().width(), top, m_fit->sizeHint().width(), kRow - 4);
}

void RangeBar::present(const Snapshot& shown)
{
    const DepthSpread* spread = shown.spread();
    if (!spread || shown.compare.seen() == CompareShow::Difference) return hide();
    m_spread = *spread;
    m_log->setChecked(shown.look.range.isLogarithmic);
    m_fit->setEnabled(!shown.look.range.isAutomatic);
    setAccessibleDescription(
        tr("from %1 to %2").arg(depthText(m_spread.used.farthest), depthText(m_spread.used.nearest)));
    resize(sizeHint());
    show();
    update();
}

void RangeBar::paintEvent(QPaintEvent*)
{
    const Theme& theme = themeOf(palette());
    QPainter     painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? theme.picked : theme.border);
    painter.setBrush(theme.card);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setRenderHint(QPainter::Antialiasing, false);

    const QRect      at = bars();
    const RangeScale scale{m_spread.whole};
    std::uint64_t    most = 1;
    for (const std::uint64_t count : m_spread.histogram) most = std::max(most, count);
    const auto parts = static_cast<int>(m_spread.histogram.size());
    for (int i = 0; i < parts; ++i) {
        const int    left = at.left() + at.width() * i / parts, right = at.left() + at.width() * (i + 1) / parts;
        const double high =
            std::sqrt(static_cast<double>(m_spread.histogram[static_cast<std::size_t>(i)]) / static_cast<double>(most))
            * (kHigh - 8);
        const double part = partOf(scale.depthAt((i + 0.5) / parts), m_spread.used);
        painter.fillRect(QRectF(left, at.bottom() - 5 - high, right - left, high), theme.idle);
        painter.fillRect(QRect(left, at.bottom() - 4, right - left, 5), QColor::fromRgb(cividis(part)));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (const End end : {End::Farthest, End::Nearest}) {
        const double x =
            at.left()
            + scale.partOf(end == End::Farthest ? m_spread.used.farthest : m_spread.used.nearest) * at.width();
        painter.setPen(QPen(theme.text, 1.5));
        painter.drawLine(QPointF(x, at.top()), QPointF(x, at.bottom()));
        painter.setBrush(end == m_end && hasFocus() ? theme.picked : theme.text);
        painter.drawEllipse(QPointF(x, at.top() + 2), 3.5, 3.5);
    }
    painter.setPen(theme.softText);
    const QRect line(at.left(), at.bottom() + 5, at.width(), fontMetrics().height());
    painter.drawText(line, Qt::AlignLeft, tr("far  %1").arg(depthText(m_spread.used.farthest)));
    painter.drawText(line, Qt::AlignRight, tr("near  %1").arg(depthText(m_spread.used.nearest)));
    painter.drawText(QRect(at.left(), height() - kRow - 4, at.width(), kRow - 4), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("depth D"));
}

void RangeBar::moveTo(End end, double part)
{
    const RangeScale scale{m_spread.whole};
    const double     limited = std::clamp(part, 0.0, 1.0);
    m_end                    = end;
    DepthRange range         = m_spread.used;
    range.isAutomatic        = false;
    if (end == End::Farthest)
        range.farthest = std::min(scale.depthAt(limited), range.nearest);
    else
        range.nearest = std::max(scale.depthAt(limited), range.farthest);
    m_spread.used = range;  // what the next move starts from, before the picture is there
    m_session.setDepthRange(range);
    update();
}

void RangeBar::mousePressEvent(QMouseEvent* event)
{
    const RangeScale scale{m_spread.whole};
    const double     part = (event->position().x() - bars().left()) / bars().width();
    const bool       toFarthest =
        std::abs(part - scale.partOf(m_spread.used.farthest)) <= std::abs(part - scale.partOf(m_spread.used.nearest));
    moveTo(toFarthest ? End::Farthest : End::Nearest, part);
}

void RangeBar::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons() & Qt::LeftButton) moveTo(m_end, (event->position().x() - bars().left()) / bars().width());
}

void RangeBar::keyPressEvent(QKeyEvent* event)
{
    const double     by = event->modifiers() & Qt::ShiftModifier ? kFineStepOfKeys : kStepOfKeys;
    const RangeScale scale{m_spread.whole};
    const double     at = scale.partOf(m_end == End::Farthest ? m_spread.used.farthest : m_spread.used.nearest);
    switch (event->key()) {
        case Qt::Key_Left:
            return moveTo(m_end, at - by);
        case Qt::Key_Right:
            return moveTo(m_end, at + by);
        case Qt::Key_Up:
        case Qt::Key_Down:
            m_end = m_end == End::Farthest ? End::Nearest : End::Farthest;
            return update();
        default:
            QFrame::keyPressEvent(event);
    }
}

}  // namespace zscope::ui
