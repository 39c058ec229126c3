// SPDX-License-Identifier: GPL-3.0-or-later
// What the window remembers from one run to the next. Nothing in here can keep the program from starting: what does
// not read is left out, and after a start that did not finish the layout is left out once.
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QStringList>

#include "ui/text/language.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

class Settings {
public:
    static constexpr int kLayoutVersion = 1;
    static constexpr int kRecentFiles   = 9;

    /// A file, or the user's own place.
    explicit Settings(const QString& file = {});

    static void forget();  // --reset-settings

    /// Between beginStart() and finishStart() a crash is remembered, and the next start does without the layout.
    void beginStart();
    void finishStart();

    QByteArray  geometry() const;
    QByteArray  layout() const;
    QStringList hiddenPanels() const;
    void        keepWindow(const QByteArray& geometry, const QByteArray& layout, const QStringList& hiddenPanels);

    QStringList recentFiles() const;
    void        addRecentFile(const QString& path);
    void        clearRecentFiles();

    Appearance appearance() const;
    void       setAppearance(Appearance appearance);

    Language language() const;
    void     setLanguage(Language language);

    QString pictureFolder() const;
    void    setPictureFolder(const QString& folder);

private:
    mutable QSettings m_settings;
    bool              m_useLayout = true;
};

}  // namespace zscope::ui
