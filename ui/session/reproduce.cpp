// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/reproduce.h"

#include <cmath>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include "core/io/png.h"

#include "ui/session/session_file.h"
#include "ui/text/phrase_book.h"
#include "ui/text/utf8_text.h"

namespace zscope::ui {
namespace {

QString number(double value)
{
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return QString::number(value, 'g', QLocale::FloatingPointShortest);  // reads back as the same value
}

QString triple(const dvec3& v) { return number(v.x) + ',' + number(v.y) + ',' + number(v.z); }

void addView(QStringList& words, const ViewRequest& view)
{
    if (view.exact) {
        words << "--camera" << kCameraFile;
        return;
    }
    words << "--size" << QString("%1x%2").arg(view.width).arg(view.height);
    if (view.eye) words << "--eye" << triple(*view.eye);
    if (view.target) words << "--target" << triple(*view.target);
    if (view.up != dvec3{0, 1, 0}) words << "--up" << triple(view.up);
    if (view.verticalFov != 45) words << "--fov" << number(view.verticalFov);
    if (view.near) words << "--near" << number(*view.near);
    if (view.far) words << "--far" << number(*view.far);
}

void addPipeline(QStringList& words, const Pipeline& pipeline)
{
    for (const Preset& preset : presets()) {
        if (preset.pipeline != pipeline) continue;
        words << "--algorithm" << utf8Text(preset.name);
        return;
    }
    for (const AxisEntry& axis : axes())
        words << "--set" << utf8Text(axis.word) + '=' + utf8Text(chosen(pipeline, axis.word));
}

}  // namespace

QStringList commandOf(const Snapshot& shown, const DrawSettings& settings)
{
    const bool  stepped = shown.showsStep && shown.step;
    QStringList words{"zscope-cli", stepped ? "step" : "render"};
    if (shown.scene) words << shown.scene->word;
    addView(words, shown.view);
    if (settings.faceCulling == FaceCulling::Back)
        words << "--cull"
              << "back";
    addPipeline(words, stepped ? shown.step->pipeline : shown.pipeline);
    if (stepped)
        words << "--grain" << utf8Text(wordOf(shown.step->state.grain)) << "--at"
              << QString::number(shown.step->state.step.value);
    if (!shown.look.isShaded()) words << "--show" << utf8Text(shown.look.layer->word);
    return words;
}

QString commandLineOf(const QStringList& words)
{
    static const QRegularExpression plain("^[A-Za-z0-9_./:=,+%@-]+$");
    QStringList                     quoted;
    for (QString word : words)
        quoted << (plain.match(word).hasMatch() ? word : '\'' + word.replace('\'', "'\\''") + '\'');
    return quoted.join(' ');
}

std::optional<QString> savePicture(const QImage& image, const QString& file, const Session& session, bool replace)
{
    const Snapshot& shown = session.now();
    if (!replace && QFileInfo::exists(file))
        return QCoreApplication::translate("SavePicture", "%1 is there already; it was left as it is.").arg(file);

    const auto texts = [&] {
        const std::string command = commandLineOf(commandOf(shown, session.settings())).toStdString();
        auto              all = reproducingTexts(command, shown.scene ? shown.scene->scene().digest : std::string());
        if (shown.view.exact) all.push_back({kCameraFile, cameraToJson(*shown.view.exact)});
        if (const auto saved = sessionFileOf(session)) all.push_back({kPngSession, sessionToJson(*saved, file)});
        return all;
    }();
    const QImage                        opaque = image.convertToFormat(QImage::Format_RGB32);
    const GridView<const std::uint32_t> pixels{reinterpret_cast<const std::uint32_t*>(opaque.constBits()),
                                               opaque.width(), opaque.height(),
                                               static_cast<std::size_t>(opaque.bytesPerLine()) / 4};
    const auto                          written = writePng(file.toStdString(), pixels, texts);
    if (!written) return said(written.error());
    return {};
}

}  // namespace zscope::ui
