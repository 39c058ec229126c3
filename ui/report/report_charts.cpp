// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_charts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <qcustomplot.h>
#include <QApplication>

#include "ui/charts/speed_error_chart.h"
#include "ui/report/report_words.h"
#include "ui/text/numbers.h"
#include "ui/text/utf8_text.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int    kWidth  = 900;
constexpr double kScale  = 2;  // pixels of the picture per unit
constexpr int    kBarRow = 24;

static_assert(kStages.size() <= 10);  // no two stages look alike

/// Okabe and Ito's colours, and grey, each with a filling, a mark and a dash that tells it apart in print.
struct ChartLook {
    QColor                        colour;
    Qt::BrushStyle                fill;
    QCPScatterStyle::ScatterShape mark;
    Qt::PenStyle                  dash;
};
const ChartLook& lookOf(std::size_t i)
{
    static const std::array<ChartLook, 10> kLooks{{
        {QColor(0x00, 0x72, 0xB2), Qt::SolidPattern, QCPScatterStyle::ssDisc, Qt::SolidLine},
        {QColor(0xE6, 0x9F, 0x00), Qt::BDiagPattern, QCPScatterStyle::ssSquare, Qt::DashLine},
        {QColor(0x00, 0x9E, 0x73), Qt::Dense4Pattern, QCPScatterStyle::ssTriangle, Qt::DotLine},
        {QColor(0xCC, 0x79, 0xA7), Qt::FDiagPattern, QCPScatterStyle::ssDiamond, Qt::DashDotLine},
        {QColor(0x56, 0xB4, 0xE9), Qt::Dense6Pattern, QCPScatterStyle::ssCross, Qt::DashDotDotLine},
        {QColor(0xD5, 0x5E, 0x00), Qt::CrossPattern, QCPScatterStyle::ssPlus, Qt::SolidLine},
        {QColor(0x80, 0x80, 0x80), Qt::HorPattern, QCPScatterStyle::ssStar, Qt::DashLine},
        {QColor(0x00, 0x00, 0x00), Qt::VerPattern, QCPScatterStyle::ssTriangleInverted, Qt::DotLine},
        {QColor(0xF0, 0xE4, 0x42), Qt::Dense1Pattern, QCPScatterStyle::ssPeace, Qt::DashDotLine},
        {QColor(0x80, 0x80, 0x80), Qt::NoBrush, QCPScatterStyle::ssCrossSquare, Qt::DashDotDotLine},
    }};
    return kLooks[i % kLooks.size()];
}

void dress(QCustomPlot& plot)
{
    plot.setBackground(Qt::white);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->setLabelFont(fontOfHeight(13));
        axis->setTickLabelFont(fontOfHeight(12));
        axis->grid()->setPen(QPen(QColor(0xDD, 0xDD, 0xDD), 1));
        axis->grid()->setSubGridVisible(false);
    }
    plot.legend->setFont(fontOfHeight(12));
    plot.legend->setBorderPen(Qt::NoPen);
}

void makeLogarithmic(QCPAxis& axis, double low, double high)
{
    axis.setScaleType(QCPAxis::stLogarithmic);
    axis.setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    axis.setNumberFormat("gb");
    axis.setNumberPrecision(3);
    const double air = std::pow(high / low, 0.06) * 1.05;
    axis.setRange(low / air, high * air);
}

/// The legend under the chart, in as many columns as fit.
void putLegendBelow(QCustomPlot& plot, int columns)
{
    auto* below = new QCPLayoutGrid;
    plot.plotLayout()->addElement(1, 0, below);
    plot.plotLayout()->setRowStretchFactor(1, 0.001);
    below->addElement(0, 0, plot.legend);
    plot.legend->setWrap(columns);
    plot.legend->setFillOrder(QCPLegend::foColumnsFirst);  // puts the entries in their places
    plot.legend->setVisible(true);
}

bool isPeer(const BenchRow& row) { return row.algorithm.starts_with("peer:"); }

/// What tells the runs of a chart apart. A peer draws one thing only, so nothing more has to be said of it.
QString nameOf(const BenchRow& row, bool tellsShading)
{
    QString name = QString::fromStdString(row.algorithm);
    if (row.threads > 1) name += Report::tr(", %1 threads").arg(row.threads);
    if (tellsShading && !row.shaded && !isPeer(row)) name += Report::tr(", ids and depth");
    return name;
}

bool mixesShading(std::span<const ReportCase> cases)
{
    const auto any = [cases](bool shaded) {
        return std::ranges::any_of(cases, [shaded](const ReportCase& each) {
            return std::ranges::any_of(each.rows,
                                       [shaded](const BenchRow& row) { return !isPeer(row) && row.shaded == shaded; });
        });
    };
    return any(true) && any(false);
}

