#include "core/io/phrase_book.h"

#include <algorithm>
#include <cassert>
#include <cctype>

#include "core/base/quotable.h"
#include "core/io/json_document.h"

namespace zscope {

extern const unsigned char kChineseJson[];  // made from resources/i18n/core_zh_CN.json
extern const std::size_t   kChineseJsonBytes;

namespace {

bool isHan(char32_t code)
{
    return (code >= 0x2E80 && code <= 0x2FDF) || code == 0x3005 || code == 0x3007 || (code >= 0x3400 && code <= 0x4DBF)
           || (code >= 0x4E00 && code <= 0x9FFF) || (code >= 0xF900 && code <= 0xFAFF)
           || (code >= 0x20000 && code <= 0x3FFFF);
}

bool isLatin(char32_t code) { return code < 0x80 && std::isalnum(static_cast<int>(code)) != 0; }

char32_t firstOf(std::string_view text)
{
    const auto character = firstCharacter(text);
    return character ? character->code : 0;
}

char32_t lastOf(std::string_view text)
{
    std::size_t at = text.size() - 1;
    while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80) --at;
    return firstOf(text.substr(at));
}

/// Chinese sets a blank between its own letters and latin ones or digits.
void append(std::string& text, std::string_view part)
{
    if (!text.empty() && !part.empty()) {
        const char32_t before = lastOf(text), after = firstOf(part);
        if ((isHan(before) && isLatin(after)) || (isLatin(before) && isHan(after))) text += ' ';
    }
    text += part;
}

bool isValue(std::string_view text)
{
    while (!text.empty()) {
        const auto character = firstCharacter(text);
        if (character
            && (character->code == ' ' || character->code == '\t' || character->code == '\n' || character->code == '\r'
                || character->code == 0xA0 || character->code == 0x3000))
            return false;
        text.remove_prefix(character ? character->bytes : 1);
    }
    return true;
}

bool isPlaceholderAt(std::string_view text, std::size_t at)
{
    return text[at] == '{' && at + 2 < text.size() && text[at + 2] == '}';
}

}  // namespace

Result<PhraseBook> PhraseBook::fromJson(std::string_view json, const std::string& file)
{
    const Result<JsonValue> document = parseJson(json, file);
    if (!document) return document.error();
    const JsonValue::Object* phrases = document->object();
    if (!phrases) return Error{Trouble::Input, "a phrase book must be an object of texts", file, document->line};
    PhraseBook book;
    for (const JsonMember& phrase : *phrases) {
        const std::string* translation = phrase.second.text();
        if (!translation)
            return Error{Trouble::Input, "a phrase book must be an object of texts", file, phrase.second.line};
        book.add(phrase.first, *translation);
    }
    // What takes any text comes first if much of it is given, and else last.
    std::ranges::stable_sort(book.m_phrases, std::less(), &Phrase::rank);
    return book;
}

void PhraseBook::add(std::string_view english, const std::string& translation)
{
    Phrase      phrase{.pieces = {}, .translation = translation};
    std::string literal;
    int         letters  = 0;
    bool        takesAny = false;
    for (std::size_t i = 0; i < english.size(); ++i) {
        if (!isPlaceholderAt(english, i)) {
            literal += english[i];
            ++letters;
            continue;
        }
        if (!literal.empty()) phrase.pieces.push_back({literal, 0});
        phrase.pieces.push_back({{}, english[i + 1]});
        takesAny = takesAny || std::isupper(static_cast<unsigned char>(english[i + 1])) != 0;
        literal.clear();
        i += 2;
    }
    if (phrase.pieces.empty()) {
        m_whole.emplace(english, translation);
        return;
    }
    if (!literal.empty()) phrase.pieces.push_back({literal, 0});
    constexpr int kMany = 16;
    phrase.rank         = takesAny ? kMany - letters : 0;
    m_phrases.push_back(std::move(phrase));
}

std::string PhraseBook::said(std::string_view english) const { return text(english).value_or(std::string(english)); }

std::optional<std::string> PhraseBook::text(std::string_view english) const
{
    if (english.empty()) return std::nullopt;
    if (auto whole = phrase(english)) return whole;
    for (std::size_t blank = english.find(' '); blank != std::string_view::npos; blank = english.find(' ', blank + 1)) {
        const std::string_view before = english.substr(0, blank);
        if (!before.ends_with('.') && !before.ends_with(".)")) continue;
        const auto first = phrase(before);
        if (!first) continue;
        if (const auto rest = text(english.substr(blank + 1))) return *first + *rest;
    }
    return std::nullopt;
}

std::optional<std::string> PhraseBook::phrase(std::string_view english) const
{
    if (const auto whole = m_whole.find(english); whole != m_whole.end()) return whole->second;
    for (const Phrase& candidate : m_phrases) {
        if (!english.starts_with(candidate.pieces.front().literal)
            || !english.ends_with(candidate.pieces.back().literal))
            continue;
        Values values;
        if (!matches(candidate, 0, english, 0, values)) continue;
        std::string            text;
        const std::string_view into = candidate.translation;
        for (std::size_t i = 0; i < into.size();) {
            if (isPlaceholderAt(into, i)) {
                append(text, values[into[i + 1]]);
                i += 3;
                continue;
            }
            const auto        character = firstCharacter(into.substr(i));
            const std::size_t bytes     = character ? character->bytes : 1;
            append(text, into.substr(i, bytes));
            i += bytes;
        }
        return text;
    }
    return std::nullopt;
}

bool PhraseBook::matches(const Phrase& phrase, std::size_t piece, std::string_view text, std::size_t at,
                         Values& values) const
{
    if (piece == phrase.pieces.size()) return at == text.size();
    const Piece& now = phrase.pieces[piece];
    if (!now.literal.empty())
        return text.substr(at).starts_with(now.literal)
               && matches(phrase, piece + 1, text, at + now.literal.size(), values);
    const bool        isLast = piece + 1 == phrase.pieces.size();
    const auto        kind   = static_cast<unsigned char>(now.placeholder);
    const bool        isAny  = std::isupper(kind) != 0;
    const std::size_t least  = at + (isAny ? 0 : 1);  // any text may be none
    if (least > text.size()) return false;
    const auto endFrom = [&](std::size_t from) {
        return isLast ? text.size() : text.find(phrase.pieces[piece + 1].literal, from);
    };
    for (std::size_t end = endFrom(least); end != std::string_view::npos;
         end             = isLast ? std::string_view::npos : endFrom(end + 1)) {
        const std::string_view part = text.substr(at, end - at);
        if (std::isdigit(kind) != 0 && !isValue(part)) return false;  // a longer one holds a blank too
        const auto value = std::islower(kind) != 0 ? this->phrase(part) : std::optional<std::string>(part);
        if (!value || !matches(phrase, piece + 1, text, end, values)) continue;
        values.emplace(now.placeholder, *value);
        return true;
    }
    return false;
}

const PhraseBook& chinesePhrases()
{
    static const PhraseBook book = [] {
        const std::string_view json(reinterpret_cast<const char*>(kChineseJson), kChineseJsonBytes);
        auto                   read = PhraseBook::fromJson(json, "core_zh_CN.json");
        assert(read);
        return read ? *std::move(read) : PhraseBook();
    }();
    return book;
}

}  // namespace zscope
