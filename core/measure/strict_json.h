// Numbers of a JSON file, taken for what they are: the parser's own way makes 18446744073709551615 of -1, and 2 of 2.7,
// without a word.
//
// Errors     nlohmann's exceptions, as for a member that is missing
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

namespace zscope {

/// A whole number from `least` to `most`.
template <std::integral Whole>
Whole wholeOf(const nlohmann::ordered_json& json, Whole least = 0, Whole most = std::numeric_limits<Whole>::max())
{
    const auto isIn = [=](auto value) { return std::cmp_less_equal(least, value) && std::cmp_less_equal(value, most); };
    const bool fits = json.is_number_unsigned() ? isIn(json.get<std::uint64_t>())
                                                : json.is_number_integer() && isIn(json.get<std::int64_t>());
    if (!fits) throw nlohmann::ordered_json::other_error::create(501, "no such whole number", &json);
    return json.get<Whole>();
}

/// A number that is not negative: a time, for example.
inline double amountOf(const nlohmann::ordered_json& json)
{
    const double value = json.get<double>();
    return value >= 0 ? value : throw nlohmann::ordered_json::other_error::create(501, "less than nothing", &json);
}

/// Itself, if it is a list: whoever goes over null meets nothing, and over an object its values.
inline const nlohmann::ordered_json& listOf(const nlohmann::ordered_json& json)
{
    return json.is_array() ? json : throw nlohmann::ordered_json::other_error::create(501, "no list", &json);
}

}  // namespace zscope
