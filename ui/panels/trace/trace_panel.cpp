// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/trace/trace_panel.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedLayout>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/panels/trace/trace_models.h"
#include "ui/parts/row_delegate.h"
#include "ui/parts/scrolling.h"
#include "ui/parts/wrapped_label.h"
#include "ui/predict/predictions.h"
#include "ui/session/tracer.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {
namespace {

QTreeView* tableOf(QAbstractItemModel* model, int lowest)
{
    auto* table = new QTreeView;
    table->setModel(model);
    table->setItemDelegate(new RowDelegate(table));
    table->setUniformRowHeights(true);
    table->setRootIsDecorated(false);
    table->setFrameShape(QFrame::NoFrame);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setMinimumHeight(lowest);
    table->setProperty("ownsUpAndDown", true);
    QFont small = table->font();
    small.setPointSizeF(small.pointSizeF() * 0.92);
    table->setFont(small);
    table->header()->setFont(small);
    table->header()->setStretchLastSection(false);
    table->header()->setSectionsMovable(false);
    table->header()->setSectionResizeMode(QHeaderView::Fixed);
    table->header()->setMinimumSectionSize(16);
    return table;
}

}  // namespace

TracePanel::TracePanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_rowsModel(new TraceRowsModel(this)), m_fieldsModel(new TraceFieldsModel(this)),
      m_rows(tableOf(m_rowsModel, 48)), m_fields(tableOf(m_fieldsModel, 90)), m_hint(wrappedLabel("hint")),
      m_title(wrappedLabel("title")), m_old(wrappedLabel()), m_work(wrappedLabel("soft")), m_sentence(wrappedLabel()),
      m_open(new QPushButton), m_again(new QPushButton), m_back(new QPushButton), m_close(new QPushButton),
      m_cancel(new QPushButton), m_first(new QPushButton), m_previous(new QPushButton), m_next(new QPushButton),
      m_nextDifference(new QPushButton), m_progress(new QProgressBar)
{
    m_rowsModel->setPalette(palette());
    m_fieldsModel->setPalette(palette());
    m_hint->setAlignment(Qt::AlignCenter);
    m_progress->setTextVisible(false);
    m_progress->setRange(0, 0);
    for (QPushButton* button :
         {m_open, m_again, m_back, m_close, m_cancel, m_first, m_previous, m_next, m_nextDifference})
        button->setFocusPolicy(Qt::TabFocus);
    m_rows->setHeaderHidden(true);
    for (QTreeView* table : {m_rows, m_fields}) table->viewport()->installEventFilter(this);

    const auto row = [](std::initializer_list<QWidget*> parts) {
        auto* line = new QHBoxLayout;
        line->setSpacing(kStep);
        for (QWidget* part : parts) line->addWidget(part);
        line->addStretch(1);
        return line;
    };
    auto* work = new QHBoxLayout;
    work->setSpacing(kStep);
    work->addWidget(m_progress, 1);
    work->addWidget(m_cancel);

    auto* body   = new ScrolledPart;
    auto* inside = new QVBoxLayout(body);
    inside->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    inside->setSpacing(kStep);
    auto* head = new QHBoxLayout;
    head->setSpacing(kStep);
    head->addWidget(m_title, 1);
    head->addWidget(m_again);
    head->addWidget(m_close);
    inside->addLayout(head);
    inside->addWidget(m_old);
    inside->addLayout(row({m_back}));
    inside->addWidget(m_work);
    inside->addLayout(work);
    inside->addWidget(m_sentence);
    inside->addLayout(row({m_first, m_previous, m_next, m_nextDifference}));
    inside->addWidget(m_rows, 2);
    inside->addWidget(m_fields, 3);

    auto* empty  = new QWidget;
    auto* middle = new QVBoxLayout(empty);
    middle->setContentsMargins(2 * kStep, kStep, 2 * kStep, kStep);
    middle->setSpacing(kStep);
    middle->addStretch(1);
    middle->addWidget(m_hint);
    middle->addWidget(m_open, 0, Qt::AlignHCenter);
    middle->addStretch(1);
    m_bodyOrHint = new QStackedLayout(this);
    m_bodyOrHint->addWidget(scrolling(body));
    m_bodyOrHint->addWidget(empty);

    Tracer& tracer = session.tracer();
    connect(m_open, &QPushButton::clicked, &tracer, &Tracer::chooseFile);
    connect(m_again, &QPushButton::clicked, &tracer, &Tracer::judgeAgain);
    connect(m_back, &QPushButton::clicked, &tracer, &Tracer::goBack);
    connect(m_close, &QPushButton::clicked, &tracer, &Tracer::close);
    connect(m_cancel, &QPushButton::clicked, &tracer, &Tracer::cancel);
    connect(m_first, &QPushButton::clicked, &tracer, &Tracer::goToFirstDifference);
    connect(m_previous, &QPushButton::clicked, &tracer, [&tracer] { tracer.goToNextRow(Direction::Back); });
    connect(m_next, &QPushButton::clicked, &tracer, [&tracer] { tracer.goToNextRow(Direction::Forward); });
    connect(m_nextDifference, &QPushButton::clicked, &tracer,
            [&tracer] { tracer.goToNextDifference(Direction::Forward); });
    connect(&tracer, &Tracer::changed, this, &TracePanel::showTrace);
    connect(m_rows->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& at) {
        if (!m_isShowing && at.isValid()) this->session().tracer().goToRow(static_cast<std::size_t>(at.row()));
    });
    spoken(*this, [this] {
        m_hint->setText(
            tr("Open a trace of your own program, or drop it on the window: it is stepped beside our run, "
               "and the first row that differs is found."));
        m_open->setText(tr("Open my trace…"));
        m_again->setText(tr("Judge again"));
        m_again->setToolTip(tr("Reads the file again and holds it against the run on show"));
        m_back->setText(tr("Back to its run"));
        m_back->setToolTip(tr("To the scene, the camera and the algorithm that the trace was held against"));
        m_close->setText(tr("Close"));
        m_close->setToolTip(tr("Closes the trace; the file stays as it is"));
        m_cancel->setText(tr("Cancel"));
        m_first->setText(tr("First difference"));
        m_previous->setText(QStringLiteral("\u25C0"));
        m_next->setText(QStringLiteral("\u25B6"));
        m_nextDifference->setText(QStringLiteral("\u2716 \u25B6"));
        m_previous->setToolTip(tr("The row before"));
        m_next->setToolTip(tr("The next row"));
        m_nextDifference->setToolTip(tr("The next row that differs"));
        for (QPushButton* button : {m_previous, m_next, m_nextDifference}) button->setAccessibleName(button->toolTip());
        m_rows->setAccessibleName(tr("Rows of the trace"));
        m_fields->setAccessibleName(tr("Fields of the row: ours and yours"));
        m_sentence->setAccessibleName(tr("What differs"));
        m_progress->setAccessibleName(tr("Progress of the judging"));
        m_work->setText(tr("The trace is read and held against our run."));
        m_old->setText(QStringLiteral("\u26A0 ")
                       + tr("Another run is on show than the one that the trace was held against."));
        showTrace();
    });
}

