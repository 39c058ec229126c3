// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of the keypad that call commands, by their place and not by what
// NumLock makes of them: 1 calls the same command as End.
//
// Why        On X11 Qt forgets that a key is one of the keypad's before it looks for a shortcut, so that 1 there would
//            be 1 above the letters. The keys of commands are looked up here before Qt does
// Typed      fields keep the keypad: in them it types, and moves the cursor
#pragma once

#include <QObject>
#include <QPointer>

class QAction;
class QKeyEvent;
class QWidget;

namespace zscope::ui {

class KeyBindings;

/// An event filter of the application. Whoever owns a key for other reasons has to be asked first: Qt asks the filter
/// that was installed last before the others.
class Keypad final : public QObject {
    Q_OBJECT

public:
    Keypad(QWidget& window, const KeyBindings& bindings);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    QAction* commandOf(const QKeyEvent& event) const;

    QWidget&           m_window;
    const KeyBindings& m_bindings;
    QPointer<QAction>  m_called;  // by the key that goes down
};

}  // namespace zscope::ui
