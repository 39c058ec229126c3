// SPDX-License-Identifier: GPL-3.0-or-later
// All keys on one sheet, menu by menu, as they are bound now: it follows every change while it is open.
#pragma once

#include <QDialog>
#include <QTimer>

class QMenuBar;
class QTextBrowser;

namespace zscope::ui {

class CheatSheet final : public QDialog {
    Q_OBJECT

public:
    CheatSheet(const QMenuBar& menus, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void write();

    const QMenuBar& m_menus;
    QTextBrowser*   m_text;
    QTimer          m_later;  // one writing for many changes
};

}  // namespace zscope::ui
