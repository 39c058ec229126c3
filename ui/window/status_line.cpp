// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/text/utf8_text.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

QString pixelText(const Snapshot& shown, const std::optional<QPoint>& pixel)
{
    const auto facts = pixel ? factsOf(shown, *pixel) : std::nullopt;
    if (!facts) return {};
    QString text = StatusLine::tr("x %1  y %2").arg(facts->pixel.x()).arg(facts->pixel.y());
    if (facts->theirs) {
        if (!facts->theirs->isCovered) return text + "   " + StatusLine::tr("background");
        if (facts->theirs->id) text += "   " + StatusLine::tr("id %1").arg(*facts->theirs->id);
        if (facts->theirs->depth) text += "   " + StatusLine::tr("depth %1").arg(significant(*facts->theirs->depth, 6));
        return text;
    }
    if (!facts->triangle) return text + "   " + StatusLine::tr("background");
    return text + "   " + StatusLine::tr("triangle %1").arg(grouped(facts->triangle->value)) + "   D "
           + depthText(facts->depth) + "   z " + decimal(facts->z, 4);
}

StatusLine::StatusLine(Session& session, QWidget* parent)
    : QStatusBar(parent), m_session(session), m_algorithm(new QLabel), m_time(new QLabel), m_exact(new QLabel),
      m_triangles(new QLabel), m_pixel(new QLabel), m_machine(new QLabel), m_work(new QLabel),
      m_progress(new QProgressBar), m_cancel(new QToolButton)
{
    setSizeGripEnabled(false);
    m_algorithm->setObjectName("title");
    m_machine->setObjectName("soft");
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(120);
    m_cancel->setObjectName("plain");
    connect(m_cancel, &QToolButton::clicked, this, [this] { m_session.cancelWork(); });
    for (QLabel* label : {m_algorithm, m_time, m_exact}) addWidget(label);
    // gives way to what is at work, before the window would grow
    m_triangles->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    addWidget(m_triangles, 1);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_work, m_progress, m_cancel, m_pixel, m_machine})
        addPermanentWidget(widget);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_work, m_progress, m_cancel}) widget->hide();

    m_patience.setSingleShot(true);
    m_patience.setInterval(250);
    connect(&m_patience, &QTimer::timeout, this, [this] { showBusy(m_session.now()); });
    spoken(*this, [this] {
        m_time->setAccessibleName(tr("Time of the frame"));
        m_triangles->setAccessibleName(tr("Triangles"));
        m_pixel->setAccessibleName(tr("Pixel"));
        m_cancel->setText(tr("Cancel"));
        m_cancel->setToolTip(tr("Stop what is being loaded, drawn or replayed (Esc)"));
    });
}

void StatusLine::present(const Snapshot& shown, Changes what)
{
    if (what & (Change::Scene | Change::Picture) && !shown.frame)
        // they speak of a frame
        for (QLabel* label : {m_algorithm, m_time, m_exact, m_triangles, m_machine}) label->clear();
    if ((what & (Change::Picture | Change::Pipeline)) && shown.frame) {
        const DrawnFrame& frame  = *shown.frame;
        const std::string name   = nameOf(frame.pipeline);
        const Preset*     preset = findPreset(name);
        m_algorithm->setText(QString::fromStdString(name));
        m_algorithm->setToolTip(!frame.report.why.empty() ? said(frame.report.why)
                                : preset                  ? said(preset->title)
                                                          : QString());
        m_time->setText(milliseconds(frame.report.frameMs));
        m_time->setToolTip(
            counted(frame.framesTimed, tr("One frame at full speed"), tr("The median of %1 frames at full speed"))
            + (shown.step ? tr("; replaying up to this step took %1").arg(milliseconds(shown.step->replayMs))
                          : QString()));
        const Claim claim = claimOf(frame.pipeline);
        m_exact->setText(!frame.pipeline.fault.isEmpty() ? tr("with a fault")
                         : claim == Claim::Exact         ? tr("exact")
                         : claim == Claim::ExactByFace   ? tr("exact by face")
                                                         : tr("approximate"));
        const std::size_t triangles = shown.scene ? shown.scene->scene().triangleCount() : 0;
        m_triangles->setText(tr("%1 of %2 seen in %3")
                                 .arg(grouped(frame.visibleTriangles),
                                      counted(triangles, tr("1 triangle"), tr("%1 triangles")),
                                      counted(frame.coveredPixels, tr("1 pixel"), tr("%1 pixels"))));
        const std::string_view simd = wordOf(frame.report.simd);
        m_machine->setText(counted(static_cast<unsigned>(frame.report.threads), tr("1 thread"), tr("%1 threads"))
                           + " · " + utf8Text(simd));
    }
    if (what & Change::Busy) {
        if (shown.busy.isEmpty()) {
            m_patience.stop();
            showBusy(shown);
        } else if (m_work->isVisible()) {
            showBusy(shown);
        } else if (!m_patience.isActive()) {
            m_patience.start();
        }
    }
    if (what & (Change::Picture | Change::Selection)) showPixel(shown);
}

void StatusLine::hover(const std::optional<QPoint>& pixel)
{
    m_hovered = pixel;
    showPixel(m_session.now());
}

void StatusLine::showPixel(const Snapshot& shown)
{
    m_pixel->setText(pixelText(shown, m_hovered ? m_hovered : shown.picked));
}

void StatusLine::showBusy(const Snapshot& shown)
{
    const bool busy = !shown.busy.isEmpty();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_work, m_progress, m_cancel}) widget->setVisible(busy);
    if (!busy) return;
    m_work->setText(shown.busy);
    m_progress->setRange(0, shown.progress < 0 ? 0 : 1000);
    if (shown.progress >= 0) m_progress->setValue(static_cast<int>(shown.progress * 1000));
}

}  // namespace zscope::ui
