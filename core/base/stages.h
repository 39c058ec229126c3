// The stages of a frame, in the words that every report uses, and the counters beside them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace zscope {

enum class Stage { Clear, Transform, Cull, Setup, Prepass, Build, Raster, Upkeep, Shade, Other };

inline constexpr std::array kStages{Stage::Clear, Stage::Transform, Stage::Cull,   Stage::Setup, Stage::Prepass,
                                    Stage::Build, Stage::Raster,    Stage::Upkeep, Stage::Shade, Stage::Other};

constexpr std::string_view wordOf(Stage stage)
{
    constexpr std::array<std::string_view, kStages.size()> words{"clear", "transform", "cull",   "setup", "prepass",
                                                                 "build", "raster",    "upkeep", "shade", "other"};
    return words[static_cast<std::size_t>(stage)];
}

struct StageTime {
    Stage       stage = Stage::Other;
    double      ms    = 0;  // wall time; with several threads the mean of theirs
    bool        ran   = false;
    std::string why;  // one clause: why it ran, or why this frame did not need it
};

/// A counter or a size in bytes with the name that stats.json uses.
struct NamedCount {
    std::string   name;
    std::uint64_t value = 0;
};

}  // namespace zscope
