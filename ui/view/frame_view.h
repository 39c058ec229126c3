// SPDX-License-Identifier: GPL-3.0-or-later
// The picture: the frame, or the state after the step, with zoom, pan, pick and camera by mouse and keys. Painting
// only copies what was made before: the picture by the worker, the overlay when something changed.
//
// Inspect    wheel zooms to the cursor, drag pans, click or right click picks
// Camera     left drag orbits, middle drag pans, wheel dollies, right drag looks around, WASD and QE fly
// Alt        held, the mouse is that of the camera tool
#pragma once

#include <QElapsedTimer>
#include <QSet>
#include <QTimer>
#include <QWidget>

#include "ui/session/session.h"
#include "ui/view/overlay.h"
#include "ui/view/view_transform.h"

namespace zscope::ui {

class Magnifier;
class RangeBar;

enum class Tool { Inspect, Camera };

class FrameView final : public QWidget {
    Q_OBJECT

public:
    explicit FrameView(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& now, Changes what);

    Tool tool() const { return m_tool; }
    void setTool(Tool tool);

    void fit();
    void oneToOne();
    void zoomBy(double factor);
    void reveal(const QPoint& pixel);

    /// The picture on show at its own size, as core made it; with `decorated` the overlay drawn into it.
    QImage               picture(bool decorated) const;
    const ViewTransform& view() const { return m_view; }
    /// What stands over the picture: in which state it is, and what is laid over it.
    QStringList chips() const;

    QSize minimumSizeHint() const override { return {320, 200}; }
    QSize sizeHint() const override { return {960, 640}; }

signals:
    void toolChanged(zscope::ui::Tool tool);
    void viewChanged();
    /// The pixel under the cursor; nothing when it is outside the picture.
    void hovered(const std::optional<QPoint>& pixel);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    enum class Drag { None, PanPicture, Orbit, PanCamera, Look, Wipe };
    static constexpr int kPaneGap = 4;  // logical pixels between A and B

    QPointF device(const QPointF& logical) const { return logical * devicePixelRatioF(); }
    /// A place in the view, of the pane that it lies in: with A and B side by side there are two that move together.
    QPointF inPane(const QPointF& logical) const;
    bool    isInOtherPane(const QPointF& logical) const { return isBeside() && logical.x() >= otherPaneAt(); }
    bool    isBeside() const { return m_shown.compare.seen() == CompareShow::Beside && !m_other.isNull(); }
    int     paneWidth() const { return isBeside() ? (width() - kPaneGap) / 2 : width(); }
    int     otherPaneAt() const { return paneWidth() + kPaneGap; }
    std::optional<QPoint> pixelAt(const QPointF& logical) const;
    void                  placePanes();
    void paintPane(QPainter& painter, const Snapshot& shown, const QImage& picture, const Overlay& overlay) const;
    void showPicture();
    void placeMagnifier();
    void viewMoved();
    void moveOn();  // one tick of flying
    void paintPicture(QPainter& painter, const QImage& picture) const;
    void paintWipe(QPainter& painter) const;
    /// Where the wipe lies; logical, nothing while there is none.
    std::optional<double> wipeAt() const;
    void                  paintGrid(QPainter& painter) const;
    void                  paintValues(QPainter& painter, const Snapshot& shown, const QImage& picture) const;
    void                  paintChips(QPainter& painter) const;
    void                  paintLegend(QPainter& painter) const;
    void                  paintHint(QPainter& painter) const;
    bool                  usesCamera(Qt::KeyboardModifiers modifiers) const;

    Session&              m_session;
    Snapshot              m_shown;
    QImage                m_picture;  // borrows from m_shown, as does the next
    QImage                m_other;    // B, to the right of the wipe or in its own pane; null: neither is there
    Overlay               m_overlay;
    ViewTransform         m_view;
    Tool                  m_tool = Tool::Inspect;
    Drag                  m_drag = Drag::None;
    QPointF               m_pressed, m_last;  // logical
    std::optional<QPoint> m_hovered;
    bool                  m_hoversOther = false;  // in B's pane
    QSet<int>             m_held;                 // keys that fly
    QTimer                m_flight;
    QElapsedTimer         m_sinceTick;
    Magnifier*            m_magnifier;
    RangeBar*             m_range;
};

}  // namespace zscope::ui
