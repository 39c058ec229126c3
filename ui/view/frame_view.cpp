// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/frame_view.h"

#include <algorithm>
#include <cmath>

#include <QFontDatabase>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include "ui/predict/predictions.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/view/magnifier.h"
#include "ui/view/range_bar.h"

namespace zscope::ui {
namespace {

constexpr double kGridFrom     = 10;    // device pixels per pixel from which the grid is drawn
constexpr double kValuesFrom   = 52;    // and the numbers, times the screen's scale
constexpr double kClickReach   = 4;     // logical pixels a click may wander
constexpr double kWipeReach    = 8;     // logical pixels from the wipe that still are its handle
constexpr double kWheelStep    = 1.25;  // zoom per notch
constexpr double kOrbitPerSize = 3.2;   // radians per height of the view
constexpr double kFlyPerSecond = 0.6;   // scene units
constexpr double kFlyFaster    = 4;     // with Shift
constexpr double kChipsTop = 1.5 * kStep, kChipsHigh = 3 * kStep;

}  // namespace

FrameView::FrameView(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_magnifier(new Magnifier(this)), m_range(new RangeBar(session, this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_flight.setInterval(16);
    connect(&m_flight, &QTimer::timeout, this, &FrameView::moveOn);
    spoken(*this, [this] {
        setAccessibleName(tr("Frame view"));
        setAccessibleDescription(tr("The picture of the chosen algorithm at the chosen step"));
    });
}

void FrameView::present(const Snapshot& now, Changes what)
{
    const auto before = m_session.predictions().before(now);  // while a question is open
    m_shown           = before ? *before : now;
    if (what & (Change::Picture | Change::Scene | Change::Layers | Change::Compare)) showPicture();
    if ((what & Change::Compare) || ((what & Change::Busy) && m_picture.isNull())) update();
    if (what & (Change::Picture | Change::Selection | Change::Scene | Change::Layers | Change::Marks)) {
        m_overlay = overlayOf(m_shown, m_shown.layers);
        placeMagnifier();
        m_range->present(m_shown);
        m_range->move(2 * kStep, height() - m_range->height() - 2 * kStep);
        update();
    }
}

void FrameView::showPicture()
{
    const Grid<std::uint32_t>* colours = m_shown.colours();
    const Grid<std::uint32_t>* other   = m_shown.coloursOfOther();
    const bool                 ghosts  = m_shown.showsStep && m_shown.layers.ghost;
    if (!colours)
        m_picture = {};
    else if (ghosts && !m_shown.step->ghosted.isNull())
        m_picture = m_shown.step->ghosted;
    else
        m_picture = imageOf(*colours);
    m_other = {};
    if (colours && other && other->width() == colours->width() && other->height() == colours->height()) {
        const ShownStep*  step    = m_shown.compare.isLinked ? m_shown.compare.step.get() : nullptr;
        const QImage      ofOther = ghosts && step && !step->ghosted.isNull() ? step->ghosted : imageOf(*other);
        const Comparison* result  = m_shown.compare.result.get();
        switch (m_shown.compare.seen()) {
            case CompareShow::A:
                break;
            case CompareShow::B:
                m_picture = ofOther;
                break;
            case CompareShow::Wipe:
            case CompareShow::Beside:
                m_other = ofOther;
                break;
            case CompareShow::Difference:
                if (result && result->difference.heat.width() == colours->width()
                    && result->difference.heat.height() == colours->height())
                    m_picture = imageOf(result->difference.heat);
                break;
        }
    }
    if (!m_picture.isNull() && m_picture.size() != m_view.picture()) {
        m_view.setPicture(m_picture.size());
        emit viewChanged();
    }
    placePanes();
}

void FrameView::placePanes()
{
    const QSizeF area = QSizeF(paneWidth(), height()) * devicePixelRatioF();
    if (area == m_view.area()) return;
    m_view.setArea(area);
    update();
    emit viewChanged();
}

std::optional<QPoint> FrameView::pixelAt(const QPointF& logical) const
{
    const bool isBetween = isBeside() && logical.x() >= paneWidth() && logical.x() < otherPaneAt();
    return isBetween ? std::nullopt : m_view.pixelAt(inPane(logical));
}

QPointF FrameView::inPane(const QPointF& logical) const
{
    return device(isInOtherPane(logical) ? logical - QPointF(otherPaneAt(), 0) : logical);
}

void FrameView::setTool(Tool tool)
{
    m_held.clear();
    m_flight.stop();
    setCursor(tool == Tool::Camera ? Qt::SizeAllCursor : Qt::ArrowCursor);
    if (tool == m_tool) return;
    m_tool = tool;
    update();
    emit toolChanged(tool);
}

void FrameView::fit()
{
    m_view.fit();
    viewMoved();
}

void FrameView::oneToOne()
{
    m_view.oneToOne();
    viewMoved();
}

void FrameView::zoomBy(double factor)
{
    m_view.zoomAt(device(QPointF(paneWidth() / 2.0, height() / 2.0)), factor);
    viewMoved();
}

void FrameView::reveal(const QPoint& pixel)
{
    m_view.reveal(pixel);
    viewMoved();
}

void FrameView::viewMoved()
{
    update();
    emit viewChanged();
}

QImage FrameView::picture(bool decorated) const
{
    const Grid<std::uint32_t>* colours = m_shown.colours();
    if (!colours) return {};
    if (!decorated) return imageOf(*colours).copy();
    QImage        image = m_picture.copy();
    ViewTransform plain;
    plain.setPicture(image.size());
    plain.setArea(image.size());
    QPainter painter(&image);
    paintOverlay(painter, m_overlay, plain, themeOf(palette()), 1);
    return image;
}

void FrameView::placeMagnifier()
{
    const std::optional<QPoint> pixel =
        m_shown.layers.magnifier ? m_shown.picked ? m_shown.picked : m_hovered : std::nullopt;
    const bool    isBesideOther = isBeside() && !m_shown.picked && m_hoversOther;
    const bool    isOfOther     = isBesideOther || (pixel && isBeyondWipe(m_shown, *pixel));
    const QString whose         = m_other.isNull() ? QString() : isOfOther ? QStringLiteral("B") : QStringLiteral("A");
    m_magnifier->present(isBesideOther ? asOther(m_shown) : m_shown,
                         isOfOther && !m_other.isNull() ? m_other : m_picture, pixel, whose);
    const QSize size = m_magnifier->size();
    QPoint      at(width() - size.width() - 2 * kStep, height() - size.height() - 2 * kStep);
    if (QRect(at, size).adjusted(-2 * kStep, -2 * kStep, 2 * kStep, 2 * kStep).contains(m_last.toPoint())
        && underMouse())
        // out of the way of the cursor, and of what says what is shown
        at.setY(static_cast<int>(kChipsTop + kChipsHigh) + kStep);
    m_magnifier->move(at);
}

bool FrameView::usesCamera(Qt::KeyboardModifiers modifiers) const
{
    return m_tool == Tool::Camera || (modifiers & Qt::AltModifier);
}

// Painting ----------------------------------------------------------------------------------------------------------

void FrameView::paintEvent(QPaintEvent*)
{
    const Theme& theme = themeOf(palette());
    const double scale = devicePixelRatioF();
    QPainter     painter(this);
    painter.fillRect(rect(), theme.canvas);
    if (m_picture.isNull()) {
        paintHint(painter);
        return;
    }
    painter.save();
    painter.scale(1 / scale, 1 / scale);  // from here in device pixels
    if (isBeside()) {
        const QRectF pane(0, 0, paneWidth() * scale, height() * scale);
        painter.setClipRect(pane);
        paintPane(painter, m_shown, m_picture, m_overlay);
        painter.setClipping(false);
        painter.translate(otherPaneAt() * scale, 0);
        painter.setClipRect(pane);
        Overlay ofOther;  // edges, nodes and questions are those of A's step
        ofOther.picture = m_overlay.picture;
        ofOther.pick    = m_overlay.pick;
        paintPane(painter, asOther(m_shown), m_other, ofOther);
    } else {
        paintPane(painter, m_shown, m_picture, m_overlay);
    }
    painter.restore();
    if (isBeside()) painter.fillRect(QRect(paneWidth(), 0, kPaneGap, height()), theme.border);
    paintWipe(painter);
    paintChips(painter);
    paintLegend(painter);
}

void FrameView::paintPane(QPainter& painter, const Snapshot& shown, const QImage& picture, const Overlay& overlay) const
{
    const double scale = devicePixelRatioF();
    if (wipeAt()) {
        const double at = *wipeAt() * scale;
        painter.save();
        painter.setClipRect(QRectF(0, 0, at, height() * scale));
        paintPicture(painter, picture);
        painter.setClipRect(QRectF(at, 0, width() * scale - at, height() * scale));
        paintPicture(painter, m_other);
        painter.restore();
    } else {
        paintPicture(painter, picture);
    }
    if (shown.layers.grid && m_view.zoom() >= kGridFrom) paintGrid(painter);
    if (shown.layers.grid && m_view.zoom() >= kValuesFrom * scale) paintValues(painter, shown, picture);
    paintOverlay(painter, overlay, m_view, themeOf(palette()), scale);
}

/// What the colours of over-rendering stand for.
void FrameView::paintLegend(QPainter& painter) const
{
    constexpr int kStripe = 14, kHigh = 12;
    if (!m_shown.look.layer->needsTests || m_shown.compare.seen() == CompareShow::Difference) return;
    const Theme&  theme = themeOf(palette());
    const QString from = QStringLiteral("1"), to = QStringLiteral("%1+").arg(kMostTests),
                  what = tr("depth tests per pixel");
    const int    left = fontMetrics().horizontalAdvance(from), right = fontMetrics().horizontalAdvance(to);
    const int    stripes = kMostTests * kStripe;
    const QRectF card(2 * kStep, height() - 6.5 * kStep,
                      std::max(left + right + stripes + 5 * kStep, fontMetrics().horizontalAdvance(what) + 3 * kStep),
                      4.5 * kStep);
    painter.setPen(theme.border);
    painter.setBrush(theme.card);
    painter.drawRoundedRect(card.adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.setPen(theme.softText);
    painter.drawText(card.adjusted(1.5 * kStep, 2, 0, 0), Qt::AlignLeft | Qt::AlignTop, what);
    const double y = card.bottom() - kHigh - 5;
    painter.drawText(QRectF(card.left() + 1.5 * kStep, y - 3, left, kHigh + 6), Qt::AlignCenter, from);
    for (int i = 0; i < kMostTests; ++i)
        painter.fillRect(QRectF(card.left() + 2 * kStep + left + i * kStripe, y, kStripe - 1, kHigh),
                         QColor::fromRgb(heatOfTests(static_cast<std::uint32_t>(i) + 1)));
    painter.drawText(QRectF(card.left() + 2.5 * kStep + left + stripes, y - 3, right, kHigh + 6), Qt::AlignCenter, to);
}

void FrameView::paintPicture(QPainter& painter, const QImage& picture) const
{
    painter.setRenderHint(QPainter::SmoothPixmapTransform, m_view.zoom() < 1);
    const QRect seen = m_view.visiblePixels();
    if (m_view.zoom() < 1)
        painter.drawImage(m_view.toView(QRectF(QPointF(0, 0), QSizeF(picture.size()))), picture);
    else
        painter.drawImage(m_view.toView(QRectF(seen)), picture, QRectF(seen));
}

std::optional<double> FrameView::wipeAt() const
{
    if (m_other.isNull() || isBeside()) return {};
    return m_view.toView(QPointF(m_shown.compare.wipe * m_picture.width(), 0)).x() / devicePixelRatioF();
}

void FrameView::paintWipe(QPainter& painter) const
{
    const auto at = wipeAt();
    if (!at) return;
    const Theme& theme = themeOf(palette());
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(QPen(Qt::white, 4));
    painter.drawLine(QPointF(*at, 0), QPointF(*at, height()));
    painter.setPen(QPen(Qt::black, 1.5));  // whatever the window's colours are: it lies on the picture
    painter.drawLine(QPointF(*at, 0), QPointF(*at, height()));
    const QRectF knob(*at - 2.25 * kStep, height() / 2.0 - 1.5 * kStep, 4.5 * kStep, 3 * kStep);
    painter.setPen(theme.border);
    painter.setBrush(theme.card);
    painter.drawRoundedRect(knob, knob.height() / 2, knob.height() / 2);
    painter.setPen(theme.text);
    painter.drawText(knob, Qt::AlignCenter, QStringLiteral("A | B"));
}

void FrameView::paintGrid(QPainter& painter) const
{
    const QRect seen = m_view.visiblePixels();
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(QColor(128, 128, 128, 70), 1));
    for (int x = seen.left(); x <= seen.right() + 1; ++x)
        painter.drawLine(m_view.toView(QPointF(x, seen.top())), m_view.toView(QPointF(x, seen.bottom() + 1)));
    for (int y = seen.top(); y <= seen.bottom() + 1; ++y)
        painter.drawLine(m_view.toView(QPointF(seen.left(), y)), m_view.toView(QPointF(seen.right() + 1, y)));
}

void FrameView::paintValues(QPainter& painter, const Snapshot& shown, const QImage& picture) const
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPixelSize(static_cast<int>(std::clamp(m_view.zoom() / 6.5, 8.0, 20.0 * devicePixelRatioF())));
    painter.setFont(font);
    const QRect seen = m_view.visiblePixels().intersected(picture.rect());
    for (int y = seen.top(); y <= seen.bottom(); ++y) {
        for (int x = seen.left(); x <= seen.right(); ++x) {
            const QString numbers = numbersAt(shown, {x, y});
            if (numbers.isEmpty()) continue;
            const bool isOther = isBeyondWipe(shown, {x, y}) && !m_other.isNull();
            painter.setPen(qGray((isOther ? m_other : picture).pixel(x, y)) < 128 ? Qt::white : Qt::black);
            painter.drawText(m_view.toView(QRectF(x, y, 1, 1)), Qt::AlignCenter, numbers);
        }
    }
}

QStringList FrameView::chips() const
{
    QStringList chips{m_shown.showsStep ? tr("Step") : tr("Finished picture")};
    if (!m_shown.look.isShaded()) chips << said(m_shown.look.layer->word);
    if (m_shown.compare.isOn()) {
        const QString a = QString::fromStdString(nameOf(m_shown.pipeline)), b = nameOfOther(m_shown.compare);
        switch (m_shown.compare.seen()) {
            case CompareShow::A:
                chips << tr("A  %1").arg(a);
                break;
            case CompareShow::B:
                chips << tr("B  %1").arg(b);
                break;
            case CompareShow::Wipe:
            case CompareShow::Beside:
                chips << tr("A  %1  |  B  %2").arg(a, b);
                break;
            case CompareShow::Difference: {
                const auto& result = m_shown.compare.result;
                chips << (result && result->difference.differing() == 0 ? tr("Difference  %1, %2: no pixel")
                                                                        : tr("Difference  %1, %2"))
                             .arg(a, b);
                break;
            }
        }
    }
    if (m_shown.showsStep && !m_overlay.edges.empty()) chips << tr("Active edges");
    if (m_overlay.boxesWanted > 0)
        chips << (m_overlay.boxesShown < m_overlay.boxesWanted
                      ? tr("%1 of %2 node boxes").arg(grouped(m_overlay.boxesShown), grouped(m_overlay.boxesWanted))
                      : counted(m_overlay.boxesShown, tr("1 node box"), tr("%1 node boxes")));
    if (m_overlay.cells) chips << tr("Pyramid, level %1").arg(m_overlay.cells->level);
    chips << tr("× %1").arg(decimal(m_view.zoom(), m_view.zoom() < 10 ? 2 : 0));
    if (m_tool == Tool::Camera) chips << tr("Camera");
    return chips;
}

void FrameView::paintChips(QPainter& painter) const
{
    const Theme& theme = themeOf(palette());
    painter.setRenderHint(QPainter::Antialiasing, true);
    int x = 2 * kStep;
    for (const QString& chip : chips()) {
        const QRectF at(x, kChipsTop, fontMetrics().horizontalAdvance(chip) + 3 * kStep, kChipsHigh);
        painter.setPen(theme.border);
        painter.setBrush(theme.card);
        painter.drawRoundedRect(at.adjusted(0.5, 0.5, -0.5, -0.5), at.height() / 2, at.height() / 2);
        painter.setPen(theme.text);
        painter.drawText(at, Qt::AlignCenter, chip);
        x += static_cast<int>(at.width()) + kStep;
    }
}

void FrameView::paintHint(QPainter& painter) const
{
    const Theme& theme = themeOf(palette());
    QFont        large = font();
    large.setPointSizeF(large.pointSizeF() * 1.5);
    const QRect upper(0, 0, width(), height() / 2), lower(0, height() / 2 + kStep, width(), height() / 2);
    painter.setPen(theme.text);
    painter.setFont(large);
    const bool isCancelled = m_shown.scene && m_shown.busy.isEmpty();
    painter.drawText(upper, Qt::AlignHCenter | Qt::AlignBottom,
                     !m_shown.busy.isEmpty() ? m_shown.busy
                     : isCancelled           ? tr("Nothing is drawn")
                                             : tr("Drop an OBJ file here"));
    if (m_shown.scene && !isCancelled) return;
    painter.setPen(theme.softText);
    painter.setFont(font());
    painter.drawText(lower, Qt::AlignHCenter | Qt::AlignTop,
                     isCancelled ? tr("The drawing was cancelled; the next step, or another algorithm, begins it again")
                                 : tr("or press Ctrl+O to open one, or choose an example in File ▸ Examples"));
}

void FrameView::resizeEvent(QResizeEvent*)
{
    placePanes();
    placeMagnifier();
    m_range->move(2 * kStep, height() - m_range->height() - 2 * kStep);
    emit viewChanged();
}

// Mouse -------------------------------------------------------------------------------------------------------------

void FrameView::wheelEvent(QWheelEvent* event)
{
    // With Alt held some systems turn a vertical wheel into a horizontal one.
    const QPoint turned  = event->angleDelta();
    const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
    if (notches == 0) return;
    const double factor = std::pow(kWheelStep, notches);
    if (usesCamera(event->modifiers())) {
        m_session.moveCamera([factor](CameraControl& camera) { camera.dolly(1 / std::sqrt(factor)); });
    } else {
        m_view.zoomAt(inPane(event->position()), factor);
        viewMoved();
    }
    event->accept();
}

void FrameView::mousePressEvent(QMouseEvent* event)
{
    m_pressed = m_last = event->position();
    const bool camera  = usesCamera(event->modifiers());
    const auto wipe    = wipeAt();
    if (event->button() == Qt::LeftButton && wipe && std::abs(event->position().x() - *wipe) <= kWipeReach) {
        m_drag = Drag::Wipe;
        return;
    }
    switch (event->button()) {
        case Qt::LeftButton:
            m_drag = camera ? Drag::Orbit : Drag::PanPicture;
            break;
        case Qt::MiddleButton:
            m_drag = camera ? Drag::PanCamera : Drag::PanPicture;
            break;
        case Qt::RightButton:
            if (camera)
                m_drag = Drag::Look;
            else
                m_session.pick(pixelAt(event->position()));
            break;
        default:
            return QWidget::mousePressEvent(event);
    }
}

void FrameView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF moved = event->position() - m_last;
    m_last              = event->position();
    const bool   isDrag = (m_last - m_pressed).manhattanLength() > kClickReach;
    const double size   = std::max(height(), 1);
    switch (m_drag) {
        case Drag::PanPicture:
            if (!isDrag) break;
            m_view.panBy(device(moved));
            viewMoved();
            break;
        case Drag::Orbit:
        case Drag::Look:
            m_session.moveCamera([&](CameraControl& camera) {
                const double aboutUp    = -moved.x() / size * kOrbitPerSize,
                             aboutRight = -moved.y() / size * kOrbitPerSize;
                if (m_drag == Drag::Orbit)
                    camera.orbit(aboutUp, aboutRight);
                else
                    camera.look(aboutUp, aboutRight);
            });
            break;
        case Drag::PanCamera:
            m_session.moveCamera([&](CameraControl& camera) {  // the point under the cursor stays under it
                const double pictureHeight = m_view.zoom() * m_view.picture().height() / devicePixelRatioF();
                camera.pan(-moved.x() / pictureHeight, moved.y() / pictureHeight, m_shown.camera.focal);
            });
            break;
        case Drag::Wipe:
            m_session.setWipe(m_view.toPicture(device(m_last)).x() / m_view.picture().width());
            break;
        case Drag::None:
            break;
    }
    if (m_drag == Drag::None) {  // the handle says that it can be dragged
        const auto wipe = wipeAt();
        const bool over = wipe && std::abs(m_last.x() - *wipe) <= kWipeReach;
        setCursor(over ? Qt::SplitHCursor : m_tool == Tool::Camera ? Qt::SizeAllCursor : Qt::ArrowCursor);
    }
    if (m_drag == Drag::None || m_drag == Drag::PanPicture) {
        const auto pixel = pixelAt(m_last);
        if (pixel != m_hovered || m_hoversOther != isInOtherPane(m_last)) {
            m_hovered     = pixel;
            m_hoversOther = isInOtherPane(m_last);
            emit hovered(pixel);
        }
        placeMagnifier();
    }
}

void FrameView::mouseReleaseEvent(QMouseEvent* event)
{
    const bool isClick = (event->position() - m_pressed).manhattanLength() <= kClickReach;
    if (event->button() == Qt::LeftButton && m_drag == Drag::PanPicture && isClick)
        m_session.pick(pixelAt(event->position()));
    m_drag = Drag::None;
}

void FrameView::mouseDoubleClickEvent(QMouseEvent* event) { mousePressEvent(event); }

void FrameView::leaveEvent(QEvent*)
{
    m_hovered.reset();
    emit hovered({});
    placeMagnifier();
}

// Keys: only those that are held; single presses are actions of the window -------------------------------------------

void FrameView::keyPressEvent(QKeyEvent* event)
{
    static const QSet<int> flying{Qt::Key_W, Qt::Key_A, Qt::Key_S, Qt::Key_D, Qt::Key_Q, Qt::Key_E, Qt::Key_Shift};
    const bool             plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    if (m_tool != Tool::Camera || !plain || !flying.contains(event->key())) return QWidget::keyPressEvent(event);
    if (event->isAutoRepeat()) return;
    m_held.insert(event->key());
    if (event->key() == Qt::Key_Shift || m_flight.isActive()) return;
    m_sinceTick.start();
    m_flight.start();
}

void FrameView::keyReleaseEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat() || !m_held.remove(event->key())) return QWidget::keyReleaseEvent(event);
    if (m_held.isEmpty()) m_flight.stop();
}

void FrameView::focusOutEvent(QFocusEvent* event)
{
    m_held.clear();
    m_flight.stop();
    QWidget::focusOutEvent(event);
}

void FrameView::moveOn()
{
    const double seconds = static_cast<double>(m_sinceTick.restart()) / 1000;
    const double way     = seconds * kFlyPerSecond * (m_held.contains(Qt::Key_Shift) ? kFlyFaster : 1);
    const auto   along   = [&](Qt::Key plus, Qt::Key minus) {
        return way * ((m_held.contains(plus) ? 1 : 0) - (m_held.contains(minus) ? 1 : 0));
    };
    const double right = along(Qt::Key_D, Qt::Key_A), up = along(Qt::Key_E, Qt::Key_Q),
                 ahead = along(Qt::Key_W, Qt::Key_S);
    if (right == 0 && up == 0 && ahead == 0) return;
    m_session.moveCamera([&](CameraControl& camera) { camera.fly(right, up, ahead); });
}

}  // namespace zscope::ui
