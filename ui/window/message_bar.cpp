// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/message_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), m_icon(new QLabel), m_text(new QLabel), m_close(new QToolButton)
{
    setObjectName("messageBar");
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_close->setObjectName("plain");
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kStep + 4, kStep, kStep, kStep);
    layout->setSpacing(kStep);
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_close);
    connect(m_close, &QToolButton::clicked, this, &QWidget::hide);
    dress();
    hide();
    spoken(*this, [this] {
        setAccessibleName(tr("Message"));
        m_close->setAccessibleName(tr("Close the message"));
        if (sentence().isEmpty()) return;
        if (m_say)
            show(m_say());
        else
            hide();
    });
}

void MessageBar::tell(std::function<QString()> say)
{
    m_say = std::move(say);
    show(m_say());
}

void MessageBar::tell(const Error& error)
{
    tell([error] { return said(error); });
}

void MessageBar::tell(const QString& sentence)
{
    m_say = nullptr;
    show(sentence);
}

void MessageBar::show(const QString& sentence)
{
    m_text->setText(sentence);
    setAccessibleDescription(sentence);
    QFrame::show();
}

QString MessageBar::sentence() const { return isVisibleTo(parentWidget()) ? m_text->text() : QString(); }

void MessageBar::dress()
{
    const Theme& theme = themeOf(palette());
    m_icon->setPixmap(iconOf("warning", theme.error).pixmap(20, 20));
    m_close->setIcon(iconOf("close", theme.text));
}

void MessageBar::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange && m_close) dress();
    QFrame::changeEvent(event);
}

}  // namespace zscope::ui
