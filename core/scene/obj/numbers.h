// Numbers as they stand in an OBJ or MTL file, read from one word.
//
// Promise    the float64 nearest to the decimal text (ties to even), whatever the locale; nothing but a whole word is
//            a number: no hex, no "1,5", no trailing letters. A leading '+' is allowed
#pragma once

#include <cstdint>
#include <string_view>

namespace zscope::obj {

enum class NumberTrouble {
    None,
    NotANumber,
    NotFinite,   // nan, inf
    OutOfRange,  // beyond the largest float64
};

NumberTrouble readReal(std::string_view word, double& value);

/// What is wrong, to follow the quoted word: "is not a number".
std::string_view describe(NumberTrouble trouble);

/// What stands before the comment of a statement of numbers, which any '#' begins: "0 1 0# green". Only in what some
/// programs write for infinity and NaN, "1.#INF" and "-1.#IND", it belongs to the word.
std::string_view beforeComment(std::string_view text);

/// An index: decimal digits with an optional sign. Values beyond int64 become the nearest int64, which no list holds.
bool readIndex(std::string_view word, std::int64_t& value);

}  // namespace zscope::obj
