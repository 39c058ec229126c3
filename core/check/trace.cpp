#include "core/check/trace.h"

#include <algorithm>
#include <map>
#include <new>

#include <fmt/format.h>

#include "core/base/grouped.h"
#include "core/check/trace_compare.h"
#include "core/frame/frame_plan.h"
#include "core/frame/observed_run.h"
#include "core/lesson/checkpoints.h"
#include "core/lesson/run_state.h"
#include "core/method/intervals.h"

namespace zscope::check {
namespace {

/// The moment that an event ends, as rows name it.
std::optional<MomentKey> keyOf(const Heard& heard)
{
    if (const auto* e = heard.as<PixelTested>()) return MomentKey{MomentKind::Pixel, e->x, e->y, e->triangle.value};
    if (const auto* e = heard.as<PyramidAsked>())
        return e->node ? std::nullopt : std::optional(MomentKey{MomentKind::Query, e->triangle.value});
    if (const auto* e = heard.as<CellUpdated>())
        return MomentKey{MomentKind::Update, e->write.level, e->write.x, e->write.y};
    if (const auto* e = heard.as<plain::IntervalDecided>()) return MomentKey{MomentKind::Interval, e->y, e->x0};
    if (const auto* e = heard.as<TriangleFinished>()) return MomentKey{MomentKind::Triangle, e->triangle.value};
    if (const auto* e = heard.as<plain::LineFinished>()) return MomentKey{MomentKind::Line, e->y};
    return std::nullopt;
}

/// A step of our run.
struct RunStep {
    Grain         grain;
    std::uint64_t step;
};

/// First run: the steps at which the moments of the rows come.
class MomentFinder {
public:
    explicit MomentFinder(const Trace& trace)
    {
        for (const TraceRow& row : trace.rows) ++m_wanted[row.key].rows;
    }

    void hear(const Heard& heard)
    {
        m_steps.hear(heard);
        if (!heard.kind.grain) return;
        const auto key = keyOf(heard);
        if (!key) return;
        const auto wanted = m_wanted.find(*key);
        if (wanted == m_wanted.end() || wanted->second.steps.size() >= wanted->second.rows) return;
        wanted->second.grain = *heard.kind.grain;
        wanted->second.steps.push_back(m_steps.seen(*heard.kind.grain) - 1);
    }

    /// One per row; nothing: there is no such moment. The run is over.
    std::vector<std::optional<RunStep>> stepsOf(const Trace& trace, const std::vector<Grain>& grains)
    {
        std::vector<std::optional<RunStep>> steps;
        for (const TraceRow& row : trace.rows) {
            if (row.key.kind == MomentKind::Step || row.key.kind == MomentKind::End) {
                const bool  isStep = row.key.kind == MomentKind::Step;
                const Grain grain  = isStep ? static_cast<Grain>(row.key.a) : Grain::Frame;
                const auto  count  = m_steps.seen(grain);
                const auto  step   = isStep ? static_cast<std::uint64_t>(row.key.b) : count - 1;
                const bool  has    = std::ranges::find(grains, grain) != grains.end() && step < count;
                steps.push_back(has ? std::optional(RunStep{grain, step}) : std::nullopt);
                continue;
            }
            Wanted& wanted = m_wanted.at(row.key);
            if (wanted.steps.empty()) {
                steps.emplace_back();
                continue;
            }
            steps.push_back(RunStep{wanted.grain, wanted.steps[std::min(wanted.used, wanted.steps.size() - 1)]});
            ++wanted.used;
        }
        return steps;
    }

private:
    struct Wanted {
        std::size_t                rows  = 0;
        Grain                      grain = Grain::Frame;
        std::vector<std::uint64_t> steps;
        std::size_t                used = 0;
    };
    StepCounter                 m_steps;
    std::map<MomentKey, Wanted> m_wanted;
};

/// Keeps the edge table of a sweep.
class TableKeeper {
public:
    using Events = Wants<plain::EdgeTableReady>;

