// SPDX-License-Identifier: GPL-3.0-or-later
// What saved pictures are called: the template, the name that comes next, and what is wrong with it while it is typed.
#pragma once

#include <QDialog>

#include "ui/session/snapshot.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace zscope::ui {

class PictureNamesDialog final : public QDialog {
    Q_OBJECT

public:
    /// `shown` and `folder` are what the next name is made for.
    PictureNamesDialog(const QString& pattern, const Snapshot& shown, const QString& folder, QWidget* parent);

    QString pattern() const;

private:
    void showNext();

    const Snapshot m_shown;
    const QString  m_folder;
    QLineEdit*     m_pattern;
    QLabel*        m_next;
    QPushButton*   m_keep;
};

}  // namespace zscope::ui
