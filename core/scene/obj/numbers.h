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

/// An index: decimal digits with an optional sign. Values beyond int64 become the nearest int64, which no list holds.
bool readIndex(std::string_view word, std::int64_t& value);

}  // namespace zscope::obj