/// The runs that are told apart in a chart, by the order in which they come.
std::vector<QString> namesIn(std::span<const ReportCase> cases)
{
    std::vector<QString> names;
    for (const ReportCase& each : cases)
        for (const BenchRow& row : each.rows)
            if (const QString name = nameOf(row, mixesShading(cases)); std::ranges::find(names, name) == names.end())
                names.push_back(name);
    return names;
}

ReportChart stageChart(std::span<const ReportCase> cases)
{
    const bool  tellsShading = mixesShading(cases);
    QCustomPlot plot;
    dress(plot);
    const auto                   ticker = QSharedPointer<QCPAxisTickerText>::create();
    std::vector<const BenchRow*> rows;
    double                       longest = 0;
    int                          place   = 0;
    std::vector<int>             places;
    for (const ReportCase& each : cases) {
        for (const BenchRow& row : each.rows) {
            if (row.isBroken()) continue;
            const bool isFirst = &row == &each.rows.front();
            ticker->addTick(place, isFirst && cases.size() > 1
                                       ? each.scene + QStringLiteral(":  ") + nameOf(row, tellsShading)
                                       : nameOf(row, tellsShading));
            rows.push_back(&row);
            places.push_back(place++);
            longest = std::max(longest, row.medianMs);
        }
        ++place;  // a gap between scenes
    }
    QCPBars* below = nullptr;
    for (std::size_t stage = 0; stage < kStages.size(); ++stage) {
        if (std::ranges::none_of(rows, [&](const BenchRow* row) { return row->stageMs[stage] > 0.002 * longest; }))
            continue;
        auto*            bars = new QCPBars(plot.yAxis, plot.xAxis);
        const ChartLook& look = lookOf(stage);
        bars->setName(utf8Text(wordOf(kStages[stage])));
        bars->setPen(QPen(look.colour.darker(130), 1));
        bars->setBrush(QBrush(look.colour, look.fill));
        bars->setWidth(0.72);
        bars->setStackingGap(0);
        if (below) bars->moveAbove(below);
        below = bars;
        for (std::size_t i = 0; i < rows.size(); ++i) bars->addData(places[i], rows[i]->stageMs[stage]);
    }
    plot.yAxis->setTicker(ticker);
    plot.yAxis->setRange(-0.7, place - 1.3);
    plot.yAxis->setRangeReversed(true);
    plot.yAxis->setTickLength(0);
    plot.yAxis->grid()->setVisible(false);
    plot.xAxis->setRange(0, longest * 1.05);
    plot.xAxis->setLabel(Report::tr("ms, median frame"));
    putLegendBelow(plot, 6);
    plot.resize(kWidth, 110 + kBarRow * place);
    return {QStringLiteral("stages"), Report::tr("Where the time goes"),
            plot.toPixmap(kWidth, 110 + kBarRow * place, kScale).toImage()};
}

/// Times, or their ratios to a baseline, along the axis of the part.
ReportChart growthChart(std::span<const ReportCase> cases, const QString& axis, const std::string& baseline,
                        bool isRatio)
{
    QCustomPlot plot;
    dress(plot);
    double                     lowX = 1e300, highX = 0, lowY = 1e300, highY = 0;
    const std::vector<QString> names        = namesIn(cases);
    const bool                 tellsShading = mixesShading(cases);
    for (std::size_t i = 0; i < names.size(); ++i) {
        std::vector<double> x, y;
        for (const ReportCase& each : cases) {
            const auto row =
                std::ranges::find_if(each.rows, [&](const BenchRow& r) { return nameOf(r, tellsShading) == names[i]; });
            if (row == each.rows.end() || row->isBroken() || each.place <= 0) continue;
            const auto base = std::ranges::find_if(each.rows, [&](const BenchRow& r) {
                return r.algorithm == baseline && r.threads == row->threads && r.shaded == row->shaded;
            });
            if (isRatio && (base == each.rows.end() || base->isBroken())) continue;
            x.push_back(each.place);
            y.push_back(isRatio ? row->medianMs / base->medianMs : row->medianMs);
        }
        if (x.empty()) continue;
        const ChartLook& look  = lookOf(i);
        QCPGraph*        graph = plot.addGraph();
        graph->setData(QVector<double>(x.begin(), x.end()), QVector<double>(y.begin(), y.end()));
        graph->setPen(QPen(look.colour, 2, look.dash));
        graph->setScatterStyle(QCPScatterStyle(look.mark, QPen(look.colour, 1.5), QBrush(Qt::white), 9));
        const bool grows = !isRatio && x.size() >= 2;
        graph->setName(grows ? Report::tr("%1: grows like n to the %2").arg(names[i], decimal(growthExponent(x, y), 2))
                             : names[i]);
        const auto [left, right] = std::ranges::minmax(x);
        const auto [least, most] = std::ranges::minmax(y);
        lowX = std::min(lowX, left), highX = std::max(highX, right), lowY = std::min(lowY, least),
        highY = std::max(highY, most);
    }
    if (isRatio) {
        lowY = std::min(lowY, 0.9), highY = std::max(highY, 1.1);
        auto* even = new QCPItemStraightLine(&plot);
        even->point1->setCoords(lowX, 1);
        even->point2->setCoords(highX, 1);
        even->setPen(QPen(Qt::black, 1));
    }
    makeLogarithmic(*plot.xAxis, lowX, highX);
    makeLogarithmic(*plot.yAxis, lowY, highY);
    plot.xAxis->setLabel(axis);
    plot.yAxis->setLabel(isRatio ? Report::tr("times as long as %1").arg(QString::fromStdString(baseline))
                                 : Report::tr("ms, median frame"));
    const int columns = isRatio ? 4 : 2;
    const int height  = 400 + 24 * ((static_cast<int>(names.size()) + columns - 1) / columns);
    putLegendBelow(plot, columns);
    return {isRatio ? QStringLiteral("break-even") : QStringLiteral("growth"),
            isRatio ? Report::tr("Below the line: faster than %1").arg(QString::fromStdString(baseline))
                    : Report::tr("How the time grows"),
            plot.toPixmap(kWidth, height, kScale).toImage()};
}

