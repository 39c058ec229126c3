#include "core/scene/obj/numbers.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "core/io/decimal.h"

namespace zscope::obj {

namespace {

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
        if (!roundsToZero(text)) return NumberTrouble::OutOfRange;
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

std::string_view beforeComment(std::string_view text)
{
    for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
        // The word before "1.#IND", "-1.#QNAN0" and their kind, as it would be without the rest.
        const std::size_t      begin = text.find_last_of(" \t\v\f", at) + 1;
        const std::string_view sign  = text.substr(begin, at - begin);
        const std::string_view rest  = text.substr(at + 1, text.find_first_of(" \t\v\f#", at + 1) - at - 1);
        const bool             isOfPrintf =
            (sign == "1." || sign == "-1." || sign == "+1.") && !rest.empty()
            && std::string_view("IJQRS").find(rest.front()) != std::string_view::npos
            && rest.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789") == std::string_view::npos;
        if (!isOfPrintf) return text.substr(0, at);
    }
    return text;
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
