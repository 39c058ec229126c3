// SPDX-License-Identifier: GPL-3.0-or-later
// What the window opens and saves: scenes, sessions, pictures.
#include "ui/window/main_window.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>

#include "core/io/file_writer.h"
#include "core/io/read_file.h"
#include "ui/session/course.h"
#include "ui/session/examiner.h"
#include "ui/session/picture_name.h"
#include "ui/session/reproduce.h"
#include "ui/session/session_file.h"
#include "ui/session/their_files.h"
#include "ui/session/tracer.h"
#include "ui/text/phrase_book.h"
#include "ui/view/frame_view.h"
#include "ui/window/actions.h"
#include "ui/window/message_bar.h"
#include "ui/window/picture_names_dialog.h"
#include "ui/window/start_page.h"
#include "ui/window/status_line.h"

namespace zscope::ui {
namespace {

constexpr std::uint64_t kLargestSession = std::uint64_t{16} << 20;  // bytes

}  // namespace

void MainWindow::open(const QString& word, const Session::ViewOf& viewOf)
{
    if (word.endsWith(QString(".") + kSessionSuffix, Qt::CaseInsensitive)) return openSession(word);
    if (!word.startsWith("builtin:") && (isDrawn(word) || isTrace(word))) return openFiles({word}, false);
    QString name = word;
    m_fileAwaited.clear();
    if (!word.startsWith("builtin:")) m_fileAwaited = name = QFileInfo(word).absoluteFilePath();
    m_session.player().setPlaying(false);
    m_session.open(name, viewOf);
}

void MainWindow::addRecentFile(const QString& file)
{
    m_settings.addRecentFile(file);
    m_actions->showRecent(m_settings.recentFiles());
}

void MainWindow::chooseFile()
{
    const QStringList recent = m_settings.recentFiles();
    const QString     folder = recent.isEmpty() ? QString() : QFileInfo(recent.front()).absolutePath();
    const QString     file =
        QFileDialog::getOpenFileName(this, tr("Open a scene"), folder,
                                     tr("Scenes and sessions (*.obj *.OBJ *.json *.zscope-session);;All files (*)"));
    if (!file.isEmpty()) open(file);
}

void MainWindow::chooseTheirs()
{
    const QStringList files =
        QFileDialog::getOpenFileNames(this, tr("Open my picture"), m_settings.theirFolder(),
                                      tr("Depth, ids and pictures (%1);;All files (*)").arg(drawnPatterns()));
    if (!files.isEmpty()) openTheirs(files);
}

void MainWindow::saveReport()
{
    const auto theirs = m_session.now().compare.theirs;
    if (!theirs) return;
    const QDir folder(m_settings.theirFolder());
    QString    file = QFileDialog::getSaveFileName(
           this, tr("Save the report"), folder.filePath(QFileInfo(theirs->title).completeBaseName() + "-report.html"),
           tr("HTML pages (*.html)"));
    if (file.isEmpty()) return;
    if (!file.endsWith(".html", Qt::CaseInsensitive)) {
        file += ".html";
        if (QFileInfo::exists(file))
            return m_messages->tell([file] { return tr("%1 is there already; it was left as it is.").arg(file); });
    }
    m_session.examiner().saveReport(file);
}

void MainWindow::openTheirs(const QStringList& files)
{
    m_settings.setTheirFolder(QFileInfo(files.front()).absolutePath());
    QStringList paths;  // a session is found again from elsewhere
    for (const QString& file : files) paths << QFileInfo(file).absoluteFilePath();
    m_session.examiner().open(paths);
}

void MainWindow::chooseTrace()
{
    const QString file = QFileDialog::getOpenFileName(this, tr("Open my trace"), m_settings.theirFolder(),
                                                      tr("Traces (%1);;All files (*)").arg(tracePatterns()));
    if (!file.isEmpty()) openTrace(file);
}

void MainWindow::openTrace(const QString& file)
{
    m_settings.setTheirFolder(QFileInfo(file).absolutePath());
    m_session.tracer().open(QFileInfo(file).absoluteFilePath());
}

void MainWindow::openFiles(const QStringList& files, bool asB)
{
    QStringList others, drawn;
    for (const QString& file : files)
        if (!isTrace(file)) others << file;
    if (const auto trace = std::ranges::find_if(files, isTrace); trace != files.end()) openTrace(*trace);
    if (others.isEmpty()) return;
    for (const QString& file : others)
        if (isDrawn(file)) drawn << file;
    if (!isDrawn(others.front())) return open(others.front());
    if (!asB && sessionInPicture(others.front())) return openSession(others.front());
    openTheirs(drawn);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) return event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) files << url.toLocalFile();
    if (files.isEmpty()) return;
    event->acceptProposedAction();
    openFiles(files, event->modifiers().testFlag(Qt::ShiftModifier));
}

