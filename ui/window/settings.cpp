// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/settings.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUrl>

#include "ui/session/picture_name.h"

namespace zscope::ui {
namespace {

constexpr const char* kOrganisation = "ZScope";
constexpr const char* kProgram      = "zscope";

/// The first line, from 1, that is neither empty nor a comment, a [group] or a key with a value; 0: there is none.
int firstBrokenLine(const QString& name)
{
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly)) return 0;  // there is none yet
    for (int number = 1; !file.atEnd(); ++number) {
        const QByteArray line = file.readLine().trimmed();
        if (line.isEmpty() || line.startsWith(';') || line.startsWith('#')) continue;
        if (line.startsWith('[') ? !line.endsWith(']') : line.indexOf('=') < 1) return number;
        if (line.contains('\0')) return number;
    }
    return 0;
}

}  // namespace

Settings::Settings(const QString& file)
    : m_settings(file.isEmpty()
                     ? QSettings(QSettings::IniFormat, QSettings::UserScope, kOrganisation, kProgram).fileName()
                     : file,
                 QSettings::IniFormat)
{
    const int line = firstBrokenLine(m_settings.fileName());
    if (line == 0 && m_settings.status() == QSettings::NoError) return;
    m_brokenLine = line;
    QFile::remove(m_settings.fileName() + ".broken");
    QFile::copy(m_settings.fileName(), m_settings.fileName() + ".broken");  // what the user wrote is not lost
    m_settings.clear();
}

std::optional<QString> Settings::trouble() const
{
    if (!m_brokenLine) return {};
    return *m_brokenLine > 0
               ? tr("%1:%2: this is no setting; the window starts with its defaults.")
                     .arg(m_settings.fileName())
                     .arg(*m_brokenLine)
               : tr("%1 cannot be read as settings; the window starts with its defaults.").arg(m_settings.fileName());
}

void Settings::forget(const QString& file)
{
    QSettings settings(file.isEmpty()
                           ? QSettings(QSettings::IniFormat, QSettings::UserScope, kOrganisation, kProgram).fileName()
                           : file,
                       QSettings::IniFormat);
    settings.clear();
    settings.sync();
}

void Settings::beginStart()
{
    m_useLayout = !m_settings.value("start/unfinished", false).toBool();
    m_settings.setValue("start/unfinished", true);
    m_settings.sync();
}

void Settings::finishStart()
{
    m_settings.setValue("start/unfinished", false);
    m_settings.sync();
}

QByteArray Settings::geometry() const
{
    return m_useLayout ? m_settings.value("window/geometry").toByteArray() : QByteArray();
}

QByteArray Settings::layout() const
{
    return m_useLayout ? m_settings.value("window/layout").toByteArray() : QByteArray();
}

QStringList Settings::hiddenPanels() const
{
    return m_useLayout ? m_settings.value("window/hiddenPanels").toStringList() : QStringList();
}

void Settings::keepWindow(const QByteArray& geometry, const QByteArray& layout, const QStringList& hiddenPanels)
{
    m_settings.setValue("window/geometry", geometry);
    m_settings.setValue("window/layout", layout);
    m_settings.setValue("window/hiddenPanels", hiddenPanels);
}

QString Settings::layoutName() const
{
    return m_useLayout ? m_settings.value("window/layoutName").toString() : QString();
}

void Settings::setLayoutName(const QString& word) { m_settings.setValue("window/layoutName", word); }

QStringList Settings::ownLayouts() const
{
    QStringList names;
    m_settings.beginGroup("layouts");
    for (const QString& key : m_settings.childGroups()) names << QUrl::fromPercentEncoding(key.toLatin1());
    m_settings.endGroup();
    names.sort(Qt::CaseInsensitive);
    return names;
}

std::pair<QByteArray, QStringList> Settings::ownLayout(const QString& name) const
{
    const QString at = "layouts/" + QString::fromLatin1(QUrl::toPercentEncoding(name));
    return {m_settings.value(at + "/state").toByteArray(), m_settings.value(at + "/hidden").toStringList()};
}

void Settings::keepOwnLayout(const QString& name, const QByteArray& state, const QStringList& hidden)
{
    const QString at = "layouts/" + QString::fromLatin1(QUrl::toPercentEncoding(name));
    m_settings.setValue(at + "/state", state);
    m_settings.setValue(at + "/hidden", hidden);
}

void Settings::forgetOwnLayout(const QString& name)
{
    m_settings.remove("layouts/" + QString::fromLatin1(QUrl::toPercentEncoding(name)));
}

QStringList Settings::recentFiles() const
{
    QStringList files = m_settings.value("files/recent").toStringList();
    while (files.size() > kRecentFiles) files.removeLast();
    return files;
}

void Settings::addRecentFile(const QString& path)
{
    QStringList files = recentFiles();
    files.removeAll(path);
    files.prepend(path);
    while (files.size() > kRecentFiles) files.removeLast();
    m_settings.setValue("files/recent", files);
}

void Settings::clearRecentFiles() { m_settings.remove("files/recent"); }

Appearance Settings::appearance() const
{
    const QString word = m_settings.value("look/appearance").toString();
    return word == "light" ? Appearance::Light : word == "dark" ? Appearance::Dark : Appearance::System;
}

void Settings::setAppearance(Appearance appearance)
{
    m_settings.setValue("look/appearance", appearance == Appearance::Light  ? "light"
                                           : appearance == Appearance::Dark ? "dark"
                                                                            : "system");
}

Language Settings::language() const
{
    return languageOf(m_settings.value("look/language").toString().toStdString()).value_or(Language::System);
}

void Settings::setLanguage(Language language)
{
    const std::string_view word = wordOf(language);
    m_settings.setValue("look/language", QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size())));
}

std::optional<QStringList> Settings::keysOf(const QString& command) const
{
    const QString at = "keys/" + command;
    if (!m_settings.contains(at)) return {};
    QStringList keys = m_settings.value(at).toStringList();
    keys.removeAll(QString());  // an empty list is kept as one empty word
    return keys;
}

void Settings::keepKeys(const QString& command, const std::optional<QStringList>& keys)
{
    if (!keys)
        m_settings.remove("keys/" + command);
    else
        m_settings.setValue("keys/" + command, keys->isEmpty() ? QStringList{QString()} : *keys);
}

QString Settings::theirFolder() const { return m_settings.value("files/theirs").toString(); }
void    Settings::setTheirFolder(const QString& folder) { m_settings.setValue("files/theirs", folder); }

QString Settings::lessonFolder() const { return m_settings.value("files/lessons").toString(); }

void Settings::setLessonFolder(const QString& folder) { m_settings.setValue("files/lessons", folder); }

QString Settings::pictureTemplate() const
{
    const QString kept = m_settings.value("files/pictureTemplate").toString();
    return whyNoPictureTemplate(kept) ? QString(kPictureTemplate) : kept;
}

void Settings::setPictureTemplate(const QString& pattern)
{
    if (!whyNoPictureTemplate(pattern)) m_settings.setValue("files/pictureTemplate", pattern);
}

QString Settings::pictureFolder() const
{
    const QString kept = m_settings.value("files/pictures").toString();
    if (QFileInfo(kept).isDir()) return kept;
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QFileInfo(pictures).isDir() ? pictures : QDir::homePath();
}

void Settings::setPictureFolder(const QString& folder) { m_settings.setValue("files/pictures", folder); }

}  // namespace zscope::ui
