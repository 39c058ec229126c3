// SPDX-License-Identifier: GPL-3.0-or-later
// Where the picture lies in the frame view: zoom, pan, and the way from a place in the view to a pixel and back.
// No widget, so that a test reaches it.
//
// View       device pixels of the widget, (0, 0) its top-left corner
// Picture    pixels of the picture, pixel (x, y) is the square [x, x+1) x [y, y+1)
// Promise    the place under the anchor of a zoom stays under it; some of the picture always stays in view
#pragma once

#include <optional>

#include <QPoint>
#include <QPointF>
#include <QRect>
#include <QRectF>
#include <QSize>
#include <QSizeF>

namespace zscope::ui {

class ViewTransform {
public:
    static constexpr double kSmallestZoom = 1.0 / 64;
    static constexpr double kLargestZoom  = 256;
    static constexpr double kKeepInView   = 48;  // device pixels of the picture that cannot be panned away

    /// A fitted view stays fitted; any other keeps the picture's point at its centre.
    void setArea(const QSizeF& area);
    /// The same place stays in view unless the size changes, which fits the picture again.
    void setPicture(const QSize& picture);

    void fit();
    void oneToOne();
    void zoomAt(const QPointF& anchor, double factor);
    void panBy(const QPointF& device);
    /// Moves the picture only as far as needed to have the pixel well inside the view.
    void reveal(const QPoint& pixel);

    double zoom() const { return m_zoom; }  // device pixels per picture pixel
    bool   isFitted() const { return m_fitted; }
    QSize  picture() const { return m_picture; }
    QSizeF area() const { return m_area; }  // of the view, device pixels

    QPointF               toPicture(const QPointF& view) const { return (view - m_origin) / m_zoom; }
    QPointF               toView(const QPointF& picture) const { return picture * m_zoom + m_origin; }
    QRectF                toView(const QRectF& picture) const;
    std::optional<QPoint> pixelAt(const QPointF& view) const;  // nothing outside the picture
    QRect                 visiblePixels() const;               // empty when there is no picture

private:
    void keepInView();

    QSizeF  m_area{1, 1};
    QSize   m_picture;
    QPointF m_origin;  // of the picture's top-left corner, device pixels
    double  m_zoom   = 1;
    bool    m_fitted = true;  // follows the size of the view until the user zooms or pans
};

}  // namespace zscope::ui
