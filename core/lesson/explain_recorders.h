// What becomes of chosen triangles in a run: of those that meet chosen pixels, or of a single one everywhere.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/base/grid.h"
#include "core/cull/cull_events.h"
#include "core/frame/frame_events.h"
#include "core/frame/pipeline.h"
#include "core/geometry/geometry_events.h"
#include "core/lesson/step_counter.h"
#include "core/method/intervals.h"
#include "core/scan/pixel_events.h"
#include "core/scene/scene.h"
#include "core/sweep/blend_events.h"

namespace zscope {

/// The depth of a polygon of the sweep at a pixel, as the picture stores it where rules are exact.
float depthOf(const DepthPlane& plane, int x, int y);

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

/// The histories of the triangles that meet a few pixels.
class PixelHistories {
public:
    using Events = Wants<StageStarted, PassStarted, NodeJudged, NodeDrawn, NodeRecalled, TriangleSetUp, PyramidAsked,
                         TriangleHidden, TileTested, PixelTested, plain::IntervalDecided, PixelBlended>;

    /// `covers`: of each pixel, ascending by triangle. `byFace`: whole faces are drawn, under their first triangle's
    /// id.
    PixelHistories(const Scene& scene, int width, int height, std::span<const PixelPosition> pixels,
                   const std::vector<std::vector<PixelCover>>& covers, bool byFace, const StepCounter& steps);

    void observe(const StageStarted& e) { m_isPrepass = e.stage == Stage::Prepass; }
    void observe(const PassStarted& e) { m_pass = e.pass; }
    void observe(const NodeJudged& e);
    void observe(const NodeDrawn& e) { m_holder = nameOf(e.place); }
    void observe(const NodeRecalled& e) { m_holder = nameOf(e.place); }
    void observe(const TriangleSetUp& e);
    void observe(const PyramidAsked& e);
    void observe(const TriangleHidden& e);
    void observe(const TileTested& e);
    void observe(const PixelTested& e);
    void observe(const plain::IntervalDecided& e);
    void observe(const PixelBlended& e);

    /// What one pixel has seen.
    struct History {
        std::vector<PixelCandidate>   candidates;  // by drawnAs, then triangle
        std::vector<std::uint64_t>    met;         // of each: when, counted in events of all histories; kNever
        std::optional<Moment>         blended;
        std::optional<IntervalReason> comparedBecause;  // the interval that it lies in was compared pixel by pixel
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
    /// Notes it for a triangle at all pixels that it meets, if they lie in `box`.
    void  noteOf(TriangleId triangle, const Event& event, const PixelBox* box = nullptr);
    void  overtake(History& history, TriangleId loser, TriangleId winner, float depth, float winnersDepth,
                   const Moment& moment);
    Event begin(Happening happening, const Moment& moment, Grain grain) const;

    const Scene&                                         m_scene;
    const StepCounter&                                   m_steps;
    Grid<std::int32_t>                                   m_place;      // which history; -1: none
    std::vector<std::uint8_t>                            m_hasPixels;  // of each line
    std::vector<PixelPosition>                           m_pixels;     // of each history
    std::vector<History>                                 m_histories;
    std::vector<std::uint32_t>                           m_ids;     // of the triangles that meet a pixel, ascending
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_where;   // (triangle, history), ascending
    NodeName                                             m_holder;  // whose triangles are being drawn
    Moment                                               m_asked;   // when the pyramid was asked last
    std::uint64_t                                        m_clock     = 0;
    bool                                                 m_isPrepass = false;
    bool                                                 m_byFace;
    int                                                  m_pass = 0;
};

/// The history of one triangle over the whole picture.
class TriangleHistory {
public:
    using Events = Wants<StageStarted, PassStarted, NodeJudged, NodeRecalled, TriangleSetUp, PyramidAsked,
                         TriangleHidden, TrianglePassed, TileTested, PixelTested, plain::IntervalDecided>;

    TriangleHistory(const Scene& scene, TriangleId triangle, bool byFace, const StepCounter& steps);

    void observe(const StageStarted& e) { m_isPrepass = e.stage == Stage::Prepass; }
    void observe(const PassStarted& e) { m_pass = e.pass; }
    void observe(const NodeJudged& e);
    void observe(const NodeRecalled& e);
    void observe(const TriangleSetUp& e);
    void observe(const PyramidAsked& e);
    void observe(const TriangleHidden& e);
    void observe(const TrianglePassed& e);
    void observe(const TileTested& e);
    void observe(const PixelTested& e);
    void observe(const plain::IntervalDecided& e);

    std::vector<Event>& events() { return m_events; }
    std::uint64_t       leftOut() const { return m_leftOut; }
    TriangleTally&      tally() { return m_tally; }

private:
    bool  holds(const NodePlace& place) const;
    Event begin(Happening happening, const Moment& moment, Grain grain) const;
    void  note(Event event);
    void  noteOnce(Event event, bool& noted);

    const Scene&       m_scene;
    const StepCounter& m_steps;
    TriangleId         m_triangle, m_drawnAs;
    InstanceId         m_instance;
    Moment             m_asked;
    std::vector<Event> m_events;
    std::uint64_t      m_leftOut = 0;
    TriangleTally      m_tally;
    bool               m_isPrepass = false;
    int                m_pass      = 0;
    bool m_hasWon = false, m_hasLost = false, m_wasRejected = false, m_wasDiscarded = false, m_hadInterval = false,
         m_lostInterval = false;
    bool m_wonInPrepass = false;
};

}  // namespace zscope
