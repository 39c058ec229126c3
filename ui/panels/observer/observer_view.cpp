// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/observer/observer_view.h"

#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "ui/session/engine.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr double kOrbitPerSize = 3.2;   // radians per height of the view
constexpr double kTurnStep     = 0.12;  // radians per arrow key
constexpr double kWheelStep    = 1.15;
constexpr double kClickReach   = 4;  // logical pixels a click may wander
constexpr int    kThreads      = 1;  // the picture in the middle has the others

}  // namespace

ObserverView::ObserverView(QWidget* parent) : QWidget(parent), m_worker(std::make_unique<Worker>())
{
    setFocusPolicy(Qt::StrongFocus);
    setProperty("ownsArrows", true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    spoken(*this, [this] {
        setAccessibleName(tr("The hierarchy from outside"));
        setAccessibleDescription(
            tr("Drag orbits, the middle button pans, the wheel comes closer, arrow keys turn, a click selects a node"));
    });
}

ObserverView::~ObserverView() = default;

void ObserverView::present(std::shared_ptr<const ShownStep> step, std::shared_ptr<const LoadedScene> scene,
                           int selected)
{
    const bool isSame = step == m_step && selected == m_selected;
    if (scene != m_scene) m_control.reset();
    m_step     = std::move(step);
    m_scene    = std::move(scene);
    m_selected = selected;
    if (!isSame) request();
}

void ObserverView::setBoxes(const VerdictSet& boxes)
{
    m_boxes = boxes;
    request();
}

void ObserverView::resetView()
{
    m_control.reset();
    request();
}

void ObserverView::request()
{
    if (!isVisible()) return;
    if (!m_step || !m_step->state.hierarchy || !m_scene) {
        m_worker->cancel();
        m_observer.reset();
        m_picture = {};
        update();
        return;
    }
    const QSize size = (QSizeF(this->size()) * devicePixelRatioF()).toSize();
    if (size.isEmpty()) return;
    m_worker->post(
        Worker::Slot::Draw,
        [this, step = m_step, scene = m_scene, control = m_control, boxes = m_boxes, selected = m_selected, size,
         known = m_observer, knownStep = m_observer ? m_observedStep : nullptr](const std::atomic<bool>& cancel) {
            std::shared_ptr<const OutsideView> observer = known;
            if (!observer || knownStep != step) {
                auto made = OutsideView::make(scene->prepared, step->camera, *step->state.hierarchy);
                if (!made) return;
                observer = *made;
            }
            Camera from = observer->firstView(size.width(), size.height());
            if (control) {
                ViewRequest base;
                base.verticalFov = 40;
                base.near        = from.near;
                base.far         = from.far;
                base.width       = size.width();
                base.height      = size.height();
                const auto moved = makeCamera(control->view(base), observer->bounds());
                if (!moved) return;
                from = *moved;
            }
            auto picture = observer->draw(from, boxes, selected, kThreads, &cancel);
            if (!picture || cancel) return;
            m_worker->deliver([this, observer, step, from, picture = std::move(picture).value()]() mutable {
                m_observer     = observer;
                m_observedStep = step;
                m_camera       = from;
                m_picture      = std::move(picture);
                update();
                emit drawn();
            });
        });
}

void ObserverView::move(const std::function<void(CameraControl&)>& how)
{
    if (!m_observer) return;
    CameraControl control = m_control ? *m_control : CameraControl::of(m_camera, m_observer->bounds());
    how(control);
    m_control = control;
    request();
}

int ObserverView::nodeAt(const QPointF& place) const
{
    const QPoint at = (place * devicePixelRatioF()).toPoint();
    if (at.x() < 0 || at.y() < 0 || at.x() >= m_picture.nodes.width() || at.y() >= m_picture.nodes.height()) return -1;
    return m_picture.nodes.at(at.x(), at.y());
}

void ObserverView::paintEvent(QPaintEvent*)
{
    const Theme& theme = themeOf(palette());
    QPainter     painter(this);
    painter.fillRect(rect(), theme.canvas);
    const QImage image = imageOf(m_picture.colours);
    if (!image.isNull()) painter.drawImage(rect(), image);
    if (hasFocus()) {
        painter.setPen(theme.picked);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void ObserverView::resizeEvent(QResizeEvent*) { request(); }

void ObserverView::showEvent(QShowEvent*) { request(); }

void ObserverView::mousePressEvent(QMouseEvent* event) { m_pressed = m_last = event->position(); }

void ObserverView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF moved = event->position() - m_last;
    m_last              = event->position();
    if ((m_last - m_pressed).manhattanLength() <= kClickReach) return;
    const double size = std::max(height(), 1);
    if (event->buttons() & Qt::LeftButton)
        move([&](CameraControl& camera) {
            camera.orbit(-moved.x() / size * kOrbitPerSize, -moved.y() / size * kOrbitPerSize);
        });
    else if (event->buttons() & (Qt::MiddleButton | Qt::RightButton))
        move([&](CameraControl& camera) { camera.pan(-moved.x() / size, moved.y() / size, m_camera.focal); });
}

void ObserverView::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || (event->position() - m_pressed).manhattanLength() > kClickReach) return;
    emit picked(nodeAt(event->position()));
}

void ObserverView::wheelEvent(QWheelEvent* event)
{
    const double notches = event->angleDelta().y() / 120.0;
    if (notches == 0) return;
    move([&](CameraControl& camera) { camera.dolly(std::pow(kWheelStep, -notches)); });
    event->accept();
}

void ObserverView::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
        case Qt::Key_Left:
            return move([](CameraControl& camera) { camera.orbit(kTurnStep, 0); });
        case Qt::Key_Right:
            return move([](CameraControl& camera) { camera.orbit(-kTurnStep, 0); });
        case Qt::Key_Up:
            return move([](CameraControl& camera) { camera.orbit(0, -kTurnStep); });
        case Qt::Key_Down:
            return move([](CameraControl& camera) { camera.orbit(0, kTurnStep); });
        case Qt::Key_Plus:
            return move([](CameraControl& camera) { camera.dolly(1 / kWheelStep); });
        case Qt::Key_Minus:
            return move([](CameraControl& camera) { camera.dolly(kWheelStep); });
        default:
            QWidget::keyPressEvent(event);
    }
}

}  // namespace zscope::ui
