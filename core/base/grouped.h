// Large numbers as people read them.
#pragma once

#include <string>

namespace zscope {

/// "12 345 678": digits in groups of three, with a blank or another character between them.
inline std::string grouped(unsigned long long value, char between = ' ')
{
    std::string digits = std::to_string(value);
    for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, between);
    return digits;
}

}  // namespace zscope