ReportChart errorChart(const ReportCase& each, std::size_t number)
{
    std::vector<SpeedErrorPoint> points;
    for (const BenchRow& row : each.rows)
        if (row.wrongPixels && row.medianMs > 0 && !isPeer(row))
            points.push_back({nameOf(row, mixesShading({&each, 1})), row.medianMs, row.q1Ms, row.q3Ms,
                              errorOf(row, ErrorMeasure::WrongPixels), markOf(row)});
    SpeedErrorChart chart;
    chart.setPalette(paletteOf(Appearance::Light, QPalette()));
    chart.resize(kWidth, 460);
    chart.setPoints(std::move(points), ErrorMeasure::WrongPixels);
    return {QStringLiteral("speed-error-%1").arg(number), Report::tr("Speed against error: %1").arg(each.scene),
            chart.toPixmap(kWidth, 460, kScale).toImage()};
}

enum class SeriesFigure { Time, Wrong };

/// Frame by frame along a camera path: times with the frame rate at the right, or the share of the picture that is
/// wrong. A line stands where the camera cuts.
ReportChart seriesChart(const ReportCase& each, std::size_t number, SeriesFigure figure)
{
    const bool  isTime = figure == SeriesFigure::Time;
    QCustomPlot plot;
    dress(plot);
    double low = 1e300, high = 0, frames = 1;
    int    shown = 0;
    for (std::size_t i = 0; i < each.rows.size(); ++i) {
        const BenchRow& row = each.rows[i];
        if (!row.series || row.isBroken() || (!isTime && row.wrongPixels.value_or(0) == 0)) continue;
        const std::vector<SeriesFrame>& of = row.series->frames;
        QVector<double>                 x, y;
        for (std::size_t frame = 0; frame < of.size(); ++frame) {
            x.push_back(static_cast<double>(frame));
            y.push_back(isTime ? of[frame].ms
                               : 100.0 * static_cast<double>(of[frame].wrongPixels.value_or(0))
                                     / static_cast<double>(std::max<std::uint64_t>(of[frame].covered, 1)));
            if (y.back() > 0) low = std::min(low, y.back());
            high = std::max(high, y.back());
        }
        frames                 = std::max(frames, static_cast<double>(of.size()));
        const ChartLook& look  = lookOf(i);
        QCPGraph*        graph = plot.addGraph();
        graph->setData(x, y);
        graph->setPen(QPen(look.colour, 2, look.dash));
        QCPScatterStyle mark(look.mark, QPen(look.colour, 1.5), QBrush(Qt::white), 7);
        graph->setScatterStyle(mark);
        graph->setScatterSkip(isTime ? 5 : 0);
        graph->setName(nameOf(row, false));
        ++shown;
    }
    for (const BenchRow& row : each.rows) {
        if (!row.series || row.series->lags.empty()) continue;
        for (const Lag& lag : row.series->lags) {
            auto* cut = new QCPItemStraightLine(&plot);
            cut->point1->setCoords(lag.cut - 0.5, low);
            cut->point2->setCoords(lag.cut - 0.5, high * 1.01 + 1e-9);
            cut->setPen(QPen(Qt::black, 1, Qt::DashLine));
            auto* word = new QCPItemText(&plot);
            word->setText(Report::tr("cut"));
            word->setFont(fontOfHeight(12));
            word->position->setTypeX(QCPItemPosition::ptPlotCoords);
            word->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
            word->position->setCoords(lag.cut - 0.2, 0.02);
            word->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        }
        break;  // all rows have been along the same path
    }
    plot.xAxis->setLabel(Report::tr("frame"));
    plot.xAxis->setRange(-1, frames);
    if (isTime) {
        makeLogarithmic(*plot.yAxis, low, high);
        plot.yAxis->setLabel(Report::tr("ms, median of the passes"));
        plot.yAxis2->setVisible(true);
        plot.yAxis2->setLabelFont(fontOfHeight(13));
        plot.yAxis2->setTickLabelFont(fontOfHeight(12));
        makeLogarithmic(*plot.yAxis2, 1, 10);
        plot.yAxis2->setRange(1000 / plot.yAxis->range().upper, 1000 / plot.yAxis->range().lower);
        plot.yAxis2->setRangeReversed(true);
        plot.yAxis2->setLabel(Report::tr("frames a second"));
    } else {
        plot.yAxis->setRange(0, high * 1.08);
        plot.yAxis->setLabel(Report::tr("wrong pixels, % of those covered"));
    }
    const int height = 360 + 24 * ((shown + 2) / 3);
    putLegendBelow(plot, 3);
    const QString title = isTime ? Report::tr("Frame by frame: %1") : Report::tr("Wrong pixels, frame by frame: %1");
    return {QStringLiteral("%1-%2").arg(isTime ? "series" : "lag").arg(number), title.arg(each.scene),
            plot.toPixmap(kWidth, height, kScale).toImage()};
}

