// Core speaks English. A phrase book turns what it says into another language: a flat JSON object of English templates
// and their translations.
//
// Template   {1}    a value: a number, an id, a name; taken over as it is, holds no blank
//            {a}    a phrase that is in the book itself, translated by itself; so clauses are written once
//            {A}    any text, taken over: a file name, what the system says
// Sentences  what is no phrase as a whole is translated sentence by sentence
// Promise    all or nothing: a text of which some part is in no template stays English as a whole
// Cost       a pass over the templates per phrase, some microseconds
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace zscope {

class PhraseBook {
public:
    PhraseBook() = default;
    /// `file` is named in errors. Errors: Input, what is no object of texts.
    static Result<PhraseBook> fromJson(std::string_view json, const std::string& file);

    /// Nothing if the book does not have it.
    std::optional<std::string> phrase(std::string_view english) const;
    /// One phrase, or several sentences one after another.
    std::optional<std::string> text(std::string_view english) const;
    /// The same, or the English text.
    std::string said(std::string_view english) const;

private:
    struct Piece {
        std::string literal;  // or, if empty:
        char        placeholder = 0;
    };
    struct Phrase {
        std::vector<Piece> pieces;  // no two placeholders side by side
        std::string        translation;
        /// Where it stands among the others, smaller first: 0 without a placeholder for any text; with one, the more of
        /// the text is given, the smaller.
        int rank = 0;
    };
    using Values = std::map<char, std::string>;

    void add(std::string_view english, const std::string& translation);
    bool matches(const Phrase& phrase, std::size_t piece, std::string_view text, std::size_t at, Values& values) const;

    std::map<std::string, std::string, std::less<>> m_whole;  // templates without a placeholder
    std::vector<Phrase>                             m_phrases;
};

/// Simplified Chinese: resources/i18n/core_zh_CN.json, which is in the program.
const PhraseBook& chinesePhrases();

}  // namespace zscope
