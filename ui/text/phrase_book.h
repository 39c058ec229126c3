// SPDX-License-Identifier: GPL-3.0-or-later
// Core speaks English and knows no Qt. Its phrase book (core/io/phrase_book.h) is a translator of Qt here, so that what
// core says follows the language of the window. A test lets core say whatever it can and wants all of it in the book.
#pragma once

#include <string_view>

#include <QString>
#include <QTranslator>

#include "core/base/result.h"
#include "core/io/phrase_book.h"

namespace zscope::ui {

/// What core says, in the language of the window: titles, words, sentences.
QString said(std::string_view english);
/// With file and line before it, where they are known.
QString said(const Error& error);

class CoreTranslator final : public QTranslator {
    Q_OBJECT

public:
    /// The book outlives it.
    explicit CoreTranslator(const PhraseBook& book, QObject* parent = nullptr) : QTranslator(parent), m_book(book) {}

    bool    isEmpty() const override { return false; }
    QString translate(const char* context, const char* source, const char* disambiguation = nullptr,
                      int n = -1) const override;

    /// Null if the book does not have it.
    QString phrase(const QString& english) const;

private:
    const PhraseBook& m_book;
};

}  // namespace zscope::ui
