// What a lesson remembers of a run: each recorder keeps one structure as it stands at the last event heard.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/stages.h"
#include "core/frame/frame_events.h"
#include "core/lesson/step_state.h"
#include "core/probe/probe.h"
#include "core/scan/pixel_events.h"
#include "core/sweep/edge_table.h"
#include "core/sweep/sweep_events.h"

namespace zscope {

/// Keeps the sweep's structures for the line the run has reached.
class SweepRecorder {
public:
    void observe(const EdgeTableReady& e);
    void observe(const EdgeLeft& e);
    void observe(const EdgeEntered& e);
    void observe(const ScanlineReady& e);
    void observe(const SpanFilled& e);
    void observe(const ScanlineFinished&) { m_lineIsOver = true; }

    /// Nothing before the edge table was ready.
    std::optional<SweepState> state() const;

private:
    void beginLineIfOver();

    const EdgeTable*        m_table = nullptr;  // of the run; outlives it
    bool                    m_lineIsOver = false;
    int                     m_y          = -1;
    std::vector<ActiveEdge> m_active, m_entered, m_left;  // each edge's polygon() is its part again
    std::vector<TriangleId> m_polygons;                   // the active polygon table, row by row
    std::vector<SpanRow>    m_spans;
};
static_assert(observes<SweepRecorder, EdgeTableReady> && observes<SweepRecorder, EdgeLeft> &&
              observes<SweepRecorder, EdgeEntered> && observes<SweepRecorder, ScanlineReady> &&
              observes<SweepRecorder, SpanFilled> && observes<SweepRecorder, ScanlineFinished>);

/// Keeps the triangle a stream method is working on and how many pixels it has won.
class TriangleRecorder {
public:
    void observe(const TriangleReached& e);
    void observe(const PixelTested& e);

    std::optional<TriangleState> state() const { return m_triangle; }

private:
    std::optional<TriangleState> m_triangle;
};
static_assert(observes<TriangleRecorder, TriangleReached> && observes<TriangleRecorder, PixelTested>);

/// Keeps the last span and the last pixel's test; a new triangle or line makes both old.
class PixelRecorder {
public:
    void observe(const SpanFilled& e) { m_span = SpanRow{e.x0, e.x1, e.triangle}; }
    void observe(const PixelTested& e);
    void observe(const TriangleReached&) { m_span.reset(); }
    void observe(const ScanlineReady&) { m_span.reset(); }

    std::optional<SpanRow>    span() const { return m_span; }
    std::optional<PixelState> pixel() const { return m_pixel; }

private:
    std::optional<SpanRow>    m_span;
    std::optional<PixelState> m_pixel;
};
static_assert(observes<PixelRecorder, SpanFilled> && observes<PixelRecorder, PixelTested> &&
              observes<PixelRecorder, TriangleReached> && observes<PixelRecorder, ScanlineReady>);

/// Keeps which stage the run is in, and what the last step was.
class MomentRecorder {
public:
    enum class Moment { None, StageOver, TriangleOver, LineReady, LineOver, SpanOver, PixelOver, FrameOver };

    void observe(const StageStarted& e) { m_stage = e.stage; }
    void observe(const StageFinished& e) { m_stage = e.stage, m_moment = Moment::StageOver; }
    void observe(const TriangleFinished&) { m_moment = Moment::TriangleOver; }
    void observe(const ScanlineReady&) { m_moment = Moment::LineReady; }
    void observe(const ScanlineFinished&) { m_moment = Moment::LineOver; }
    void observe(const SpanFilled&) { m_moment = Moment::SpanOver; }
    void observe(const PixelTested&) { m_moment = Moment::PixelOver; }
    void observe(const FrameFinished&) { m_moment = Moment::FrameOver; }

    Stage  stage() const { return m_stage; }
    Moment moment() const { return m_moment; }

private:
    Stage  m_stage  = Stage::Clear;
    Moment m_moment = Moment::None;
};

}  // namespace zscope
