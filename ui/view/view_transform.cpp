// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/view_transform.h"

#include <algorithm>
#include <cmath>

namespace zscope::ui {

void ViewTransform::setArea(const QSizeF& area)
{
    const QPointF before(m_area.width() / 2, m_area.height() / 2);
    m_area = {std::max(area.width(), 1.0), std::max(area.height(), 1.0)};
    if (m_fitted) return fit();
    m_origin += QPointF(m_area.width() / 2, m_area.height() / 2) - before;
    keepInView();
}

void ViewTransform::setPicture(const QSize& picture)
{
    if (picture == m_picture) return;
    m_picture = picture;
    fit();
}

void ViewTransform::fit()
{
    m_fitted = true;
    if (m_picture.isEmpty()) return;
    m_zoom   = std::clamp(std::min(m_area.width() / m_picture.width(), m_area.height() / m_picture.height()),
                          kSmallestZoom, kLargestZoom);
    m_origin = {std::round((m_area.width() - m_zoom * m_picture.width()) / 2),
                std::round((m_area.height() - m_zoom * m_picture.height()) / 2)};
}

void ViewTransform::oneToOne()
{
    const QPointF centre(m_area.width() / 2, m_area.height() / 2);
    zoomAt(centre, 1 / m_zoom);
    m_zoom   = 1;  // 1 / zoom * zoom need not be 1
    m_origin = {std::round(m_origin.x()), std::round(m_origin.y())};
}

void ViewTransform::zoomAt(const QPointF& anchor, double factor)
{
    const QPointF held = toPicture(anchor);
    m_fitted           = false;
    m_zoom             = std::clamp(m_zoom * factor, kSmallestZoom, kLargestZoom);
    m_origin           = anchor - held * m_zoom;
    keepInView();
}

void ViewTransform::panBy(const QPointF& device)
{
    m_fitted = false;
    m_origin += device;
    keepInView();
}

void ViewTransform::reveal(const QPoint& pixel)
{
    const double  margin = std::min({kKeepInView, m_area.width() / 4, m_area.height() / 4});
    const QPointF at     = toView(QPointF(pixel) + QPointF(0.5, 0.5));
    const QPointF inside(std::clamp(at.x(), margin, m_area.width() - margin),
                         std::clamp(at.y(), margin, m_area.height() - margin));
    if (inside != at && !m_fitted) panBy(inside - at);
}

QRectF ViewTransform::toView(const QRectF& picture) const
{
    return {toView(picture.topLeft()), toView(picture.bottomRight())};
}

std::optional<QPoint> ViewTransform::pixelAt(const QPointF& view) const
{
    const QPointF at = toPicture(view);
    if (!(at.x() >= 0 && at.y() >= 0 && at.x() < m_picture.width() && at.y() < m_picture.height())) return {};
    return QPoint(static_cast<int>(at.x()), static_cast<int>(at.y()));
}

QRect ViewTransform::visiblePixels() const
{
    const QRectF seen(toPicture(QPointF(0, 0)), toPicture(QPointF(m_area.width(), m_area.height())));
    return seen.toAlignedRect().intersected(QRect(QPoint(0, 0), m_picture));
}

void ViewTransform::keepInView()
{
    const double width  = m_zoom * m_picture.width();
    const double height = m_zoom * m_picture.height();
    const auto   keep   = [](double origin, double size, double area) {
        const double shown = std::min({kKeepInView, size, area});
        return std::clamp(origin, shown - size, area - shown);
    };
    m_origin = {keep(m_origin.x(), width, m_area.width()), keep(m_origin.y(), height, m_area.height())};
}

}  // namespace zscope::ui
