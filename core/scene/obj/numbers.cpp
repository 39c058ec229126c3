#include "core/scene/obj/numbers.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

namespace zscope::obj {

namespace {

/// For a number that from_chars calls out of range: is it one that rounds to zero? Decided by the power of ten of its
/// first digit other than 0; both limits are hundreds of powers away from zero.
bool isTiny(std::string_view word)
{
    std::int64_t power = 0;
    bool         point = false, started = false;
    std::size_t  i = 0;
    for (; i < word.size() && word[i] != 'e' && word[i] != 'E'; ++i) {
        if (word[i] == '.')
            point = true;
        else if (word[i] >= '0' && word[i] <= '9') {
            started = started || word[i] != '0';
            if (started && !point) ++power;
            if (!started && point) --power;
        }
    }
    if (i + 1 >= word.size()) return power < 0;
    std::string_view digits = word.substr(i + 1);
    if (digits.front() == '+') digits.remove_prefix(1);
    std::int64_t exponent = 0;
    const auto   read     = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (read.ec == std::errc::result_out_of_range) return digits.front() == '-';
    return power + exponent < 0;
}

std::string_view withoutPlus(std::string_view word)
{
    if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
    return word;
}

}  // namespace

NumberTrouble readReal(std::string_view word, double& value)
{
    const std::string_view text = withoutPlus(word);
    const auto [end, trouble]   = std::from_chars(text.data(), text.data() + text.size(), value);
    if (trouble == std::errc::invalid_argument || end != text.data() + text.size()) return NumberTrouble::NotANumber;
    if (trouble == std::errc::result_out_of_range) {
        if (!isTiny(text)) return NumberTrouble::OutOfRange;
        value = text.front() == '-' ? -0.0 : 0.0;
        return NumberTrouble::None;
    }
    return std::isfinite(value)                                         ? NumberTrouble::None
           : text.find_first_of("0123456789") == std::string_view::npos ? NumberTrouble::NotFinite
                                                                        : NumberTrouble::OutOfRange;
}

std::string_view describe(NumberTrouble trouble)
{
    switch (trouble) {
        case NumberTrouble::NotFinite:
            return "is not a finite number";
        case NumberTrouble::OutOfRange:
            return "is beyond the range of numbers";
        case NumberTrouble::None:
        case NumberTrouble::NotANumber:
            break;
    }
    return "is not a number";
}

bool readIndex(std::string_view word, std::int64_t& value)
{
    const std::string_view text = withoutPlus(word);
    const auto [end, trouble]   = std::from_chars(text.data(), text.data() + text.size(), value);
    if (trouble == std::errc::invalid_argument || end != text.data() + text.size()) return false;
    if (trouble == std::errc::result_out_of_range)
        value =
            text.front() == '-' ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
    return true;
}

}  // namespace zscope::obj
