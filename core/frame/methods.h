// The plain methods, one line each: what the choice on the axis "scan" is called, what can be asked of it, and which
// function draws by it. Everything else reads this table and knows no method by name.
//
// Growing    a method is a file in core/method and a line here, with its enumerator in enum Scan (same order)
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/frame/pipeline.h"
#include "core/plain/work.h"

namespace zscope {

struct MethodEntry {
    ChoiceEntry      choice;
    std::string_view family;           // see familyOf()
    bool             drawsLineByLine;  // with an edge table, else triangle after triangle
    bool             drawsFaces;       // whole faces as they were read
    bool             stepsAlongLines;  // edges and depths move from pixel to pixel by a constant
    // of its own structures, coarse to fine; those of a frame, a tree and a pyramid come on top
    std::span<const Grain> grains;
    /// What of the other axes does not fit the method, in one sentence.
    std::optional<std::string> (*explainMisfit)(const Pipeline&);
    /// The opaque picture of the stripe.
    void (*draw)(const Pipeline&, plain::Work&);
};

std::optional<std::string> misfitOfTriangles(const Pipeline& pipeline);  // core/frame/pipeline.cpp
std::optional<std::string> misfitOfSweep(const Pipeline& pipeline);

void drawTriangles(const Pipeline& pipeline, plain::Work& work);  // core/frame/plain_stripe.cpp
void drawLinesByDepth(const Pipeline& pipeline, plain::Work& work);
void drawLinesByIntervals(const Pipeline& pipeline, plain::Work& work);
void drawFacesByIntervals(const Pipeline& pipeline, plain::Work& work);

namespace grains {
inline constexpr std::array kHalfSpace{Grain::Triangle, Grain::Pixel};
inline constexpr std::array kEdgeWalk{Grain::Triangle, Grain::Span, Grain::Pixel};
inline constexpr std::array kLines{Grain::Line, Grain::Span, Grain::Pixel};
inline constexpr std::array kIntervals{Grain::Line, Grain::Interval, Grain::Span, Grain::Pixel};
}  // namespace grains

// clang-format off
inline constexpr std::array kMethods{
    MethodEntry{{"half-space", "Three edge functions over tiles"},
                "stream", false, false, false, grains::kHalfSpace, misfitOfTriangles, drawTriangles},
    MethodEntry{{"edge-walk", "Left and right edge of each triangle, line by line"},
                "stream", false, false, true, grains::kEdgeWalk, misfitOfTriangles, drawTriangles},
    MethodEntry{{"sweep-z-line", "The scene line by line, with a one-line z-buffer"},
                "sweep", true, false, true, grains::kLines, misfitOfSweep, drawLinesByDepth},
    MethodEntry{{"sweep-intervals", "The scene line by line, interval by interval"},
                "sweep", true, false, true, grains::kIntervals, misfitOfSweep, drawLinesByIntervals},
    MethodEntry{{"sweep-polygons", "The same with whole faces as they were read, not their triangles"},
                "sweep", true, true, true, grains::kIntervals, misfitOfSweep, drawFacesByIntervals},
};
// clang-format on

inline constexpr std::array kScanChoices = [] {
    std::array<ChoiceEntry, kMethods.size()> choices;
    for (std::size_t i = 0; i < choices.size(); ++i) choices[i] = kMethods[i].choice;
    return choices;
}();

constexpr const MethodEntry& methodOf(const Pipeline& pipeline)
{
    return kMethods[static_cast<std::size_t>(pipeline.scan)];
}

}  // namespace zscope
