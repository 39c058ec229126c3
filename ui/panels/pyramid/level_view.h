// SPDX-License-Identifier: GPL-3.0-or-later
// One level of the pyramid, large: its cells with their values where they
// fit, what was asked, what was written, and the cell over the picked pixel. A click picks a pixel of the cell.
#pragma once

#include <QWidget>

#include "ui/session/snapshot.h"

namespace zscope::ui {

class LevelView final : public QWidget {
    Q_OBJECT

public:
    explicit LevelView(QWidget* parent = nullptr);

    void  present(const Snapshot& shown);
    QSize sizeHint() const override { return {400, 190}; }
    QSize minimumSizeHint() const override { return {160, 96}; }

signals:
    void picked(const QPoint& pixel);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    const PyramidLevel&   level() const { return m_step->pyramid.levels[static_cast<std::size_t>(m_level)]; }
    QRectF                room() const;  // where the picture lies in the widget
    std::optional<QPoint> pixelAt(const QPointF& place) const;

    std::shared_ptr<const ShownStep> m_step;  // nothing: there is no level to show
    int                              m_level = -1;
    std::optional<QPoint>            m_picked;
};

}  // namespace zscope::ui
