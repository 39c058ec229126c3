// SPDX-License-Identifier: GPL-3.0-or-later
// What the window remembers from one run to the next. Nothing in here can keep the program from starting: what does
// not read is left out, and after a start that did not finish the layout is left out once.
#pragma once

#include <optional>

#include <QByteArray>
#include <QCoreApplication>
#include <QSettings>
#include <QStringList>

#include "ui/text/language.h"
#include "ui/theme/theme.h"

namespace zscope::ui {

class Settings {
    Q_DECLARE_TR_FUNCTIONS(Settings)

public:
    static constexpr int kLayoutVersion = 2;
    static constexpr int kRecentFiles   = 9;

    /// A file, or the user's own place.
    explicit Settings(const QString& file = {});

    /// What was wrong with the file, with its line, in the language of the moment; nothing of the file is used, and a
    /// copy is kept.
    std::optional<QString> trouble() const;

    /// --reset-settings; of a file, or the user's own.
    static void forget(const QString& file = {});

    /// Between beginStart() and finishStart() a crash is remembered, and the next start does without the layout.
    void beginStart();
    void finishStart();

    QByteArray  geometry() const;
    QByteArray  layout() const;
    QStringList hiddenPanels() const;
    void        keepWindow(const QByteArray& geometry, const QByteArray& layout, const QStringList& hiddenPanels);

    /// The layout chosen last, by its word.
    QString layoutName() const;
    void    setLayoutName(const QString& word);

    /// Layouts that the user has saved.
    QStringList                        ownLayouts() const;
    std::pair<QByteArray, QStringList> ownLayout(const QString& name) const;  // state, hidden panels
    void keepOwnLayout(const QString& name, const QByteArray& state, const QStringList& hidden);
    void forgetOwnLayout(const QString& name);

    QStringList recentFiles() const;
    void        addRecentFile(const QString& path);
    void        clearRecentFiles();

    Appearance appearance() const;
    void       setAppearance(Appearance appearance);

    Language language() const;
    void     setLanguage(Language language);

    /// Keys of a command in portable words; nothing: its defaults.
    std::optional<QStringList> keysOf(const QString& command) const;
    void                       keepKeys(const QString& command, const std::optional<QStringList>& keys);

    /// Of pictures that another program drew; empty: none was opened yet.
    QString theirFolder() const;
    void    setTheirFolder(const QString& folder);
    /// A teacher's lessons; empty: none.
    QString lessonFolder() const;
    void    setLessonFolder(const QString& folder);

    /// What saved pictures are called; one that cannot be used counts as the default.
    QString pictureTemplate() const;
    void    setPictureTemplate(const QString& pattern);

    QString pictureFolder() const;
    void    setPictureFolder(const QString& folder);

private:
    mutable QSettings  m_settings;
    bool               m_useLayout = true;
    std::optional<int> m_brokenLine;  // from 1; 0: the file as a whole; nothing: it is sound
};

}  // namespace zscope::ui
