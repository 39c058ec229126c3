// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

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
#include <QSpinBox>
#include <QTextBrowser>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/panels/registry.h"
#include "ui/session/reproduce.h"
#include "ui/text/numbers.h"
#include "ui/text/spoken.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"
#include "ui/view/frame_view.h"
#include "ui/window/actions.h"
#include "ui/window/dock.h"
#include "ui/window/message_bar.h"
#include "ui/window/status_line.h"

namespace zscope::ui {

MainWindow::MainWindow(Session& session, Settings& settings, const QPalette& systemPalette)
    : m_session(session), m_settings(settings), m_systemPalette(systemPalette)
{
    m_translation.speak(settings.language());  // before anything is said
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
    m_actions = new Actions(*this, session, *m_view,
                            {.open             = [this] { chooseFile(); },
                             .savePicture      = [this] { savePicture(true); },
                             .savePlainPicture = [this] { savePicture(false); },
                             .savePictureAs    = [this] { savePictureAs(); },
                             .copyPicture      = [this] { copyPicture(); },
                             .goToPixel        = [this] { goToPixel(); },
                             .resetLayout      = [this] { resetLayout(); },
                             .about            = [this] { showAbout(); },
                             .keys             = [this] { showKeys(); },
                             .look             = [this](Appearance look) {
                                 m_settings.setAppearance(look);
                                 applyAppearance(look);
                             },
                             .speak            = [this](Language language) {
                                 m_settings.setLanguage(language);
                                 speak(language);
                             },
                             .openWord         = [this](const QString& word) { open(word); }});
    m_sceneName = new QLabel;
    m_sceneName->setObjectName("soft");
    m_sceneName->setContentsMargins(0, kStep / 2, 2 * kStep, 0);
    menuBar()->setCornerWidget(m_sceneName);
    makeDocks();

    connect(m_view, &FrameView::toolChanged, m_actions, &Actions::showTool);
    connect(m_view, &FrameView::hovered, m_status, &StatusLine::hover);
    connect(&session, &Session::changed, this, &MainWindow::present);
    connect(&session, &Session::failed, m_messages, &MessageBar::tell);
    m_held.setSingleShot(true);
    m_held.setInterval(120);  // Shift with another key is not held
    connect(&m_held, &QTimer::timeout, this, [this] { m_session.holdOther(true); });
    qApp->installEventFilter(this);

    m_actions->showRecent(settings.recentFiles());
    m_actions->showAppearance(settings.appearance());
    m_actions->showLanguage(settings.language());
    applyAppearance(settings.appearance());
    resize(1280, 800);
    resetLayout();
    restoreLayout();
    present(kEverything);
}

MainWindow::~MainWindow() { qApp->removeEventFilter(this); }

void MainWindow::makeCentre()
{
    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kStep);
    m_messages = new MessageBar(centre);
    auto* frame = new QFrame;
    frame->setObjectName("picture");
    auto* inside = new QVBoxLayout(frame);
    inside->setContentsMargins(1, 1, 1, 1);
    m_view = new FrameView(m_session);
    inside->addWidget(m_view);
    layout->addWidget(m_messages);
    layout->addWidget(frame, 1);
    setCentralWidget(centre);
}

// Docks -------------------------------------------------------------------------------------------------------------

