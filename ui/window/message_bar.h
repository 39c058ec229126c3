// SPDX-License-Identifier: GPL-3.0-or-later
// What went wrong, above the picture, until it is closed or something goes right. Blocks nothing.
#pragma once

#include <QFrame>

class QLabel;
class QToolButton;

namespace zscope::ui {

class MessageBar final : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void    tell(const QString& sentence);
    QString sentence() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void dress();

    QLabel*      m_icon;
    QLabel*      m_text;
    QToolButton* m_close;
};

}  // namespace zscope::ui