bool hasTime(const ReportCase& each)
{
    return std::ranges::any_of(each.rows, [](const BenchRow& row) { return !row.isBroken() && row.medianMs > 0; });
}

/// One chart of all scenes, or one of each where that would be longer than a page.
void addStageCharts(std::span<const ReportCase> cases, std::vector<ReportChart>& charts)
{
    constexpr std::size_t kMostBars = 48;
    std::size_t           bars      = 0;
    for (const ReportCase& each : cases) bars += each.rows.size();
    if (std::ranges::none_of(cases, hasTime)) return;
    if (bars <= kMostBars || cases.size() == 1) return charts.push_back(stageChart(cases));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (!hasTime(cases[i])) continue;
        ReportChart chart = stageChart(cases.subspan(i, 1));
        chart.name        = QStringLiteral("stages-%1").arg(i + 1);
        chart.title       = Report::tr("Where the time goes: %1").arg(cases[i].scene);
        charts.push_back(std::move(chart));
    }
}

}  // namespace

double growthExponent(std::span<const double> x, std::span<const double> y)
{
    double     meanX = 0, meanY = 0, both = 0, square = 0;
    const auto n = static_cast<double>(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) meanX += std::log(x[i]) / n, meanY += std::log(y[i]) / n;
    for (std::size_t i = 0; i < x.size(); ++i) {
        both += (std::log(x[i]) - meanX) * (std::log(y[i]) - meanY);
        square += (std::log(x[i]) - meanX) * (std::log(x[i]) - meanX);
    }
    return both / square;
}

std::vector<ReportChart> chartsOf(std::span<const ReportCase> cases, const QString& axis, const std::string& baseline)
{
    std::vector<ReportChart> charts;
    addStageCharts(cases, charts);
    const bool hasAxis = !axis.isEmpty() && cases.size() >= 2;
    if (hasAxis) charts.push_back(growthChart(cases, axis, baseline, false));
    const bool hasBaseline = std::ranges::any_of(cases, [&](const ReportCase& each) {
        return std::ranges::find(each.rows, baseline, &BenchRow::algorithm) != each.rows.end();
    });
    if (hasAxis && hasBaseline) charts.push_back(growthChart(cases, axis, baseline, true));
    std::size_t number = 0;
    for (const ReportCase& each : cases) {
        ++number;
        if (std::ranges::any_of(each.rows,
                                [](const BenchRow& row) { return row.series.has_value() && !row.isBroken(); })) {
            charts.push_back(seriesChart(each, number, SeriesFigure::Time));
            if (std::ranges::any_of(each.rows, [](const BenchRow& row) {
                    return row.series && !row.isBroken() && row.wrongPixels.value_or(0) > 0;
                }))
                charts.push_back(seriesChart(each, number, SeriesFigure::Wrong));
        }
        if (std::ranges::any_of(each.rows,
                                [](const BenchRow& row) { return !isPeer(row) && row.wrongPixels.value_or(0) > 0; }))
            charts.push_back(errorChart(each, number));
    }
    return charts;
}

}  // namespace zscope::ui
