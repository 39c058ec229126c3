// SPDX-License-Identifier: GPL-3.0-or-later
// Everything a key or a menu can do, as one action each with a name that
// stays ("step.forward", its object name), and the menus and toolbar made of them. Algorithms, layers, grains and
// examples come from the registries of core.
//
// Keys       mean one thing per tool: actions that belong to one tool are enabled only while it is chosen
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include <QObject>

#include "ui/session/session.h"
#include "ui/text/language.h"
#include "ui/view/frame_view.h"
#include "ui/window/key_bindings.h"

class QAction;
class QActionGroup;
class QComboBox;
class QMainWindow;
class QMenu;
class QToolBar;
class QToolButton;

namespace zscope::ui {

/// What an action asks of the window itself.
struct WindowRequests {
    std::function<void()> open, openTheirs, openTrace, savePicture, savePlainPicture, savePictureAs, copyPicture,
        goToPixel, namePictures, saveSheet, measure, stopMeasuring, openRecord, addKeyFrame, addKeyFrameAfterCut,
        savePath, forgetPath, resetLayout, about, keys, changeKeys, palette, saveSession, openLessons;
    std::function<void(const QString&)> layout;  // its word
    std::function<void()>               saveOwnLayout;
    std::function<void(const QString&)> useOwnLayout, forgetOwnLayout;
    std::function<void(Appearance)>     look;
    std::function<void(Language)>       speak;
    std::function<void(const QString&)> openWord;
};

/// The name of an action without the letter that Alt chooses it by: "&Open" and "打开(&O)" alike.
QString plainName(const QAction& action);
/// The name of the menu it stands in, likewise; empty if it stands in none.
QString menuNameOf(const QAction& action);
/// Whether lists of commands show it: a place for a recent file that there is not is nothing to choose.
bool isListed(const QAction& action);

class Actions final : public QObject {
    Q_OBJECT

public:
    Actions(QMainWindow& window, Session& session, FrameView& view, Settings& settings, WindowRequests requests);

    void present(const Snapshot& shown, Changes what);
    void showTool(Tool tool);
    void showMeasuring(bool isMeasuring);
    void showRecent(const QStringList& files);
    void showLayout(const QString& word);
    void showOwnLayouts(const QStringList& names);
    void showAppearance(Appearance appearance);
    void showLanguage(Language language);
    void dress(const Theme& theme);

    QMenu*    panelsMenu() const { return m_panels; }
    QToolBar* toolBar() const { return m_toolBar; }
    /// An action that somebody else made, as one of the commands.
    void adopt(QAction& action, const QString& name);
    /// All of them, with their keys.
    KeyBindings& bindings() { return m_bindings; }

private:
    /// `label` is marked with QT_TR_NOOP: say() translates it, now and when the language changes. `under` the menu bar:
    /// nullptr.
    QMenu*   addMenu(QMenu* under, const char* label);
    QAction* add(QMenu* menu, const QString& name, const char* label, const QList<QKeySequence>& keys,
                 std::function<void()> run, const QString& icon = {});
    QAction* add(QMenu* menu, const QString& name, const char* label, const QKeySequence& key,
                 std::function<void()> run, const QString& icon = {})
    {
        return add(menu, name, label, key.isEmpty() ? QList<QKeySequence>{} : QList<QKeySequence>{key}, std::move(run),
                   icon);
    }
    /// With a label that no language changes, or that say() makes.
    QAction* addNamed(QMenu* menu, const QString& name, const QString& label, const QList<QKeySequence>& keys,
                      std::function<void()> run, const QString& icon = {});
    void     say();
    void     makeFileMenu();
    void     makeViewMenu();
    void     makeLayersMenu(QMenu* view);
    void     makeSizeMenu(QMenu* view);
    void     makeLayoutMenu(QMenu* view);
    void     makeAppearanceMenu(QMenu* view);
    void     makeCameraMenu();
    void     makeAlgorithmMenu();
    void     makeStepMenu();
    void     makeBreakpointMenu(QMenu* menu);
    void     makeCompareMenu();
    void     makeMeasureMenu();
    void     makeLessonsMenu();
    void     makeLanguageMenu();
    void     makeHelpMenu();
    void     makeToolBar();
    void     showNamedViews(const Snapshot& shown);

    QMainWindow&   m_window;
    Session&       m_session;
    FrameView&     m_view;
    WindowRequests m_requests;
    KeyBindings    m_bindings;

    std::vector<QAction*>                              m_all;
    std::vector<std::pair<QAction*, const char*>>      m_labels, m_tips;  // in English
    std::vector<std::pair<QAction*, std::string_view>> m_titles;          // tool tips that are core's, in English
    std::vector<std::pair<QAction*, QString>>          m_icons;           // with the name of each one's icon
    std::vector<QAction*>                              m_inspectOnly, m_cameraOnly, m_needScene;
    std::vector<QAction*>                              m_algorithms;    // in the order of presets()
    std::vector<QAction*>                              m_others;        // likewise, as B
    std::vector<QAction*>                              m_needOther;     // something to compare with
    std::vector<QAction*>                              m_layerChoices;  // in the order of layers()
    std::vector<std::pair<QAction*, bool Layers::*>>   m_layerToggles;
    QAction *m_open = nullptr, *m_inspect = nullptr, *m_camera = nullptr, *m_fit = nullptr, *m_cull = nullptr,
            *m_measure = nullptr, *m_stopMeasuring = nullptr, *m_judgeAgain = nullptr, *m_saveReport = nullptr,
            *m_swap                                       = nullptr;
    bool                                    m_isMeasuring = false;
    std::vector<QAction*>                   m_layoutChoices;  // in the order of layoutEntries()
    QMenu *                                 m_ownLayouts = nullptr, *m_forgetLayouts = nullptr;
    std::vector<QAction*>                   m_recentFiles;  // as many as are remembered
    std::vector<QAction*>                   m_appearances, m_languages;
    std::vector<std::pair<QAction*, QSize>> m_sizes;  // of the picture
    QMenu *      m_recent = nullptr, *m_panels = nullptr, *m_namedViews = nullptr, *m_layers = nullptr;
    QToolBar*    m_toolBar      = nullptr;
    QComboBox*   m_algorithmBox = nullptr;
    QToolButton* m_layersButton = nullptr;
};

}  // namespace zscope::ui
