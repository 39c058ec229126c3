// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/reproduce.h"

#include <cmath>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QImageWriter>
#include <QRegularExpression>
#include <QSaveFile>

namespace zscope::ui {
namespace {

QString number(double value)
{
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return QString::number(value, 'g', QLocale::FloatingPointShortest);  // reads back as the same value
}

QString triple(const dvec3& v) { return number(v.x) + ',' + number(v.y) + ',' + number(v.z); }

QString text(std::string_view view) { return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size())); }

void addView(QStringList& words, const ViewRequest& view)
{
    if (view.exact) {
        words << "--camera" << "camera.json";
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
        words << "--algorithm" << text(preset.name);
        return;
    }
    for (const AxisEntry& axis : axes())
        words << "--set" << text(axis.word) + '=' + text(chosen(pipeline, axis.word));
}

}  // namespace

QStringList commandOf(const Snapshot& shown, const DrawSettings& settings, const QString& file)
{
    const bool  stepped = shown.showsStep && shown.step;
    QStringList words{"zscope-cli", stepped ? "step" : "render"};
    if (shown.scene) words << shown.scene->word;
    addView(words, shown.view);
    if (settings.faceCulling == FaceCulling::Back) words << "--cull" << "back";
    addPipeline(words, stepped ? shown.step->pipeline : shown.pipeline);
    if (stepped)
        words << "--grain" << text(wordOf(shown.step->state.grain)) << "--at"
              << QString::number(shown.step->state.step.value);
    if (shown.layer != &layers().front()) words << "--show" << text(shown.layer->word);
    return words << "-o" << file;
}

QString commandLineOf(const QStringList& words)
{
    static const QRegularExpression plain("^[A-Za-z0-9_./:=,+%@-]+$");
    QStringList quoted;
    for (QString word : words)
        quoted << (plain.match(word).hasMatch() ? word : '\'' + word.replace('\'', "'\\''") + '\'');
    return quoted.join(' ');
}

QString freePictureName(const Snapshot& shown, const QString& folder)
{
    static const QRegularExpression unfit("[^\\w.-]+", QRegularExpression::UseUnicodePropertiesOption);
    QString scene = shown.scene ? shown.scene->title : QString("picture");
    if (shown.scene && scene.endsWith(".obj", Qt::CaseInsensitive)) scene.chop(4);
    scene.replace(unfit, "-");
    QString algorithm = QString::fromStdString(nameOf(shown.pipeline));
    algorithm.replace(unfit, "-");
    for (int n = 1;; ++n) {
        const QString name = QString("%1_%2_%3").arg(scene, algorithm).arg(n);
        if (!QFileInfo::exists(QDir(folder).filePath(name + ".png"))) return name;
    }
}

std::optional<QString> savePicture(const QImage& image, const QString& file, const Snapshot& shown,
                                   const DrawSettings& settings, bool replace)
{
    const auto tr = [](const char* source) { return QCoreApplication::translate("SavePicture", source); };
    if (!replace && QFileInfo::exists(file)) return tr("%1 is there already; it was left as it is.").arg(file);

    QSaveFile out(file);
    if (!out.open(QIODevice::WriteOnly)) return tr("%1 cannot be written: %2.").arg(file, out.errorString());
    QImageWriter writer(&out, "png");
    writer.setText("Software", "ZScope " ZSCOPE_VERSION);
    writer.setText("Command", commandLineOf(commandOf(shown, settings, QFileInfo(file).fileName())));
    if (shown.scene) writer.setText("Scene digest", QString::fromStdString(shown.scene->scene().digest));
    if (shown.view.exact) writer.setText("camera.json", QString::fromStdString(cameraToJson(*shown.view.exact)));
    if (!writer.write(image)) return tr("%1 cannot be written: %2.").arg(file, writer.errorString());
    if (!out.commit()) return tr("%1 cannot be written: %2.").arg(file, out.errorString());
    return {};
}

}  // namespace zscope::ui
