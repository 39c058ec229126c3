// Numbers out of the bytes of a file, in either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace zscope {

enum class ByteOrder { Little, Big };

/// The number that begins at `at`; `bytes` must hold all of it.
template <class T>
T numberAt(std::string_view bytes, std::size_t at, ByteOrder order)
{
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
    if ((order == ByteOrder::Little) != (std::endian::native == std::endian::little)) std::ranges::reverse(raw);
    return std::bit_cast<T>(raw);
}

/// IEEE binary16.
inline double halfOf(std::uint16_t bits)
{
    const int    exponent = bits >> 10 & 31, fraction = bits & 1023;
    const double magnitude = exponent == 31  ? (fraction ? std::nan("") : HUGE_VAL)
                             : exponent == 0 ? std::ldexp(fraction, -24)
                                             : std::ldexp(fraction + 1024, exponent - 25);
    return bits & 0x8000 ? -magnitude : magnitude;
}

}  // namespace zscope
