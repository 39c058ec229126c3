// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/overlay.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <QPainter>

#include "ui/theme/verdicts.h"

namespace zscope::ui {

bool isSameEdge(const EdgeRow& a, const EdgeRow& b)
{
    return a.polygon == b.polygon && a.dx == b.dx && a.firstLine == b.firstLine && a.lastLine == b.lastLine;
}

EdgeNames::EdgeNames(std::span<const EdgeRow> edges)
{
    for (const EdgeRow& edge : edges) m_names.push_back(nameOf(edge));
    std::ranges::sort(m_names);
}

bool EdgeNames::holds(const EdgeRow& edge) const { return std::ranges::binary_search(m_names, nameOf(edge)); }

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

namespace {

QRect rectOf(const PixelBox& box) { return {box.x0, box.y0, box.x1 - box.x0, box.y1 - box.y0}; }

void addPyramid(Overlay& overlay, const Snapshot& shown, const Layers& layers)
{
    const int level = levelOnShow(shown);
    if (level < 0) return;
    if (layers.pyramid) {
        overlay.step  = shown.step;
        overlay.cells = &shown.step->pyramid.levels[static_cast<std::size_t>(level)];
        overlay.empty = shown.step->pyramid.empty;
    }
    if (!layers.query) return;
    const HierarchyState& hierarchy = *shown.step->state.hierarchy;
    if (hierarchy.query) overlay.asked = rectOf(hierarchy.query->box);
    if (hierarchy.update && shown.step->state.event == Grain::Update) {
        const CellWrite& cell = *hierarchy.update;
        const int        size = 1 << cell.level;
        overlay.written =
            QRect(cell.x * size, cell.y * size, size, size).intersected(QRect(QPoint(0, 0), overlay.picture));
    }
}

/// The lines of a node's box or of a triangle, those that no part of the picture can show left out.
template <class What>
std::vector<QLineF> linesOf(const What& what, const Snapshot& shown, const QSize& picture)
{
    std::vector<QLineF> lines;
    const QRectF        seen(-1, -1, picture.width() + 2, picture.height() + 2);
    for (const ScreenLine& line : outlineOf(what, shown.scene->scene(), shown.pictureCamera())) {
        const bool misses =
            (line.x0 < seen.left() && line.x1 < seen.left()) || (line.x0 > seen.right() && line.x1 > seen.right())
            || (line.y0 < seen.top() && line.y1 < seen.top()) || (line.y0 > seen.bottom() && line.y1 > seen.bottom());
        if (!misses) lines.emplace_back(line.x0, line.y0, line.x1, line.y1);
    }
    return lines;
}

void addMarks(Overlay& overlay, const Snapshot& shown)
{
    if (!shown.scene) return;
    const QRect inside(QPoint(0, 0), overlay.picture);
    const auto  addOutline = [&](std::vector<QLineF> lines) {
        if (!lines.empty()) overlay.marks.outlines.push_back(std::move(lines));
    };
    for (const Breakpoint& at : shown.marks.breakpoints) {
        switch (at.on) {
            case Breakpoint::On::Line:
                if (at.line >= 0 && at.line < inside.height()) overlay.marks.lines.push_back(at.line);
                break;
            case Breakpoint::On::Pixel:
                if (const QPoint pixel(at.pixel.x, at.pixel.y); inside.contains(pixel))
                    overlay.marks.pixels.push_back(pixel);
                break;
            case Breakpoint::On::Node:
                if (const HierarchyState* hierarchy = shown.hierarchy())
                    if (const int id = rowOf(hierarchy->nodes, at.node); id >= 0)
                        addOutline(linesOf(hierarchy->nodes[static_cast<std::size_t>(id)], shown, overlay.picture));
                break;
            case Breakpoint::On::Triangle:
                addOutline(linesOf(at.triangle, shown, overlay.picture));
                break;
        }
    }
}

void addBoxes(Overlay& overlay, const Snapshot& shown, const Layers& layers)
{
    const HierarchyState* hierarchy = shown.hierarchy();
    if (!hierarchy || hierarchy->nodes.empty() || !shown.scene) return;
    const auto& nodes = hierarchy->nodes;
    if (layers.boxes) {
        std::array<OverlayBox, 6> byVerdict;
        std::vector<int>          upperFirst(nodes.size());
        std::iota(upperFirst.begin(), upperFirst.end(), 0);
        std::ranges::stable_sort(upperFirst, {}, [&](int id) { return nodes[static_cast<std::size_t>(id)].depth; });
        for (const int id : upperFirst) {
            const NodeRow& node    = nodes[static_cast<std::size_t>(id)];
            const auto     verdict = static_cast<std::size_t>(node.verdict);
            if (!shown.shownNodes[verdict]) continue;
            const auto lines = linesOf(node, shown, overlay.picture);
            if (lines.empty()) continue;
            ++overlay.boxesWanted;
            if (overlay.boxesShown >= Overlay::kMostBoxes) continue;
            ++overlay.boxesShown;
            byVerdict[verdict].verdict = node.verdict;
            byVerdict[verdict].lines.insert(byVerdict[verdict].lines.end(), lines.begin(), lines.end());
        }
        for (const NodeVerdict verdict : {NodeVerdict::Outside, NodeVerdict::Waiting, NodeVerdict::Entered,
                                          NodeVerdict::Small, NodeVerdict::Hidden, NodeVerdict::Drawn})
            if (!byVerdict[static_cast<std::size_t>(verdict)].lines.empty())
                overlay.boxes.push_back(std::move(byVerdict[static_cast<std::size_t>(verdict)]));
    }
    const auto addOne = [&](int id, OverlayBox::Kind kind) {
        const NodeRow& node = nodes[static_cast<std::size_t>(id)];
        overlay.boxes.push_back({linesOf(node, shown, overlay.picture), node.verdict, kind});
    };
    const bool isAboutNode =
        shown.showsStep && hierarchy->now >= 0 && shown.step->state.event <= Grain::Query && !hierarchy->askedAbout;
    if (isAboutNode && layers.query) addOne(hierarchy->now, OverlayBox::Kind::Now);
    if (const int id = shown.selectedNode ? rowOf(nodes, *shown.selectedNode) : -1; id >= 0)
        addOne(id, OverlayBox::Kind::Selected);
}

}  // namespace

QString cellText(float value, float empty)
{
    if (value <= empty) return QStringLiteral("\u2013");
    const QString text = QString::number(static_cast<double>(value), 'f', 4);
    return text.startsWith(QLatin1String("0.")) ? text.mid(1) : text;
}

Overlay overlayOf(const Snapshot& shown, const Layers& layers)
{
    Overlay overlay;
    overlay.pick = shown.picked;
    if (const VisibilityBuffer* visible = shown.visible()) overlay.picture = {visible->width(), visible->height()};
    const ShownStep* step = shown.stepOfPicture();
    if (layers.marks) addMarks(overlay, shown);
    if (step) addBoxes(overlay, shown, layers);
    if (step && layers.pyramid && !shown.showsStep) addPyramid(overlay, shown, {.query = false, .pyramid = true});
    if (!step || !shown.showsStep) return overlay;  // the finished picture is shown as it is

    if (const SweepState* sweep = shown.sweep(); sweep && sweep->y >= 0) {
        if (layers.line) overlay.line = sweep->y;
        const auto      picked = pickedTriangle(shown);
        const EdgeNames entered(sweep->entered);
        const auto      kindOf = [&](const EdgeRow& edge) {
            if (shown.selectedEdge && isSameEdge(edge, *shown.selectedEdge)) return EdgeKind::Selected;
            if (picked && edge.polygon == *picked) return EdgeKind::Picked;
            return entered.holds(edge) ? EdgeKind::Entered : EdgeKind::Active;
        };
        const auto add = [&](const EdgeRow& edge, int y, EdgeKind kind) {
            const bool always = kind == EdgeKind::Selected;  // a selected row is shown even with the layer off
            if (!layers.edges && !always) return;
            if (const auto segment = segmentOf(edge, y, overlay.picture)) overlay.edges.push_back({*segment, kind});
        };
        for (const EdgeRow& edge : sweep->activeEdges) add(edge, sweep->y, kindOf(edge));
        for (const EdgeRow& edge : sweep->left) add(edge, edge.lastLine, EdgeKind::Left);
        std::ranges::stable_sort(overlay.edges, {},
                                 [](const OverlayEdge& edge) { return static_cast<int>(edge.kind); });
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
    addPyramid(overlay, shown, layers);
    if (step->state.pixel) overlay.pixel = QPoint(step->state.pixel->x, step->state.pixel->y);
    return overlay;
}

namespace {

/// The cells in their colours with the picture shining through, their borders, and their values where they fit.
void paintCells(QPainter& painter, const Overlay& overlay, const ViewTransform& view, double scale)
{
    constexpr double    kCellValuesFrom = 40, kCellGridFrom = 5;  // device pixels per cell, times the screen's scale
    constexpr double    kOpacity = 0.72;
    const PyramidLevel& cells    = *overlay.cells;
    const int           size     = cells.cellSize();
    const QRect         seen     = view.visiblePixels();
    if (seen.isEmpty()) return;
    const QRect  inCells(QPoint(seen.left() / size, seen.top() / size),
                         QPoint(seen.right() / size, seen.bottom() / size));
    const QImage colours(reinterpret_cast<const uchar*>(cells.colours.values().data()), cells.width(), cells.height(),
                         cells.width() * static_cast<qsizetype>(sizeof(QRgb)), QImage::Format_RGB32);
    const auto   placeOf = [&](int x, int y, int w, int h) {
        return view.toView(QRectF(x * size, y * size, w * size, h * size));
    };

    const QRectF whole = view.toView(QRectF(QPointF(0, 0), QSizeF(overlay.picture)));  // the last cells reach beyond it
    painter.save();
    painter.setClipRect(whole);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setOpacity(kOpacity);
    painter.drawImage(placeOf(inCells.left(), inCells.top(), inCells.width(), inCells.height()), colours,
                      QRectF(inCells));
    painter.setOpacity(1);
    const double wide = view.zoom() * size;
    if (wide >= kCellGridFrom * scale) {
        painter.setPen(QPen(QColor(255, 255, 255, 90), scale));
        const QRectF all = placeOf(inCells.left(), inCells.top(), inCells.width(), inCells.height());
        for (int x = inCells.left(); x <= inCells.right() + 1; ++x) {
            const double at = view.toView(QPointF(x * size, 0)).x();
            painter.drawLine(QPointF(at, all.top()), QPointF(at, all.bottom()));
        }
        for (int y = inCells.top(); y <= inCells.bottom() + 1; ++y) {
            const double at = view.toView(QPointF(0, y * size)).y();
            painter.drawLine(QPointF(all.left(), at), QPointF(all.right(), at));
        }
    }
    if (wide >= kCellValuesFrom * scale) {
        QFont font = painter.font();
        font.setPixelSize(static_cast<int>(std::clamp(wide / 4, 9 * scale, 14 * scale)));
        painter.setFont(font);
        for (int y = inCells.top(); y <= inCells.bottom(); ++y) {
            for (int x = inCells.left(); x <= inCells.right(); ++x) {
                const bool lags = cells.isStored && cells.lags.at(x, y) != 0;
                painter.setPen(qGray(cells.colours.at(x, y)) < 120 ? Qt::white : Qt::black);
                painter.drawText(
                    placeOf(x, y, 1, 1).intersected(whole), Qt::AlignCenter,
                    cellText(cells.farthest.at(x, y), overlay.empty) + (lags ? QStringLiteral("*") : QString()));
            }
        }
    }
    painter.restore();
}

/// The colour of a verdict; the box of this step in the accent, the selected one framed in it too.
void paintBoxes(QPainter& painter, const Overlay& overlay, const ViewTransform& view, const Theme& theme, double scale)
{
    constexpr std::size_t kFew = 60;  // that many lines can be strong
    if (overlay.boxes.empty()) return;
    painter.save();
    painter.setClipRect(view.toView(QRectF(QPointF(0, 0), QSizeF(overlay.picture))));
    for (const OverlayBox& box : overlay.boxes) {
        std::vector<QLineF> lines;
        lines.reserve(box.lines.size());
        for (const QLineF& line : box.lines) lines.emplace_back(view.toView(line.p1()), view.toView(line.p2()));
        const auto draw = [&](const QColor& colour, double width, Qt::PenStyle style) {
            painter.setPen(QPen(colour, width * scale, style));
            painter.drawLines(lines.data(), static_cast<int>(lines.size()));
        };
        QColor colour = colourOf(box.verdict, theme);
        if (box.kind == OverlayBox::Kind::Plain && overlay.boxesShown > kFew) colour.setAlpha(150);
        switch (box.kind) {
            case OverlayBox::Kind::Plain:
                draw(colour, 1, box.verdict == NodeVerdict::Hidden ? Qt::DashLine : Qt::SolidLine);
                break;
            case OverlayBox::Kind::Now:
                draw(theme.now, 2, Qt::SolidLine);
                break;
            case OverlayBox::Kind::Selected:
                draw(Qt::white, 5, Qt::SolidLine);
                draw(colour, 2.5, Qt::SolidLine);
                break;
        }
    }
    painter.restore();
}

/// Breakpoints: a dot beside what is marked, as in the table of marks, on a dotted outline; light around dark, for any
/// picture.
void paintMarks(QPainter& painter, const OverlayMarks& marks, const QSize& picture, const ViewTransform& view,
                double scale)
{
    const QColor dark(24, 24, 24), light(Qt::white);
    const QRectF whole = view.toView(QRectF(QPointF(0, 0), QSizeF(picture)));
    const double wide  = 4.5 * scale;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, true);
    const auto dotted = [&](const auto& draw) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(light, 3 * scale));
        draw();
        painter.setPen(QPen(dark, 1.5 * scale, Qt::DotLine));
        draw();
    };
    const auto dot = [&](const QPointF& at) {
        painter.setPen(QPen(light, 1.5 * scale));
        painter.setBrush(dark);
        painter.drawEllipse(at, wide, wide);
    };
    for (const int line : marks.lines) {
        const double y = view.toView(QRectF(0, line, 1, 1)).center().y();
        dotted([&] { painter.drawLine(QPointF(whole.left(), y), QPointF(whole.right(), y)); });
        // where it is seen, however far the picture is scrolled
        dot(QPointF(std::max(whole.left(), 0.0) + 2 * wide, y));
    }
    for (const QPoint& pixel : marks.pixels) {
        const QRectF at     = view.toView(QRectF(pixel, QSizeF(1, 1)));
        const double around = std::max(at.width() * 0.75, 9 * scale);
        dotted([&] { painter.drawEllipse(at.center(), around, around); });
        dot(at.center() + QPointF(-around, -around) * 0.75);
    }
    painter.setClipRect(whole);
    for (const auto& outline : marks.outlines) {
        std::vector<QLineF> lines;
        QPointF             middle;
        for (const QLineF& line : outline) {
            lines.emplace_back(view.toView(line.p1()), view.toView(line.p2()));
            middle += lines.back().center() / static_cast<double>(outline.size());
        }
        dotted([&] { painter.drawLines(lines.data(), static_cast<int>(lines.size())); });
        dot(middle);
    }
    painter.restore();
}

}  // namespace

