// SPDX-License-Identifier: GPL-3.0-or-later
// The layouts that come with the program: which panels are there, and where. A panel in no place of a layout is closed.
#pragma once

#include <span>
#include <vector>

#include <QSize>
#include <QString>

namespace zscope::ui {

struct LayoutPlace {
    const char*        panel;
    Qt::DockWidgetArea area;
    const char*        tabbedWith = nullptr;  // the panel whose place it shares
    int                share      = 1;        // of the height of its area
};

struct LayoutEntry {
    const char* word;
    const char* title;        // English; translated in the context "Layouts"
    const char* tip;          // likewise
    const char* raised;       // the panel in front of those that share its place
    int         left, right;  // widths in logical pixels, at 1280
    int         narrow;       // of the right side while it holds nothing that wants room
    int         bottom = 0;   // hundredths of the window's height; 0: what its panels need

    QString                  translatedTitle() const;
    QString                  translatedTip() const;
    std::vector<LayoutPlace> places() const;
};
/// Teach, the first, has the panels of the registry where that says, but for those that belong to another layout.
std::span<const LayoutEntry> layoutEntries();
const LayoutEntry&           layoutEntry(const QString& word);  // the first, if there is none of that word

/// Of a window that nobody has sized yet: most of the room on the screen, for the picture's sake, but no wall of it.
/// Logical pixels.
QSize firstSize(const QSize& room);

}  // namespace zscope::ui
