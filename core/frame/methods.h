// The plain methods, one row each: what the choice on the axis "scan" is called, what can be asked of it, and which
// function draws by it. Everything else reads this table and knows no method by name.
//
// Growing    a method that stands alone is a file in core/method and a row here. The row makes its preset, its steps
//            and its words: nothing else in core knows of it. It has no fast text, and says why
// Fast text  a method with one has an enumerator in enum Scan (same order) and a case in drivers-inl.h; its presets are
//            in presets.h, because it can be composed with other choices
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/frame/pipeline.h"
#include "core/method/painter.h"
#include "core/method/ray_casting.h"
#include "core/method/warnock.h"
#include "core/plain/parts.h"
#include "core/plain/work.h"

namespace zscope {

/// Why these stages run, one clause each.
struct StageClauses {
    std::string_view clear, setUp, raster;
};

struct MethodEntry {
    ChoiceEntry      choice;                   // of a method that stands alone also its preset's name and title
    std::string_view family;                   // see familyOf()
    bool             drawsLineByLine = false;  // with an edge table
    bool             drawsFaces      = false;  // whole faces as they were read
    bool             stepsAlongLines = false;  // edges and depths move from pixel to pixel by a constant
    // of its own structures, coarse to fine; those of a frame, a tree and a pyramid come on top
    std::span<const Grain> grains = {};
    /// What of the other axes does not fit the method, in one sentence.
    std::optional<std::string> (*explainMisfit)(const Pipeline&) = nullptr;
    /// The opaque picture of the stripe.
    void (*draw)(const Pipeline&, plain::Work&) = nullptr;
    StageClauses stages                         = {};
    Claim        claim                          = Claim::Exact;  // by exact rules

    // Of a method that stands alone.
    void (*whole)(plain::Work&, const plain::Parts&) = nullptr;  // its main function
    Order            order                           = Order::Submitted;
    std::string_view whyNoFastText                   = {};  // a clause, as in whyPlain()
};

std::optional<std::string> misfitOfTriangles(const Pipeline& pipeline);  // core/frame/pipeline.cpp
std::optional<std::string> misfitOfSweep(const Pipeline& pipeline);
std::optional<std::string> misfitOfWhole(const Pipeline& pipeline);

void drawTriangles(const Pipeline& pipeline, plain::Work& work);  // core/frame/plain_stripe.cpp
void drawLinesByDepth(const Pipeline& pipeline, plain::Work& work);
void drawLinesByIntervals(const Pipeline& pipeline, plain::Work& work);
void drawFacesByIntervals(const Pipeline& pipeline, plain::Work& work);
void drawByWhole(const Pipeline& pipeline, plain::Work& work);

namespace grains {
inline constexpr std::array kTriangles{Grain::Triangle, Grain::Pixel};
inline constexpr std::array kEdgeWalk{Grain::Triangle, Grain::Span, Grain::Pixel};
inline constexpr std::array kLines{Grain::Line, Grain::Span, Grain::Pixel};
inline constexpr std::array kIntervals{Grain::Line, Grain::Interval, Grain::Span, Grain::Pixel};
inline constexpr std::array kQuestions{Grain::Query, Grain::Pixel};
}  // namespace grains

namespace stages {
inline constexpr std::string_view kCleared = "a z-buffer starts from background",
                                  kByLine  = "buffers sized; each line is cleared when the sweep reaches it",
                                  kSwept   = "the sweep, line by line";
inline constexpr StageClauses kStream{kCleared, "triangles of every batch", "the pixels of every triangle"};
inline constexpr StageClauses kSweep{kByLine, "triangles and the edge table", kSwept};
inline constexpr StageClauses kFaces{kByLine, "faces and the edge table", kSwept};
}  // namespace stages

// clang-format off
inline constexpr std::array kMethods{
    MethodEntry{{"half-space", "Three edge functions over tiles"},
                "stream", false, false, false, grains::kTriangles, misfitOfTriangles, drawTriangles, stages::kStream},
    MethodEntry{{"edge-walk", "Left and right edge of each triangle, line by line"},
                "stream", false, false, true, grains::kEdgeWalk, misfitOfTriangles, drawTriangles, stages::kStream},
    MethodEntry{{"sweep-z-line", "The scene line by line, with a one-line z-buffer"},
                "sweep", true, false, true, grains::kLines, misfitOfSweep, drawLinesByDepth, stages::kSweep},
    MethodEntry{{"sweep-intervals", "The scene line by line, interval by interval"},
                "sweep", true, false, true, grains::kIntervals, misfitOfSweep, drawLinesByIntervals, stages::kSweep},
    MethodEntry{{"sweep-polygons", "The same with whole faces as they were read, not their triangles"},
                "sweep", true, true, true, grains::kIntervals, misfitOfSweep, drawFacesByIntervals, stages::kFaces,
                Claim::ExactByFace},
    MethodEntry{{"ray-casting", "Ray casting: one ray through every pixel's centre, "
                                "through a bounding volume hierarchy"},
                "rays", false, false, false, grains::kQuestions, misfitOfWhole, drawByWhole,
                {stages::kCleared, "the triangles of every node in view", "one ray for every pixel"},
                Claim::Exact, plain::castRays, Order::Bvh,
                "ray casting is here to prove the picture by another way, and runs the plain text"},
    MethodEntry{{"painter", "Painter's algorithm: triangles sorted by depth and painted over each other, "
                            "farthest first"},
                "stream", false, false, false, grains::kTriangles, misfitOfWhole, drawByWhole,
                {"the picture starts from background", "all triangles, before the first is painted",
                 "the triangles, from the farthest to the nearest"},
                Claim::Approximate, plain::paint, Order::Submitted,
                "the painter's algorithm is here to show what a depth test is for, and runs the plain text"},
    MethodEntry{{"warnock", "Area subdivision: a window is divided in four until one triangle or none decides it"},
                "areas", false, false, false, grains::kQuestions, misfitOfWhole, drawByWhole,
                {"the picture starts from background", "all triangles, before the first window",
                 "windows, divided until they are simple"},
                Claim::Exact, plain::subdivide, Order::Submitted,
                "area subdivision is here to prove the picture by another way, and runs the plain text"},
};
// clang-format on

/// The rows with a fast text come first, as enum Scan has them; each other row says why it has none.
static_assert([] {
    constexpr auto kLastNamed = static_cast<std::size_t>(Scan::SweepPolygons);
    for (std::size_t i = 0; i < kMethods.size(); ++i)
        if ((i <= kLastNamed) != !kMethods[i].whole || (i <= kLastNamed) != kMethods[i].whyNoFastText.empty())
            return false;
    return kMethods[kLastNamed].choice.word == "sweep-polygons";
}());

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
