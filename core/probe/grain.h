// How coarse a step is. An event belongs to one grain; a run stepped at a grain stops at the events of that
// grain and of all coarser ones.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace zscope {

enum class Grain { Frame, Stage, Node, Triangle, Line, Span, Pixel };  // coarse to fine

inline constexpr std::array kGrains{Grain::Frame, Grain::Stage, Grain::Node, Grain::Triangle,
                                    Grain::Line,  Grain::Span,  Grain::Pixel};

constexpr std::string_view wordOf(Grain grain)
{
    constexpr std::array<std::string_view, kGrains.size()> words{"frame", "stage", "node", "triangle",
                                                                 "line",  "span",  "pixel"};
    return words[static_cast<std::size_t>(grain)];
}

constexpr std::optional<Grain> grainOf(std::string_view word)
{
    for (Grain grain : kGrains)
        if (wordOf(grain) == word) return grain;
    return std::nullopt;
}

}  // namespace zscope
