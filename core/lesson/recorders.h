// What a lesson remembers of a run: each recorder keeps one structure as it stands at the last event heard.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/stages.h"
#include "core/cull/cull_events.h"
#include "core/frame/frame_events.h"
#include "core/lesson/step_state.h"
#include "core/method/intervals.h"
#include "core/plain/edge_table.h"
#include "core/probe/recorders.h"
#include "core/scan/pixel_events.h"
#include "core/sweep/blend_events.h"

namespace zscope {

/// Keeps the sweep's structures for the line the run has reached.
class SweepRecorder {
public:
    using Events = Wants<plain::EdgeTableReady, plain::EdgeLeft, plain::EdgeEntered, plain::LineReady, SpanFilled,
                         plain::LineFinished>;

    void observe(const plain::EdgeTableReady& e);
    void observe(const plain::EdgeLeft& e);
    void observe(const plain::EdgeEntered& e);
    void observe(const plain::LineReady& e);
    void observe(const SpanFilled& e);
    void observe(const plain::LineFinished&) { m_lineIsOver = true; }

    /// Nothing before the edge table was ready.
    std::optional<SweepState> state() const;
    std::size_t               bytes() const
    {
        return (m_active.capacity() + m_entered.capacity() + m_left.capacity()) * sizeof(plain::Edge)
               + m_spans.capacity() * sizeof(SpanRow);
    }

private:
    void beginLineIfOver();

    const plain::EdgeTable*  m_table      = nullptr;  // of the run; outlives it
    bool                     m_lineIsOver = false;
    int                      m_y          = -1;
    std::vector<plain::Edge> m_active, m_entered, m_left;
    std::vector<SpanRow>     m_spans;
};

/// Keeps the triangle a stream method is working on and how many pixels it has won.
class TriangleRecorder {
public:
    using Events = Wants<TriangleReached, PixelTested>;

    void observe(const TriangleReached& e);
    void observe(const PixelTested& e);

    std::optional<TriangleState> state() const { return m_triangle; }

private:
    std::optional<TriangleState> m_triangle;
};

/// Keeps the last span, the last tile, and the last pixel's test and blending; a new triangle or line makes a span old.
class PixelRecorder {
public:
    using Events = Wants<SpanFilled, PixelTested, TileTested, PixelBlended, TriangleReached, plain::LineReady>;

    void observe(const SpanFilled& e) { m_span = SpanRow{e.x0, e.x1, e.triangle}; }
    void observe(const PixelTested& e);
    void observe(const TileTested& e) { m_tile = e; }
    void observe(const PixelBlended& e) { m_blend = BlendState{e.x, e.y, e.surfaces, e.before, e.after}; }
    void observe(const TriangleReached&) { m_span.reset(); }
    void observe(const plain::LineReady&) { m_span.reset(); }

    std::optional<SpanRow>    span() const { return m_span; }
    std::optional<PixelState> pixel() const { return m_pixel; }
    std::optional<TileTested> tile() const { return m_tile; }
    std::optional<BlendState> blend() const { return m_blend; }

private:
    std::optional<SpanRow>    m_span;
    std::optional<PixelState> m_pixel;
    std::optional<TileTested> m_tile;
    std::optional<BlendState> m_blend;
};

/// Keeps the last interval decided; a new line makes it old.
class IntervalRecorder {
public:
    using Events = Wants<plain::IntervalDecided, plain::LineReady>;

    void observe(const plain::IntervalDecided& e);
    void observe(const plain::LineReady&) { m_interval.reset(); }

    std::optional<IntervalState> state() const { return m_interval; }

private:
    std::optional<IntervalState> m_interval;
};

/// Keeps the nodes of the hierarchy as they become known and are judged, the last question to the pyramid, and the
/// cell of it that was written last.
class HierarchyRecorder {
public:
    using Events =
        Wants<StageStarted, NodeJudged, PassStarted, NodeRecalled, NodeOpened, NodeDrawn, PyramidAsked, CellUpdated>;

    /// A pre-pass visits the tree too, but what it met is forgotten when the visit that counts begins.
    void observe(const StageStarted& e);
    void observe(const PassStarted& e) { m_state.pass = e.pass; }
    void observe(const NodeRecalled& e);
    void observe(const NodeJudged& e);
    void observe(const NodeOpened& e);
    void observe(const NodeDrawn& e);
    void observe(const PyramidAsked& e);
    void observe(const CellUpdated& e);

    /// Nothing if neither a node nor the pyramid has been met. The levels are those of a picture of the given size.
    std::optional<HierarchyState> state(int width, int height, bool hasPyramid) const;
    /// Roughly: a row of the map costs what a row of the list costs.
    std::size_t bytes() const { return 2 * m_state.nodes.capacity() * sizeof(NodeRow); }

private:
    /// The row of a node, new (and waiting) if it was not known.
    NodeRow& rowOf(const NodePlace& place);
    /// The same of a node whose ancestors may not be known either.
    NodeRow& rowWithAncestors(const NodePlace& place);

    HierarchyState                                          m_state;
    std::map<std::pair<std::int64_t, const TreeNode*>, int> m_ids;  // (instance or -1, node) to row
    int m_instanceNode = -1;  // of the tree over the instances: the one whose instances are being visited
};

/// Counts the depth tests of every pixel, those of a pre-pass included.
class TestCounter {
public:
    using Events = Wants<PixelTested>;

    TestCounter(int width, int height) : m_tests(width, height, 0) {}

    void observe(const PixelTested& e) { ++m_tests.at(e.x, e.y); }

    Grid<std::uint32_t>        take() { return std::move(m_tests); }
    const Grid<std::uint32_t>& tests() const { return m_tests; }
    std::size_t                bytes() const { return m_tests.values().size_bytes(); }

private:
    Grid<std::uint32_t> m_tests;
};

/// Keeps which stage the run is in, or has just been in.
class CurrentStage {
public:
    using Events = Wants<StageStarted>;

    void  observe(const StageStarted& e) { m_stage = e.stage; }
    Stage stage() const { return m_stage; }

private:
    Stage m_stage = Stage::Clear;
};

}  // namespace zscope
