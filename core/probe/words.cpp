#include "core/probe/words.h"

#include <bit>

#include "core/base/grouped.h"

namespace zscope {

std::string withCommas(std::uint64_t value) { return grouped(value, ','); }

std::string counted(std::uint64_t value, std::string_view one, std::string_view many)
{
    return withCommas(value) + ' ' + std::string(value == 1 ? one : many);
}

std::uint64_t float32StepsBetween(float a, float b)
{
    // Bits of negative floats run the other way.
    const auto place = [](float value) {
        const auto bits = std::bit_cast<std::int32_t>(value);
        return bits < 0 ? -(std::int64_t{bits} & 0x7FFFFFFF) : std::int64_t{bits};
    };
    const std::int64_t apart = place(a) - place(b);
    return static_cast<std::uint64_t>(apart < 0 ? -apart : apart);
}

std::string countedSteps(float a, float b)
{
    return counted(float32StepsBetween(a, b), "float32 step", "float32 steps");
}

std::string capital(std::string text)
{
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

}  // namespace zscope
