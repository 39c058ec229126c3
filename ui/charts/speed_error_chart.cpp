// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/speed_error_chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <QHelpEvent>
#include <QToolTip>

#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr double     kMark  = 9;   // pixels across
constexpr double     kReach = 12;  // how near a click has to be
constexpr std::array kMarks{RunMark::Exact, RunMark::ByFace, RunMark::Approximate, RunMark::Broken};

QCPScatterStyle::ScatterShape scatterOf(RunMark mark)
{
    switch (mark) {
        case RunMark::Exact:
            return QCPScatterStyle::ssCircle;
        case RunMark::ByFace:
            return QCPScatterStyle::ssDiamond;
        case RunMark::Approximate:
            return QCPScatterStyle::ssTriangle;
        case RunMark::Broken:
            return QCPScatterStyle::ssCross;
        case RunMark::Unchecked:
            break;
    }
    return QCPScatterStyle::ssCircle;
}

/// A power of ten, with its exponent raised where the number would be long.
QString decadeText(double decade)
{
    const int exponent = static_cast<int>(std::lround(std::log10(decade)));
    if (exponent >= 0 && exponent <= 6) return grouped(static_cast<std::uint64_t>(std::llround(decade)));
    static constexpr std::array<char16_t, 10> kRaised{u'\u2070', u'\u00B9', u'\u00B2', u'\u00B3', u'\u2074',
                                                      u'\u2075', u'\u2076', u'\u2077', u'\u2078', u'\u2079'};
    QString                                   text = QStringLiteral("10");
    if (exponent < 0) text += QChar(0x207B);
    for (const QChar digit : QString::number(std::abs(exponent)))
        text += QChar(kRaised[static_cast<std::size_t>(digit.digitValue())]);
    return text;
}

/// As many decimals as tell the ticks apart.
QString tickText(double tick, const std::vector<double>& ticks)
{
    const double step     = ticks.size() > 1 ? ticks[1] - ticks[0] : tick;
    const int    decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
    return decimal(tick, decimals);
}

}  // namespace

SpeedErrorChart::SpeedErrorChart(QWidget* parent) : QCustomPlot(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setProperty("ownsArrows", true);
    setProperty("ownsEnter", true);
    setMouseTracking(false);
    plotLayout()->setRowSpacing(2);
    plotLayout()->setMargins({});
    for (QCPAxis* axis : {xAxis, yAxis}) axis->setScaleType(QCPAxis::stLogarithmic);
    for (QCPAxis* axis : {xAxis2, yAxis2}) {  // the other two sides of the frame
        axis->setVisible(true);
        axis->setTicks(false);
        axis->setTickLabels(false);
    }
    setAutoAddPlottableToLegend(false);
    connect(this, &QCustomPlot::afterLayout, this, &SpeedErrorChart::addLabels);
    spoken(*this, [this] {
        setAccessibleName(tr("Speed against error"));
        layOut();
    });
}

void SpeedErrorChart::setPoints(std::vector<SpeedErrorPoint> points, ErrorMeasure measure)
{
    m_points  = std::move(points);
    m_measure = measure;
    m_current.reset();
    m_loaded.reset();
    layOut();
}

void SpeedErrorChart::setCurrent(std::optional<std::size_t> point)
{
    if (point == m_current) return;
    m_current = point;
    layOut();
}

void SpeedErrorChart::setLoaded(std::optional<std::size_t> point)
{
    if (point == m_loaded) return;
    m_loaded = point;
    layOut();
}

QPointF SpeedErrorChart::placeOf(std::size_t point) const
{
    return {xAxis->coordToPixel(m_points[point].ms), yAxis->coordToPixel(m_errors.placeOf(m_points[point].error))};
}

// Laying out --------------------------------------------------------------------------------------------------------

void SpeedErrorChart::layOut()
{
    m_labelItems.clear();
    clearItems();
    clearPlottables();
    if (m_legend) {
        plotLayout()->remove(m_legend);
        plotLayout()->simplify();
    }
    dress();
    scaleAxes();
    addPoints();
    addRings();
    describe();
    replot(rpQueuedRefresh);
}

