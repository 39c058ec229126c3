// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/overlay.h"

#include <algorithm>

#include <QPainter>

namespace zscope::ui {

bool isSameEdge(const EdgeRow& a, const EdgeRow& b)
{
    return a.polygon == b.polygon && a.dx == b.dx && a.firstLine == b.firstLine && a.lastLine == b.lastLine;
}

std::optional<QLineF> segmentOf(const EdgeRow& edge, int y, const QSize& picture)
{
    const double perLine = static_cast<double>(edge.dx[0]) / static_cast<double>(edge.dx[1]);
    const auto   xAt     = [&](double line) { return edge.x + perLine * (line - (y + 0.5)); };

    double top = std::max(edge.firstLine, 0) + 0.5, bottom = std::min(edge.lastLine, picture.height() - 1) + 0.5;
    if (top > bottom) return {};
    if (perLine != 0) {  // the lines at which it crosses the sides of the picture
        const double atLeft = y + 0.5 - edge.x / perLine, atRight = y + 0.5 + (picture.width() - edge.x) / perLine;
        top    = std::max(top, std::min(atLeft, atRight));
        bottom = std::min(bottom, std::max(atLeft, atRight));
        if (top > bottom) return {};
    } else if (edge.x < 0 || edge.x > picture.width()) {
        return {};
    }
    return QLineF(xAt(top), top, xAt(bottom), bottom);
}

Overlay overlayOf(const Snapshot& shown, const Layers& layers)
{
    Overlay overlay;
    overlay.pick = shown.picked;
    if (const VisibilityBuffer* visible = shown.visible()) overlay.picture = {visible->width(), visible->height()};
    const ShownStep* step = shown.stepOfPicture();
    if (!step || !shown.showsStep) return overlay;  // the finished picture is shown as it is

    if (const SweepState* sweep = shown.sweep(); sweep && sweep->y >= 0) {
        if (layers.line) overlay.line = sweep->y;
        const auto picked = pickedTriangle(shown);
        const auto kindOf = [&](const EdgeRow& edge) {
            if (shown.selectedEdge && isSameEdge(edge, *shown.selectedEdge)) return EdgeKind::Selected;
            if (picked && edge.polygon == *picked) return EdgeKind::Picked;
            const bool isNew = std::ranges::any_of(sweep->entered, [&](const EdgeRow& e) { return isSameEdge(e, edge); });
            return isNew ? EdgeKind::Entered : EdgeKind::Active;
        };
        const auto add = [&](const EdgeRow& edge, int y, EdgeKind kind) {
            const bool always = kind == EdgeKind::Selected;  // a selected row is shown even with the layer off
            if (!layers.edges && !always) return;
            if (const auto segment = segmentOf(edge, y, overlay.picture)) overlay.edges.push_back({*segment, kind});
        };
        for (const EdgeRow& edge : sweep->activeEdges) add(edge, sweep->y, kindOf(edge));
        for (const EdgeRow& edge : sweep->left) add(edge, edge.lastLine, EdgeKind::Left);
        std::ranges::stable_sort(overlay.edges, {}, [](const OverlayEdge& edge) { return static_cast<int>(edge.kind); });
    }
    if (layers.triangle && step->state.triangle) {
        QPolygonF triangle;
        for (const auto& corner : step->state.triangle->corners) triangle << QPointF(corner[0], corner[1]);
        overlay.triangle = triangle;
    }
    if (const auto& span = step->state.span; span && step->state.event >= Grain::Span) {
        const int y = step->state.sweep ? step->state.sweep->y : step->state.pixel ? step->state.pixel->y : -1;
        if (y >= 0) overlay.span = QRect(span->x0, y, span->x1 - span->x0, 1);
    }
    if (step->state.pixel) overlay.pixel = QPoint(step->state.pixel->x, step->state.pixel->y);
    return overlay;
}

void paintOverlay(QPainter& painter, const Overlay& overlay, const ViewTransform& view, const Theme& theme,
                  double scale)
{
    const auto pen = [scale](const QColor& colour, double width) {
        QPen made(colour, width * scale);
        made.setJoinStyle(Qt::MiterJoin);
        made.setCapStyle(Qt::FlatCap);
        return made;
    };
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setBrush(Qt::NoBrush);

    for (const OverlayEdge& edge : overlay.edges) {
        QColor colour = theme.idle;
        double width  = 1;
        switch (edge.kind) {
        case EdgeKind::Active: colour = theme.picked; break;
        case EdgeKind::Entered: colour = theme.entered; width = 2; break;
        case EdgeKind::Left: colour = theme.left; width = 2; break;
        case EdgeKind::Picked: colour = theme.picked; width = 3; break;
        case EdgeKind::Selected: colour = theme.now; width = 3; break;
        }
        painter.setPen(pen(colour, width));
        painter.drawLine(view.toView(edge.segment.p1()), view.toView(edge.segment.p2()));
    }
    if (overlay.triangle) {
        QPolygonF corners;
        for (const QPointF& corner : *overlay.triangle) corners << view.toView(corner);
        QColor fill = theme.now;
        fill.setAlpha(40);
        painter.setBrush(fill);
        painter.setPen(pen(theme.now, 2));
        painter.drawPolygon(corners);
        painter.setBrush(Qt::NoBrush);
    }

    painter.setRenderHint(QPainter::Antialiasing, false);
    if (overlay.line) {
        const QRectF row = view.toView(QRectF(0, *overlay.line, overlay.picture.width(), 1));
        QColor       tint = theme.now;
        if (row.height() >= 6 * scale) {  // large pixels: frame the line, and leave what it shows to be seen
            painter.setPen(pen(tint, 2));
            painter.drawLine(row.topLeft(), row.topRight());
            painter.drawLine(row.bottomLeft(), row.bottomRight());
        } else {
            const double thick = std::max(row.height(), 1.5 * scale);
            painter.fillRect(QRectF(row.left(), row.center().y() - thick / 2, row.width(), thick), tint);
        }
    }
    const auto frame = [&](const QRect& pixels, const QColor& colour, double width) {
        painter.setPen(pen(colour, width));
        const QRectF at = view.toView(QRectF(pixels));
        painter.drawRect(at.adjusted(-width * scale / 2, -width * scale / 2, width * scale / 2, width * scale / 2));
    };
    if (overlay.span) frame(*overlay.span, theme.now, 2);
    if (overlay.pixel) frame(QRect(*overlay.pixel, QSize(1, 1)), theme.now, 3);
    if (overlay.pick) {  // a ring that stays visible on light and dark, and a cross of four short arms
        const QRectF  pixel  = view.toView(QRectF(overlay.pick->x(), overlay.pick->y(), 1, 1));
        const QPointF centre = pixel.center();
        const double  inner  = std::max(pixel.width() / 2 + 2 * scale, 5 * scale), outer = inner + 6 * scale;
        painter.setRenderHint(QPainter::Antialiasing, true);
        for (const auto& [colour, width] : {std::pair(QColor(Qt::white), 4.0), std::pair(theme.picked, 2.0)}) {
            painter.setPen(pen(colour, width));
            painter.drawRect(QRectF(centre.x() - inner, centre.y() - inner, 2 * inner, 2 * inner));
            for (const QPointF direction : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
                painter.drawLine(centre + direction * inner, centre + direction * outer);
        }
    }
}

}  // namespace zscope::ui
