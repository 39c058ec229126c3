// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the window. Three sources make it up: the window's own texts (resources/i18n/zscope_zh_CN.ts), Qt's
// own, and the sentences of core (resources/i18n/core_zh_CN.json, ui/text/phrase_book.h). All three are in the program.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <QString>
#include <QTranslator>

namespace zscope::ui {

enum class Language : unsigned char { System, English, Chinese };

/// "system", "en", "zh_CN": how settings and the command line name it.
std::string_view        wordOf(Language language);
std::optional<Language> languageOf(std::string_view word);
/// What the system asks for: Chinese where it is written in simplified letters, otherwise English.
Language languageOfSystem();

/// Holds the translators that are installed. Every widget hears QEvent::LanguageChange from speak().
class Translation {
public:
    Translation();
    ~Translation();

    void speak(Language language);

private:
    std::vector<std::unique_ptr<QTranslator>> m_installed;
};

}  // namespace zscope::ui
