// Numbers and beginnings as sentences write them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace zscope {

/// 1234567 as "1,234,567".
std::string withCommas(std::uint64_t value);
/// "1 edge", "1,234 edges".
std::string counted(std::uint64_t value, std::string_view one, std::string_view many);
/// Values of float32 between two depths of any sign; 0 if they are equal.
std::uint64_t float32StepsBetween(float a, float b);
/// "1 float32 step", "12 float32 steps".
std::string countedSteps(float a, float b);
/// With a capital at its beginning.
std::string capital(std::string text);

}  // namespace zscope