void SpeedErrorChart::dress()
{
    const Theme& theme = themeOf(palette());
    QFont        small = font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    setBackground(QBrush(theme.card));
    for (QCPAxis* axis : {xAxis, yAxis, xAxis2, yAxis2}) {
        axis->setBasePen(QPen(hasFocus() ? theme.picked : theme.border, 1));
        axis->setTickPen(QPen(theme.border, 1));
        axis->setSubTicks(false);
        axis->setLabelColor(theme.softText);
        axis->setTickLabelColor(theme.softText);
        axis->setLabelFont(small);
        axis->setTickLabelFont(small);
        axis->setLabelPadding(3);
        axis->setTickLabelPadding(4);
    }
    for (QCPAxis* axis : {xAxis, yAxis}) {
        axis->grid()->setPen(QPen(theme.border, 1, Qt::DotLine));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
    xAxis->setLabel(tr("median time of a frame, ms"));
    yAxis->setLabel(m_measure == ErrorMeasure::WrongPixels ? tr("wrong pixels") : tr("largest relative depth error"));

    QStringList kinds;
    for (const RunMark mark : kMarks)
        if (std::ranges::find(m_points, mark, &SpeedErrorPoint::mark) != m_points.end())
            kinds << shapeOf(mark) + ' ' + nameOf(mark);
    if (kinds.isEmpty()) return;
    kinds << QStringLiteral("\u2014 ") + tr("unbeaten");
    plotLayout()->insertRow(0);
    m_legend = new QCPTextElement(this, kinds.join(QStringLiteral("   ")), small);
    m_legend->setTextColor(theme.softText);
    m_legend->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    m_legend->setMargins({4, 0, 4, 2});
    plotLayout()->addElement(0, 0, m_legend);
}

void SpeedErrorChart::scaleAxes()
{
    const Theme&        theme = themeOf(palette());
    std::vector<double> times, errors;
    for (const SpeedErrorPoint& point : m_points) {
        times.insert(times.end(), {point.ms, point.q1, point.q3});
        errors.push_back(point.error);
    }
    const TimeScale time = timeScaleOf(times);
    m_errors             = errorScaleOf(errors, m_measure == ErrorMeasure::WrongPixels);

    auto across = QSharedPointer<QCPAxisTickerText>::create();
    for (const double tick : time.ticks) across->addTick(tick, tickText(tick, time.ticks));
    auto up = QSharedPointer<QCPAxisTickerText>::create();
    for (const double tick : m_errors.ticks) up->addTick(tick, decadeText(tick));
    up->addTick(m_errors.zero, QStringLiteral("0"));
    if (m_errors.hasInfinite) up->addTick(m_errors.infinite, QStringLiteral("\u221E"));
    xAxis->setTicker(across);
    yAxis->setTicker(up);
    xAxis->setRange(time.low, time.high);
    yAxis->setRange(m_errors.bottom, m_errors.top);

    auto* band = new QCPItemRect(this);  // of zero, which has no place on the scale above it
    band->setLayer(QStringLiteral("background"));
    band->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
    band->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
    band->topLeft->setCoords(0, m_errors.bandTop);
    band->bottomRight->setCoords(1, m_errors.bottom);
    band->setPen(Qt::NoPen);
    QColor fill = theme.entered;
    fill.setAlpha(theme.dark ? 34 : 22);
    band->setBrush(fill);
}

void SpeedErrorChart::addPoints()
{
    const Theme& theme = themeOf(palette());
    const auto   worth = worthChoosing(m_points);
    auto*        line  = addGraph();
    line->setPen(QPen(theme.text, 1.2));
    for (const std::size_t i : worth) line->addData(m_points[i].ms, m_errors.placeOf(m_points[i].error));

    for (const RunMark mark : kMarks) {
        QColor colour = colourOf(mark, theme);
        for (const SpeedErrorPoint& point : m_points) {
            if (point.mark != mark) continue;
            auto* spread = new QCPItemLine(this);  // from the first to the third quartile
            spread->start->setCoords(point.q1, m_errors.placeOf(point.error));
            spread->end->setCoords(point.q3, m_errors.placeOf(point.error));
            QPen pen(colour, 1.5);
            pen.setCapStyle(Qt::FlatCap);
            spread->setPen(pen);
            spread->setLayer(QStringLiteral("main"));
        }
        auto* marks = addGraph();
        marks->setLineStyle(QCPGraph::lsNone);
        QCPScatterStyle style(scatterOf(mark),
                              QPen(mark == RunMark::Broken ? colour : theme.card, mark == RunMark::Broken ? 2 : 1),
                              QBrush(colour), kMark);
        marks->setScatterStyle(style);
        for (const SpeedErrorPoint& point : m_points)
            if (point.mark == mark) marks->addData(point.ms, m_errors.placeOf(point.error));
    }
}

void SpeedErrorChart::addRings()
{
    const Theme& theme = themeOf(palette());
    const auto   ring  = [this](std::optional<std::size_t> which, QCPScatterStyle::ScatterShape shape,
                             const QColor& colour, double across) {
        if (!which || *which >= m_points.size()) return;
        auto* graph = addGraph();
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(QCPScatterStyle(shape, QPen(colour, 2), Qt::NoBrush, across));
        graph->addData(m_points[*which].ms, m_errors.placeOf(m_points[*which].error));
    };
    ring(m_loaded, QCPScatterStyle::ssSquare, theme.now, kMark + 7);
    ring(m_current, QCPScatterStyle::ssCircle, theme.picked, kMark + 5);
}

void SpeedErrorChart::addLabels()
{
    if (m_placesLabels) return;
    m_placesLabels = true;
    for (QCPAbstractItem* item : m_labelItems) removeItem(item);
    m_labelItems.clear();

    const Theme& theme = themeOf(palette());
    QFont        small = font();
    small.setPointSizeF(small.pointSizeF() * 0.84);
    const QFontMetricsF  metrics(small);
    std::vector<QPointF> places;
    std::vector<QSizeF>  sizes;
    std::vector<QRectF>  areas;  // the name of what has no error stands in the band, others above it
    const QRectF         all     = QRectF(axisRect()->rect()).adjusted(2, 2, -2, -2);
    const double         bandTop = yAxis->coordToPixel(m_errors.bandTop);
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        places.push_back(placeOf(i));
        areas.push_back(m_points[i].error > 0 ? QRectF(all.topLeft(), QPointF(all.right(), bandTop))
                                              : QRectF(QPointF(all.left(), bandTop), all.bottomRight()));
        sizes.emplace_back(metrics.horizontalAdvance(m_points[i].name) + 2, metrics.height());
    }
    // Who is looked at first, then who is worth choosing, then the rest from the fastest on.
    std::vector<std::size_t> order;
    const auto               next = [&order](std::size_t i) {
        if (std::ranges::find(order, i) == order.end()) order.push_back(i);
    };
    if (m_current && *m_current < m_points.size()) next(*m_current);
    if (m_loaded && *m_loaded < m_points.size()) next(*m_loaded);
    for (const std::size_t i : worthChoosing(m_points)) next(i);
    std::vector<std::size_t> byTime(m_points.size());
    std::iota(byTime.begin(), byTime.end(), std::size_t{0});
    std::ranges::stable_sort(byTime, {}, [this](std::size_t i) { return m_points[i].ms; });
    for (const std::size_t i : byTime) next(i);
    m_labels = placeLabels(places, sizes, order, areas, kMark / 2 + 1);

    for (std::size_t i = 0; i < m_points.size(); ++i) {
        if (!m_labels[i]) continue;
        const QRectF& rect  = m_labels[i]->rect;
        const bool    isNow = m_current == i;
        if (m_labels[i]->isFar) {
            auto* leader = new QCPItemLine(this);
            leader->start->setType(QCPItemPosition::ptAbsolute);
            leader->end->setType(QCPItemPosition::ptAbsolute);
            leader->start->setCoords(places[i]);
            leader->end->setCoords(std::clamp(places[i].x(), rect.left(), rect.right()),
                                   rect.center().y() < places[i].y() ? rect.bottom() - 1 : rect.top() + 1);
            leader->setPen(QPen(theme.border, 1));
            leader->setLayer(QStringLiteral("grid"));
            m_labelItems.push_back(leader);
        }
        auto* name = new QCPItemText(this);
        name->position->setType(QCPItemPosition::ptAbsolute);
        name->position->setCoords(rect.center());
        name->setPositionAlignment(Qt::AlignCenter);
        name->setText(m_points[i].name);
        name->setFont(small);
        name->setColor(isNow ? theme.picked : m_points[i].mark == RunMark::Broken ? theme.error : theme.text);
        name->setLayer(QStringLiteral("overlay"));
        m_labelItems.push_back(name);
    }
    m_placesLabels = false;
}

