// Named values of an event, as JSON and the window show them: numbers, words, rectangles, groups of values.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace zscope {

struct NamedValue;
using Values = std::vector<NamedValue>;
using Value  = std::variant<bool, std::int64_t, double, std::string, std::vector<int>, Values>;

struct NamedValue {
    std::string_view name;  // outlives every run, as a literal does
    Value            value;
};

}  // namespace zscope
