// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include <utility>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QMouseEvent>
#include <QScreen>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTimer>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/panels/registry.h"
#include "ui/parts/typing.h"
#include "ui/parts/wheel_guard.h"
#include "ui/session/course.h"
#include "ui/session/examiner.h"
#include "ui/session/reproduce.h"
#include "ui/session/tracer.h"
#include "ui/sheet/sheet_maker.h"
#include "ui/text/numbers.h"
#include "ui/text/phrase_book.h"
#include "ui/text/spoken.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"
#include "ui/view/frame_view.h"
#include "ui/window/actions.h"
#include "ui/window/cheat_sheet.h"
#include "ui/window/command_palette.h"
#include "ui/window/dock.h"
#include "ui/window/keypad.h"
#include "ui/window/keys_dialog.h"
#include "ui/window/layouts.h"
#include "ui/window/message_bar.h"
#include "ui/window/start_page.h"
#include "ui/window/status_line.h"

namespace zscope::ui {
namespace {

/// For a window, beside its frame and what the desktop keeps for itself.
QSize roomOn(const QScreen& screen)
{
    constexpr QSize kFrame{2 * kStep, 5 * kStep};  // with the title bar; nobody knows it before the window is shown
    return screen.availableSize() - kFrame;
}

/// A tree opens and closes nodes with Left and Right, and goes up and down their levels; where there is nothing of that
/// they step.
bool hasNoUseFor(const QWidget* widget, int key)
{
    const auto* tree = qobject_cast<const QTreeView*>(widget);
    if (!tree) return false;
    const QModelIndex at = tree->currentIndex();
    if (key == Qt::Key_Right) return !at.isValid() || !tree->model()->hasChildren(at.siblingAtColumn(0));
    return !at.isValid() || (!at.parent().isValid() && !tree->isExpanded(at.siblingAtColumn(0)));
}

/// What the docks leave; a step off each edge of the window where no dock is.
class Centre final : public QWidget {
public:
    explicit Centre(QMainWindow& window) : QWidget(&window), m_window(window) {}

protected:
    void moveEvent(QMoveEvent*) override { keepOffTheEdges(); }
    void resizeEvent(QResizeEvent*) override { keepOffTheEdges(); }

private:
    void keepOffTheEdges() const
    {
        const QRect at = geometry();
        layout()->setContentsMargins(at.left() <= 0 ? kStep : 0, 0, at.right() + 1 >= m_window.width() ? kStep : 0,
                                     at.bottom() + 1 >= m_window.statusBar()->y() ? kStep : 0);
    }

