// SPDX-License-Identifier: GPL-3.0-or-later
// A panel in a dock that looks like a card: a title, a few words on what it shows, a close button, and no frame inside
// a frame. Dragging the title moves it.
#pragma once

#include <QDockWidget>

class QLabel;
class QToolButton;

namespace zscope::ui {

class Panel;
struct PanelEntry;

class PanelDock final : public QDockWidget {
    Q_OBJECT

public:
    PanelDock(const PanelEntry& entry, Panel* panel, QWidget* parent = nullptr);

    Panel&            panel() const { return *m_panel; }
    const PanelEntry& entry() const { return m_entry; }
    /// Whether the user wants it, seen or folded away for want of anything to show.
    bool isWanted() const { return m_wanted; }
    void setWanted(bool wanted);
    /// Of the height of its area, among those that are there.
    int  share() const { return m_share; }
    void setShare(int share) { m_share = share; }
    bool isNeeded() const { return m_needed; }
    void setNeeded(bool needed);

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

signals:
    void wantedChanged(bool wanted);

private:
    QWidget* makeTitle();
    void     dress();
    void     keepOffTheEdge(Qt::DockWidgetArea area);

    const PanelEntry& m_entry;
    Panel*            m_panel;
    QWidget *         m_titleRoom = nullptr, *m_bodyRoom = nullptr;  // leave a step to the window's edge
    QLabel*           m_summary = nullptr;
    QToolButton*      m_close   = nullptr;
    bool              m_wanted  = true;
    bool              m_needed  = true;
    int               m_share   = 1;
};

}  // namespace zscope::ui
