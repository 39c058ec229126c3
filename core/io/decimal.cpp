#include "core/io/decimal.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <system_error>

namespace zscope {

bool roundsToZero(std::string_view decimal)
{
    std::int64_t power = 0;
    bool         point = false, started = false;
    std::size_t  i = 0;
    for (; i < decimal.size() && decimal[i] != 'e' && decimal[i] != 'E'; ++i) {
        if (decimal[i] == '.')
            point = true;
        else if (decimal[i] >= '0' && decimal[i] <= '9') {
            started = started || decimal[i] != '0';
            if (started && !point) ++power;
            if (!started && point) --power;
        }
    }
    if (i + 1 >= decimal.size()) return power < 0;
    std::string_view digits = decimal.substr(i + 1);
    if (digits.front() == '+') digits.remove_prefix(1);
    std::int64_t exponent = 0;
    const auto   read     = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (read.ec == std::errc::result_out_of_range) return digits.front() == '-';
    return power + exponent < 0;
}

}  // namespace zscope
