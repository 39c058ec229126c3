// JSON as it was written: every value knows its line, objects keep their order, and nothing is guessed.
//
// Limits     nesting to kMaxJsonDepth; the memory of the values is bounded before they are made
// Text       UTF-8, a byte order mark at its start aside (core/io/text_encoding.h)
// Errors     "file:line: sentence": syntax, with the column in characters and the mistake by its name; a key given
//            twice, a number beyond float64, text that is not UTF-8
// Why        nlohmann's values know no lines and keep the last of two equal keys without a word, and its errors speak
//            of tokens
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace zscope {

inline constexpr int kMaxJsonDepth = 64;

struct JsonMember;

struct JsonValue {
    using Array  = std::vector<JsonValue>;
    using Member = JsonMember;
    using Object = std::vector<Member>;  // in the order of the file, keys unique

    /// null, bool, whole number, whole number beyond int64, real, text, array, object
    std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> value;
    int line = 0;  // 1-based, where the value starts; of arrays and objects where they open

    const Array*       array() const { return std::get_if<Array>(&value); }
    const Object*      object() const { return std::get_if<Object>(&value); }
    const std::string* text() const { return std::get_if<std::string>(&value); }
    const bool*        truth() const { return std::get_if<bool>(&value); }
};

struct JsonMember {
    std::string first;   // the key
    JsonValue   second;  // what it stands for
};

/// `file` is named in errors. memoryLimit: bytes the values may take; 0 for the default. firstLine: where in the file
/// the text begins.
Result<JsonValue> parseJson(std::string_view text, const std::string& file, std::uint64_t memoryLimit = 0,
                            int firstLine = 1);

inline Error errorAt(const JsonValue& value, const std::string& file, std::string sentence)
{
    return inputError(std::move(sentence), file, value.line);
}

/// A real: a JSON number, or a string holding a decimal, a C hex float, or "inf"; correctly rounded.
/// `what` names the value in errors.
Result<double> realOf(const JsonValue& value, const std::string& file, std::string_view what);
/// The same for words of a command line.
Result<double> realFromText(std::string_view text);

/// A whole number in [min, max].
Result<std::int64_t> wholeOf(const JsonValue& value, const std::string& file, std::string_view what, std::int64_t min,
                             std::int64_t max);

/// Text between quotes, with everything escaped that JSON wants escaped.
std::string quoted(std::string_view text);

}  // namespace zscope
