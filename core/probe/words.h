// Numbers and beginnings as sentences write them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace zscope {

/// 1234567 as "1,234,567".
std::string grouped(std::uint64_t value);
/// "1 edge", "1,234 edges".
std::string counted(std::uint64_t value, std::string_view one, std::string_view many);
/// With a capital at its beginning.
std::string capital(std::string text);

}  // namespace zscope
