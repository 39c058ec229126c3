#include "app/cli/words.h"

#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/io/json_document.h"

namespace zscope::cli {
namespace {

Error wrong(std::string_view option, std::string_view wants, std::string_view text)
{
    return {Trouble::Usage, fmt::format("{} wants {}, not '{}'", option, wants, text)};
}

}  // namespace

Result<std::int64_t> wholeNumber(std::string_view text, std::string_view option, std::int64_t min, std::int64_t max)
{
    std::int64_t value    = 0;
    const auto [end, why] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (why == std::errc{} && end == text.data() + text.size() && value >= min && value <= max) return value;
    if (max == std::numeric_limits<std::int64_t>::max())
        return wrong(option, fmt::format("a whole number from {}", min), text);
    return wrong(option, fmt::format("a whole number from {} to {}", min, max), text);
}

Result<double> realNumber(std::string_view text, std::string_view option, Infinity infinity)
{
    const Result<double> value = realFromText(text);
    if (value && std::isfinite(*value)) return *value;
    if (infinity == Infinity::Refused) return wrong(option, "a finite number", text);
    if (value && std::isinf(*value) && *value > 0) return *value;
    return wrong(option, "a number or inf", text);
}

Result<dvec3> vector(std::string_view text, std::string_view option)
{
    const std::vector<std::string> parts = listOf(text);
    if (parts.size() != 3) return wrong(option, "three numbers as x,y,z", text);
    dvec3 v{};
    for (int i = 0; i < 3; ++i) {
        const Result<double> part = realNumber(parts[static_cast<std::size_t>(i)], option);
        if (!part) return wrong(option, "three finite numbers as x,y,z", text);
        v[i] = *part;
    }
    return v;
}

Result<PictureSize> pictureSize(std::string_view text, std::string_view option)
{
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) return wrong(option, "WIDTHxHEIGHT in pixels", text);
    constexpr std::int64_t kMost  = std::numeric_limits<int>::max();
    const auto             width  = wholeNumber(text.substr(0, cross), option, 0, kMost);
    const auto             height = wholeNumber(text.substr(cross + 1), option, 0, kMost);
    if (!width || !height) return wrong(option, "WIDTHxHEIGHT in pixels", text);
    return PictureSize{static_cast<int>(*width), static_cast<int>(*height)};
}

std::vector<std::string> listOf(std::string_view text)
{
    std::vector<std::string> parts;
    for (std::size_t start = 0;;) {
        const std::size_t comma = text.find(',', start);
        parts.emplace_back(text.substr(start, comma - start));
        if (comma == std::string_view::npos) return parts;
        start = comma + 1;
    }
}

Error unknownWord(std::string_view kind, std::string_view word, const std::vector<std::string>& valid)
{
    std::string choices;
    for (std::size_t i = 0; i < valid.size(); ++i)
        choices += (i == 0 ? "" : i + 1 == valid.size() ? " or " : ", ") + valid[i];
    return {Trouble::Usage, fmt::format("unknown {} '{}': choose {}", kind, word, choices)};
}

}  // namespace zscope::cli
