// How coarse a step is. An event belongs to one grain; a run stepped at a grain stops at the events of that
// grain and of all coarser ones.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace zscope {

enum class Grain { Frame, Stage, Node, Triangle, Query, Line, Interval, Span, Update, Pixel };  // coarse to fine

inline constexpr std::array kGrains{Grain::Frame, Grain::Stage,    Grain::Node, Grain::Triangle, Grain::Query,
                                    Grain::Line,  Grain::Interval, Grain::Span, Grain::Update,   Grain::Pixel};

constexpr std::string_view wordOf(Grain grain)
{
    constexpr std::array<std::string_view, kGrains.size()> words{"frame", "stage",    "node", "triangle", "query",
                                                                 "line",  "interval", "span", "update",   "pixel"};
    return words[static_cast<std::size_t>(grain)];
}

constexpr std::optional<Grain> grainOf(std::string_view word)
{
    for (Grain grain : kGrains)
        if (wordOf(grain) == word) return grain;
    return std::nullopt;
}

}  // namespace zscope
