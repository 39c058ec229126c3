// SPDX-License-Identifier: GPL-3.0-or-later
// The card in the other corner of the frame view while it shows depths: their
// histogram, and the two ends of the range as handles. Arrow keys move the handle that was moved last, Shift finer; the
// automatic range is one button away.
#pragma once

#include <QFrame>

#include "ui/session/session.h"

class QToolButton;

namespace zscope::ui {

/// Between depths and the bar's width, on the scale of its histogram.
struct RangeScale {
    DepthRange whole;

    double partOf(float depth) const { return zscope::partOf(depth, whole); }
    float  depthAt(double part) const;
};

class RangeBar final : public QFrame {
    Q_OBJECT

public:
    explicit RangeBar(Session& session, QWidget* parent = nullptr);

    /// Hides itself unless the picture shows depths.
    void  present(const Snapshot& shown);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    enum class End { Farthest, Nearest };

    QRect bars() const;  // where the histogram lies
    void  moveTo(End end, double part);

    Session&     m_session;
    DepthSpread  m_spread;
    End          m_end = End::Farthest;
    QToolButton *m_fit, *m_log;
};

}  // namespace zscope::ui
