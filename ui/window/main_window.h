// SPDX-License-Identifier: GPL-3.0-or-later
// The window: the picture in the middle, the panels of the registry around it, and the files in between. It hands the
// session's snapshot to everybody and holds nothing of its own but where things are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QMainWindow>
#include <QTimer>

#include "core/scene/camera_path.h"
#include "ui/session/session.h"
#include "ui/session/session_file.h"
#include "ui/text/language.h"
#include "ui/window/settings.h"

class QLabel;
class QStackedWidget;

namespace zscope::ui {

class Actions;
class FrameView;
class MeasurePanel;
class MessageBar;
class StartPage;
struct LayoutEntry;
class PanelDock;
class SheetMaker;
class StatusLine;

class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(Session& session, Settings& settings, const QPalette& systemPalette);
    ~MainWindow() override;

    /// A file that can be shown is added to the recent ones; builtin scenes are not.
    void open(const QString& word, const Session::ViewOf& viewOf = {});
    /// A teacher's lessons, remembered.
    void openLessons(const QString& folder);
    /// For this run; the Language menu is what keeps a choice.
    void speak(Language language);

    FrameView&  view() const { return *m_view; }
    MessageBar& messages() const { return *m_messages; }
    /// Why the finished picture is empty, for as long as it is.
    MessageBar& emptiness() const { return *m_emptiness; }
    PanelDock*  dock(const QString& panelWord) const;

    /// One of layoutEntries().
    void         useLayout(const QString& word);
    WindowLayout layoutNow() const;
    /// False, and nothing is changed, if it does not fit.
    bool applyLayout(const WindowLayout& layout);
    /// A session file, or a picture of the window that carries one.
    void openSession(const QString& file);
    /// What another program drew becomes B.
    void openTheirs(const QStringList& files);
    /// What another program wrote of its steps is stepped beside A.
    void openTrace(const QString& file);
    /// As if they were dropped; with `asB` a picture becomes B even if it carries a session.
    void openFiles(const QStringList& files, bool asB);
    /// Replaces the file.
    void saveSessionTo(const QString& file);

    /// What the Measure menu recorded, key by key; no key: nothing yet.
    const CameraPath& cameraPath() const { return m_path; }
    /// The trouble as a sentence, or nothing.
    std::optional<QString> saveCameraPath(const QString& file) const;
    SheetMaker&            sheets() { return *m_sheets; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* object, QEvent* event) override;
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void          present(Changes what);
    bool          leavesField(QObject* object, QEvent* event);
    void          watchShift(const QKeyEvent* event);
    void          makeCentre();
    void          makeDocks();
    void          placeDocks(const LayoutEntry& layout);
    void          showNeeded(const Snapshot& shown);
    void          shareWidths();
    void          shareHeights();
    void          widen(Qt::DockWidgetArea side, int width);
    void          rememberWidths();
    void          restoreWidths();
    void          fitToolBar();
    void          resetLayout();
    void          saveOwnLayout();
    void          useOwnLayout(const QString& name);
    void          forgetOwnLayout(const QString& name);
    void          showWhy(const Snapshot& shown);
    void          showEmptiness(const Snapshot& shown);
    void          saveSession();
    void          restoreLayout();
    void          applyAppearance(Appearance appearance);
    void          addRecentFile(const QString& file);
    void          chooseFile();
    void          chooseTheirs();
    void          chooseTrace();
    void          saveReport();
    void          makeRoomForDiagnosis();
    void          chooseLessons();
    void          showPanel(const QString& word);
    void          keepTabsOffTheEdge();
    void          joinNeighbour(PanelDock& opened);
    void          makeRoomForLesson();
    void          makeRoomFor(const QString& word);
    void          savePicture(bool decorated);
    void          savePictureAs();
    void          copyPicture();
    void          namePictures();
    void          saveSheet();
    void          measure();
    void          stopMeasuring();
    void          watchMeasuring();
    void          openRecord();
    MeasurePanel& measurePanel() const;
    void          addKeyFrame(bool afterCut);
    void          askWhereToSavePath();
    void          goToPixel();
    void          showKeys();
    void          changeKeys();
    void          showPalette();
    void          showAbout();

    Session&                           m_session;
    Settings&                          m_settings;
    const QPalette                     m_systemPalette;
    Translation                        m_translation;
    QStackedWidget*                    m_centre    = nullptr;  // the start page or the picture
    StartPage*                         m_start     = nullptr;
    FrameView*                         m_view      = nullptr;
    MessageBar*                        m_messages  = nullptr;
    MessageBar*                        m_emptiness = nullptr;
    std::string                        m_whyEmpty;  // what m_emptiness was told last, until the picture shows something
    StatusLine*                        m_status    = nullptr;
    Actions*                           m_actions   = nullptr;
    QLabel*                            m_sceneName = nullptr;
    QString                            m_layout;  // the word of the one chosen last
    std::optional<QPoint>              m_lastPick;
    std::shared_ptr<const LoadedScene> m_sceneShown;
    QString                            m_fileAwaited;  // what was opened last, until it is there
    CameraPath                         m_path;         // recorded key by key; no key: none yet
    SheetMaker*                        m_sheets = nullptr;
    QTimer                             m_held;               // from pressing Shift until it counts as held
    std::vector<PanelDock*>            m_docks;              // in the order of panels()
    bool                               m_separates = false;  // the mouse has hold of what separates docks
    // widths of the docks' sides as they were asked for; a narrow window may give less
    int m_left = 0, m_right = 0;
};

}  // namespace zscope::ui
