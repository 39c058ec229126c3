#include "core/io/json_document.h"

#include <charconv>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/quotable.h"

namespace zscope {

Result<double> realFromText(std::string_view text)
{
    const auto wrong = [text] {
        return Error{Trouble::Input,
                     fmt::format("'{}' is not a number: write a decimal, a C hex float, or inf", quotable(text, 60))};
    };
    std::string_view digits   = text;
    const bool       negative = digits.starts_with('-');
    if (negative || digits.starts_with('+')) digits.remove_prefix(1);
    if (digits == "inf") {
        const double infinity = std::numeric_limits<double>::infinity();
        return negative ? -infinity : infinity;
    }
    const bool hex = digits.starts_with("0x") || digits.starts_with("0X");
    if (hex) digits.remove_prefix(2);
    const auto isDigit = [hex](char c) {
        return (c >= '0' && c <= '9') || c == '.' || (hex && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')));
    };
    if (digits.empty() || !isDigit(digits.front())) return wrong();  // no second sign, no "nan"

    double     value = 0;
    const auto end   = digits.data() + digits.size();
    const auto answer =
        std::from_chars(digits.data(), end, value, hex ? std::chars_format::hex : std::chars_format::general);
    if (answer.ec == std::errc::result_out_of_range)
        return Error{Trouble::Input, fmt::format("the number '{}' is beyond the range of float64", quotable(text, 60))};
    if (answer.ec != std::errc{} || answer.ptr != end) return wrong();
    return negative ? -value : value;
}

Result<double> realOf(const JsonValue& value, const std::string& file, std::string_view what)
{
    if (const auto* real = std::get_if<double>(&value.value)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&value.value)) return static_cast<double>(*whole);
    if (const auto* large = std::get_if<std::uint64_t>(&value.value)) return static_cast<double>(*large);
    if (const auto* text = value.text()) {
        Result<double> real = realFromText(*text);
        if (!real) return errorAt(value, file, fmt::format("'{}': {}", what, real.error().sentence));
        return real;
    }
    return errorAt(value, file, fmt::format("'{}' must be a number", what));
}

Result<std::int64_t> wholeOf(const JsonValue& value, const std::string& file, std::string_view what, std::int64_t min,
                             std::int64_t max)
{
    const auto* whole = std::get_if<std::int64_t>(&value.value);
    if (!whole || *whole < min || *whole > max)
        return errorAt(value, file, fmt::format("'{}' must be a whole number from {} to {}", what, min, max));
    return *whole;
}

std::string quoted(std::string_view text)
{
    return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace zscope