void TracePanel::present(const Snapshot&, Changes what)
{
    if (what & (Change::Scene | Change::Camera | Change::Pipeline | Change::Picture)) showTrace();
}

void TracePanel::showTrace()
{
    const Tracer&     tracer = session().tracer();
    const TheirTrace* trace  = tracer.trace();
    const bool        isOld  = tracer.isOld();
    m_bodyOrHint->setCurrentIndex(trace || tracer.isJudging() ? 0 : 1);
    for (QWidget* part : std::initializer_list<QWidget*>{m_progress, m_cancel, m_work})
        part->setVisible(tracer.isJudging());
    for (QWidget* part : std::initializer_list<QWidget*>{m_title, m_sentence, m_rows, m_fields, m_again, m_close,
                                                         m_first, m_previous, m_next, m_nextDifference})
        part->setVisible(trace != nullptr);
    m_old->setVisible(isOld);
    m_back->setVisible(isOld);
    m_again->setEnabled(!tracer.isJudging());
    m_isShowing = true;
    m_rowsModel->present(trace ? trace->trace : nullptr, trace ? trace->answer : nullptr);
    m_isShowing = false;
    if (trace) {
        m_title->setText(trace->title);
        m_first->setEnabled(trace->answer->firstWrong.has_value());
        m_nextDifference->setEnabled(trace->differenceFrom(tracer.row(), Direction::Forward).has_value());
        m_previous->setEnabled(tracer.row() && *tracer.row() > 0);
        m_next->setEnabled(!tracer.row() || *tracer.row() + 1 < trace->answer->rows.size());
        emit summaryChanged(isOld ? tr("old")
                            : trace->answer->isRight()
                                ? tr("no difference")
                                : counted(trace->answer->wrong, tr("1 row differs"), tr("%1 rows differ")));
    } else {
        emit summaryChanged({});
    }
    showRow();
}

