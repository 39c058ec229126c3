// A run along a camera path, frame by frame: what bench() says of one view, benchPath() says of every frame.
//
// Times      the median over the passes along the path; stages are those of that very frame and add up to it
// Counters   of each view by itself, counted in a run of its own: what a second frame of the same view does
// Lag        after a cut: how many frames show a wrong pixel before the first that shows none. A method that takes
//            nothing over from the frame before has none
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/stages.h"

namespace zscope {

struct SeriesFrame {
    double                             ms = 0;
    std::array<double, kStages.size()> stageMs{};
    std::uint64_t                      covered = 0;  // pixels (or samples) where the reference shows a triangle
    std::optional<std::uint64_t>       wrongPixels;  // as BenchRow::wrongPixels; nothing: not checked
    std::string                        chosen;       // `auto`: the preset that drew it on the last pass
    std::vector<std::uint64_t>         counts;       // as Series::counters; empty: not counted

    friend bool operator==(const SeriesFrame&, const SeriesFrame&) = default;
};

/// Of one cut.
struct Lag {
    int                cut = 0;  // its frame
    std::optional<int> frames;   // wrong ones; nothing: none is right before the next cut or the path's end

    friend bool operator==(const Lag&, const Lag&) = default;
};

struct Series {
    std::vector<std::string> counters;  // names
    std::vector<SeriesFrame> frames;
    std::vector<Lag>         lags;  // of every cut; empty where nothing was checked

    friend bool operator==(const Series&, const Series&) = default;
};

/// `cuts` rise, each inside the series. All frames were checked.
std::vector<Lag> lagsOf(std::span<const SeriesFrame> frames, std::span<const int> cuts);

/// The largest share of the covered pixels that is wrong in one frame; 0 where nothing was checked.
double worstShare(const Series& series);

}  // namespace zscope
