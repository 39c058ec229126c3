// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/pyramid/level_thumbs.h"

#include <algorithm>

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QToolTip>

#include "ui/session/engine.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int kGap = 6;

}  // namespace

QRect ThumbLayout::placeOf(int index, int gap) const
{
    return {QPoint((index % columns) * (cell.width() + gap), (index / columns) * (cell.height() + gap)), cell};
}

ThumbLayout thumbLayout(int count, int width, QSize picture, int gap)
{
    constexpr int kNarrowest = 72, kLowest = 44, kHighest = 72;
    ThumbLayout   layout;
    if (count <= 0) return layout;
    layout.columns = std::clamp((width + gap) / (kNarrowest + gap), 1, count);
    layout.rows    = (count + layout.columns - 1) / layout.columns;
    layout.columns = (count + layout.rows - 1) / layout.rows;  // no ragged last row if it can be helped
    const int wide = std::max(1, (width - (layout.columns - 1) * gap) / layout.columns);
    const int high = picture.width() > 0 ? wide * picture.height() / picture.width() : kLowest;
    layout.cell    = {wide, std::clamp(high, kLowest, kHighest)};
    return layout;
}

LevelThumbs::LevelThumbs(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    spoken(*this, [this] { setAccessibleName(tr("Levels of the pyramid")); });
}

int LevelThumbs::heightFor(int width) const
{
    if (!m_step) return 0;
    const PyramidLevel& finest = m_step->pyramid.levels.front();
    const ThumbLayout   layout =
        thumbLayout(static_cast<int>(m_step->pyramid.levels.size()), width, {finest.width(), finest.height()}, kGap);
    return layout.rows * (layout.cell.height() + kGap) - kGap;
}

void LevelThumbs::present(const Snapshot& shown)
{
    const int  level  = levelOnShow(shown);
    const auto before = m_step ? m_step->pyramid.levels.size() : 0;
    if (level < 0) m_step.reset();
    const bool isNew = level >= 0 && m_step != shown.step;
    if (isNew) m_step = shown.step;
    m_current = level;
    if (isNew) makeThumbs();
    if (before != (m_step ? m_step->pyramid.levels.size() : 0)) setFixedHeight(heightFor(width()));
    setAccessibleDescription(level < 0 ? QString() : tr("Level %1 is shown large").arg(level));
    update();
}

void LevelThumbs::resizeEvent(QResizeEvent* event)
{
    if (event->size().width() == event->oldSize().width()) return;
    setFixedHeight(heightFor(width()));  // as many rows as the width asks for
    makeThumbs();
}

