// The calm colours of the generated scenes, linear.
//
// Source     Okabe, Ito: Color Universal Design, 2008; softened towards grey and made linear
#pragma once

#include <array>
#include <cstdint>

#include "core/scene/mesh.h"

namespace zscope::palette {

inline constexpr Rgb kSky{0.28f, 0.54f, 0.80f};
inline constexpr Rgb kBlue{0.07f, 0.24f, 0.50f};
inline constexpr Rgb kGreen{0.09f, 0.42f, 0.29f};
inline constexpr Rgb kAmber{0.80f, 0.44f, 0.09f};
inline constexpr Rgb kYellow{0.82f, 0.72f, 0.26f};
inline constexpr Rgb kVermilion{0.65f, 0.19f, 0.08f};
inline constexpr Rgb kRose{0.58f, 0.28f, 0.44f};
inline constexpr Rgb kWhite{0.82f, 0.82f, 0.80f};
inline constexpr Rgb kGrey{0.40f, 0.42f, 0.45f};
inline constexpr Rgb kInk{0.05f, 0.055f, 0.065f};

/// Those that tell things apart, in an order whose neighbours differ.
inline constexpr std::array kDistinct{kSky, kAmber, kGreen, kRose, kYellow, kBlue, kVermilion};

/// The n-th of a series of colours: the distinct ones, then lighter and darker shades of them.
inline Rgb colourOf(std::uint64_t n)
{
    const Rgb   base  = kDistinct[n % kDistinct.size()];
    const auto  round = static_cast<float>((n / kDistinct.size()) % 5);
    const float light = round * 0.14f;  // 0 .. 0.56 of the way to white
    return {base.r + (0.86f - base.r) * light, base.g + (0.86f - base.g) * light, base.b + (0.86f - base.b) * light};
}

/// A colour that is the number itself, for n below 2^21: its binary digits dealt to red, green and blue in turn, the
/// lowest digit counting most, so that neighbours differ much and no two numbers share a colour even in 8 bits a
/// channel.
inline Rgb colourOfNumber(std::uint64_t n)
{
    std::array<std::uint32_t, 3> channel{};
    for (unsigned digit = 0; digit < 21; ++digit)
        channel[digit % 3] |= static_cast<std::uint32_t>(n >> digit & 1) << (6 - digit / 3);
    const auto level = [](std::uint32_t of127) { return 0.22f + 0.62f * static_cast<float>(of127) / 127.0f; };
    return {level(channel[0]), level(channel[1]), level(channel[2])};
}

}  // namespace zscope::palette
