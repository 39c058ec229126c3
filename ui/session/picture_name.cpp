// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/picture_name.h"

#include <algorithm>
#include <array>
#include <cstring>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

namespace zscope::ui {
namespace {

constexpr qsizetype  kLongestPattern = 100, kLongestField = 40;  // letters; a file's name may have 255 bytes
constexpr std::array kFields{"scene", "algorithm", "grain", "step", "n"};

QString translated(const char* sentence) { return QCoreApplication::translate("PictureName", sentence); }

/// Without anything that a file's name must not hold.
QString fit(QString text)
{
    static const QRegularExpression unfit("[^\\w.-]+", QRegularExpression::UseUnicodePropertiesOption);
    return text.replace(unfit, "-").left(kLongestField);
}

QString sceneOf(const Snapshot& shown)
{
    if (!shown.scene) return QStringLiteral("picture");
    QString scene = shown.scene->title;
    for (const char* suffix : {".obj", ".json"})
        if (scene.endsWith(QLatin1String(suffix), Qt::CaseInsensitive))
            scene.chop(static_cast<qsizetype>(std::strlen(suffix)));
    return fit(scene);
}

QString stepOf(const Snapshot& shown)
{
    return shown.showsStep && shown.step ? QString::number(shown.step->state.step.value + 1) : QStringLiteral("end");
}

}  // namespace

std::optional<QString> whyNoPictureTemplate(const QString& pattern)
{
    if (pattern.trimmed().isEmpty()) return translated(QT_TRANSLATE_NOOP("PictureName", "The template is empty."));
    if (pattern.size() > kLongestPattern)
        return translated(QT_TRANSLATE_NOOP("PictureName", "The template is longer than %1 letters."))
            .arg(kLongestPattern);
    if (pattern.startsWith('.'))
        return translated(QT_TRANSLATE_NOOP("PictureName", "A name that begins with a dot would be hidden."));
    static const QRegularExpression unfit(QStringLiteral("[/\\\\:*?\"<>|\\x00-\\x1F]"));
    if (const auto bad = unfit.match(pattern); bad.hasMatch())
        return translated(QT_TRANSLATE_NOOP("PictureName", "A file's name cannot hold “%1”.")).arg(bad.captured());

    static const QRegularExpression field(QStringLiteral("\\{([^{}]*)\\}"));
    for (const auto& match : field.globalMatch(pattern))
        if (std::ranges::find(kFields, match.captured(1)) == kFields.end())
            return translated(QT_TRANSLATE_NOOP("PictureName", "There is no field {%1}.")).arg(match.captured(1));
    if (QString(pattern).remove(field).contains(QRegularExpression("[{}]")))
        return translated(QT_TRANSLATE_NOOP("PictureName", "A brace has no counterpart."));
    if (!pattern.contains("{n}"))
        return translated(QT_TRANSLATE_NOOP(
            "PictureName", "{n} is missing: without a number one picture would take the place of another."));
    return {};
}

QString freePictureName(const Snapshot& shown, const QString& folder, const QString& pattern, const QString& suffix)
{
    QString name = whyNoPictureTemplate(pattern) ? QString(kPictureTemplate) : pattern.trimmed();
    name.replace("{scene}", sceneOf(shown));
    name.replace("{algorithm}", fit(QString::fromStdString(nameOf(shown.pipeline))));
    const std::string_view grain = wordOf(shown.grain);
    name.replace("{grain}", QString::fromLatin1(grain.data(), static_cast<qsizetype>(grain.size())));
    name.replace("{step}", stepOf(shown));
    for (int n = 1;; ++n) {
        const QString numbered = QString(name).replace("{n}", QString::number(n));
        if (!QFileInfo::exists(QDir(folder).filePath(numbered + '.' + suffix))) return numbered;
    }
}

}  // namespace zscope::ui