void MainWindow::makeDocks()
{
    for (const PanelEntry& entry : panels()) {
        auto* dock   = new PanelDock(entry, entry.make(m_session), this);
        auto* toggle = m_actions->panelsMenu()->addAction(QString());
        spoken(*toggle, [toggle, &entry] { toggle->setText(entry.translatedTitle()); });
        toggle->setCheckable(true);
        toggle->setChecked(true);
        connect(toggle, &QAction::triggered, dock, &PanelDock::setWanted);
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

void MainWindow::placeDocks()
{
    for (PanelDock* dock : m_docks) {
        dock->setFloating(false);
        addDockWidget(dock->entry().area, dock);
        if (const char* first = dock->entry().tabbedWith) tabifyDockWidget(this->dock(first), dock);
        dock->setWanted(true);
        dock->setNeeded(dock->entry().isNeededBy(m_session.now().pipeline));
    }
    // Of the panels that share a place the first is seen.
    for (auto dock = m_docks.rbegin(); dock != m_docks.rend(); ++dock) QTimer::singleShot(0, *dock, &QWidget::raise);
}

namespace {

/// What runs when the pipeline's choices are measured, as far as a panel cares: a step tells what it has.
Pipeline ranIn(const Snapshot& shown)
{
    Pipeline               ran       = shown.pipeline;
    const HierarchyState*  hierarchy = shown.hierarchy();
    if (ran.chooser != Chooser::Measured || !hierarchy) return ran;
    if (hierarchy->tree) ran.order = *hierarchy->tree == TreeKind::Octree ? Order::Octree : Order::Bvh;
    if (!hierarchy->levels.empty()) ran.upkeep = Upkeep::OnQuery;
    return ran;
}

}  // namespace

void MainWindow::showNeeded(const Snapshot& shown)
{
    const Pipeline ran = ranIn(shown);
    bool changed = false;
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
    if (changed) shareHeights();
}

void MainWindow::shareHeights()
{
    QList<QDockWidget*> docks;
    QList<int>          shares;
    for (PanelDock* dock : m_docks) {
        if (!dock->isVisible() || dock->isFloating() || dockWidgetArea(dock) != Qt::RightDockWidgetArea) continue;
        docks << dock;
        shares << dock->entry().share;
    }
    resizeDocks(docks, shares, Qt::Vertical);
}

void MainWindow::resetLayout()
{
    placeDocks();
    const auto pick = [this](std::initializer_list<const char*> words) {
        QList<QDockWidget*> docks;
        for (const char* word : words) docks << dock(word);
        return docks;
    };
    const int side = std::max(width(), 1280);
    resizeDocks(pick({"scene", "active-edges"}), {std::max(240, side * 17 / 100), std::max(440, side * 25 / 100)}, Qt::Horizontal);
    resizeDocks(pick({"scene", "pipeline"}), {42, 58}, Qt::Vertical);
    shareHeights();
}

void MainWindow::restoreLayout()
{
    if (const QByteArray geometry = m_settings.geometry(); !geometry.isEmpty()) restoreGeometry(geometry);
    if (const QByteArray layout = m_settings.layout(); !layout.isEmpty()) restoreState(layout, Settings::kLayoutVersion);
    const QStringList hidden = m_settings.hiddenPanels();
    for (PanelDock* dock : m_docks) dock->setWanted(!hidden.contains(dock->entry().word));
}

void MainWindow::showEvent(QShowEvent* event)
{
    QMainWindow::showEvent(event);
    m_settings.finishStart();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    QStringList hidden;
    for (const PanelDock* dock : m_docks)
        if (!dock->isWanted()) hidden << dock->entry().word;
    m_settings.keepWindow(saveGeometry(), saveState(Settings::kLayoutVersion), hidden);
    m_session.player().setPlaying(false);
    m_session.cancelWork();
    QMainWindow::closeEvent(event);
}

void MainWindow::applyAppearance(Appearance appearance)
{
    const QPalette palette = paletteOf(appearance, m_systemPalette);
    const Theme&   theme   = themeOf(palette);
    qApp->setPalette(palette);
    qApp->setStyleSheet(styleSheetOf(theme));
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
    const bool isHandled = QMainWindow::event(event);  // passes a change of language on to all that is in the window
    if (event->type() == QEvent::LanguageChange && m_actions) present(kEverything);
    return isHandled;
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
    if ((what & Change::Scene) && shown.scene) {
        m_messages->hide();
        m_sceneName->setText(tr("%1 — %2 triangles").arg(shown.scene->title, grouped(shown.scene->scene().triangleCount())));
        setWindowTitle(tr("%1 — ZScope").arg(shown.scene->title));
        menuBar()->setCornerWidget(m_sceneName);  // lays the corner out again for the longer text
    }
}

// Files -------------------------------------------------------------------------------------------------------------

void MainWindow::open(const QString& word, const Session::ViewOf& viewOf)
{
    QString name = word;
    if (!word.startsWith("builtin:")) {
        name = QFileInfo(word).absoluteFilePath();
        m_settings.addRecentFile(name);
        m_actions->showRecent(m_settings.recentFiles());
    }
    m_session.player().setPlaying(false);
    m_session.open(name, viewOf);
}

void MainWindow::chooseFile()
{
    const QStringList recent = m_settings.recentFiles();
    const QString     folder = recent.isEmpty() ? QString() : QFileInfo(recent.front()).absolutePath();
    const QString     file   = QFileDialog::getOpenFileName(this, tr("Open a scene"), folder,
                                                            tr("Scenes (*.obj *.OBJ *.json);;All files (*)"));
    if (!file.isEmpty()) open(file);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) return event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls()) {
        if (!url.isLocalFile()) continue;
        event->acceptProposedAction();
        return open(url.toLocalFile());
    }
}