void MainWindow::savePicture(bool decorated)
{
    const QImage image = m_view->picture(decorated);
    if (image.isNull()) return;
    const QDir    folder(m_settings.pictureFolder());
    const QString file =
        folder.filePath(freePictureName(m_session.now(), folder.path(), m_settings.pictureTemplate()) + ".png");
    if (const auto trouble = ui::savePicture(image, file, m_session, false))
        m_messages->tell(*trouble);
    else
        m_status->showMessage(tr("Saved %1").arg(QDir::toNativeSeparators(file)), 8000);
}

void MainWindow::savePictureAs()
{
    const QImage image = m_view->picture(true);
    if (image.isNull()) return;
    const QDir    folder(m_settings.pictureFolder());
    const QString suggested =
        folder.filePath(freePictureName(m_session.now(), folder.path(), m_settings.pictureTemplate()) + ".png");
    QString file = QFileDialog::getSaveFileName(this, tr("Save the picture"), suggested, tr("PNG pictures (*.png)"));
    if (file.isEmpty()) return;
    const bool asked = file.endsWith(".png", Qt::CaseInsensitive);  // the dialog has asked about this very name
    if (!asked) file += ".png";
    if (const auto trouble = ui::savePicture(image, file, m_session, asked)) return m_messages->tell(*trouble);
    m_settings.setPictureFolder(QFileInfo(file).absolutePath());
    m_status->showMessage(tr("Saved %1").arg(QDir::toNativeSeparators(file)), 8000);
}

void MainWindow::namePictures()
{
    PictureNamesDialog dialog(m_settings.pictureTemplate(), m_session.now(), m_settings.pictureFolder(), this);
    if (dialog.exec() == QDialog::Accepted) m_settings.setPictureTemplate(dialog.pattern());
}

void MainWindow::copyPicture()
{
    const QImage image = m_view->picture(true);
    if (image.isNull()) return;
    QApplication::clipboard()->setImage(image);
    m_status->showMessage(tr("The picture is in the clipboard"), 4000);
}

// Sessions ----------------------------------------------------------------------------------------------------------

void MainWindow::openSession(const QString& file)
{
    std::string text;
    if (auto carried = sessionInPicture(file)) {
        text = *std::move(carried);
    } else {
        auto read = readRegularFile(file.toStdString(), kLargestSession);
        if (!read) return m_messages->tell(read.error());
        text = std::move(read).value();
    }
    const auto session = sessionFromJson(text, file);
    if (!session) return m_messages->tell(session.error());
    addRecentFile(QFileInfo(file).absoluteFilePath());
    if (!session->layout.state.isEmpty()) applyLayout(session->layout);
    restore(m_session, *session);
}

void MainWindow::saveSession()
{
    auto session = sessionFileOf(m_session);
    if (!session) return;
    const QDir    folder(m_settings.pictureFolder());
    const QString suggested =
        folder.filePath(freePictureName(m_session.now(), folder.path(), m_settings.pictureTemplate(), kSessionSuffix)
                        + '.' + kSessionSuffix);
    QString file =
        QFileDialog::getSaveFileName(this, tr("Save the session"), suggested, tr("ZScope sessions (*.zscope-session)"));
    if (file.isEmpty()) return;
    if (!file.endsWith(QString(".") + kSessionSuffix)) {
        file += QString(".") + kSessionSuffix;
        if (QFileInfo::exists(file))
            return m_messages->tell([file] { return tr("%1 is there already; it was left as it is.").arg(file); });
    }
    saveSessionTo(file);
}

void MainWindow::saveSessionTo(const QString& file)
{
    auto session = sessionFileOf(m_session);
    if (!session) return;
    session->layout    = layoutNow();
    const auto written = writeFile(file.toStdString(), sessionToJson(*session, file));
    if (!written) return m_messages->tell(written.error());
    addRecentFile(QFileInfo(file).absoluteFilePath());
    m_status->showMessage(tr("Saved %1").arg(QDir::toNativeSeparators(file)), 8000);
}

// Lessons -----------------------------------------------------------------------------------------------------------

void MainWindow::chooseLessons()
{
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Open a folder of lessons"), m_settings.lessonFolder());
    if (!folder.isEmpty()) openLessons(folder);
}

void MainWindow::openLessons(const QString& folder)
{
    m_settings.setLessonFolder(folder);
    m_session.course().setFolder(folder);
    showPanel(QStringLiteral("lessons"));
}

}  // namespace zscope::ui
