// SPDX-License-Identifier: GPL-3.0-or-later
// The two scales of the chart of speed against error. No widgets.
//
// Time       logarithmic; a range with some air, and ticks a person can read
// Error      logarithmic over whole decades, and below them a band for zero, which no logarithm reaches: an exact
//            picture stands in its middle. An infinite error stands half a decade above the rest
#pragma once

#include <span>
#include <vector>

namespace zscope::ui {

struct TimeScale {
    double              low = 1, high = 10;  // ms
    std::vector<double> ticks;
};
/// Of the times given, which are above 0.
TimeScale timeScaleOf(std::span<const double> ms);

struct ErrorScale {
    double              bottom = 0, zero = 0, bandTop = 0;  // coordinates of the band on the logarithmic axis
    double              floor = 1, ceiling = 10;            // the decades above it
    double              top         = 10;                   // the end of the axis
    bool                hasInfinite = false;
    double              infinite    = 0;  // where those stand
    std::vector<double> ticks;            // at decades, without zero and infinity

    double placeOf(double error) const;
};
/// `whole`: errors are counts, so that nothing lies between 0 and 1.
ErrorScale errorScaleOf(std::span<const double> errors, bool whole);

}  // namespace zscope::ui
