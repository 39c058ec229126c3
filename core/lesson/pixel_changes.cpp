#include "core/lesson/pixel_changes.h"

#include <algorithm>
#include <new>
#include <type_traits>
#include <utility>

#include "core/frame/frame_plan.h"
#include "core/frame/observed_run.h"
#include "core/geometry/geometry_events.h"
#include "core/lesson/run_telling.h"
#include "core/lesson/step_state.h"
#include "core/method/intervals.h"
#include "core/plain/active_edges.h"
#include "core/probe/recorders.h"
#include "core/sweep/blend_events.h"

namespace zscope {

namespace {

std::optional<Error> cannotLook(const DrawRequest& request, Grain grain)
{
    if (const auto plan = planFrame(request); !plan) return plan.error();
    const std::vector<Grain> grains = grainsOf(request.pipeline);
    if (std::ranges::find(grains, grain) != grains.end()) return std::nullopt;
    return Error{Trouble::Usage,
                 nameOf(request.pipeline) + " has no steps of grain '" + std::string(wordOf(grain)) + "'"};
}

/// Compares a pixel of the picture that is being drawn after every step.
class ChangeRecorder {
public:
    ChangeRecorder(Grain grain, PixelPosition pixel, const VisibilityBuffer& visible)
        : m_grain(grain), m_pixel(pixel), m_visible(visible)
    {}

    void hear(const Heard& heard)
    {
        if (const auto* e = heard.as<PixelBlended>())
            m_isBlended = m_isBlended || (e->x == m_pixel.x && e->y == m_pixel.y && e->before != e->after);
        if (heard.isStepOf(m_grain)) look(StepIndex{m_seen++});
    }

    std::vector<PixelChange>& changes() { return m_changes; }

private:
    void look(StepIndex step)
    {
        const std::int64_t id     = m_visible.idAt(m_pixel.x, m_pixel.y);
        const float        value  = m_visible.storedAt(m_pixel.x, m_pixel.y);
        const float        before = m_seen == 1 ? m_visible.empty() : m_value;
        // A pre-pass keeps depths without ids, which the picture reports as background; they are a change all the same.
        if (id == m_id && value == before && !m_isBlended) {
            m_value = value;
            return;
        }
        m_changes.push_back({step, m_id, id, reported(before), reported(value), m_isBlended});
        m_id        = id;
        m_value     = value;
        m_isBlended = false;
    }
    float reported(float value) const { return value > m_visible.empty() ? value : 0.0f; }

    Grain                    m_grain;
    PixelPosition            m_pixel;
    const VisibilityBuffer&  m_visible;
    std::uint64_t            m_seen      = 0;
    std::int64_t             m_id        = -1;
    float                    m_value     = 0;
    bool                     m_isBlended = false;
    std::vector<PixelChange> m_changes;
};

/// Knows which steps hit a breakpoint, and ends the run when it has heard enough. Of events that a method has for
/// itself it takes what they mean: a test at a pixel.
class BreakpointRecorder final : public Meanings {
public:
    BreakpointRecorder(Grain grain, std::optional<StepIndex> from, std::span<const Breakpoint> breakpoints,
                       Direction direction, const Scene& scene, bool byFace, const Telling& telling)
        : m_grain(grain), m_from(from), m_direction(direction), m_telling(telling)
    {
        for (std::size_t i = 0; i < breakpoints.size(); ++i) {
            Breakpoint one = breakpoints[i];
            if (byFace && one.on == Breakpoint::On::Triangle && one.triangle.value < scene.triangleCount())
                m_faces.push_back({i, scene.firstOfFace(one.triangle)});
            m_breakpoints.push_back(one);
        }
    }

    using Events =
        Wants<NodeRecalled, NodeJudged, TriangleSetUp, TriangleHidden, TriangleReached, plain::EdgeTableReady,
              plain::EdgeEntered, plain::LineReady, PixelTested, SpanFilled, plain::IntervalDecided, PixelBlended>;

    void hear(const Heard& heard)
    {
        passOn(heard, *this, Events());
        if (!isOneOf(heard, Events())) heard.mean(*this);
        if (heard.isStepOf(m_grain)) step();
    }

    bool asksAbout(const PixelBox&) const override { return true; }
    void of(TriangleId polygon, const PixelBox& pixels, const Outcome& outcome, const Make&) override
    {
        if (!isTest(outcome.effect)) return;
        onTriangle(polygon);
        for (int y = pixels.y0; y < pixels.y1; ++y) {
            onLine(y);
            onPixel(y, pixels.x0, pixels.x1);
        }
    }
    void           below(const NodePlace&, const Outcome&, const Make&, const PixelBox*) override {}
    void           remark(const PixelBox&, const Remark&) override {}
    const Telling& telling() const override { return m_telling; }

