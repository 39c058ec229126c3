// SPDX-License-Identifier: GPL-3.0-or-later
// Core speaks English and knows no Qt. The phrase book turns what it says into another language: a flat JSON object of
// English templates and their translations.
//
// Template   {1}    a value: a number, an id, a name; taken over as it is, holds no blank
//            {a}    a phrase that is in the book itself, translated by itself; so clauses are written once
//            {A}    any text, taken over: a file name, what the system says
// Sentences  what is no phrase as a whole is translated sentence by sentence
// Promise    all or nothing: a text of which some part is in no template stays English as a whole. A test lets core say
//            whatever it can and wants all of it in the book
// Cost       a pass over the templates per phrase, some microseconds; texts are translated when they are shown
#pragma once

#include <string_view>
#include <vector>

#include <QHash>
#include <QString>
#include <QTranslator>

#include "core/base/result.h"

namespace zscope::ui {

/// What core says, in the language of the window: titles, words, sentences.
QString said(std::string_view english);
/// With file and line before it, where they are known.
QString said(const Error& error);

class PhraseBook final : public QTranslator {
    Q_OBJECT

public:
    explicit PhraseBook(const QString& file, QObject* parent = nullptr);

    bool    isEmpty() const override { return m_whole.isEmpty() && m_phrases.empty(); }
    QString translate(const char* context, const char* source, const char* disambiguation = nullptr,
                      int n = -1) const override;

    /// Null if the book does not have it.
    QString phrase(const QString& english) const;

private:
    struct Piece {
        QString literal;  // or, if empty:
        QChar   placeholder;
    };
    struct Phrase {
        std::vector<Piece> pieces;  // no two placeholders side by side
        QString            translation;

        /// Where it stands among the others, smaller first: 0 without a placeholder for any text; with one, the more of
        /// the text is given, the smaller.
        qsizetype rank() const;
    };
    using Values = QHash<QChar, QString>;

    void    add(const QString& english, const QString& translation);
    QString sentence(const QString& english) const;
    bool    matches(const Phrase& phrase, std::size_t piece, const QString& text, qsizetype at, Values& values) const;

    QHash<QString, QString> m_whole;  // templates without a placeholder
    std::vector<Phrase>     m_phrases;
};

}  // namespace zscope::ui
