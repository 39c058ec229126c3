// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/key_bindings.h"

#include <QAction>

#include "ui/window/settings.h"

namespace zscope::ui {

void KeyBindings::add(QAction& command, ToolScope scope)
{
    const QString name = command.objectName();
    m_commands.push_back(&command);
    m_entries[name] = {command.shortcuts(), scope};
    const auto kept = m_settings.keysOf(name);
    if (!kept) return;
    QList<QKeySequence> keys;
    for (const QString& word : *kept) {
        const QKeySequence key(word, QKeySequence::PortableText);
        if (key.isEmpty() || key[0].key() == Qt::Key_unknown) return;  // not ours, or damaged: the defaults stay
        keys << key;
    }
    command.setShortcuts(keys);
}

QList<QKeySequence> KeyBindings::defaultsOf(const QAction& command) const
{
    const auto entry = m_entries.find(command.objectName());
    return entry == m_entries.end() ? QList<QKeySequence>{} : entry->second.defaults;
}

bool KeyBindings::isChanged(const QAction& command) const { return command.shortcuts() != defaultsOf(command); }

std::vector<QAction*> KeyBindings::conflictsOf(const QAction& command, const QKeySequence& keys) const
{
    std::vector<QAction*> found;
    const auto            own = m_entries.find(command.objectName());
    if (keys.isEmpty() || own == m_entries.end()) return found;
    for (QAction* other : m_commands) {
        if (other == &command || !other->shortcuts().contains(keys)) continue;
        const ToolScope scope = m_entries.at(other->objectName()).scope;
        const bool      apart =
            scope != ToolScope::Both && own->second.scope != ToolScope::Both && scope != own->second.scope;
        if (!apart) found.push_back(other);
    }
    return found;
}

void KeyBindings::assign(QAction& command, const QList<QKeySequence>& keys)
{
    for (const QKeySequence& key : keys) {
        for (QAction* other : conflictsOf(command, key)) {
            QList<QKeySequence> left = other->shortcuts();
            left.removeAll(key);
            other->setShortcuts(left);
            keep(*other);
        }
    }
    command.setShortcuts(keys);
    keep(command);
}

void KeyBindings::reset(QAction& command) { assign(command, defaultsOf(command)); }

void KeyBindings::resetAll()
{
    for (QAction* command : m_commands) {
        command->setShortcuts(defaultsOf(*command));
        keep(*command);
    }
}

void KeyBindings::keep(const QAction& command)
{
    if (!isChanged(command)) return m_settings.keepKeys(command.objectName(), std::nullopt);
    QStringList words;
    for (const QKeySequence& key : command.shortcuts()) words << key.toString(QKeySequence::PortableText);
    m_settings.keepKeys(command.objectName(), words);
}

}  // namespace zscope::ui
