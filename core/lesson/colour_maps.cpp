#include "core/lesson/colour_maps.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace zscope {
namespace {

using Rgb8 = std::array<int, 3>;

/// Evenly spaced stops, straight lines between them.
template <std::size_t N>
std::uint32_t between(const std::array<Rgb8, N>& stops, double part)
{
    // not a number: the first
    const double  at     = (part >= 0 ? std::min(part, 1.0) : 0.0) * static_cast<double>(N - 1);
    const auto    lower  = std::min(static_cast<std::size_t>(at), N - 2);
    const double  rest   = at - static_cast<double>(lower);
    std::uint32_t colour = 0xFF;
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = stops[lower][i] + (stops[lower + 1][i] - stops[lower][i]) * rest;
        colour             = colour << 8 | static_cast<std::uint32_t>(value + 0.5);  // never negative
    }
    return colour;
}

constexpr std::array<Rgb8, 10> kCividis{{{0, 34, 78},
                                         {18, 53, 112},
                                         {59, 73, 108},
                                         {87, 93, 109},
                                         {112, 113, 115},
                                         {138, 134, 120},
                                         {165, 156, 116},
                                         {195, 179, 105},
                                         {225, 204, 85},
                                         {254, 232, 56}}};
constexpr std::array<Rgb8, 5>  kDiverging{
    {{0, 72, 130}, {118, 170, 210}, {255, 255, 255}, {240, 164, 112}, {176, 64, 0}}};
constexpr std::array<Rgb8, 5> kHeat{{{250, 250, 250}, {253, 216, 150}, {245, 150, 60}, {200, 70, 20}, {90, 12, 8}}};

}  // namespace

std::uint32_t cividis(double part) { return between(kCividis, part); }
std::uint32_t diverging(double part) { return between(kDiverging, (part + 1) / 2); }
std::uint32_t heat(double part) { return between(kHeat, part); }

}  // namespace zscope