void paintOverlay(QPainter& painter, const Overlay& overlay, const ViewTransform& view, const Theme& theme,
                  double scale)
{
    if (overlay.cells) paintCells(painter, overlay, view, scale);
    paintBoxes(painter, overlay, view, theme, scale);
    if (!overlay.marks.isEmpty()) paintMarks(painter, overlay.marks, overlay.picture, view, scale);
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
            case EdgeKind::Active:
                colour = theme.picked;
                break;
            case EdgeKind::Entered:
                colour = theme.entered;
                width  = 2;
                break;
            case EdgeKind::Left:
                colour = theme.left;
                width  = 2;
                break;
            case EdgeKind::Picked:
                colour = theme.picked;
                width  = 3;
                break;
            case EdgeKind::Selected:
                colour = theme.now;
                width  = 3;
                break;
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
        const QRectF row  = view.toView(QRectF(0, *overlay.line, overlay.picture.width(), 1));
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
    if (overlay.asked) {  // dashed: a question changes nothing
        QPen dashed = pen(theme.now, 2);
        dashed.setStyle(Qt::DashLine);
        painter.setPen(dashed);
        painter.drawRect(view.toView(QRectF(*overlay.asked)));
    }
    if (overlay.written) frame(*overlay.written, theme.now, 2);
    if (overlay.span) frame(*overlay.span, theme.now, 2);
    if (overlay.pixel) frame(QRect(*overlay.pixel, QSize(1, 1)), theme.now, 3);
    if (overlay.pick) {  // a ring that stays visible on light and dark, and a cross of four short arms
        const QRectF  pixel  = view.toView(QRectF(overlay.pick->x(), overlay.pick->y(), 1, 1));
        const QPointF centre = pixel.center();
        const double  inner = std::max(pixel.width() / 2 + 2 * scale, 5 * scale), outer = inner + 6 * scale;
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
