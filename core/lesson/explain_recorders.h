// What becomes of chosen triangles in a run: of those that meet chosen pixels, or of a single one everywhere.
//
// Source     what each event says that it means (core/probe/meaning.h). Only events that carry the structure of a run
//            are known by their types: stages and passes, whose triangles are at hand, and set-up
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/base/grid.h"
#include "core/cull/cull_events.h"
#include "core/frame/frame_events.h"
#include "core/frame/pipeline.h"
#include "core/geometry/geometry_events.h"
#include "core/lesson/run_telling.h"
#include "core/lesson/step_counter.h"
#include "core/scene/scene.h"

namespace zscope {

/// Calls visit(id) for those of the ascending `ids` whose triangles are below the node.
template <class Visit>
void forEachBelow(const Scene& scene, const NodePlace& place, std::span<const std::uint32_t> ids, const Visit& visit)
{
    const auto& starts = scene.firstTriangle;
    const auto  within = [&](std::uint32_t first, std::uint32_t end) {
        const auto from = std::lower_bound(ids.begin(), ids.end(), first);
        return std::pair(from, std::lower_bound(from, ids.end(), end));
    };
    const auto items = place.tree.allItems(place.node);
    if (place.isInstanceTree) {
        for (const std::uint32_t instance : items) {
            const auto some = within(starts[instance], starts[instance + 1]);
            for (auto at = some.first; at != some.second; ++at) visit(*at);
        }
        return;
    }
    const std::uint32_t start = starts[place.instance.value];
    const auto          some  = within(start, starts[place.instance.value + 1]);
    if (some.first == some.second) return;
    for (const std::uint32_t item : items)
        if (std::binary_search(some.first, some.second, start + item)) visit(start + item);
}

/// What both kinds of histories are made of.
class Histories : public Meanings {
public:
    using Events = Wants<StageStarted, PassStarted, NodeDrawn, NodeRecalled, TriangleSetUp>;

    Histories(const Scene& scene, bool byFace, const StepCounter& steps, const Telling& telling)
        : m_scene(scene), m_steps(steps), m_telling(telling), m_byFace(byFace)
    {}

    void hear(const Heard& heard)
    {
        m_heard = &heard;
        heard.mean(*this);
        passOn(heard, *this, Events());
    }

    void observe(const StageStarted& e) { m_isPrepass = e.stage == Stage::Prepass; }
    void observe(const PassStarted& e) { m_pass = e.pass; }
    void observe(const NodeDrawn& e) { m_holder = nameOf(e.place); }
    void observe(const NodeRecalled& e) { m_holder = nameOf(e.place); }
    void observe(const TriangleSetUp& e)
    {
        if (!m_isPrepass) setUp(e);
    }

    const Telling& telling() const override { return m_telling; }

protected:
    virtual void setUp(const TriangleSetUp& e) = 0;

    /// What the event at hand means for a triangle that is drawn as `polygon`.
    Event eventOf(const Outcome& outcome, Meaning meaning) const;
    Event eventOf(const TriangleSetUp& e, TriangleId polygon) const;
    /// Of a pre-pass only tests count.
    bool  counts(Effect effect) const { return !m_isPrepass || isTest(effect); }
    Grain grainAtHand() const { return m_heard->kind.grain.value_or(Grain::Stage); }

    const Scene&       m_scene;
    const StepCounter& m_steps;
    const Telling&     m_telling;
    const Heard*       m_heard = nullptr;  // the event at hand
    NodeName           m_holder;           // whose triangles are being drawn
    bool               m_byFace;
    bool               m_isPrepass = false;
    int                m_pass      = 0;
};

/// The histories of the triangles that meet a few pixels.
class PixelHistories final : public Histories {
public:
    /// `covers`: of each pixel, ascending by triangle. `byFace`: whole faces are drawn, under their first triangle's
    /// id.
    PixelHistories(const Scene& scene, int width, int height, std::span<const PixelPosition> pixels,
                   const std::vector<std::vector<PixelCover>>& covers, bool byFace, const StepCounter& steps,
                   const Telling& telling);

    bool asksAbout(const PixelBox& pixels) const override;
    void of(TriangleId polygon, const PixelBox& pixels, const Outcome& outcome, const Make& make) override;
    void below(const NodePlace& place, const Outcome& outcome, const Make& make, const PixelBox* pixels) override;
    void remark(const PixelBox& pixels, const Remark& make) override;

    /// What one pixel has seen.
    struct History {
        std::vector<PixelCandidate> candidates;  // by drawnAs, then triangle
        std::vector<std::uint64_t>  met;         // of each: when, counted in events of all histories; kNever
        std::string                 remark;      // of the pixel as such
    };
    static constexpr std::uint64_t kNever = ~std::uint64_t{0};
    /// One per distinct pixel; of() says which.
    std::vector<History>& histories() { return m_histories; }
    std::size_t of(PixelPosition pixel) const { return static_cast<std::size_t>(m_place.at(pixel.x, pixel.y)); }

private:
    struct Range {
        std::size_t first, end;
    };
    /// The candidates of a history that are drawn under this id; a new one if there was none.
    Range rangeOf(History& history, TriangleId drawnAs) const;
    Range rangeOrNew(History& history, TriangleId drawnAs);
    void  note(History& history, std::size_t candidate, Event event);
    void  setUp(const TriangleSetUp& e) override;
    bool  isMet(TriangleId triangle) const;

    /// Calls visit(history, pixel) for the pixels of the box that are asked about.
    template <class Visit>
    void forEachIn(const PixelBox& box, const Visit& visit);
    /// Calls visit(history, candidate) for a triangle at all pixels that it meets, if they lie in `box`.
    template <class Visit>
    void forEachOf(TriangleId triangle, const PixelBox* box, const Visit& visit);

    Grid<std::int32_t>                                   m_place;      // which history; -1: none
    std::vector<std::uint8_t>                            m_hasPixels;  // of each line
    std::vector<PixelPosition>                           m_pixels;     // of each history
    std::vector<History>                                 m_histories;
    std::vector<std::uint32_t>                           m_ids;    // of the triangles that meet a pixel, ascending
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_where;  // (triangle, history), ascending
    std::uint64_t                                        m_clock = 0;
};

/// The history of one triangle over the whole picture.
class TriangleHistory final : public Histories {
public:
    TriangleHistory(const Scene& scene, TriangleId triangle, bool byFace, const StepCounter& steps,
                    const Telling& telling);

    bool asksAbout(const PixelBox&) const override { return true; }
    void of(TriangleId polygon, const PixelBox& pixels, const Outcome& outcome, const Make& make) override;
    void below(const NodePlace& place, const Outcome& outcome, const Make& make, const PixelBox* pixels) override;
    void remark(const PixelBox&, const Remark&) override {}

    std::vector<Event>& events() { return m_events; }
    std::uint64_t       leftOut() const { return m_leftOut; }
    TriangleTally&      tally() { return m_tally; }

private:
    bool holds(const NodePlace& place) const;
    void note(Event event);
    /// False if an event of this word need not be noted again.
    bool isToBeNoted(const Outcome& outcome);
    void count(const PixelBox& pixels, const Outcome& outcome);
    void setUp(const TriangleSetUp& e) override;

    TriangleId         m_triangle, m_drawnAs;
    InstanceId         m_instance;
    std::vector<Event> m_events;
    std::uint64_t      m_leftOut = 0;
    TriangleTally      m_tally;
    std::vector<std::pair<std::string_view, bool>>
        m_noted;  // words of which the first is noted, and whether in a pre-pass
};

}  // namespace zscope