void SpeedErrorChart::describe()
{
    QString said = sentenceOf(m_points, m_measure);
    if (m_current && *m_current < m_points.size()) said += ' ' + sentenceOf(m_points[*m_current], m_measure);
    setAccessibleDescription(said);
}

// Walking and choosing ----------------------------------------------------------------------------------------------

void SpeedErrorChart::walk(int by, bool byError)
{
    if (m_points.empty()) return;
    std::vector<std::size_t> order(m_points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        const SpeedErrorPoint &p = m_points[a], &q = m_points[b];
        return byError ? std::pair(p.error, p.ms) < std::pair(q.error, q.ms)
                       : std::pair(p.ms, p.error) < std::pair(q.ms, q.error);
    });
    std::ptrdiff_t at = by > 0 ? -1 : static_cast<std::ptrdiff_t>(order.size());
    if (m_current) at = std::ranges::find(order, *m_current) - order.begin();
    at = std::clamp<std::ptrdiff_t>(at + by, 0, static_cast<std::ptrdiff_t>(order.size()) - 1);
    setCurrent(order[static_cast<std::size_t>(at)]);
    emit walked(*m_current);
}

void SpeedErrorChart::keyPressEvent(QKeyEvent* event)
{
    const int all = static_cast<int>(m_points.size());
    switch (event->key()) {
        case Qt::Key_Left:
            return walk(-1, false);
        case Qt::Key_Right:
            return walk(1, false);
        case Qt::Key_Down:
            return walk(-1, true);
        case Qt::Key_Up:
            return walk(1, true);
        case Qt::Key_Home:
            return walk(-all, false);
        case Qt::Key_End:
            return walk(all, false);
        case Qt::Key_Return:
        case Qt::Key_Enter:
            if (m_current) emit chosen(*m_current);
            return;
        default:
            QCustomPlot::keyPressEvent(event);
    }
}

