// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of the window. A new one is a folder in ui/panels and a line in registry.cpp; docks, the View menu and
// the layouts are made from this list.
#pragma once

#include <span>

#include <QString>

#include "ui/panels/panel.h"

namespace zscope::ui {

struct PanelEntry {
    const char*        word;   // names the dock in saved layouts
    const char*        title;  // English; translated in the context "Panels"
    Qt::DockWidgetArea area;   // in the Teach layout, in the order of the list
    Panel* (*make)(Session& session);
    bool (*isNeededBy)(const Pipeline& pipeline);  // a panel nothing would be shown in folds away
    const char* tabbedWith = nullptr;  // the word of the panel whose place it shares, as a tab, in the Teach layout
    int         share      = 1;        // of the height of its area, among those that are needed
    bool        isInTeach  = true;     // else the View menu, or another layout, opens it

    QString translatedTitle() const;
};
std::span<const PanelEntry> panels();

}  // namespace zscope::ui
