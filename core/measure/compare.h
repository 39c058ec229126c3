// Algorithms side by side: the same scene from the same camera, each picture against the reference and against the
// first one's, and the time and work behind it. The values of a comparison sheet.
//
// Equal      the same id, depth bits and colour at every pixel; where either of two draws whole faces, the same face at
//            every pixel: their depths and colours are those of faces
// Text       one of the algorithms has no fast text: plain text draws all of them
// Times      of `frames` frames after one that warms up; the stages are those of the median frame and add up to it.
//            A measured choice goes through its trials first
// Counters   from a run of its own
// Cost       the brute-force picture unless it is left out, then frames + 2 frames per algorithm
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/frame/renderer.h"
#include "core/measure/bench.h"
#include "core/measure/error_figures.h"

namespace zscope {

struct CompareRequest {
    std::shared_ptr<const PreparedScene> scene;
    Camera                               camera;
    FaceCulling                          faceCulling = FaceCulling::None;
    std::vector<BenchAlgorithm>          algorithms;        // [0] is what the others are held against
    int                                  threads      = 0;  // 0: one per core
    Simd                                 simd         = Simd::Auto;
    ShortcutSet                          shortcuts    = ShortcutSet::all();
    int                                  frames       = 9;     // timed, at least 1
    bool                                 useReference = true;  // also compare each with the brute-force picture
    std::uint64_t                        memoryLimit  = 0;     // bytes; as DrawRequest
    Progress                             progress     = {};
};

struct ComparedAlgorithm {
    BenchAlgorithm              algorithm;
    Frame                       frame;   // shaded
    FrameReport                 report;  // of the median frame
    double                      bestMs = 0, q1Ms = 0, q3Ms = 0;
    std::vector<NamedCount>     counters;
    std::optional<ErrorFigures> againstReference;  // by face where whole faces are drawn
    // the first picture is the reference; by face where either draws whole faces
    ErrorFigures  againstFirst;
    std::uint64_t coloursDiffer  = 0;  // from the first's, pixels; 0 where either draws whole faces
    bool          isEqualToFirst = true;
};

struct Comparison {
    std::vector<ComparedAlgorithm> algorithms;  // in the order asked for

    bool areAllEqual() const;
};

/// Errors: Usage (no algorithm, or what the renderer refuses), Limit, Cancelled.
Result<Comparison> compareAlgorithms(const CompareRequest& request);

/// What a pixel of a difference picture says. Two pictures of the same size.
enum class DrawnDifference { None, OnlyFirst, OnlySecond, OtherSurface, Depth, Colour };
struct DifferenceEntry {
    DrawnDifference  difference;
    std::string_view title;
    std::uint32_t    colour;  // 0xAARRGGBB
};
std::span<const DifferenceEntry> differences();  // all but None, which is the first picture, faded
/// `byFace`: ids, already those of faces or not, are compared as faces of `scene`, and depths and colours are not.
Grid<std::uint32_t> paintDifference(const Frame& first, const Frame& second, const Scene& scene, bool byFace);

}  // namespace zscope