void TracePanel::showRow()
{
    const Tracer&     tracer = session().tracer();
    const TheirTrace* trace  = tracer.trace();
    const auto        row    = tracer.row();
    m_rowsModel->presentNow(tracer.isOld() ? std::nullopt : row);
    m_isShowing = true;
    if (trace && row) {
        const QModelIndex at = m_rowsModel->index(static_cast<int>(*row), 0);
        if (m_rows->currentIndex().row() != at.row()) {
            m_rows->setCurrentIndex(at);
            m_rows->scrollTo(at);
        }
    } else {
        m_rows->setCurrentIndex({});
    }
    m_isShowing = false;
    if (trace) m_sentence->setText(sentenceOf(*trace, row));
    const bool  isAsked = session().predictions().isAnyOpen();  // what comes is not shown before the answer
    const auto* fields  = isAsked ? nullptr : tracer.fields();
    if (!fields && row && !isAsked) return;  // they are on their way
    if (!m_fieldsModel->present(fields ? *fields : std::vector<check::FieldBeside>())) return;
    const int first = m_fieldsModel->firstDifference();
    if (first >= 0) m_fields->scrollTo(m_fieldsModel->index(first, 0), QAbstractItemView::PositionAtCenter);
    fitColumns();
}

/// Of the row if it differs and is not the first one; else of the trace, which tells of that.
QString TracePanel::sentenceOf(const TheirTrace& trace, std::optional<std::size_t> row) const
{
    if (session().predictions().isAnyOpen()) return tr("The row stands beside ours when the question is answered.");
    const check::JudgedRow* judged = row ? &trace.answer->rows[*row] : nullptr;
    if (judged && judged->isRounding) return tr("This row differs by rounding alone.");
    return said(judged && judged->isWrong() && row != trace.answer->firstWrong ? judged->sentence
                                                                               : trace.answer->sentence);
}

void TracePanel::fitColumns()
{
    const QFontMetrics metrics = m_rows->fontMetrics();
    const int          mark    = metrics.horizontalAdvance(QStringLiteral("\u2716")) + 12;
    const int          line =
        std::max(metrics.horizontalAdvance(grouped(static_cast<std::uint64_t>(m_rowsModel->rowCount()))),
                 metrics.horizontalAdvance(m_rowsModel->headerData(TraceRowsModel::Line, Qt::Horizontal).toString()))
        + 14;
    m_rows->setColumnWidth(TraceRowsModel::Mark, mark);
    m_rows->setColumnWidth(TraceRowsModel::Line, line);
    m_rows->setColumnWidth(TraceRowsModel::Moment, std::max(80, m_rows->viewport()->width() - mark - line));
    const int room  = m_fields->viewport()->width() - mark;
    const int value = std::clamp(room * 3 / 10, metrics.horizontalAdvance(QStringLiteral("000.000000")) + 12, 180);
    m_fields->setColumnWidth(TraceFieldsModel::Mark, mark);
    m_fields->setColumnWidth(TraceFieldsModel::Ours, value);
    m_fields->setColumnWidth(TraceFieldsModel::Theirs, value);
    m_fields->setColumnWidth(TraceFieldsModel::Field, std::max(70, room - 2 * value));
}

/// Of the panel's width scroll bars take some, which come and go with what is said.
bool TracePanel::eventFilter(QObject* object, QEvent* event)
{
    if (event->type() == QEvent::Resize) fitColumns();
    return Panel::eventFilter(object, event);
}

void TracePanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_bodyOrHint) {
        m_rowsModel->setPalette(palette());
        m_fieldsModel->setPalette(palette());
        showTrace();
    }
    Panel::changeEvent(event);
}

}  // namespace zscope::ui
