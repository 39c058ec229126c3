// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/pyramid/level_view.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/panels/pyramid/pyramid_words.h"
#include "ui/session/engine.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"
#include "ui/view/overlay.h"

namespace zscope::ui {

LevelView::LevelView(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMouseTracking(true);
    spoken(*this, [this] { setAccessibleName(tr("One level of the pyramid, large")); });
}

void LevelView::present(const Snapshot& shown)
{
    m_level  = levelOnShow(shown);
    m_step   = m_level < 0 ? nullptr : shown.step;
    m_picked = shown.picked;
    update();
}

QRectF LevelView::room() const
{
    const auto&  finest = m_step->pyramid.levels.front();
    const QSizeF size = QSizeF(finest.width(), finest.height()).scaled(QSizeF(width(), height()), Qt::KeepAspectRatio);
    return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

std::optional<QPoint> LevelView::pixelAt(const QPointF& place) const
{
    if (!m_step) return {};
    const QRectF at = room();
    if (!at.contains(place)) return {};
    const auto&  finest = m_step->pyramid.levels.front();
    const QPoint pixel(static_cast<int>((place.x() - at.left()) / at.width() * finest.width()),
                       static_cast<int>((place.y() - at.top()) / at.height() * finest.height()));
    return QPoint(std::min(pixel.x(), finest.width() - 1), std::min(pixel.y(), finest.height() - 1));
}

void LevelView::paintEvent(QPaintEvent*)
{
    constexpr double kLevelGridFrom = 5, kLevelValuesFrom = 34;
    if (!m_step) return;
    const Theme&        theme  = themeOf(palette());
    const PyramidLevel& cells  = level();
    const auto&         finest = m_step->pyramid.levels.front();
    const QRectF        at     = room();
    const double        zoom   = at.width() / finest.width();  // of a pixel
    const double        wide   = zoom * cells.cellSize();
    const auto          placed = [&](double x, double y, double w, double h) {
        return QRectF(at.left() + x * zoom, at.top() + y * zoom, w * zoom, h * zoom);
    };
    QPainter painter(this);
    painter.setClipRect(at);
    painter.fillRect(at, QColor::fromRgb(kEmptyCell));
    painter.setRenderHint(QPainter::SmoothPixmapTransform, wide < 1);
    painter.drawImage(placed(0, 0, cells.width() * cells.cellSize(), cells.height() * cells.cellSize()),
                      imageOf(cells.colours));
    if (wide >= kLevelGridFrom) {
        painter.setPen(QColor(255, 255, 255, 46));
        for (int x = 1; x < cells.width(); ++x)
            painter.drawLine(QPointF(at.left() + x * wide, at.top()), QPointF(at.left() + x * wide, at.bottom()));
        for (int y = 1; y < cells.height(); ++y)
            painter.drawLine(QPointF(at.left(), at.top() + y * wide), QPointF(at.right(), at.top() + y * wide));
    }
    const bool writes = wide >= kLevelValuesFrom;
    if (writes) {
        QFont small = font();
        small.setPixelSize(static_cast<int>(std::clamp(wide / 3.6, 8.0, 13.0)));
        painter.setFont(small);
    }
    for (int y = 0; y < cells.height() && wide >= kLevelGridFrom; ++y) {
        for (int x = 0; x < cells.width(); ++x) {
            const QRectF cell = placed(x * cells.cellSize(), y * cells.cellSize(), cells.cellSize(), cells.cellSize());
            if (cells.isStored && cells.lags.at(x, y) != 0) {  // a small corner: this cell is not up to date
                const double side = std::min(6.0, wide / 3);
                painter.setPen(Qt::NoPen);
                painter.setBrush(QColor(255, 255, 255, 190));
                painter.drawPolygon(
                    QPolygonF{cell.topRight(), cell.topRight() - QPointF(side, 0), cell.topRight() + QPointF(0, side)});
            }
            if (!writes) continue;
            painter.setPen(qGray(cells.colours.at(x, y)) < 120 ? Qt::white : Qt::black);
            painter.drawText(cell.intersected(at), Qt::AlignCenter,
                             cellText(cells.farthest.at(x, y), m_step->pyramid.empty));
        }
    }

    const HierarchyState& hierarchy = *m_step->state.hierarchy;
    painter.setBrush(Qt::NoBrush);
    if (hierarchy.query) {
        const PixelBox& box = hierarchy.query->box;
        if (hierarchy.query->level == m_level) {  // the cells that answered
            const PixelBox asked = cellsUnder(box, m_level);
            QColor         tint  = theme.now;
            tint.setAlpha(70);
            painter.fillRect(placed(asked.x0 * cells.cellSize(), asked.y0 * cells.cellSize(),
                                    (asked.x1 - asked.x0) * cells.cellSize(), (asked.y1 - asked.y0) * cells.cellSize()),
                             tint);
        }
        painter.setPen(QPen(theme.now, 1.5, Qt::DashLine));
        painter.drawRect(placed(box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0));
    }
    if (hierarchy.update && hierarchy.update->level == m_level) {
        painter.setPen(QPen(theme.now, 2));
        painter.drawRect(placed(hierarchy.update->x * cells.cellSize(), hierarchy.update->y * cells.cellSize(),
                                cells.cellSize(), cells.cellSize()));
    }
    if (m_picked && QRect(0, 0, finest.width(), finest.height()).contains(*m_picked)) {
        const double size = cells.cellSize();
        const QRectF cell =
            placed(m_picked->x() / cells.cellSize() * size, m_picked->y() / cells.cellSize() * size, size, size);
        const QPointF centre = cell.center();
        const double  least  = 8;
        const QRectF  ring =
            cell.width() >= least ? cell : QRectF(centre.x() - least / 2, centre.y() - least / 2, least, least);
        painter.setPen(QPen(Qt::white, 3));
        painter.drawRect(ring);
        painter.setPen(QPen(theme.picked, 1.5));
        painter.drawRect(ring);
    }
}

void LevelView::mousePressEvent(QMouseEvent* event)
{
    if (const auto pixel = pixelAt(event->position())) emit picked(*pixel);
}

bool LevelView::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help  = static_cast<QHelpEvent*>(event);
    const auto  pixel = pixelAt(help->pos());
    if (!pixel) {
        QToolTip::hideText();
        return true;
    }
    const int x = pixel->x() / level().cellSize(), y = pixel->y() / level().cellSize();
    QString   text = tr("Cell (%1, %2) of level %3: %4")
                       .arg(x)
                       .arg(y)
                       .arg(m_level)
                       .arg(cellDepth(level().farthest.at(x, y), m_step->pyramid.empty));
    if (level().isStored && level().lags.at(x, y) != 0)
        text += '\n' + tr("It lags behind its pixels, which are nearer by now.");
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

}  // namespace zscope::ui
