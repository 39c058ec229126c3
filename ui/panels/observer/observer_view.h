// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of the observer: the hierarchy from outside, drawn by our own
// renderer on a thread of its own. Left drag orbits, middle drag pans, the wheel dollies, arrow keys turn; a click
// selects the node that is seen there.
//
// Requests   the newest wins; nothing is drawn while the view cannot be seen
#pragma once

#include <functional>
#include <memory>

#include <QImage>
#include <QWidget>

#include "ui/camera/camera_control.h"
#include "ui/session/snapshot.h"
#include "ui/session/worker.h"

namespace zscope::ui {

class ObserverView final : public QWidget {
    Q_OBJECT

public:
    explicit ObserverView(QWidget* parent = nullptr);
    ~ObserverView() override;

    /// `step` is what is observed, of `scene`; nothing: there is nothing to observe.
    void present(std::shared_ptr<const ShownStep> step, std::shared_ptr<const LoadedScene> scene, int selected);
    void setBoxes(const VerdictSet& boxes);
    /// Back to where the whole scene and the culling view are seen.
    void resetView();

    bool                                      isIdle() const { return !m_worker->isBusy(); }
    const std::shared_ptr<const OutsideView>& observer() const { return m_observer; }
    /// The row of the node that is seen at a place of the widget; -1: none.
    int nodeAt(const QPointF& place) const;

    QSize sizeHint() const override { return {400, 260}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    void picked(int node);
    /// Another picture is there.
    void drawn();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void request();
    void move(const std::function<void(CameraControl&)>& how);

    std::shared_ptr<const ShownStep>   m_step;
    std::shared_ptr<const LoadedScene> m_scene;
    int                                m_selected = -1;
    VerdictSet                         m_boxes{};
    std::optional<CameraControl>       m_control;   // once the user has moved
    std::shared_ptr<const OutsideView> m_observer;  // of the picture on show, made from
    std::shared_ptr<const ShownStep>   m_observedStep;
    Camera                             m_camera;  // likewise
    ObserverPicture                    m_picture;
    QPointF                            m_pressed, m_last;
    std::unique_ptr<Worker>            m_worker;  // last: stops before anything else goes
};

}  // namespace zscope::ui
