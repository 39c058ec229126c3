// SPDX-License-Identifier: GPL-3.0-or-later
// Bookmarks and breakpoints: go there, rename, remove, and add one on what is picked or selected.
#pragma once

#include "ui/panels/panel.h"

class QAction;
class QLabel;
class QPushButton;
class QTableView;
class QToolButton;

namespace zscope::ui {

class MarksModel;

class MarksPanel final : public Panel {
    Q_OBJECT

public:
    explicit MarksPanel(Session& session, QWidget* parent = nullptr);

    void present(const Snapshot& shown, Changes what) override;

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void go(int row);
    void remove(int row);
    void showChoices(const Snapshot& shown);

    MarksModel*             m_model;
    QTableView*             m_table;
    QLabel*                 m_hint;
    QPushButton *           m_bookmark, *m_remove;
    QToolButton*            m_break;
    std::array<QAction*, 4> m_breaks{};  // by Breakpoint::On
};

}  // namespace zscope::ui
