// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/faults/faults_panel.h"

#include <QDockWidget>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/panels/faults/faults_model.h"
#include "ui/parts/row_delegate.h"
#include "ui/parts/scrolling.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

FaultsPanel::FaultsPanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_model(new FaultsModel(this)), m_table(new QTableView), m_picture(new QLabel),
      m_words(new QLabel), m_hint(new QLabel), m_switch(new QPushButton), m_worker(std::make_unique<Worker>())
{
    m_table->setModel(m_model);
    m_table->setItemDelegate(new RowDelegate(m_table));
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setMinimumHeight(112);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setMinimumSectionSize(22);
    // names wrap where the panel is narrow
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(FaultsModel::Title, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(FaultsModel::Wrong, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setProperty("ownsArrows", true);
    m_table->setProperty("ownsEnter", true);
    m_picture->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    m_picture->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_words->setWordWrap(true);
    m_words->setTextFormat(Qt::RichText);
    m_words->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_words->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Minimum);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_hint->setMargin(2 * kStep);
    m_switch->setFocusPolicy(Qt::TabFocus);

    auto* body   = new ScrolledPart;
    auto* inside = new QVBoxLayout(body);
    inside->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    inside->setSpacing(6);
    inside->addWidget(m_table, 1);
    inside->addWidget(m_switch);  // above what may have to be scrolled to
    inside->addWidget(m_picture);
    inside->addWidget(m_words);
    m_bodyOrHint = new QStackedLayout(this);
    m_bodyOrHint->addWidget(scrolling(body));
    m_bodyOrHint->addWidget(m_hint);

    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &FaultsPanel::showFault);
    connect(m_table, &QTableView::activated, this, &FaultsPanel::toggle);
    connect(m_switch, &QPushButton::clicked, this, &FaultsPanel::toggle);
    spoken(*this, [this] {
        m_table->setAccessibleName(tr("Faults"));
        m_picture->setAccessibleName(tr("What the fault does to the picture; wrong pixels stand out in red"));
        m_hint->setText(tr("Open a scene: then the classic mistakes appear here, with what each of them does to it."));
        showFault();
    });
    m_table->setCurrentIndex(m_model->index(0, 0));
}

FaultsPanel::~FaultsPanel() = default;

void FaultsPanel::present(const Snapshot& shown, Changes what)
{
    if (what & Change::Pipeline) {
        m_model->setChosen(shown.pipeline.fault);
        QStringList titles;
        for (const Fault fault : shown.pipeline.fault) titles += said(entryOf(fault).title);
        emit summaryChanged(titles.isEmpty() ? QString() : QStringLiteral("\u2716 ") + titles.join(", "));
        showFault();
    }
    if (what & Change::Scene) m_asked.reset();
    if (what & (Change::Picture | Change::Scene)) ask();
}

void FaultsPanel::ask()
{
    const Snapshot& now = session().now();
    m_bodyOrHint->setCurrentIndex(now.scene ? 0 : 1);
    if (!m_isSeen || !now.scene || !now.frame) return;
    Question question{now.scene.get(), now.frame->camera, now.frame->pipeline, session().settings().faceCulling};
    question.pipeline.fault = {};
    if (m_asked == question) return;
    m_asked = question;
    m_model->forget();
    showFault();
    DrawRequest request = session().request();
    request.camera      = now.frame->camera;
    request.pipeline    = question.pipeline;
    m_worker->post(Worker::Slot::Draw, [this, request, question](const std::atomic<bool>& cancel) {
        drawFaults(request, cancel, [this, question](FaultPicture picture) {
            m_worker->deliver([this, question, picture = std::move(picture)]() mutable {
                if (m_asked != question) return;
                const Fault fault = picture.fault;
                m_model->add(std::move(picture));
                const int row = m_table->currentIndex().row();
                if (row >= 0 && faults()[static_cast<std::size_t>(row)].fault == fault) showFault();
            });
        });
    });
}

void FaultsPanel::showFault()
{
    const int row = m_table->currentIndex().row();
    if (row < 0) return;
    const FaultEntry&   entry   = faults()[static_cast<std::size_t>(row)];
    const FaultPicture* picture = m_model->pictureOf(row);
    if (picture) {
        const double ratio = devicePixelRatioF();
        const QSize  room  = QSize(std::max(80, width() - 4 * kStep), 150) * ratio;
        QPixmap image = QPixmap::fromImage(picture->picture.scaled(room, Qt::KeepAspectRatio, Qt::FastTransformation));
        image.setDevicePixelRatio(ratio);
        m_picture->setPixmap(image);
    } else {
        m_picture->clear();
    }
    m_picture->setVisible(picture != nullptr);
    QString words;
    if (picture) {
        const QString where = QString::fromStdString(nameOf(picture->pipeline)).toHtmlEscaped();
        const QString form  = picture->isOfChosen
                                  ? tr("<b>%1 of %2 pixels</b> are wrong with <b>%3</b>.")
                                  : tr("<b>%1 of %2 pixels</b> are wrong with <b>%3</b>, in which it can happen.");
        words               = form.arg(grouped(picture->wrongPixels), grouped(picture->pixels), where);
        words += QStringLiteral("<br>");
    }
    m_words->setText(words + said(entry.cause).toHtmlEscaped() + QStringLiteral("<br>")
                     + tr("<b>Right:</b> %1").arg(said(entry.cure).toHtmlEscaped()));
    const bool isOn = session().now().pipeline.fault.has(entry.fault);
    m_switch->setText(isOn ? tr("Switch it off") : tr("Switch it on"));
    m_switch->setEnabled(isOn || picture);
    m_switch->setToolTip(isOn || picture ? QString() : tr("It is being drawn, or cannot happen in this scene"));
}

void FaultsPanel::toggle()
{
    const int row = m_table->currentIndex().row();
    if (row < 0) return;
    const Fault fault   = faults()[static_cast<std::size_t>(row)].fault;
    Pipeline    changed = session().now().pipeline;
    if (changed.fault.has(fault)) {
        changed.fault.remove(fault);
        session().setPipeline(changed);
    } else if (const FaultPicture* picture = m_model->pictureOf(row)) {
        // Beside the others, where all of them can happen.
        changed.fault.add(fault);
        const bool isComposed = changed.chooser != Chooser::Measured;
        session().setPipeline(isComposed && !explainInvalid(changed) ? changed : picture->pipeline);
    }
}

void FaultsPanel::showEvent(QShowEvent* event)
{
    Panel::showEvent(event);
    for (QWidget* at = parentWidget(); at; at = at->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(at))
            connect(dock, &QDockWidget::visibilityChanged, this, &FaultsPanel::setSeen, Qt::UniqueConnection);
}

void FaultsPanel::setSeen(bool seen)
{
    m_isSeen = seen;
    if (seen) ask();
}

void FaultsPanel::resizeEvent(QResizeEvent* event)
{
    Panel::resizeEvent(event);
    showFault();
}

void FaultsPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_words) showFault();
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