void MainWindow::savePicture(bool decorated)
{
    const QImage image = m_view->picture(decorated);
    if (image.isNull()) return;
    const QDir    folder(m_settings.pictureFolder());
    const QString file = folder.filePath(freePictureName(m_session.now(), folder.path()) + ".png");
    if (const auto trouble = ui::savePicture(image, file, m_session.now(), m_session.settings(), false)) m_messages->tell(*trouble);
    else m_status->showMessage(tr("Saved %1").arg(QDir::toNativeSeparators(file)), 8000);
}

void MainWindow::savePictureAs()
{
    const QImage image = m_view->picture(true);
    if (image.isNull()) return;
    const QDir    folder(m_settings.pictureFolder());
    const QString suggested = folder.filePath(freePictureName(m_session.now(), folder.path()) + ".png");
    QString       file      = QFileDialog::getSaveFileName(this, tr("Save the picture"), suggested, tr("PNG pictures (*.png)"));
    if (file.isEmpty()) return;
    const bool asked = file.endsWith(".png", Qt::CaseInsensitive);  // the dialog has asked about this very name
    if (!asked) file += ".png";
    if (const auto trouble = ui::savePicture(image, file, m_session.now(), m_session.settings(), asked)) return m_messages->tell(*trouble);
    m_settings.setPictureFolder(QFileInfo(file).absolutePath());
    m_status->showMessage(tr("Saved %1").arg(QDir::toNativeSeparators(file)), 8000);
}

void MainWindow::copyPicture()
{
    const QImage image = m_view->picture(true);
    if (image.isNull()) return;
    QApplication::clipboard()->setImage(image);
    m_status->showMessage(tr("The picture is in the clipboard"), 4000);
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
    QString rows;
    for (const QAction* action : m_actions->all()) {
        if (action->shortcuts().isEmpty()) continue;
        QString name = plainName(*action);
        name.remove(QChar(0x2026));
        rows += QString("<tr><td style='padding:2px 24px 2px 0'><b>%1</b></td><td>%2</td></tr>")
                    .arg(QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText).toHtmlEscaped(),
                         name.toHtmlEscaped());
    }
    QDialog dialog(this);
    dialog.setWindowTitle(tr("Keys and mouse"));
    dialog.resize(560, 640);
    auto* text = new QTextBrowser;
    text->setFrameShape(QFrame::NoFrame);
    text->setHtml(tr("<p><b>Inspect</b>: the wheel zooms to the cursor, dragging pans, a click picks a pixel.<br>"
                     "<b>Camera</b>, or Alt held: left drag orbits, middle drag pans, right drag looks around, the wheel "
                     "dollies, the arrow keys turn the model, W A S D Q E fly, Shift flies faster.</p>") +
                  "<table>" + rows + "</table>");
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(&dialog);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog.exec();
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
        const int  key     = static_cast<QKeyEvent*>(event)->key();
        auto*      widget  = qobject_cast<QWidget*>(object);
        const bool isInput = qobject_cast<QAbstractButton*>(object) || qobject_cast<QComboBox*>(object) ||
                             qobject_cast<QAbstractSpinBox*>(object) || qobject_cast<QLineEdit*>(object);
        if (widget && widget->hasFocus() && isInput && (key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter)) {
            event->accept();
            return true;
        }
        if (widget && widget->hasFocus() && (key == Qt::Key_Return || key == Qt::Key_Enter) && widget->property("ownsEnter").toBool()) {
            event->accept();
            return true;
        }
        // Views that turn or move by arrow keys while they have the focus say so.
        const bool isArrow = key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down;
        const bool isPlain = !(static_cast<QKeyEvent*>(event)->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
        if (widget && widget->hasFocus() && isArrow && isPlain && widget->property("ownsArrows").toBool()) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) watchShift(static_cast<QKeyEvent*>(event));
    if (event->type() == QEvent::WindowDeactivate) m_session.holdOther(false);
    return QMainWindow::eventFilter(object, event);
}

void MainWindow::watchShift(const QKeyEvent* event)
{
    if (event->isAutoRepeat()) return;
    const bool isShift = event->key() == Qt::Key_Shift, isPress = event->type() == QEvent::KeyPress;
    const bool types   = qobject_cast<QLineEdit*>(QApplication::focusWidget()) || qobject_cast<QAbstractSpinBox*>(QApplication::focusWidget());
    if (isShift && isPress && m_view->tool() == Tool::Inspect && !types) {
        m_held.start();
    } else {  // another key: Shift was part of a shortcut
        m_held.stop();
        if (isShift || isPress) m_session.holdOther(false);
    }
}

}  // namespace zscope::ui
