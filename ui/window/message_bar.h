// SPDX-License-Identifier: GPL-3.0-or-later
// What went wrong, above the picture, until it is closed or something goes right. Blocks nothing.
#pragma once

#include <functional>

#include <QFrame>

#include "core/base/result.h"

class QLabel;
class QToolButton;

namespace zscope::ui {

class MessageBar final : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    /// Says it again when the language changes.
    void tell(std::function<QString()> say);
    void tell(const Error& error);
    /// Goes when the language changes.
    void    tell(const QString& sentence);
    QString sentence() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void dress();
    void show(const QString& sentence);

    QLabel*                  m_icon;
    QLabel*                  m_text;
    QToolButton*             m_close;
    std::function<QString()> m_say;  // what is told; nothing: it is known in one language only
};

}  // namespace zscope::ui