void LevelThumbs::makeThumbs()
{
    m_thumbs.clear();
    if (!m_step) return;
    const auto&       levels = m_step->pyramid.levels;
    const double      scale  = devicePixelRatioF();
    const ThumbLayout layout =
        thumbLayout(static_cast<int>(levels.size()), width(), {levels[0].width(), levels[0].height()}, kGap);
    for (const PyramidLevel& level : levels) {
        const QImage whole = imageOf(level.colours);
        const QSize  size  = QSizeF(levels[0].width(), levels[0].height())
                               .scaled(QSizeF(layout.cell) * scale, Qt::KeepAspectRatio)
                               .toSize();
        // Large levels are averaged; small ones keep their cells, and the last column only the part that is in the
        // picture.
        const QSizeF part(static_cast<double>(levels[0].width()) / level.cellSize(),
                          static_cast<double>(levels[0].height()) / level.cellSize());
        QImage       thumb(size.expandedTo({1, 1}), QImage::Format_RGB32);
        QPainter     painter(&thumb);
        painter.setRenderHint(QPainter::SmoothPixmapTransform, whole.width() > thumb.width());
        painter.drawImage(QRectF(QPointF(0, 0), QSizeF(thumb.size())),
                          whole.width() > 2 * thumb.width()
                              ? whole.scaled(thumb.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                              : whole,
                          whole.width() > 2 * thumb.width() ? QRectF(QPointF(0, 0), QSizeF(thumb.size()))
                                                            : QRectF(QPointF(0, 0), part));
        painter.end();
        thumb.setDevicePixelRatio(scale);
        m_thumbs.push_back(std::move(thumb));
    }
}

void LevelThumbs::paintEvent(QPaintEvent*)
{
    if (!m_step || m_thumbs.empty()) return;
    const Theme&      theme  = themeOf(palette());
    const auto&       levels = m_step->pyramid.levels;
    const ThumbLayout layout =
        thumbLayout(static_cast<int>(levels.size()), width(), {levels[0].width(), levels[0].height()}, kGap);
    const HierarchyState& hierarchy = *m_step->state.hierarchy;
    QPainter              painter(this);
    QFont                 small = font();
    small.setPointSizeF(small.pointSizeF() * 0.82);
    QFont strong = font();
    strong.setBold(true);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const QRect   at    = layout.placeOf(static_cast<int>(i), kGap);
        const QImage& thumb = m_thumbs[i];
        const QSize   size  = (QSizeF(thumb.size()) / thumb.devicePixelRatio()).toSize();
        painter.setRenderHint(QPainter::Antialiasing, true);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor::fromRgb(kEmptyCell));
        painter.drawRoundedRect(at, 3, 3);
        painter.drawImage(
            QRect(QPoint(at.left() + (at.width() - size.width()) / 2, at.top() + (at.height() - size.height()) / 2),
                  size),
            thumb);
        const auto label = [&](const QString& text, Qt::Alignment where, const QFont& as, const QColor& colour) {
            painter.setFont(as);
            const QRect  inside = at.adjusted(5, 2, -5, -2);
            const QRectF box =
                painter.boundingRect(QRectF(inside), static_cast<int>(where), text).adjusted(-3, 0, 3, 0);
            painter.setPen(Qt::NoPen);
            painter.setBrush(QColor(0, 0, 0, 130));
            painter.drawRoundedRect(box, 3, 3);
            painter.setPen(colour);
            painter.drawText(inside, static_cast<int>(where), text);
        };
        label(QString::number(i), Qt::AlignLeft | Qt::AlignTop, strong, Qt::white);
        label(QStringLiteral("%1 × %2").arg(levels[i].width()).arg(levels[i].height()),
              Qt::AlignRight | Qt::AlignBottom, small, QColor(225, 230, 236));
        QString marks;
        if (hierarchy.query && hierarchy.query->level == static_cast<int>(i)) marks += QStringLiteral("?");
        if (hierarchy.update && hierarchy.update->level == static_cast<int>(i)) marks += QStringLiteral("\u25B2");
        if (!marks.isEmpty()) label(marks, Qt::AlignRight | Qt::AlignTop, strong, themeOf(palette()).now);
        if (static_cast<int>(i) == m_current) {
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(theme.now, 2.5));
            painter.drawRoundedRect(QRectF(at).adjusted(1, 1, -1, -1), 3, 3);
        }
    }
    if (hasFocus() && m_current >= 0) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme.picked, 1));
        painter.drawRoundedRect(QRectF(layout.placeOf(m_current, kGap)).adjusted(3.5, 3.5, -3.5, -3.5), 2, 2);
    }
}

int LevelThumbs::levelAt(const QPoint& place) const
{
    if (!m_step) return -1;
    const auto&       levels = m_step->pyramid.levels;
    const ThumbLayout layout =
        thumbLayout(static_cast<int>(levels.size()), width(), {levels[0].width(), levels[0].height()}, kGap);
    for (int i = 0; i < static_cast<int>(levels.size()); ++i)
        if (layout.placeOf(i, kGap).contains(place)) return i;
    return -1;
}

void LevelThumbs::mousePressEvent(QMouseEvent* event)
{
    if (const int level = levelAt(event->position().toPoint()); level >= 0) emit chosen(level);
}

void LevelThumbs::keyPressEvent(QKeyEvent* event)
{
    if (!m_step || m_current < 0) return QWidget::keyPressEvent(event);
    const int last = static_cast<int>(m_step->pyramid.levels.size()) - 1;
    switch (event->key()) {
        case Qt::Key_Plus:
        case Qt::Key_PageUp:
            return emit chosen(std::min(last, m_current + 1));
        case Qt::Key_Minus:
        case Qt::Key_PageDown:
            return emit chosen(std::max(0, m_current - 1));
        default:
            QWidget::keyPressEvent(event);
    }
}

bool LevelThumbs::event(QEvent* event)
{
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) update();
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help  = static_cast<QHelpEvent*>(event);
    const int   level = levelAt(help->pos());
    if (level < 0) {
        QToolTip::hideText();
        return true;
    }
    const PyramidLevel& of   = m_step->pyramid.levels[static_cast<std::size_t>(level)];
    const int           side = of.cellSize();
    const QString       form = of.isStored ? tr("Level %1: a cell holds the farthest depth of %2 × %2 pixels")
                                           : tr("Level %1 is not stored: a question reads the %2 × %2 pixels instead");
    QString             text = level == 0 ? tr("Level 0: the depth buffer itself") : form.arg(level).arg(side);
    if (of.lagging > 0)
        text += '\n'
                + counted(static_cast<std::uint64_t>(of.lagging), tr("1 cell lags behind its pixels"),
                          tr("%1 cells lag behind their pixels"));
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

}  // namespace zscope::ui
