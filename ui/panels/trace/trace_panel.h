// SPDX-License-Identifier: GPL-3.0-or-later
// Another program's trace stepped beside our run: its rows, and of the current one every field beside ours. A row is a
// link to its step; the step on show leads to its row.
#pragma once

#include "ui/panels/panel.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedLayout;
class QTreeView;

namespace zscope::ui {

class TraceFieldsModel;
class TraceRowsModel;
struct TheirTrace;

class TracePanel final : public Panel {
    Q_OBJECT

public:
    explicit TracePanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void    showTrace();
    void    showRow();
    QString sentenceOf(const TheirTrace& trace, std::optional<std::size_t> row) const;
    void    fitColumns();

    TraceRowsModel*   m_rowsModel;
    TraceFieldsModel* m_fieldsModel;
    QTreeView *       m_rows, *m_fields;
    QStackedLayout*   m_bodyOrHint;
    QLabel *          m_hint, *m_title, *m_old, *m_work, *m_sentence;
    QPushButton *     m_open, *m_again, *m_back, *m_close, *m_cancel;
    QPushButton *     m_first, *m_previous, *m_next, *m_nextDifference;
    QProgressBar*     m_progress;
    bool              m_isShowing = false;  // the current row is not the user's choice
};

}  // namespace zscope::ui
