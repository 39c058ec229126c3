// SPDX-License-Identifier: GPL-3.0-or-later
// Which keys call which command: the defaults, what the user has changed, and
// where two commands would get in each other's way. Kept in the settings under the commands' object names.
//
// Conflict   two commands with a key in common of which both can be called with one tool: keys mean one thing per tool
// Kept       only what differs from the defaults; keys that the settings cannot spell are left at their default
#pragma once

#include <map>
#include <vector>

#include <QKeySequence>
#include <QList>
#include <QString>

class QAction;

namespace zscope::ui {

class Settings;

enum class ToolScope { Both, Inspect, Camera };

class KeyBindings {
public:
    explicit KeyBindings(Settings& settings) : m_settings(settings) {}

    /// The keys that the command has now are its defaults; those of the settings take their place.
    void add(QAction& command, ToolScope scope);

    const std::vector<QAction*>& commands() const { return m_commands; }
    QList<QKeySequence>          defaultsOf(const QAction& command) const;
    bool                         isChanged(const QAction& command) const;
    /// Who else is called by `keys` while `command` could be.
    std::vector<QAction*> conflictsOf(const QAction& command, const QKeySequence& keys) const;

    /// Takes the keys away from whoever is in the way.
    void assign(QAction& command, const QList<QKeySequence>& keys);
    void reset(QAction& command);
    void resetAll();

private:
    struct Entry {
        QList<QKeySequence> defaults;
        ToolScope           scope = ToolScope::Both;
    };
    void keep(const QAction& command);

    Settings&                m_settings;
    std::vector<QAction*>    m_commands;  // owned by the window
    std::map<QString, Entry> m_entries;   // by object name
};

}  // namespace zscope::ui
