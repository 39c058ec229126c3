// SPDX-License-Identifier: GPL-3.0-or-later
// What the window does about measuring: starts and stops it, saves comparison sheets and camera paths, opens records.
#include "ui/window/main_window.h"

#include <cmath>

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

#include "core/io/file_writer.h"
#include "ui/panels/measure/measure_panel.h"
#include "ui/session/picture_name.h"
#include "ui/sheet/sheet_maker.h"
#include "ui/text/phrase_book.h"
#include "ui/window/actions.h"
#include "ui/window/dock.h"
#include "ui/window/message_bar.h"
#include "ui/window/status_line.h"

namespace zscope::ui {
namespace {

constexpr int kFramesBetweenKeys = 30;  // a second where a film has 30 frames

/// `name` in the folder, with a number that no file has yet.
QString freeName(const QString& folder, const QString& name, const QString& suffix)
{
    for (int n = 1;; ++n) {
        const QString file = QDir(folder).filePath(QStringLiteral("%1_%2.%3").arg(name).arg(n).arg(suffix));
        if (!QFileInfo::exists(file)) return file;
    }
}

}  // namespace

void MainWindow::saveSheet()
{
    const std::vector<BenchAlgorithm> algorithms = SheetMaker::ask(this, m_session);
    if (algorithms.empty()) return;
    const QString suggested = QDir(m_settings.pictureFolder())
                                  .filePath(freePictureName(m_session.now(), m_settings.pictureFolder(),
                                                            m_settings.pictureTemplate(), QStringLiteral("pdf"))
                                            + QStringLiteral(".pdf"));
    QString file = QFileDialog::getSaveFileName(this, tr("Save the comparison sheet"), suggested,
                                                tr("PDF pages (*.pdf);;PNG pictures (*.png)"));
    if (file.isEmpty()) return;
    if (const QString suffix = QFileInfo(file).suffix().toLower();
        suffix != QStringLiteral("pdf") && suffix != QStringLiteral("png")) {
        file += QStringLiteral(".pdf");  // the dialog has not asked about this name
        if (QFileInfo::exists(file))
            return m_messages->tell(tr("%1 is there already; it was left as it is.").arg(file));
    }
    m_settings.setPictureFolder(QFileInfo(file).absolutePath());
    m_status->showMessage(tr("Drawing and timing %1 algorithms for the sheet").arg(algorithms.size()));
    m_sheets->make(algorithms, file);
}

void MainWindow::measure()
{
    showPanel(QStringLiteral("measure"));
    measurePanel().start();
}

void MainWindow::stopMeasuring() { measurePanel().measurer().stop(); }

void MainWindow::watchMeasuring()
{
    Measurer&  measurer = measurePanel().measurer();
    const auto show     = [this, &measurer] { m_actions->showMeasuring(measurer.isRunning()); };
    connect(&measurer, &Measurer::progressed, m_actions, show);
    connect(&measurer, &Measurer::ended, m_actions, show);
}

MeasurePanel& MainWindow::measurePanel() const
{
    return static_cast<MeasurePanel&>(dock(QStringLiteral("measure"))->panel());
}

void MainWindow::openRecord()
{
    showPanel(QStringLiteral("measure"));
    measurePanel().askForRecord();
}

void MainWindow::addKeyFrame(bool afterCut)
{
    const Snapshot& now = m_session.now();
    if (!now.scene) return;
    const Bounds& box    = now.scene->scene().bounds;
    const dvec3   middle = box.isEmpty() ? dvec3(0, 0, 0) : box.min * 0.5 + box.max * 0.5;
    const dvec3   way    = middle - now.camera.eye;
    const double  length = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
    const int     frame  = m_path.keys.empty() ? 0 : m_path.keys.back().frame + kFramesBetweenKeys;
    if (frame >= kMaxPathFrames)
        return m_messages->tell(tr("A camera path has at most %1 frames.").arg(kMaxPathFrames));
    CameraKey key = keyOf(now.camera, frame, length > 0 ? length : 1);
    key.isCut     = afterCut && frame > 0;
    m_path.keys.push_back(key);
    m_status->showMessage(tr("Key frame %1 of the camera path, at frame %2").arg(m_path.keys.size()).arg(frame), 8000);
}

std::optional<QString> MainWindow::saveCameraPath(const QString& file) const
{
    if (const auto done = writeFile(QFile::encodeName(file).toStdString(), cameraPathToJson(m_path)); !done)
        return said(done.error());
    return {};
}

void MainWindow::askWhereToSavePath()
{
    if (m_path.keys.empty()) return m_messages->tell(tr("The camera path is empty: add key frames first."));
    const QString suggested =
        freeName(m_settings.pictureFolder(), QStringLiteral("camera-path"), QStringLiteral("json"));
    QString file =
        QFileDialog::getSaveFileName(this, tr("Save the camera path"), suggested, tr("Camera paths (*.json)"));
    if (file.isEmpty()) return;
    if (!file.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive)) {
        file += QStringLiteral(".json");
        if (QFileInfo::exists(file))
            return m_messages->tell(tr("%1 is there already; it was left as it is.").arg(file));
    }
    if (const auto trouble = saveCameraPath(file)) return m_messages->tell(*trouble);
    m_settings.setPictureFolder(QFileInfo(file).absolutePath());
    m_status->showMessage(tr("Saved %1").arg(QDir::toNativeSeparators(file)), 8000);
}

}  // namespace zscope::ui