    void observe(const NodeRecalled& e) { onNode(e.place); }
    void observe(const NodeJudged& e) { onNode(e.place); }
    void observe(const TriangleSetUp& e)
    {
        if (e.fate != SetUp::Drawn) onTriangle(e.triangle);
    }
    void observe(const TriangleHidden& e) { onTriangle(e.triangle); }
    void observe(const TriangleReached& e)
    {
        onTriangle(e.triangle.id);
        m_line = -1;
    }
    void observe(const plain::EdgeTableReady& e) { m_table = &e.table; }
    void observe(const plain::EdgeEntered& e) { onTriangle(m_table->polygons()[e.edge.polygon].id); }
    void observe(const plain::LineReady& e)
    {
        m_isSweep = true;
        onLine(e.y);
    }
    void observe(const PixelTested& e)
    {
        onPixel(e.y, e.x, e.x + 1);
        if (!m_isSweep && e.y != m_line) onLine(e.y);
        m_line = e.y;
    }
    void observe(const SpanFilled& e)
    {
        if (m_isSweep) onTriangle(e.triangle);
    }
    void observe(const plain::IntervalDecided& e)
    {
        if (e.winner) onPixel(e.y, e.x0, e.x1);
    }
    void observe(const PixelBlended& e) { onPixel(e.y, e.x, e.x + 1); }

    const std::optional<Stop>& found() const { return m_found; }

private:
    void step()
    {
        const StepIndex now{m_seen++};
        const auto      hit = std::exchange(m_hit, std::nullopt);
        if (m_direction == Direction::Back) {
            if (m_from && now >= *m_from) throw RunStopped{};
            if (hit) m_found = Stop{now, *hit};
            return;
        }
        if (!hit || (m_from && now <= *m_from)) return;
        m_found = Stop{now, *hit};
        throw RunStopped{};
    }

    template <class Is>
    void hitIf(const Is& is)
    {
        for (std::size_t i = 0; i < m_breakpoints.size(); ++i)
            if (is(i, m_breakpoints[i]) && (!m_hit || i < *m_hit)) m_hit = i;
    }
    void onLine(int y)
    {
        hitIf([y](std::size_t, const Breakpoint& b) { return b.on == Breakpoint::On::Line && b.line == y; });
    }
    void onPixel(int y, int x0, int x1)
    {
        hitIf([=](std::size_t, const Breakpoint& b) {
            return b.on == Breakpoint::On::Pixel && b.pixel.y == y && x0 <= b.pixel.x && b.pixel.x < x1;
        });
    }
    void onTriangle(TriangleId id)
    {
        hitIf([&](std::size_t i, const Breakpoint& b) {
            if (b.on != Breakpoint::On::Triangle) return false;
            return b.triangle == id
                   || std::ranges::any_of(m_faces, [&](const auto& f) { return f.breakpoint == i && f.face == id; });
        });
    }
    void onNode(const NodePlace& place)
    {
        hitIf([&](std::size_t, const Breakpoint& b) {
            if (b.on != Breakpoint::On::Node || b.node.instance.has_value() == place.isInstanceTree) return false;
            if (b.node.instance && *b.node.instance != place.instance) return false;
            return b.node.path == pathOf(place.node);
        });
    }

    struct FaceOf {
        std::size_t breakpoint;
        TriangleId  face;
    };

    Grain                      m_grain;
    std::optional<StepIndex>   m_from;
    Direction                  m_direction;
    const Telling&             m_telling;
    std::vector<Breakpoint>    m_breakpoints;
    std::vector<FaceOf>        m_faces;              // of triangles that are drawn as part of a face
    const plain::EdgeTable*    m_table   = nullptr;  // of the run; outlives it
    bool                       m_isSweep = false;
    int                        m_line    = -1;  // on which the triangle at hand was tested last
    std::uint64_t              m_seen    = 0;
    std::optional<std::size_t> m_hit;  // since the last step
    std::optional<Stop>        m_found;
};

Error tooLittleToRun() { return {Trouble::Limit, "there is not enough memory to run this frame"}; }

bool wasCancelled(const DrawRequest& request) { return request.cancel && request.cancel->load(); }

}  // namespace

Result<std::vector<PixelChange>> changesOfPixel(const DrawRequest& asked, Grain grain, PixelPosition pixel)
try {
    const DrawRequest request = repeatable(asked);
    if (const auto error = cannotLook(request, grain)) return *error;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= request.camera.width || pixel.y >= request.camera.height)
        return Error{Trouble::Usage, "there is no pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y)
                                         + " in this picture"};
    Frame          frame;
    plain::Scratch scratch;
    ChangeRecorder changes(grain, pixel, frame.visible);
    Listening      listening(changes);
    drawObserved(request, frame, scratch, listening);
    if (wasCancelled(request)) return Error{Trouble::Cancelled, "the search was cancelled"};
    return std::move(changes.changes());
} catch (const std::bad_alloc&) {
    return tooLittleToRun();
}

Result<std::optional<Stop>> nextStop(const DrawRequest& asked, Grain grain, std::optional<StepIndex> from,
                                     std::span<const Breakpoint> breakpoints, Direction direction)
try {
    const DrawRequest request = repeatable(asked);
    if (const auto error = cannotLook(request, grain)) return *error;
    Frame              frame;
    plain::Scratch     scratch;
    TriangleRecorder   triangle;
    RunTelling         telling(request, frame, triangle);
    BreakpointRecorder recorder(grain, from, breakpoints, direction, request.scene->scene(),
                                drawsFaces(request.pipeline), telling);
    try {
        Listening listening(recorder);
        drawObserved(request, frame, scratch, listening);
    } catch (const RunStopped&) {}
    if (wasCancelled(request)) return Error{Trouble::Cancelled, "the search was cancelled"};
    return recorder.found();
} catch (const std::bad_alloc&) {
    return tooLittleToRun();
}

}  // namespace zscope
