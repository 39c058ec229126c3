// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <algorithm>
#include <cstring>
#include <string>

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

namespace zscope::ui {
namespace {

constexpr const char* kContext = "Core";

/// Chinese sets a blank between its own letters and latin ones or digits.
void append(QString& text, const QString& part)
{
    const auto isLatin = [](QChar c) { return c.unicode() < 0x80 && c.isLetterOrNumber(); };
    const auto isHan   = [](QChar c) { return c.script() == QChar::Script_Han; };
    if (!text.isEmpty() && !part.isEmpty()) {
        const QChar before = text.back(), after = part.front();
        if ((isHan(before) && isLatin(after)) || (isLatin(before) && isHan(after))) text += ' ';
    }
    text += part;
}

bool isValue(const QString& text)
{
    return std::ranges::none_of(text, [](QChar c) { return c.isSpace(); });
}

}  // namespace

QString said(std::string_view english) { return QCoreApplication::translate(kContext, std::string(english).c_str()); }

QString said(const Error& error)
{
    const QString sentence = said(error.sentence);
    if (error.file.empty()) return sentence;
    const QString file = QString::fromStdString(error.file);
    return error.line > 0 ? QStringLiteral("%1:%2: %3").arg(file).arg(error.line).arg(sentence)
                          : QStringLiteral("%1: %2").arg(file, sentence);
}

PhraseBook::PhraseBook(const QString& file, QObject* parent) : QTranslator(parent)
{
    QFile                       book(file);
    [[maybe_unused]] const bool isOpen = book.open(QIODevice::ReadOnly);
    Q_ASSERT(isOpen);
    const QJsonObject phrases = QJsonDocument::fromJson(book.readAll()).object();
    for (auto phrase = phrases.begin(); phrase != phrases.end(); ++phrase) add(phrase.key(), phrase.value().toString());
    // What takes any text comes first if much of it is given, and else last.
    std::ranges::stable_sort(m_phrases, std::less(), [](const Phrase& phrase) { return phrase.rank(); });
}

qsizetype PhraseBook::Phrase::rank() const
{
    constexpr qsizetype kMany    = 16;
    qsizetype           letters  = 0;
    bool                takesAny = false;
    for (const Piece& piece : pieces) {
        letters += piece.literal.size();
        takesAny = takesAny || piece.placeholder.isUpper();
    }
    return takesAny ? kMany - letters : 0;
}

void PhraseBook::add(const QString& english, const QString& translation)
{
    Phrase  phrase{.pieces = {}, .translation = translation};
    QString literal;
    for (qsizetype i = 0; i < english.size(); ++i) {
        const bool isPlaceholder = english[i] == '{' && i + 2 < english.size() && english[i + 2] == '}';
        if (!isPlaceholder) {
            literal += english[i];
            continue;
        }
        if (!literal.isEmpty()) phrase.pieces.push_back({literal, {}});
        phrase.pieces.push_back({{}, english[i + 1]});
        literal.clear();
        i += 2;
    }
    if (phrase.pieces.empty()) {
        m_whole.insert(english, translation);
        return;
    }
    if (!literal.isEmpty()) phrase.pieces.push_back({literal, {}});
    m_phrases.push_back(std::move(phrase));
}

QString PhraseBook::translate(const char* context, const char* source, const char*, int) const
{
    if (std::strcmp(context, kContext) != 0) return {};
    return sentence(QString::fromUtf8(source));
}

QString PhraseBook::sentence(const QString& english) const
{
    if (english.isEmpty()) return {};
    if (const QString whole = phrase(english); !whole.isNull()) return whole;
    for (qsizetype blank = english.indexOf(' '); blank > 0; blank = english.indexOf(' ', blank + 1)) {
        const QStringView before = QStringView(english).first(blank);
        if (!before.endsWith('.') && !before.endsWith(QLatin1String(".)"))) continue;
        const QString first = phrase(before.toString());
        if (first.isNull()) continue;
        if (const QString rest = sentence(english.mid(blank + 1)); !rest.isNull()) return first + rest;
    }
    return {};
}

QString PhraseBook::phrase(const QString& english) const
{
    if (const auto whole = m_whole.constFind(english); whole != m_whole.constEnd()) return *whole;
    for (const Phrase& candidate : m_phrases) {
        const QString &first = candidate.pieces.front().literal, &last = candidate.pieces.back().literal;
        if (!english.startsWith(first) || !english.endsWith(last)) continue;
        Values values;
        if (!matches(candidate, 0, english, 0, values)) continue;
        QString text;
        for (qsizetype i = 0; i < candidate.translation.size(); ++i) {
            const bool isPlaceholder = candidate.translation[i] == '{' && i + 2 < candidate.translation.size()
                                       && candidate.translation[i + 2] == '}';
            append(text,
                   isPlaceholder ? values.value(candidate.translation[i + 1]) : QString(candidate.translation[i]));
            if (isPlaceholder) i += 2;
        }
        return text;
    }
    return {};
}

bool PhraseBook::matches(const Phrase& phrase, std::size_t piece, const QString& text, qsizetype at,
                         Values& values) const
{
    if (piece == phrase.pieces.size()) return at == text.size();
    const Piece& now = phrase.pieces[piece];
    if (!now.literal.isEmpty()) {
        return QStringView(text).sliced(at).startsWith(now.literal)
               && matches(phrase, piece + 1, text, at + now.literal.size(), values);
    }
    const bool    isLast = piece + 1 == phrase.pieces.size();
    const QString next   = isLast ? QString() : phrase.pieces[piece + 1].literal;
    const bool    isAny  = now.placeholder.isUpper();
    const auto    least  = at + (isAny ? 0 : 1);  // any text may be none
    qsizetype     end    = isLast ? text.size() : text.indexOf(next, least);
    for (; end >= least; end = isLast ? -1 : text.indexOf(next, end + 1)) {
        const QString part = text.mid(at, end - at);
        if (now.placeholder.isDigit() && !isValue(part)) return false;  // a longer one holds a blank too
        const QString value = now.placeholder.isLower() ? this->phrase(part) : part;
        if ((value.isNull() && !isAny) || !matches(phrase, piece + 1, text, end, values)) continue;
        values.insert(now.placeholder, value);
        return true;
    }
    return false;
}

}  // namespace zscope::ui
