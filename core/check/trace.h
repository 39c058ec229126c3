// Another program's run held against ours, row by row. A trace is JSON lines: each line one object with fields of the
// state that `zscope-cli step --state` writes (core/lesson/replay.h). A row may hold few of them; what it does not hold
// is not judged.
//
// Moment     the state of our run that a row is held against, by what the row holds:
//                grain and step                 the state after that step
//                pixel (x, y, triangle)         right after this triangle was tested at this pixel
//                query (triangle)               right after the pyramid was asked about this triangle
//                update (level, x, y)           right after this cell was computed anew
//                interval (line, x0)            right after the interval that begins there was decided
//                triangle (id)                  when this triangle is drawn
//                line                           when this line is drawn
//                none of these                  the finished picture
//            Of several rows with one moment, row n is held against its n-th time; if there are fewer, against the last
// Not judged algorithm, count, sentence, event, stage, source: a program may write there what it likes
// Order      active_edges are sorted by x; elsewhere the order of a list means nothing
// Rounding   numbers may differ as a careful renderer's do (core/check/exact_triangle.h): corners that lie up to d
//            elsewhere move x, slopes, depths, and the lines and pixels whose centres lie that close to an edge
// Memory     the file, at most kMaxTraceFile bytes, and some words per row; rows are parsed one at a time
// Cost       two observed runs of the frame, and the state at each row
// Errors     Input, with file and line; Usage: the algorithm cannot be stepped. Limit, Cancelled
// Source     docs/check.md, Traces
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/frame/renderer.h"
#include "core/probe/grain.h"

namespace zscope::check {

inline constexpr std::uint64_t kMaxTraceFile = std::uint64_t{1} << 30;

enum class MomentKind { Step, Pixel, Query, Update, Interval, Triangle, Line, End };
/// What a row says of its moment. a, b, c: grain and step; x, y and triangle; triangle; level, x and y; line and x0;
/// triangle; line; nothing.
struct MomentKey {
    MomentKind   kind = MomentKind::End;
    std::int64_t a = 0, b = 0, c = 0;

    friend auto operator<=>(const MomentKey&, const MomentKey&) = default;
};
/// "On line 41", "After triangle 7", ...
std::string phraseOf(const MomentKey& key);

struct TraceRow {
    int         line  = 0;            // of the file, counted from 1
    std::size_t first = 0, size = 0;  // bytes of the file
    MomentKey   key;
};

struct Trace {
    std::string                file;
    std::string                text;
    std::vector<TraceRow>      rows;       // in the order of the file; empty lines are none
    std::optional<std::string> algorithm;  // that it names
    std::string_view           guess;      // a preset that has the fields of the first row

    std::string_view textOf(const TraceRow& row) const { return std::string_view(text).substr(row.first, row.size); }
};
Result<Trace> readTrace(const std::string& path);
/// The same of its text; `file` is named in errors.
Result<Trace> traceOf(std::string text, const std::string& file);

/// One row beside ours: Replay::at(grain, step) is the state that it was held against.
struct JudgedRow {
    std::optional<Grain> grain;  // nothing: our run has no such moment
    StepIndex            step;
    std::uint64_t        events = 0;          // StepState::events of that state
    std::string          sentence;            // the first difference; empty: there is none
    bool                 isRounding = false;  // something differs by rounding alone

    bool isWrong() const { return !sentence.empty(); }
};

struct TraceAnswer {
    std::string                algorithm;
    std::vector<JudgedRow>     rows;                     // one per row of the trace
    std::uint64_t              wrong = 0, rounding = 0;  // rows; a wrong one is none of the latter
    std::optional<std::size_t> firstWrong;
    FaceCulling                faceCulling = FaceCulling::None;  // of the run that it was held against
    std::string                sentence;                         // in plain English

    bool isRight() const { return wrong == 0; }
};

/// The algorithm that a trace is held against: `named`, or what the trace names, or its guess. Errors: Input, Usage.
Result<Pipeline> traceAlgorithm(const Trace& trace, const std::optional<std::string>& named);
/// Whether a run of the pipeline has moments and tables like those of the first row.
bool hasTablesOf(const Trace& trace, const Pipeline& pipeline);

/// `request` names scene, camera, culling and pipeline. `halfStep`: of the coarser sub-pixel grid (core/check/truth.h).
Result<TraceAnswer> judgeTrace(const Trace& trace, const DrawRequest& request, double halfStep);

}  // namespace zscope::check
