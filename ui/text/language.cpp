// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/language.h"

#include <QCoreApplication>
#include <QLocale>

#include "ui/text/phrase_book.h"

static void registerTranslations() { Q_INIT_RESOURCE(zscope_i18n); }  // not inside a namespace

namespace zscope::ui {

std::string_view wordOf(Language language)
{
    switch (language) {
        case Language::System:
            return "system";
        case Language::English:
            return "en";
        case Language::Chinese:
            return "zh_CN";
    }
    return {};
}

std::optional<Language> languageOf(std::string_view word)
{
    for (const Language language : {Language::System, Language::English, Language::Chinese})
        if (wordOf(language) == word) return language;
    return {};
}

Language languageOfSystem()
{
    const QLocale system = QLocale::system();
    return system.language() == QLocale::Chinese && system.script() == QLocale::SimplifiedHanScript ? Language::Chinese
                                                                                                    : Language::English;
}

Translation::Translation() { registerTranslations(); }

Translation::~Translation() = default;

void Translation::speak(Language language)
{
    m_installed.clear();  // a translator that goes away takes itself out
    if ((language == Language::System ? languageOfSystem() : language) == Language::English) return;
    for (const char* name : {":/i18n/qtbase_zh_CN.qm", ":/i18n/zscope_zh_CN.qm"}) {
        m_installed.push_back(std::make_unique<QTranslator>());
        [[maybe_unused]] const bool isThere = m_installed.back()->load(name);
        Q_ASSERT(isThere);
    }
    m_installed.push_back(std::make_unique<CoreTranslator>(chinesePhrases()));
    for (const auto& translator : m_installed) QCoreApplication::installTranslator(translator.get());
}

}  // namespace zscope::ui