    void                    observe(const plain::EdgeTableReady& e) { m_table = &e.table; }
    const plain::EdgeTable* table() const { return m_table; }

private:
    const plain::EdgeTable* m_table = nullptr;
};

/// Why a row that our run has no moment for may be there by rounding alone.
bool mayBeElsewhere(const MomentKey& key, const JsonValue::Object& row, const PolygonLimits& limits)
{
    if (key.kind == MomentKind::Pixel)
        return limits.isInside(key.a, key.b)
               && limits.placeOf(key.c, static_cast<int>(key.a), static_cast<int>(key.b)).isNearEdge();
    if (key.kind == MomentKind::Triangle) return limits.pixelsNearEdges(key.a) > 0;
    if (key.kind != MomentKind::Interval || !limits.isInside(key.b, key.a)) return false;
    const JsonValue* interval = memberOf(row, "interval");
    const JsonValue* open     = memberOf(*interval->object(), "open");
    if (!open || !open->array()) return false;
    const int x = static_cast<int>(key.b), y = static_cast<int>(key.a);
    return std::ranges::any_of(*open->array(), [&](const JsonValue& polygon) {
        const auto id = wholeIn(polygon);
        return id && (limits.placeOf(*id, x, y).isNearEdge() || limits.placeOf(*id, x - 1, y).isNearEdge());
    });
}

std::string noMoment(const MomentKey& key)
{
    switch (key.kind) {
        case MomentKind::Step:
            return fmt::format("Our run has no step {} of grain {}.", key.b, wordOf(static_cast<Grain>(key.a)));
        case MomentKind::Pixel:
            return fmt::format("Our run never tests triangle {} at pixel ({}, {}).", key.c, key.a, key.b);
        case MomentKind::Query:
            return fmt::format("Our run never asks the pyramid about triangle {}.", key.a);
        case MomentKind::Update:
            return fmt::format("Our run never updates cell ({}, {}) of level {}.", key.b, key.c, key.a);
        case MomentKind::Interval:
            return fmt::format("Our run has no interval on line {} that begins at pixel {}.", key.a, key.b);
        case MomentKind::Triangle:
            return fmt::format("Our run never draws triangle {}.", key.a);
        case MomentKind::Line:
            return fmt::format("Our run never draws line {}.", key.a);
        case MomentKind::End:
            break;
    }
    return "Our run never ends.";
}

/// What a row speaks of, where it names a step of ours.
MomentKey spokenKey(const TraceRow& row, const JsonValue::Object& fields)
{
    if (row.key.kind != MomentKind::Step) return row.key;
    const auto numberIn = [](const JsonValue::Object& in, std::string_view name) {
        const JsonValue* value = memberOf(in, name);
        return value ? wholeIn(*value) : std::nullopt;
    };
    const auto grain = static_cast<Grain>(row.key.a);
    if (const auto line = numberIn(fields, "line"); line && grain == Grain::Line) return {MomentKind::Line, *line};
    if (const JsonValue* triangle = memberOf(fields, "triangle"); triangle && grain == Grain::Triangle)
        if (const auto id = numberIn(*triangle->object(), "id")) return {MomentKind::Triangle, *id};
    if (const JsonValue* pixel = memberOf(fields, "pixel")) {
        const auto x = numberIn(*pixel->object(), "x"), y = numberIn(*pixel->object(), "y"),
                   triangle = numberIn(*pixel->object(), "triangle");
        if (x && y && triangle) return {MomentKind::Pixel, *x, *y, *triangle};
    }
    return row.key;
}

/// Second run: each row against the state at its step.
class RowJudge final : public Observer {
public:
    RowJudge(const Trace& trace, const DrawRequest& request, double halfStep,
             const std::vector<std::optional<RunStep>>& steps, std::vector<JudgedRow>& rows)
        : m_trace(trace), m_request(request), m_limits(request, halfStep), m_rows(rows),
          m_recorders(request.camera.width, request.camera.height)
    {
        for (std::size_t i = 0; i < steps.size(); ++i)
            if (steps[i]) {
                m_wanted[static_cast<std::size_t>(steps[i]->grain)].emplace_back(steps[i]->step, i);
                m_rows[i].grain = steps[i]->grain;
                m_rows[i].step  = StepIndex{steps[i]->step};
            }
        for (auto& wanted : m_wanted) std::ranges::sort(wanted);
    }

    /// Rows without a moment. Errors: none that traceOf() has not found.
    void judgeOthers()
    {
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            if (m_rows[i].grain) continue;
            const JsonValue row = parsed(i);
            if (mayBeElsewhere(m_trace.rows[i].key, *row.object(), m_limits))
                m_rows[i].isRounding = true;
            else
                m_rows[i].sentence = noMoment(m_trace.rows[i].key);
        }
    }

