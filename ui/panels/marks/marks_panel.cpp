// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/marks/marks_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/panels/marks/marks_model.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

MarksPanel::MarksPanel(Session& session, QWidget* parent)
    : Panel(session, parent), m_model(new MarksModel(session, this)), m_table(new QTableView), m_hint(new QLabel),
      m_bookmark(new QPushButton), m_remove(new QPushButton), m_break(new QToolButton)
{
    m_table->setModel(m_model);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_table->setTabKeyNavigation(false);
    m_table->setMinimumHeight(60);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setMinimumSectionSize(24);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // both columns wrap
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionResizeMode(MarksModel::Name, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(MarksModel::Where, QHeaderView::Stretch);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setProperty("ownsArrows", true);
    m_table->setProperty("ownsEnter", true);  // it jumps
    m_table->installEventFilter(this);
    m_hint->setObjectName("hint");
    m_hint->setWordWrap(true);
    m_hint->setAlignment(Qt::AlignCenter);
    m_bookmark->setText(QStringLiteral("\u2605"));
    m_break->setText(QStringLiteral("\u25CF \u2026"));
    m_break->setPopupMode(QToolButton::InstantPopup);
    m_break->setMenu(new QMenu(m_break));
    for (std::size_t i = 0; i < m_breaks.size(); ++i)
        m_breaks[i] = m_break->menu()->addAction(QString(), this, [this, i] {
            if (const auto at = breakpointHere(this->session().now(), static_cast<Breakpoint::On>(i)))
                this->session().toggleBreakpoint(*at);
        });

    auto* row = new QHBoxLayout;
    row->setSpacing(kStep);
    for (QWidget* button :
         {static_cast<QWidget*>(m_bookmark), static_cast<QWidget*>(m_break), static_cast<QWidget*>(m_remove)}) {
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
    }
    row->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kStep + 4, 0, kStep + 4, kStep);
    layout->setSpacing(kStep);
    layout->addWidget(m_hint, 1);
    layout->addWidget(m_table, 1);
    layout->addLayout(row);

    spoken(*this, [this] {
        m_bookmark->setAccessibleName(tr("Bookmark"));
        m_remove->setText(tr("Remove"));
        m_table->setAccessibleName(tr("Bookmarks and breakpoints"));
        m_hint->setText(tr(
            "Ctrl+B marks a step to come back to. F9 sets a breakpoint on what is picked or selected; F5 runs to it."));
        m_bookmark->setToolTip(tr("Marks the step on show, or takes its mark away (Ctrl+B)"));
        m_remove->setToolTip(tr("Removes the selected mark (Del)"));
        m_break->setAccessibleName(tr("Break on"));
        m_break->setToolTip(tr("Sets a breakpoint on what is picked or selected, or takes it away (F9)"));
    });
    connect(m_bookmark, &QPushButton::clicked, this, [this] { this->session().toggleBookmark(); });
    connect(m_remove, &QPushButton::clicked, this, [this] { remove(m_table->currentIndex().row()); });
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex& at) { go(at.row()); });
}

void MarksPanel::present(const Snapshot& shown, Changes what)
{
    if (what & Change::Marks) {
        m_model->present(shown.marks);
        const int marks = m_model->rowCount();
        m_table->setVisible(marks > 0);
        m_hint->setVisible(marks == 0);
        m_remove->setEnabled(marks > 0);
        emit summaryChanged(marks == 0 ? QString() : grouped(static_cast<std::uint64_t>(marks)));
    }
    if (what & (Change::Marks | Change::Selection | Change::Picture | Change::Scene)) showChoices(shown);
}

void MarksPanel::showChoices(const Snapshot& shown)
{
    const std::array kinds{tr("line"), tr("pixel"), tr("node"), tr("triangle")};
    const std::array missing{tr("The step works on no line, and no pixel is picked"), tr("No pixel is picked"),
                             tr("No node is selected"), tr("No triangle is selected or picked")};
    for (std::size_t i = 0; i < m_breaks.size(); ++i) {
        const auto at = breakpointHere(shown, static_cast<Breakpoint::On>(i));
        m_breaks[i]->setText(at ? textOf(*at) : kinds[i]);
        m_breaks[i]->setEnabled(at.has_value());
        m_breaks[i]->setToolTip(at ? QString() : missing[i]);
    }
    m_break->menu()->setToolTipsVisible(true);
    m_bookmark->setEnabled(session().position().has_value());
}

void MarksPanel::go(int row)
{
    if (const auto at = m_model->bookmarkOf(row))
        session().goToBookmark(*at);
    else if (m_model->breakpointOf(row))
        session().runTo(Direction::Forward);
}

void MarksPanel::remove(int row)
{
    if (const auto at = m_model->bookmarkOf(row))
        session().removeBookmark(*at);
    else if (const auto on = m_model->breakpointOf(row))
        session().removeBreakpoint(*on);
}

bool MarksPanel::eventFilter(QObject* object, QEvent* event)
{
    if (object == m_table && event->type() == QEvent::KeyPress
        && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        remove(m_table->currentIndex().row());
        return true;
    }
    return Panel::eventFilter(object, event);
}

}  // namespace zscope::ui
