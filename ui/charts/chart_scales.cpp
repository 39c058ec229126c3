// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/chart_scales.h"

#include <algorithm>
#include <cmath>

namespace zscope::ui {
namespace {

constexpr double kAir       = 1.12;  // of the range of times, to both sides
constexpr double kLeast     = 1.6;   // of its ends to each other
constexpr double kBandShare = 0.4;   // of the height of the chart
constexpr double kBandGap   = 0.12;  // decades between the band and what is above it
constexpr int    kMostTicks = 7;

/// 1, 2, 5 times powers of ten, or every tenth of a narrow range.
std::vector<double> readableTicks(double low, double high)
{
    std::vector<double> ticks;
    for (int decade = static_cast<int>(std::floor(std::log10(low))); decade <= std::ceil(std::log10(high)); ++decade)
        for (const double digit : {1.0, 2.0, 5.0})
            if (const double tick = digit * std::pow(10, decade); tick >= low && tick <= high) ticks.push_back(tick);
    if (ticks.size() > kMostTicks)
        std::erase_if(ticks,
                      [](double tick) { return std::abs(std::log10(tick) - std::round(std::log10(tick))) > 1e-9; });
    if (ticks.size() >= 3) return ticks;

    const double rough = (high - low) / 5, unit = std::pow(10, std::floor(std::log10(rough)));
    const double step = unit * (rough / unit > 5 ? 10 : rough / unit > 2 ? 5 : 2);
    ticks.clear();
    for (double tick = std::ceil(low / step) * step; tick <= high; tick += step) ticks.push_back(tick);
    return ticks;
}

}  // namespace

TimeScale timeScaleOf(std::span<const double> ms)
{
    TimeScale scale;
    if (!ms.empty()) {
        const auto [least, most] = std::ranges::minmax(ms);
        const double widen       = std::max(1.0, std::sqrt(kLeast * least / most));
        scale.low                = least / widen / kAir;
        scale.high               = most * widen * kAir;
    }
    scale.ticks = readableTicks(scale.low, scale.high);
    return scale;
}

double ErrorScale::placeOf(double error) const
{
    if (error <= 0) return zero;
    if (std::isinf(error)) return infinite;
    return std::max(error, floor);
}

ErrorScale errorScaleOf(std::span<const double> errors, bool whole)
{
    ErrorScale scale;
    double     least = 0, most = 0;
    for (const double error : errors) {
        scale.hasInfinite |= std::isinf(error);
        if (!(error > 0) || std::isinf(error)) continue;
        least = least > 0 ? std::min(least, error) : error;
        most  = std::max(most, error);
    }
    if (!(most > 0)) {  // all are right: something to be right against
        least = whole ? 1 : 1e-6;
        most  = whole ? 100 : 1e-4;
    }
    int low  = static_cast<int>(std::floor(std::log10(least)));
    int high = static_cast<int>(std::ceil(std::log10(most)));
    if (high - low < 2) high = low + 2;
    scale.floor          = std::pow(10, low);
    scale.ceiling        = std::pow(10, high);
    const double decades = high - low + (scale.hasInfinite ? 0.8 : 0.25);
    scale.infinite       = std::pow(10, high + 0.5);
    scale.top            = std::pow(10, low + decades);
    const double band    = decades * kBandShare / (1 - kBandShare);
    scale.bandTop        = std::pow(10, low - kBandGap);
    scale.bottom         = std::pow(10, low - kBandGap - band);
    scale.zero           = std::pow(10, low - kBandGap - band / 2);
    const int every      = 1 + (high - low) / kMostTicks;
    for (int decade = low; decade <= high; decade += every) scale.ticks.push_back(std::pow(10, decade));
    return scale;
}

}  // namespace zscope::ui
