// Times algorithms on a scene: verified first, then timed without an observer, then explained by counters.
//
// Runs       every algorithm with every thread count and vector target, shaded, or ids and depth alone, or both; each
//            has warm-up frames, then `frames` timed ones, or as many as `leastMs` wants; one that chooses by trials
//            has them behind it before. Counters come from a separate run and never slow a timed one
// Verified   the first picture of every run, and the last timed one, which stands on what all before it have left. Of
//            methods that draw faces the first of each algorithm is judged against the reference, which takes long, and
//            the others against that first one. A picture that differs gets all its error figures; one that does not
//            has zeros for the cost of the comparison alone
// Rounds     more than one: the timed frames of every run are parted into so many turns, each run after the other in
//            every turn, so that what disturbs the machine disturbs all of them alike and their times may be divided
//            turn by turn; every other turn goes back through them, so that nobody always draws after the same one. All
//            runs keep their memory until the last turn; the limit of memory is each run's own
// Quantiles  nearest rank, so every figure is a time that was measured; the stage times are those of the median
//            frame and add up to it. The quartiles of a stage are its own, over all timed frames, and need not add up
// Threads    one render thread, OpenMP inside; nothing else should run meanwhile
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/stages.h"
#include "core/frame/renderer.h"
#include "core/measure/error_figures.h"
#include "core/measure/series.h"
#include "core/measure/suites.h"
#include "core/scene/load.h"
#include "core/scene/scene.h"

namespace zscope {

struct BenchAlgorithm {
    std::string                name;
    Pipeline                   pipeline;
    Claim                      claim     = Claim::Exact;
    std::optional<ShortcutSet> shortcuts = {};  // in place of the request's
};

/// The algorithm once for each rung of the ladder of shortcuts: none; each that it can have added alone, with what that
/// needs; each left out, with what needs it; all.
std::vector<BenchAlgorithm> ladderOf(const BenchAlgorithm& algorithm);

struct BenchRow;

struct BenchRequest {
    std::shared_ptr<const Scene> scene;
    Camera                       camera;
    FaceCulling                  faceCulling = FaceCulling::None;
    std::vector<BenchAlgorithm>  algorithms;
    std::vector<int>             threads   = {0};  // 0: one per core
    std::vector<Simd>            simd      = {Simd::Auto};
    ShortcutSet                  shortcuts = ShortcutSet::all();
    int                          warmUp    = 3;   // frames before the timed ones
    int                          frames    = 30;  // timed, at least 1
    // that the timed frames of a run take together: more frames, if need be
    double                       leastMs     = 0;
    int                          rounds      = 1;  // 1 to frames; each has its part of both
    BenchPictures                pictures    = BenchPictures::Shaded;
    bool                         verify      = true;  // against the brute-force reference
    std::optional<std::uint64_t> samples     = {};    // random pixels that are verified instead of all
    bool                         count       = true;  // the work behind the times
    std::uint64_t                memoryLimit = 0;     // bytes; as DrawRequest
    LoadTimes                    load        = {};    // of the scene, for the rows
    Progress                     progress    = {};
    /// Told of every row as soon as it is finished, from the calling thread; what was told stays true if the rest
    /// fails.
    std::function<void(const BenchRow&)> finished = {};
};

/// exact, exact-by-face, approximate.
std::string_view wordOf(Claim claim);

/// Of one stage over the timed frames, in ms.
struct StageQuartiles {
    double q1 = 0, median = 0, q3 = 0;
};

struct BenchRow {
    std::string scene;
    std::string algorithm;
    Claim       claim = Claim::Exact;
    std::string chosen;         // `auto`: by which preset the last timed frame was drawn
    int         threads   = 1;  // as used
    Simd        simd      = Simd::Scalar;
    ShortcutSet shortcuts = ShortcutSet::all();
    bool        shaded    = true;  // false: ids and depth only

    /// Pixels whose id or depth bits differ from the reference, or, of a method that is exact by face, its holes and
    /// spills; nothing: no reference was asked for.
    std::optional<std::uint64_t> wrongPixels;
    /// All figures of the same picture, by face for a method that draws faces; there whenever wrongPixels is.
    std::optional<ErrorFigures> figures;
    std::uint64_t               samples = 0;  // pixels that were verified, of each frame; 0: all

    double        bestMs = 0, medianMs = 0, q1Ms = 0, q3Ms = 0;  // of a frame
    std::uint64_t frames    = 0;                                 // that were timed
    std::uint64_t triangles = 0;                                 // of the scene, instances included
    std::uint64_t pixels    = 0;                                 // of the picture
    double        buildMs   = 0;                                 // making the scene ready for drawing, once
    LoadTimes     load      = {};                                // of the scene, as the request says
    std::uint64_t bytes     = 0;                                 // of all structures of the frame

    std::array<double, kStages.size()>         stageMs{};         // of the median frame
    std::array<StageQuartiles, kStages.size()> stageQuartiles{};  // of each stage by itself
    std::vector<NamedCount>                    tallies;           // of the median frame: what it did, in its own units
    std::vector<NamedCount>                    counters;          // the textbook method's work, of a run of its own
    std::vector<double>                        roundMs;           // the median frame of each round
    std::optional<Series>                      series;            // along a camera path: frame by frame

    /// It promised the reference's picture and drew another: its time is no result.
    bool isBroken() const { return claim != Claim::Approximate && wrongPixels.value_or(0) != 0; }
};

/// How many times as long as another run a run takes: the median over the rounds, and an interval that holds the true
/// one in 19 of 20 cases, as far as so few rounds allow it.
struct PairedRatio {
    double median = 1, low = 1, high = 1;
};
/// Two runs of as many rounds, at least one, timed in turn; no baseline time is 0. Source: the sign test's interval.
PairedRatio pairedRatio(std::span<const double> roundMs, std::span<const double> baselineRoundMs);

/// Position in `count` sorted values of their quantile p in (0, 1]: nearest rank.
std::size_t quantileRank(std::size_t count, double p);

/// Why times of these algorithms may not stand side by side, in one sentence: plain text draws some of them, fast text
/// the others.
std::optional<std::string> whyNotOnEqualTerms(std::span<const BenchAlgorithm> algorithms, ShortcutSet shortcuts);

/// Errors: Usage (not on equal terms), what the renderer refuses, Limit, Cancelled.
Result<std::vector<BenchRow>> bench(const BenchRequest& request);

/// A header and one line per row, the columns as the command line promises them; one more, `shaded`, if a row is not.
std::string benchToCsv(std::span<const BenchRow> rows);
std::string benchToJson(std::span<const BenchRow> rows);
/// The rows that benchToJson() wrote. Error: Input, without a file: these are no such rows.
Result<std::vector<BenchRow>> benchFromJson(const std::string& json);

}  // namespace zscope