std::optional<std::size_t> SpeedErrorChart::pointNear(const QPointF& place) const
{
    std::optional<std::size_t> nearest;
    double                     least = kReach;
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const double away = QLineF(placeOf(i), place).length();
        if (away >= least) continue;
        least   = away;
        nearest = i;
    }
    for (std::size_t i = 0; i < m_labels.size() && !nearest; ++i)
        if (m_labels[i] && m_labels[i]->rect.contains(place)) nearest = i;
    return nearest;
}

void SpeedErrorChart::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) m_pressed = event->position();
    QCustomPlot::mousePressEvent(event);
}

void SpeedErrorChart::mouseReleaseEvent(QMouseEvent* event)
{
    const bool isClick = m_pressed && QLineF(*m_pressed, event->position()).length() < kReach / 2;
    m_pressed.reset();
    QCustomPlot::mouseReleaseEvent(event);
    if (!isClick) return;
    if (const auto point = pointNear(event->position())) {
        setCurrent(point);
        emit walked(*point);
        emit chosen(*point);
    }
}

void SpeedErrorChart::focusInEvent(QFocusEvent* event)
{
    QCustomPlot::focusInEvent(event);
    layOut();
}

void SpeedErrorChart::focusOutEvent(QFocusEvent* event)
{
    QCustomPlot::focusOutEvent(event);
    layOut();
}

void SpeedErrorChart::changeEvent(QEvent* event)
{
    QCustomPlot::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) layOut();
}

bool SpeedErrorChart::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const auto point = pointNear(help->pos()))
            QToolTip::showText(help->globalPos(), sentenceOf(m_points[*point], m_measure), this);
        else
            QToolTip::hideText();
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {  // else they are the run's first and last step
        const auto* key = static_cast<QKeyEvent*>(event);
        if ((key->key() == Qt::Key_Home || key->key() == Qt::Key_End) && key->modifiers() == Qt::NoModifier) {
            event->accept();
            return true;
        }
    }
    return QCustomPlot::event(event);
}

}  // namespace zscope::ui