    QMainWindow& m_window;
};

}  // namespace

MainWindow::MainWindow(Session& session, Settings& settings, const QPalette& systemPalette)
    : m_session(session), m_settings(settings), m_systemPalette(systemPalette)
{
    m_translation.speak(settings.language());        // before anything is said
    qApp->installEventFilter(new WheelGuard(this));  // and before anything is made
    registerIcons();
    setWindowTitle(tr("ZScope"));
    setWindowIcon(QIcon(":/icons/zscope.svg"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setContextMenuPolicy(Qt::NoContextMenu);

    makeCentre();
    m_status = new StatusLine(session);
    setStatusBar(m_status);
    m_actions = new Actions(*this, session, *m_view, settings,
                            {.open                = [this] { chooseFile(); },
                             .openTheirs          = [this] { chooseTheirs(); },
                             .openTrace           = [this] { chooseTrace(); },
                             .savePicture         = [this] { savePicture(true); },
                             .savePlainPicture    = [this] { savePicture(false); },
                             .savePictureAs       = [this] { savePictureAs(); },
                             .copyPicture         = [this] { copyPicture(); },
                             .goToPixel           = [this] { goToPixel(); },
                             .namePictures        = [this] { namePictures(); },
                             .saveSheet           = [this] { saveSheet(); },
                             .measure             = [this] { measure(); },
                             .stopMeasuring       = [this] { stopMeasuring(); },
                             .openRecord          = [this] { openRecord(); },
                             .addKeyFrame         = [this] { addKeyFrame(false); },
                             .addKeyFrameAfterCut = [this] { addKeyFrame(true); },
                             .savePath            = [this] { askWhereToSavePath(); },
                             .forgetPath =
                                 [this] {
                                     m_path.keys.clear();
                                     m_status->showMessage(tr("The camera path is empty"), 4000);
                                 },
                             .resetLayout     = [this] { resetLayout(); },
                             .about           = [this] { showAbout(); },
                             .keys            = [this] { showKeys(); },
                             .changeKeys      = [this] { changeKeys(); },
                             .palette         = [this] { showPalette(); },
                             .saveSession     = [this] { saveSession(); },
                             .openLessons     = [this] { chooseLessons(); },
                             .layout          = [this](const QString& word) { useLayout(word); },
                             .saveOwnLayout   = [this] { saveOwnLayout(); },
                             .useOwnLayout    = [this](const QString& name) { useOwnLayout(name); },
                             .forgetOwnLayout = [this](const QString& name) { forgetOwnLayout(name); },
                             .look =
                                 [this](Appearance look) {
                                     m_settings.setAppearance(look);
                                     applyAppearance(look);
                                 },
                             .speak =
                                 [this](Language language) {
                                     m_settings.setLanguage(language);
                                     speak(language);
                                 },
                             .openWord = [this](const QString& word) { open(word); }});
    m_sheets  = new SheetMaker(session, this);
    connect(m_sheets, &SheetMaker::made, this, [this](const QString& file) {
        m_status->showMessage(tr("Saved %1").arg(QDir::toNativeSeparators(file)), 8000);
    });
    connect(m_sheets, &SheetMaker::failed, this, [this](const QString& sentence) { m_messages->tell(sentence); });
    m_sceneName = new QLabel;
    m_sceneName->setObjectName("soft");
    m_sceneName->setContentsMargins(0, kStep / 2, 2 * kStep, 0);
    menuBar()->setCornerWidget(m_sceneName);
    makeDocks();
    watchMeasuring();

    connect(m_view, &FrameView::toolChanged, m_actions, &Actions::showTool);
    connect(m_view, &FrameView::hovered, m_status, &StatusLine::hover);
    connect(&session, &Session::changed, this, &MainWindow::present);
    connect(&session, &Session::noticed, this,
            [this](const QString& sentence) { m_status->showMessage(sentence, 8000); });
    connect(&session, &Session::failed, m_messages,
            [this](const QString& sentence, const std::function<QString()>& again) {
                if (again)
                    m_messages->tell(again);
                else
                    m_messages->tell(sentence);
            });
    m_held.setSingleShot(true);
    m_held.setInterval(120);  // Shift with another key is not held
    connect(&m_held, &QTimer::timeout, this, [this] { m_session.holdOther(true); });
    qApp->installEventFilter(new Keypad(*this, m_actions->bindings()));
    qApp->installEventFilter(this);  // is asked first

    Examiner& examiner = session.examiner();
    connect(&examiner, &Examiner::filesWanted, this, [this] { chooseTheirs(); });
    connect(&examiner, &Examiner::reportWanted, this, [this] { saveReport(); });
    connect(&examiner, &Examiner::opened, this, [this] {
        m_messages->hide();  // something went right
        makeRoomForDiagnosis();
    });
    Tracer& tracer = session.tracer();
    connect(&tracer, &Tracer::fileWanted, this, [this] { chooseTrace(); });
    connect(&tracer, &Tracer::opened, this, [this] {
        m_messages->hide();  // something went right
        makeRoomFor(QStringLiteral("trace"));
    });
    Course& course = session.course();
    connect(&course, &Course::troubled, m_messages, qOverload<std::function<QString()>>(&MessageBar::tell));
    connect(&course, &Course::panelWanted, this, [this](const QString& word) { showPanel(word); });
    connect(&course, &Course::opened, this, [this] { makeRoomForLesson(); });
    connect(&course, &Course::listWanted, this, [this] { makeRoomForLesson(); });
    if (const QString folder = settings.lessonFolder(); QFileInfo(folder).isDir()) course.setFolder(folder);
    m_actions->showRecent(settings.recentFiles());
    m_start->showRecent(settings.recentFiles());
    m_actions->showOwnLayouts(settings.ownLayouts());
    m_actions->showAppearance(settings.appearance());
    m_actions->showLanguage(settings.language());
    applyAppearance(settings.appearance());
    resize(firstSize(roomOn(*screen())));
    useLayout(settings.layoutName());
    restoreLayout();
    present(kEverything);
}

MainWindow::~MainWindow()
{
    // Widgets that go may still commit what was typed into them: nobody is here any more to show what that changes.
    m_session.disconnect(this);
    m_session.course().disconnect(this);
    m_session.examiner().disconnect(this);
    m_session.tracer().disconnect(this);
    qApp->removeEventFilter(this);
    qDeleteAll(findChildren<QDialog*>());  // they speak of actions, which go with the window
}

void MainWindow::makeCentre()
{
    auto* centre = new Centre(*this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kStep);
    m_messages  = new MessageBar(centre);
    m_emptiness = new MessageBar(centre);
    auto* frame = new QFrame;
    frame->setObjectName("picture");
    auto* inside = new QVBoxLayout(frame);
    inside->setContentsMargins(1, 1, 1, 1);
    m_view   = new FrameView(m_session);
    m_start  = new StartPage({.open        = [this] { chooseFile(); },
                              .openWord    = [this](const QString& word) { open(word); },
                              .firstLesson = [this] { m_session.course().open(0); }});
    m_centre = new QStackedWidget;
    // it is not seen beside panels that are as wide as they can be
    m_start->setMinimumWidth(m_view->minimumSizeHint().width());
    m_centre->addWidget(m_start);
    m_centre->addWidget(m_view);
    inside->addWidget(m_centre);
    layout->addWidget(m_messages);
    layout->addWidget(m_emptiness);
    layout->addWidget(frame, 1);
    setCentralWidget(centre);
}

void MainWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    m_settings.finishStart();
    QTimer::singleShot(0, this, [this] { keepTabsOffTheEdge(); });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    const WindowLayout layout = layoutNow();
    m_settings.keepWindow(layout.geometry, layout.state, layout.hidden);
    m_settings.setLayoutName(m_layout);
    m_session.player().setPlaying(false);
    m_session.cancelWork();
    QMainWindow::closeEvent(event);
}

void MainWindow::applyAppearance(Appearance appearance)
{
    const QPalette palette = paletteOf(appearance, m_systemPalette);
    const Theme&   theme   = themeOf(palette);
    // Setting either makes every widget look again at how it looks.
    if (qApp->palette() != palette) qApp->setPalette(palette);
    if (const QString sheet = styleSheetOf(theme); qApp->styleSheet() != sheet) qApp->setStyleSheet(sheet);
    m_actions->dress(theme);
    present(kEverything);
}

void MainWindow::speak(Language language)
{
    m_translation.speak(language);
    m_actions->showLanguage(language);
}

bool MainWindow::event(QEvent* event)
{
    if (event->type() == QEvent::MouseButtonPress)
        m_separates = isSeparator(static_cast<QMouseEvent*>(event)->position().toPoint());
    const bool isHandled = QMainWindow::event(event);  // passes a change of language on to all that is in the window
    if (event->type() == QEvent::LanguageChange && m_actions) {
        present(kEverything);
        fitToolBar();
    }
    if (event->type() == QEvent::MouseButtonRelease && std::exchange(m_separates, false)) rememberWidths();
    return isHandled;
}

void MainWindow::resizeEvent(QResizeEvent* event)
{
    QMainWindow::resizeEvent(event);
    fitToolBar();
    if (event->size().width() > event->oldSize().width()) restoreWidths();
}

// The snapshot ------------------------------------------------------------------------------------------------------

void MainWindow::present(Changes what)
{
    const Snapshot& shown = m_session.now();
    m_view->present(shown, what);
    m_status->present(shown, what);
    m_actions->present(shown, what);
    for (PanelDock* dock : m_docks) dock->panel().present(shown, what);
    if (what & (Change::Pipeline | Change::Picture)) showNeeded(shown);
    if (what & (Change::Scene | Change::Busy))
        m_centre->setCurrentWidget(shown.scene || !shown.busy.isEmpty() ? static_cast<QWidget*>(m_view) : m_start);
    if (what & Change::Selection) showWhy(shown);
    if (what & (Change::Scene | Change::Picture)) showEmptiness(shown);
    if ((what & Change::Scene) && shown.scene) {
        if (std::exchange(m_sceneShown, shown.scene) != shown.scene) {
            m_messages->hide();  // something went right
            if (shown.scene->word == m_fileAwaited) addRecentFile(std::exchange(m_fileAwaited, {}));
        }
        m_sceneName->setText(tr("%1 — %2").arg(
            shown.scene->title, counted(shown.scene->scene().triangleCount(), tr("1 triangle"), tr("%1 triangles"))));
        setWindowTitle(tr("%1 — ZScope").arg(shown.scene->title));
        menuBar()->setCornerWidget(m_sceneName);  // lays the corner out again for the longer text
    }
}

/// Once per reason: a bar that was closed stays closed until there is another.
void MainWindow::showEmptiness(const Snapshot& shown)
{
    const std::string why = shown.frame ? shown.frame->whyEmpty : std::string();
    if (std::exchange(m_whyEmpty, why) == why) return;
    if (why.empty())
        m_emptiness->hide();
    else
        m_emptiness->tell([why] { return said(why); });
}

void MainWindow::showWhy(const Snapshot& shown)
{
    const bool isNew = shown.picked && shown.picked != m_lastPick;
    m_lastPick       = shown.picked;
    // Whoever compares looks at the comparison of many pixels.
    if (isNew && !shown.compare.other && dock("why")->isVisible()) dock("why")->raise();
}

// Small dialogs -----------------------------------------------------------------------------------------------------

void MainWindow::goToPixel()
{
    const Camera& camera = m_session.now().pictureCamera();
    const QPoint  at     = m_session.now().picked.value_or(QPoint(camera.width / 2, camera.height / 2));
    QDialog       dialog(this);
    dialog.setWindowTitle(tr("Go to pixel"));
    auto* form = new QFormLayout(&dialog);
    auto *x = new QSpinBox, *y = new QSpinBox;
    x->setRange(0, camera.width - 1);
    y->setRange(0, camera.height - 1);
    x->setValue(at.x());
    y->setValue(at.y());
    form->addRow(tr("x"), x);
    form->addRow(tr("y"), y);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    form->addRow(buttons);
    x->selectAll();
    if (dialog.exec() != QDialog::Accepted) return;
    m_session.pick(QPoint(x->value(), y->value()));
    m_view->reveal(QPoint(x->value(), y->value()));
}

void MainWindow::showKeys()
{
    auto* sheet = new CheatSheet(*menuBar(), this);
    sheet->show();
}

void MainWindow::changeKeys()
{
    auto* dialog = new KeysDialog(m_actions->bindings(), this);
    dialog->open();
}

void MainWindow::showPalette()
{
    auto* palette = new CommandPalette(m_actions->bindings().commands(), this);
    palette->open();
}

void MainWindow::showAbout()
{
    QMessageBox::about(this, tr("About ZScope"),
                       tr("<h3>ZScope %1</h3><p>A microscope for visible-surface algorithms.</p>"
                          "<p>The window is free software under the GNU General Public License, version 3 or later; "
                          "the core library under the MIT licence.</p>")
                           .arg(ZSCOPE_VERSION));
}

bool MainWindow::eventFilter(QObject* object, QEvent* event)
{
    // Space and Enter belong to a focused button, box or dialog before they belong to the window.
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape && QApplication::activePopupWidget()) {  // which it closes, and no more
            event->accept();
            return true;
        }
        auto*      widget  = qobject_cast<QWidget*>(object);
        const bool isInput = qobject_cast<QAbstractButton*>(object) || qobject_cast<QComboBox*>(object)
                             || qobject_cast<QAbstractSpinBox*>(object) || qobject_cast<QLineEdit*>(object);
        if (widget && widget->hasFocus() && isInput
            && (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter)) {
            event->accept();
            return true;
        }
        if (widget && widget->hasFocus() && (key == Qt::Key_Return || key == Qt::Key_Enter)
            && widget->property("ownsEnter").toBool()) {
            event->accept();
            return true;
        }
        // Views that turn or move by arrow keys while they have the focus say so.
        const bool isSideways = key == Qt::Key_Left || key == Qt::Key_Right,
                   isUpright  = key == Qt::Key_Up || key == Qt::Key_Down;
        const bool isPlain = !(static_cast<QKeyEvent*>(event)->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
        if (widget && widget->hasFocus() && isPlain && !(isSideways && hasNoUseFor(widget, key))
            && (((isSideways || isUpright) && widget->property("ownsArrows").toBool())
                || (isUpright && widget->property("ownsUpAndDown").toBool()))) {
            event->accept();
            return true;
        }
        // In a field that holds nothing Left and Right have nowhere to go: they step.
        const auto* field = qobject_cast<QLineEdit*>(object);
        if (field && field->hasFocus() && isSideways && field->text().isEmpty()) {
            event->ignore();
            return true;
        }
    }
    if (leavesField(object, event)) return true;
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease)
        watchShift(static_cast<QKeyEvent*>(event));
    if (event->type() == QEvent::WindowDeactivate) m_session.holdOther(false);
    return QMainWindow::eventFilter(object, event);
}

/// Escape leaves a field before it stops or forgets anything.
bool MainWindow::leavesField(QObject* object, QEvent* event)
{
    const bool isAsked = event->type() == QEvent::ShortcutOverride;
    if (!isAsked && event->type() != QEvent::KeyPress) return false;
    const auto* field = qobject_cast<QWidget*>(object);
    if (static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape || !field || !isTyping(*field) || !field->hasFocus())
        return false;
    if (qobject_cast<QDialog*>(field->window())) return false;  // which it closes
    if (!isAsked) field->window()->setFocus();
    event->accept();
    return true;
}

void MainWindow::watchShift(const QKeyEvent* event)
{
    if (event->isAutoRepeat()) return;
    const bool  isShift = event->key() == Qt::Key_Shift, isPress = event->type() == QEvent::KeyPress;
    const auto* focus = QApplication::focusWidget();
    if (isShift && isPress && m_view->tool() == Tool::Inspect && !(focus && isTyping(*focus))) {
        m_held.start();
    } else {  // another key: Shift was part of a shortcut
        m_held.stop();
        if (isShift || isPress) m_session.holdOther(false);
    }
}

}  // namespace zscope::ui
