// SPDX-License-Identifier: GPL-3.0-or-later
// Speed against error, live: a point per run, the set that nothing beats in both joined by a line, a band for zero.
//
// Data       setPoints() lays everything out; painting only shows what was laid out. Sizes, palette and language
//            likewise
// Shapes     a mark's shape says what its picture was; colour only repeats it. The point that is current has a ring,
//            the one that is in the window a square
// Keys       Left and Right walk by time, Up and Down by error, Home and End to the fastest and slowest; Enter loads
// Alone      needs a QApplication and no session: a report draws the same chart without a window (toPixmap)
#pragma once

#include <optional>
#include <vector>

#include <qcustomplot.h>

#include "ui/charts/chart_scales.h"
#include "ui/charts/label_places.h"
#include "ui/charts/speed_error_points.h"

namespace zscope::ui {

class SpeedErrorChart final : public QCustomPlot {
    Q_OBJECT

public:
    explicit SpeedErrorChart(QWidget* parent = nullptr);

    void setPoints(std::vector<SpeedErrorPoint> points, ErrorMeasure measure);
    /// The point that is looked at, and the one whose pipeline the window shows; indices of the points, or nothing.
    void setCurrent(std::optional<std::size_t> point);
    void setLoaded(std::optional<std::size_t> point);

    const std::vector<SpeedErrorPoint>& points() const { return m_points; }
    std::optional<std::size_t>          current() const { return m_current; }
    /// Where a point is in the widget, in logical pixels.
    QPointF placeOf(std::size_t point) const;
    /// Where the names are; nothing: there was no room.
    const std::vector<std::optional<LabelPlace>>& labels() const { return m_labels; }
    /// The error scale of what is shown.
    const ErrorScale& errorScale() const { return m_errors; }

    QSize sizeHint() const override { return {420, 300}; }
    QSize minimumSizeHint() const override { return {260, 220}; }

signals:
    void walked(std::size_t point);
    void chosen(std::size_t point);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    void                       layOut();
    void                       dress();
    void                       scaleAxes();
    void                       addPoints();
    void                       addRings();
    void                       addLabels();  // once the axes have their places
    void                       describe();
    void                       walk(int by, bool byError);
    std::optional<std::size_t> pointNear(const QPointF& place) const;

    std::vector<SpeedErrorPoint>           m_points;
    ErrorMeasure                           m_measure = ErrorMeasure::WrongPixels;
    std::optional<std::size_t>             m_current, m_loaded;
    ErrorScale                             m_errors;
    std::vector<std::optional<LabelPlace>> m_labels;
    std::vector<QCPAbstractItem*>          m_labelItems;
    QPointer<QCPTextElement>               m_legend;
    std::optional<QPointF>                 m_pressed;
    bool                                   m_placesLabels = false;
};

}  // namespace zscope::ui