    void hear(const Heard& heard) override
    {
        m_recorders.hear(heard);
        passOn(heard, m_table);
        if (!heard.kind.grain) return;
        for (auto grain = static_cast<std::size_t>(*heard.kind.grain); grain < m_wanted.size(); ++grain) {
            const Wanted& wanted = m_wanted[grain];
            std::size_t&  next   = m_next[grain];
            if (next == wanted.size()) continue;
            const std::uint64_t step = m_recorders.steps.seen(static_cast<Grain>(grain)) - 1;
            for (; next < wanted.size() && wanted[next].first == step; ++next) judge(wanted[next].second, heard);
        }
    }

    Frame          frame;
    plain::Scratch scratch;

private:
    JsonValue parsed(std::size_t row) const
    {
        auto value = parseJson(m_trace.textOf(m_trace.rows[row]), m_trace.file);
        assert(value);
        return *std::move(value);
    }

    void judge(std::size_t row, const Heard& heard)
    {
        const JsonValue          theirs     = parsed(row);
        const JsonValue::Object& fields     = *theirs.object();
        const bool               needsCells = memberOf(fields, "pyramid") != nullptr;
        StepState state = stateOf(m_recorders, &heard.kind, m_request, needsCells ? &scratch.pyramid : nullptr);
        if (needsCells) state.frame.visible = frame.visible;
        m_rows[row].events = state.events;
        RowComparison comparison(m_limits, state, m_table.table(), phraseOf(spokenKey(m_trace.rows[row], fields)));
        if (auto difference = comparison.difference(fields))
            m_rows[row].sentence = *std::move(difference);
        else
            m_rows[row].isRounding = comparison.isRounding();
    }

    using Wanted = std::vector<std::pair<std::uint64_t, std::size_t>>;  // step, row

    const Trace&                            m_trace;
    const DrawRequest&                      m_request;
    PolygonLimits                           m_limits;
    std::vector<JudgedRow>&                 m_rows;
    RunRecorders                            m_recorders;
    TableKeeper                             m_table;
    std::array<Wanted, kGrains.size()>      m_wanted;
    std::array<std::size_t, kGrains.size()> m_next{};
};

std::string sentenceOf(const TraceAnswer& answer, const Trace& trace)
{
    const std::string rows = grouped(answer.rows.size(), ',');
    std::string       text;
    if (answer.firstWrong) {
        text = fmt::format("Line {} of the trace is the first that differs from {}. {}",
                           trace.rows[*answer.firstWrong].line, answer.algorithm,
                           answer.rows[*answer.firstWrong].sentence);
        text += fmt::format(" Rows that differ: {} of {}.", grouped(answer.wrong, ','), rows);
    } else {
        text = fmt::format("Every row of the trace agrees with {}: {} of {}.", answer.algorithm, rows, rows);
    }
    if (answer.rounding > 0)
        text += fmt::format(" Rows that differ by rounding alone: {}.", grouped(answer.rounding, ','));
    return text;
}

}  // namespace

Result<TraceAnswer> judgeTrace(const Trace& trace, const DrawRequest& request, double halfStep)
try {
    if (const auto plan = planFrame(request); !plan) return plan.error();
    const auto  wasCancelled = [&request] { return request.cancel && request.cancel->load(); };
    const Error cancelled{Trouble::Cancelled, "stepping was cancelled"};

    TraceAnswer answer;
    answer.algorithm   = nameOf(request.pipeline);
    answer.faceCulling = request.faceCulling;
    answer.rows.resize(trace.rows.size());
    MomentFinder finder(trace);
    {
        Listening      listening(finder);
        Frame          frame;
        plain::Scratch scratch;
        drawObserved(request, frame, scratch, listening);
    }
    if (wasCancelled()) return cancelled;
    const auto steps = finder.stepsOf(trace, grainsOf(repeatable(request).pipeline));
    RowJudge   judge(trace, request, halfStep, steps, answer.rows);
    judge.judgeOthers();
    drawObserved(request, judge.frame, judge.scratch, judge);
    if (wasCancelled()) return cancelled;

    for (std::size_t i = 0; i < answer.rows.size(); ++i) {
        answer.wrong += answer.rows[i].isWrong();
        answer.rounding += answer.rows[i].isRounding;
        if (answer.rows[i].isWrong() && !answer.firstWrong) answer.firstWrong = i;
    }
    answer.sentence = sentenceOf(answer, trace);
    return answer;
} catch (const std::bad_alloc&) {
    return Error{Trouble::Limit, "there is not enough memory to step through this frame"};
}

}  // namespace zscope::check
