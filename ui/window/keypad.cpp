// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/keypad.h"

#include <algorithm>

#include <QAction>
#include <QKeyEvent>
#include <QWidget>

#include "ui/parts/typing.h"
#include "ui/window/key_bindings.h"

namespace zscope::ui {
namespace {

constexpr Qt::Key kWithoutNumLock[] = {Qt::Key_Insert, Qt::Key_End, Qt::Key_Down, Qt::Key_PageDown, Qt::Key_Left,
                                       // of 0 to 9
                                       Qt::Key_Clear, Qt::Key_Right, Qt::Key_Home, Qt::Key_Up, Qt::Key_PageUp};

/// What the key is with NumLock.
Qt::Key withNumLock(int key)
{
    const auto* found = std::ranges::find(kWithoutNumLock, key);
    return static_cast<Qt::Key>(found == std::end(kWithoutNumLock) ? key
                                                                   : Qt::Key_0 + (found - std::begin(kWithoutNumLock)));
}

/// Of the window itself or of a panel that floats beside it; not of a dialog or a menu.
bool isPartOf(const QWidget& window, const QWidget& widget)
{
    const QWidget* top = widget.window();
    if (top->windowType() == Qt::Tool && top->parentWidget()) top = top->parentWidget()->window();
    return top == &window;
}

}  // namespace

Keypad::Keypad(QWidget& window, const KeyBindings& bindings) : QObject(&window), m_window(window), m_bindings(bindings)
{}

bool Keypad::eventFilter(QObject* object, QEvent* event)
{
    const bool isAsked = event->type() == QEvent::ShortcutOverride;  // is this key yours, or may it be a shortcut?
    if (!isAsked && event->type() != QEvent::KeyPress) return false;
    const auto* widget = qobject_cast<QWidget*>(object);
    const auto& key    = *static_cast<QKeyEvent*>(event);
    if (!widget || !(key.modifiers() & Qt::KeypadModifier) || !isPartOf(m_window, *widget)) return false;
    QAction* called = isAsked ? nullptr : m_called.data();
    m_called        = isAsked && !isTyping(*widget) ? commandOf(key) : nullptr;
    if (called) called->trigger();
    if (!called && !m_called) return false;
    event->accept();
    return true;
}

QAction* Keypad::commandOf(const QKeyEvent& event) const
{
    const QKeySequence keys(QKeyCombination(event.modifiers(), withNumLock(event.key())));
    const auto&        commands = m_bindings.commands();
    const auto         found =
        std::ranges::find_if(commands, [&](const QAction* one) { return one->shortcuts().contains(keys); });
    return found == commands.end() ? nullptr : *found;
}

}  // namespace zscope::ui
