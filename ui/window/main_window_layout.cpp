// SPDX-License-Identifier: GPL-3.0-or-later
// The window's panels and layouts: which are there, where, and how large.
#include "ui/window/main_window.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QStyle>
#include <QTabBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include "ui/panels/registry.h"
#include "ui/text/spoken.h"
#include "ui/theme/theme.h"
#include "ui/window/actions.h"
#include "ui/window/dock.h"
#include "ui/window/layouts.h"
#include "ui/window/message_bar.h"

namespace zscope::ui {

void MainWindow::makeDocks()
{
    for (const PanelEntry& entry : panels()) {
        auto* dock   = new PanelDock(entry, entry.make(m_session), this);
        auto* toggle = m_actions->panelsMenu()->addAction(QString());
        spoken(*toggle, [toggle, &entry] { toggle->setText(entry.translatedTitle()); });
        toggle->setCheckable(true);
        toggle->setChecked(true);
        m_actions->adopt(*toggle, QStringLiteral("panel.") + entry.word);
        connect(toggle, &QAction::triggered, this, [this, dock](bool isWanted) {
            if (isWanted)
                showPanel(dock->entry().word);
            else
                dock->setWanted(false);
        });
        connect(dock, &PanelDock::wantedChanged, toggle, &QAction::setChecked);
        m_docks.push_back(dock);
    }
}

PanelDock* MainWindow::dock(const QString& panelWord) const
{
    for (PanelDock* dock : m_docks)
        if (panelWord == dock->entry().word) return dock;
    return nullptr;
}

void MainWindow::placeDocks(const LayoutEntry& layout)
{
    const std::vector<LayoutPlace> places  = layout.places();
    const auto                     placeOf = [&](const PanelDock& dock) {
        const auto isOfDock = [&](const LayoutPlace& place) {
            return std::strcmp(place.panel, dock.entry().word) == 0;
        };
        return std::ranges::find_if(places, isOfDock);
    };
    for (PanelDock* dock : m_docks) {
        dock->setFloating(false);
        dock->setNeeded(dock->entry().isNeededBy(m_session.now().pipeline));
        dock->hide();  // until all are in their places: one below the other they may be higher than the screen
        if (placeOf(*dock) != places.end()) continue;
        addDockWidget(dock->entry().area, dock);  // where it opens, if it is opened
        dock->setShare(dock->entry().share);
        dock->setWanted(false);
    }
    for (const LayoutPlace& place : places) {  // in the order of the layout, which is that from top to bottom
        PanelDock* dock = this->dock(place.panel);
        if (!dock) continue;
        addDockWidget(place.area, dock);
        if (place.tabbedWith) tabifyDockWidget(this->dock(place.tabbedWith), dock);
        dock->setShare(place.share);
    }
    for (const LayoutPlace& place : places)
        if (PanelDock* dock = this->dock(place.panel)) dock->setWanted(true);
    // Of the panels that share a place the first is seen.
    for (auto place = places.rbegin(); place != places.rend(); ++place)
        if (PanelDock* dock = this->dock(place->panel)) QTimer::singleShot(0, dock, &QWidget::raise);
    if (PanelDock* front = dock(layout.raised)) QTimer::singleShot(0, front, &QWidget::raise);
}

namespace {

/// What runs when the pipeline's choices are measured, as far as a panel cares: a step tells what it has.
Pipeline ranIn(const Snapshot& shown)
{
    Pipeline              ran       = shown.pipeline;
    const HierarchyState* hierarchy = shown.hierarchy();
    if (ran.chooser != Chooser::Measured || !hierarchy) return ran;
    if (hierarchy->tree) ran.order = *hierarchy->tree == TreeKind::Octree ? Order::Octree : Order::Bvh;
    if (!hierarchy->levels.empty()) ran.upkeep = Upkeep::OnQuery;
    return ran;
}

/// Whether it takes part in how wide its side is.
bool isThere(const PanelDock& dock) { return dock.isWanted() && dock.isNeeded() && !dock.isFloating(); }

/// The height that docks one below the other have together: that of the picture beside them.
int roomOf(const QMainWindow& window)
{
    // about as much, before it is known
    return window.isVisible() ? window.centralWidget()->height() : window.height() * 2 / 3;
}

/// What a scene has to tell needs no more than this; choices and faults take what is left.
QList<int> sceneAndPipeline(int room)
{
    constexpr int kFacts = 290, kOfHundred = 57;
    const int     scene = std::min(kFacts, room * kOfHundred / 100);
    return {scene, room - scene};
}

/// Docks one below the other get their parts of it.
void divideHeight(QMainWindow& window, const QList<QDockWidget*>& docks, QList<int> parts)
{
    const int room  = roomOf(window);
    const int whole = std::accumulate(parts.begin(), parts.end(), 0);
    for (int& part : parts) part = part * room / whole;
    window.resizeDocks(docks, parts, Qt::Vertical);
}

}  // namespace

void MainWindow::showNeeded(const Snapshot& shown)
{
    const Pipeline ran     = ranIn(shown);
    bool           changed = false;
    // First away, then in: all at once they would not fit, and a window that has grown does not shrink again.
    for (const bool needed : {false, true}) {
        for (PanelDock* dock : m_docks) {
            if (dock->entry().isNeededBy(ran) != needed || dock->isNeeded() == needed) continue;
            dock->setNeeded(needed);
            // Above the others of its place, once the tabs are there.
            if (needed && !dock->entry().tabbedWith) QTimer::singleShot(0, dock, &QWidget::raise);
            changed = true;
        }
    }
    if (!changed) return;
    shareWidths();
    shareHeights();
}

void MainWindow::shareWidths()
{
    // Tables and pyramids want room; a column of facts does not, and the picture is the largest thing on the screen.
    constexpr std::array kWide{"active-edges", "pyramid", "hierarchy", "observer"};
    const LayoutEntry&   layout = layoutEntry(m_layout);
    const double         larger = 1 + 0.4 * (std::max(width(), 1280) / 1280.0 - 1);
    const bool           isWide = std::ranges::any_of(kWide, [&](const char* word) { return isThere(*dock(word)); });
    for (const auto& [area, at1280] : {std::pair(Qt::LeftDockWidgetArea, layout.left),
                                       std::pair(Qt::RightDockWidgetArea, isWide ? layout.right : layout.narrow)}) {
        widen(area, static_cast<int>(at1280 * larger));
    }
}

void MainWindow::widen(Qt::DockWidgetArea side, int width)
{
    (side == Qt::LeftDockWidgetArea ? m_left : m_right) = width;
    const auto first =
        std::ranges::find_if(m_docks, [&](PanelDock* dock) { return isThere(*dock) && dockWidgetArea(dock) == side; });
    if (first != m_docks.end()) resizeDocks({*first}, {width}, Qt::Horizontal);
}

void MainWindow::rememberWidths()
{
    for (PanelDock* dock : m_docks) {
        if (!dock->isVisible() || !isThere(*dock)) continue;
        if (dockWidgetArea(dock) == Qt::LeftDockWidgetArea) m_left = dock->width();
        if (dockWidgetArea(dock) == Qt::RightDockWidgetArea) m_right = dock->width();
    }
}

void MainWindow::restoreWidths()
{
    // The picture gives way first, then the docks; but only the picture grows again by itself.
    const int left = m_left, right = m_right;
    for (const auto& [area, wanted] :
         {std::pair(Qt::LeftDockWidgetArea, left), std::pair(Qt::RightDockWidgetArea, right)})
        if (std::ranges::any_of(m_docks, [&, side = area, width = wanted](PanelDock* dock) {
                return dock->isVisible() && isThere(*dock) && dockWidgetArea(dock) == side && dock->width() < width;
            }))
            widen(area, wanted);
}

void MainWindow::fitToolBar()
{
    auto*      tools = findChild<QToolBar*>("tools");
    const auto dress = [tools](Qt::ToolButtonStyle style) {
        tools->setToolButtonStyle(style);
        for (auto* button : tools->findChildren<QToolButton*>()) button->setToolButtonStyle(style);
    };
    dress(Qt::ToolButtonTextBesideIcon);
    // what has no icon keeps its word, and all have their tool tips
    if (tools->sizeHint().width() > width()) dress(Qt::ToolButtonIconOnly);
}

void MainWindow::shareHeights()
{
    QList<QDockWidget*> docks;
    QList<int>          shares;
    for (PanelDock* dock : m_docks) {
        if (!isThere(*dock) || dockWidgetArea(dock) != Qt::RightDockWidgetArea) continue;
        const QList<QDockWidget*> sameTabs = tabifiedDockWidgets(dock);  // they share one height
        if (std::ranges::any_of(docks, [&](QDockWidget* counted) { return sameTabs.contains(counted); })) continue;
        docks << dock;
        shares << dock->share();
    }
    if (!docks.isEmpty()) divideHeight(*this, docks, shares);
}

void MainWindow::useLayout(const QString& word)
{
    const LayoutEntry& layout = layoutEntry(word);
    m_layout                  = layout.word;
    placeDocks(layout);
    shareWidths();
    for (const LayoutPlace& place : layout.places()) {
        if (place.area != Qt::BottomDockWidgetArea) continue;
        PanelDock* below = dock(place.panel);  // else as high as what stood there in the layout before
        resizeDocks({below}, {layout.bottom > 0 ? height() * layout.bottom / 100 : below->sizeHint().height()},
                    Qt::Vertical);
    }
    if (dock("scene")->isWanted())
        divideHeight(*this, {dock("scene"), dock("pipeline")}, sceneAndPipeline(roomOf(*this)));
    shareHeights();
    m_actions->showLayout(m_layout);
    QTimer::singleShot(0, this, [this] { keepTabsOffTheEdge(); });
}

void MainWindow::resetLayout() { useLayout(m_layout); }

void MainWindow::showPanel(const QString& word)
{
    PanelDock* wanted = dock(word);
    if (!wanted) return m_messages->tell([word] { return tr("There is no panel “%1”").arg(word); });
    const bool opens = !wanted->isWanted();
    if (opens) joinNeighbour(*wanted);
    wanted->setWanted(true);
    QTimer::singleShot(0, wanted, [this, wanted, opens] {
        if (opens && dockWidgetArea(wanted) == Qt::RightDockWidgetArea) shareHeights();
        wanted->raise();
        keepTabsOffTheEdge();
    });
}

/// A panel that the layout leaves out opens behind a tab of its neighbour, if that is where the panel belongs.
void MainWindow::joinNeighbour(PanelDock& opened)
{
    const PanelEntry& entry = opened.entry();
    const bool        isElsewhere =
        opened.isFloating() || dockWidgetArea(&opened) != entry.area || !tabifiedDockWidgets(&opened).isEmpty();
    if (!entry.tabbedWith || isElsewhere) return;
    for (const char* word : {entry.tabbedWith, "pipeline"}) {
        PanelDock* neighbour = dock(word);
        if (!isThere(*neighbour) || dockWidgetArea(neighbour) != entry.area) continue;
        return tabifyDockWidget(neighbour, &opened);
    }
}

void MainWindow::keepTabsOffTheEdge()
{
    for (QTabBar* tabs : findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
        tabs->setDrawBase(false);  // the window makes new ones, and gives them a line
        const bool atEdge = tabs->x() < kStep;
        if (tabs->property("atLeftEdge").toBool() == atEdge) continue;
        tabs->setProperty("atLeftEdge", atEdge);
        tabs->style()->unpolish(tabs);
        tabs->style()->polish(tabs);
        QEvent dressed(QEvent::StyleChange);  // only this makes it measure its tabs again
        QCoreApplication::sendEvent(tabs, &dressed);
    }
}

void MainWindow::makeRoomForLesson() { makeRoomFor(QStringLiteral("lessons")); }

void MainWindow::makeRoomForDiagnosis() { makeRoomFor(QStringLiteral("diagnosis")); }

void MainWindow::makeRoomFor(const QString& word)
{
    showPanel(word);
    PanelDock *wanted = dock(word), *pipeline = dock("pipeline");
    if (dockWidgetArea(wanted) != Qt::LeftDockWidgetArea) return;
    widen(Qt::LeftDockWidgetArea, std::max(320, width() * 24 / 100));
    if (pipeline->isWanted() && !tabifiedDockWidgets(pipeline).contains(wanted))
        divideHeight(*this, {wanted, pipeline}, {80, 20});
}

WindowLayout MainWindow::layoutNow() const
{
    WindowLayout now{saveGeometry(), saveState(Settings::kLayoutVersion), {}, m_layout};
    for (const PanelDock* dock : m_docks)
        if (!dock->isWanted()) now.hidden << dock->entry().word;
    return now;
}

bool MainWindow::applyLayout(const WindowLayout& layout)
{
    const bool fits = restoreState(layout.state, Settings::kLayoutVersion);
    for (PanelDock* dock : m_docks)
        dock->setWanted(fits ? !layout.hidden.contains(dock->entry().word) : dock->isWanted());
    if (fits && !layout.name.isEmpty()) {
        m_layout = layoutEntry(layout.name).word;
        m_actions->showLayout(m_layout);
    }
    QTimer::singleShot(0, this, [this] {
        rememberWidths();
        keepTabsOffTheEdge();
    });
    return fits;
}

void MainWindow::saveOwnLayout()
{
    bool          isNamed = false;
    const QString name    = QInputDialog::getText(this, tr("Save this layout"), tr("Name of the layout"),
                                                  QLineEdit::Normal, QString(), &isNamed)
                             .trimmed();
    if (!isNamed || name.isEmpty()) return;
    m_settings.keepOwnLayout(name, layoutNow().state, layoutNow().hidden);
    m_actions->showOwnLayouts(m_settings.ownLayouts());
}

void MainWindow::useOwnLayout(const QString& name)
{
    const auto [state, hidden] = m_settings.ownLayout(name);
    if (!applyLayout({{}, state, hidden, {}}))
        m_messages->tell(
            [name] { return tr("The layout \u201C%1\u201D does not fit this version of the window.").arg(name); });
}

void MainWindow::forgetOwnLayout(const QString& name)
{
    m_settings.forgetOwnLayout(name);
    m_actions->showOwnLayouts(m_settings.ownLayouts());
}

void MainWindow::restoreLayout()
{
    if (const QByteArray geometry = m_settings.geometry(); !geometry.isEmpty()) restoreGeometry(geometry);
    const QByteArray layout = m_settings.layout();
    if (layout.isEmpty() || !restoreState(layout, Settings::kLayoutVersion)) return;
    const QStringList hidden = m_settings.hiddenPanels();
    for (PanelDock* dock : m_docks) dock->setWanted(!hidden.contains(dock->entry().word));
    QTimer::singleShot(0, this, [this] { rememberWidths(); });
}

}  // namespace zscope::ui
