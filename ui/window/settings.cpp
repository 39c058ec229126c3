// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/settings.h"

#include <algorithm>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace zscope::ui {
namespace {

constexpr const char* kOrganisation = "ZScope";
constexpr const char* kProgram      = "zscope";

}  // namespace

Settings::Settings(const QString& file)
    : m_settings(file.isEmpty() ? QSettings(QSettings::IniFormat, QSettings::UserScope, kOrganisation, kProgram).fileName() : file,
                 QSettings::IniFormat)
{
    if (m_settings.status() != QSettings::NoError) m_settings.clear();  // not ours, or damaged
}

void Settings::forget()
{
    QSettings settings(QSettings::IniFormat, QSettings::UserScope, kOrganisation, kProgram);
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

QByteArray Settings::geometry() const { return m_useLayout ? m_settings.value("window/geometry").toByteArray() : QByteArray(); }

QByteArray Settings::layout() const { return m_useLayout ? m_settings.value("window/layout").toByteArray() : QByteArray(); }

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

QString Settings::pictureFolder() const
{
    const QString kept = m_settings.value("files/pictures").toString();
    if (QFileInfo(kept).isDir()) return kept;
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QFileInfo(pictures).isDir() ? pictures : QDir::homePath();
}

void Settings::setPictureFolder(const QString& folder) { m_settings.setValue("files/pictures", folder); }

}  // namespace zscope::ui
