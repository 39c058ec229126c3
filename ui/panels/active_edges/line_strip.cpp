// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/active_edges/line_strip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

constexpr int kLaneHeight  = 7;
constexpr int kOwnerHeight = 18;

}  // namespace

LineStripContents stripOf(const StepState& state)
{
    LineStripContents strip;
    if (!state.sweep || state.sweep->y < 0) return strip;
    const SweepState&       sweep   = *state.sweep;
    const VisibilityBuffer& visible = state.frame.visible;

    double low = visible.width(), high = 0;
    for (const EdgeRow& edge : sweep.activeEdges) {
        low  = std::min(low, edge.x);
        high = std::max(high, edge.x);
    }
    strip.x0 = std::max(0, static_cast<int>(std::floor(std::max(low, 0.0))) - 1);
    strip.x1 = std::min(visible.width(), static_cast<int>(std::ceil(std::min(high, visible.width() + 0.0))) + 1);
    if (sweep.activeEdges.empty() || strip.x0 >= strip.x1) return {};

    std::array<int, LineStripContents::kLanes> ends{};  // of the last span in each lane
    std::vector<SpanRow>                       spans = sweep.spans;
    std::ranges::stable_sort(spans, {}, &SpanRow::x0);
    for (const SpanRow& span : spans) {
        if (span.x1 <= strip.x0 || span.x0 >= strip.x1) continue;
        const auto free = std::ranges::find_if(ends, [&](int end) { return end <= span.x0; });
        const auto lane = free == ends.end() ? LineStripContents::kLanes - 1 : static_cast<int>(free - ends.begin());
        ends[static_cast<std::size_t>(lane)] = span.x1;
        strip.lanes                          = std::max(strip.lanes, lane + 1);
        const bool isNow                     = state.event >= Grain::Span && state.span && span == *state.span;
        strip.offered.push_back(
            {std::max(span.x0, strip.x0), std::min(span.x1, strip.x1), span.polygon.value, lane, isNow});
    }
    const auto rank = [&](int x) { return visible.rankAt(x, sweep.y); };
    for (int x = strip.x0; x < strip.x1;) {
        int end = x + 1;
        while (end < strip.x1 && rank(end) == rank(x)) ++end;
        if (rank(x) != 0) strip.owners.push_back({x, end, rank(x) - 1, 0, false});
        x = end;
    }
    return strip;
}

LineStrip::LineStrip(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMouseTracking(true);
    spoken(*this, [this] { setAccessibleName(tr("Strip of the current line")); });
}

QSize LineStrip::sizeHint() const
{
    return {320, LineStripContents::kLanes * kLaneHeight + kOwnerHeight + fontMetrics().height() + 6};
}

void LineStrip::present(const Snapshot& shown)
{
    const ShownStep* step = shown.stepOfPicture();
    m_contents            = step ? stripOf(step->state) : LineStripContents{};
    m_picked              = pickedTriangle(shown);
    setAccessibleDescription(
        counted(m_contents.owners.size(), tr("1 interval has an owner"), tr("%1 intervals have an owner")));
    update();
}

double LineStrip::toView(double x) const
{
    return (x - m_contents.x0) * width() / std::max(1, m_contents.x1 - m_contents.x0);
}

std::optional<int> LineStrip::pixelAt(double view) const
{
    if (m_contents.x0 >= m_contents.x1) return {};
    const int x = m_contents.x0 + static_cast<int>(view * (m_contents.x1 - m_contents.x0) / std::max(1, width()));
    return std::clamp(x, m_contents.x0, m_contents.x1 - 1);
}

void LineStrip::paintEvent(QPaintEvent*)
{
    const Theme& theme = themeOf(palette());
    QPainter     painter(this);
    const int    ownersTop = LineStripContents::kLanes * kLaneHeight + 2;
    painter.fillRect(QRect(0, ownersTop, width(), kOwnerHeight), theme.ground);
    const auto runRect = [&](const StripRun& run, int top, int height) {
        const double left = toView(run.x0), right = toView(run.x1);
        const double gap = right - left > 4 ? 1 : 0;  // neighbours of one colour stay two
        return QRectF(left, top, std::max(right - left - gap, 1.0), height);
    };
    const auto paintRun = [&](const StripRun& run, const QRectF& at) {
        const bool picked = m_picked && run.polygon == m_picked->value;
        painter.fillRect(at, run.isNow ? theme.now : picked ? theme.picked : theme.ofPolygon(run.polygon));
    };
    for (const StripRun& run : m_contents.offered)
        paintRun(run, runRect(run, (LineStripContents::kLanes - 1 - run.lane) * kLaneHeight, kLaneHeight - 1));
    for (const StripRun& run : m_contents.owners) paintRun(run, runRect(run, ownersTop, kOwnerHeight));

    const QRect labels(0, ownersTop + kOwnerHeight + 2, width(), fontMetrics().height());
    painter.setPen(theme.softText);
    if (m_contents.x0 >= m_contents.x1) {
        painter.drawText(labels, Qt::AlignLeft | Qt::AlignVCenter, tr("Nothing on this line"));
        return;
    }
    painter.drawText(labels, Qt::AlignLeft | Qt::AlignVCenter,
                     tr("x %1").arg(grouped(static_cast<unsigned>(m_contents.x0))));
    painter.drawText(
        labels, Qt::AlignHCenter | Qt::AlignVCenter,
        m_contents.offered.empty() ? tr("no span of this line is filled yet") : tr("spans offered, owners below"));
    painter.drawText(labels, Qt::AlignRight | Qt::AlignVCenter, grouped(static_cast<unsigned>(m_contents.x1)));
}

void LineStrip::mousePressEvent(QMouseEvent* event)
{
    if (const auto x = pixelAt(event->position().x())) emit picked(*x);
}

bool LineStrip::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QString     text;
    if (const auto x = pixelAt(help->pos().x())) {
        const auto run =
            std::ranges::find_if(m_contents.owners, [&](const StripRun& r) { return r.x0 <= *x && *x < r.x1; });
        text = run == m_contents.owners.end()
                   ? tr("x %1: background").arg(grouped(static_cast<unsigned>(*x)))
                   : tr("x %1 to %2: triangle %3")
                         .arg(grouped(static_cast<unsigned>(run->x0)), grouped(static_cast<unsigned>(run->x1 - 1)),
                              grouped(run->polygon));
    }
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

}  // namespace zscope::ui
