#include "core/lesson/explain_recorders.h"

#include <algorithm>

namespace zscope {

namespace {

Happening happeningOf(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Outside:
            return Happening::NodeOutside;
        case Verdict::Hidden:
            return Happening::NodeHidden;
        case Verdict::Small:
            return Happening::NodeSmall;
        case Verdict::Entered:
            break;
    }
    return Happening::NodeEntered;
}

Happening happeningOf(const PixelTested& e)
{
    return e.discarded ? Happening::Discarded : e.won ? Happening::Won : Happening::Lost;
}

bool holds(const PixelBox& box, PixelPosition p)
{
    return box.x0 <= p.x && p.x < box.x1 && box.y0 <= p.y && p.y < box.y1;
}

std::optional<TriangleId> rivalOf(const PixelTested& e)
{
    return e.rivalRank == 0 ? std::nullopt : std::optional(TriangleId{e.rivalRank - 1});
}

}  // namespace

NodeName nameOf(const NodePlace& place)
{
    return {place.isInstanceTree ? std::nullopt : std::optional(place.instance), pathOf(place.node)};
}

float depthOf(const DepthPlane& plane, int x, int y)
{
    const double z = plane.a * (x + 0.5) + (plane.b * (y + 0.5) + plane.c);
    return static_cast<float>(std::min(std::max(z, double{plane.farthest}), double{plane.nearest}));
}

PixelHistories::PixelHistories(const Scene& scene, int width, int height, std::span<const PixelPosition> pixels,
                               const std::vector<std::vector<PixelCover>>& covers, bool byFace,
                               const StepCounter& steps)
    : m_scene(scene), m_steps(steps), m_place(width, height, -1), m_hasPixels(static_cast<std::size_t>(height), 0),
      m_byFace(byFace)
{
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const PixelPosition p = pixels[i];
        if (m_place.at(p.x, p.y) >= 0) continue;
        m_place.at(p.x, p.y)                       = static_cast<std::int32_t>(m_histories.size());
        m_hasPixels[static_cast<std::size_t>(p.y)] = 1;
        m_pixels.push_back(p);
        History& history = m_histories.emplace_back();
        for (const PixelCover& cover : covers[i]) {
            m_ids.push_back(cover.triangle.value);
            m_where.emplace_back(cover.triangle.value, static_cast<std::uint32_t>(m_histories.size() - 1));
            history.candidates.push_back({.triangle = cover.triangle,
                                          .drawnAs  = m_byFace ? scene.firstOfFace(cover.triangle) : cover.triangle,
                                          .instance = scene.instanceOf(cover.triangle),
                                          .cover    = cover.cover,
                                          .depth    = cover.depth});
        }
        history.met.assign(history.candidates.size(), kNever);
    }
    std::ranges::sort(m_ids);
    m_ids.erase(std::unique(m_ids.begin(), m_ids.end()), m_ids.end());
    std::ranges::sort(m_where);
}

PixelHistories::Range PixelHistories::rangeOf(History& history, TriangleId drawnAs) const
{
    const auto& all   = history.candidates;
    const auto  first = std::lower_bound(all.begin(), all.end(), drawnAs,
                                         [](const PixelCandidate& c, TriangleId id) { return c.drawnAs < id; });
    auto        end   = first;
    while (end != all.end() && end->drawnAs == drawnAs) ++end;
    return {static_cast<std::size_t>(first - all.begin()), static_cast<std::size_t>(end - all.begin())};
}

PixelHistories::Range PixelHistories::rangeOrNew(History& history, TriangleId drawnAs)
{
    Range range = rangeOf(history, drawnAs);
    if (range.first < range.end) return range;
    const auto at = static_cast<std::ptrdiff_t>(range.first);
    history.candidates.insert(
        history.candidates.begin() + at,
        {.triangle = drawnAs, .drawnAs = drawnAs, .instance = m_scene.instanceOf(drawnAs), .cover = std::nullopt});
    history.met.insert(history.met.begin() + at, kNever);
    ++range.end;
    return range;
}

Event PixelHistories::begin(Happening happening, const Moment& moment, Grain grain) const
{
    Event event;
    event.happening = happening;
    event.moment    = moment;
    event.grain     = grain;
    event.isPrepass = m_isPrepass;
    event.pass      = m_pass;
    return event;
}

void PixelHistories::note(History& history, std::size_t candidate, Event event)
{
    if (history.met[candidate] == kNever) history.met[candidate] = m_clock++;
    history.candidates[candidate].events.push_back(std::move(event));
}

void PixelHistories::noteOf(TriangleId triangle, const Event& event, const PixelBox* box)
{
    const std::pair<std::uint32_t, std::uint32_t> from(triangle.value, 0);
    for (auto at = std::lower_bound(m_where.begin(), m_where.end(), from);
         at != m_where.end() && at->first == triangle.value; ++at) {
        if (box && !holds(*box, m_pixels[at->second])) continue;
        History&    history = m_histories[at->second];
        const Range range   = rangeOf(history, m_byFace ? m_scene.firstOfFace(triangle) : triangle);
        for (std::size_t i = range.first; i < range.end; ++i)
            if (history.candidates[i].triangle == triangle) note(history, i, event);
    }
}

void PixelHistories::observe(const NodeJudged& e)
{
    if (m_isPrepass || e.verdict == Verdict::Entered) return;
    std::optional<Event> event;
    forEachBelow(m_scene, e.place, m_ids, [&](std::uint32_t id) {
        if (!event) {
            event.emplace(begin(happeningOf(e.verdict), m_steps.of(e), Grain::Node));
            event->node = nameOf(e.place);
            if (e.query) event->query = *e.query, event->depth = e.query->nearest;
        }
        noteOf(TriangleId{id}, *event);
    });
}

void PixelHistories::observe(const TriangleSetUp& e)
{
    if (m_isPrepass || !std::binary_search(m_ids.begin(), m_ids.end(), e.triangle.value)) return;
    Event event = begin(Happening::SetUp, m_steps.next(), Grain::Stage);
    event.setUp = e.fate;
    event.isCut = e.cut;
    if (!m_holder.path.empty()) event.node = m_holder;
    noteOf(e.triangle, event);
}

void PixelHistories::observe(const PyramidAsked& e)
{
    if (!e.node) m_asked = m_steps.of(e);
}

void PixelHistories::observe(const TriangleHidden& e)
{
    if (m_isPrepass || !std::binary_search(m_ids.begin(), m_ids.end(), e.triangle.value)) return;
    Event event = begin(Happening::TriangleHidden, m_asked, Grain::Query);
    event.query = e.query;
    event.depth = e.query.nearest;
    noteOf(e.triangle, event, &e.query.box);
}

void PixelHistories::observe(const TileTested& e)
{
    if (!e.rejected || !std::binary_search(m_ids.begin(), m_ids.end(), e.triangle.value)) return;
    Event event = begin(Happening::TileRejected, m_steps.of(e), Grain::Query);
    event.tile  = e;
    event.depth = e.nearest;
    noteOf(e.triangle, event, &e.box);
}

void PixelHistories::overtake(History& history, TriangleId loser, TriangleId winner, float depth, float winnersDepth,
                              const Moment& moment)
{
    const Range range = rangeOrNew(history, loser);
    for (std::size_t i = range.first; i < range.end; ++i) {
        Event event      = begin(Happening::Overtaken, moment, Grain::Pixel);
        event.depth      = depth;
        event.rival      = winner;
        event.rivalDepth = winnersDepth;
        note(history, i, std::move(event));
    }
}

void PixelHistories::observe(const PixelTested& e)
{
    const std::int32_t place = m_place.at(e.x, e.y);
    if (place < 0) return;
    History&     history = m_histories[static_cast<std::size_t>(place)];
    const Moment moment  = m_steps.of(e);
    if (e.won && e.keep != Keep::DepthOnly)
        if (const auto loser = rivalOf(e)) overtake(history, *loser, e.triangle, e.rivalDepth, e.depth, moment);
    const Range range = rangeOrNew(history, e.triangle);
    for (std::size_t i = range.first; i < range.end; ++i) {
        Event event      = begin(happeningOf(e), moment, Grain::Pixel);
        event.isPrepass  = e.keep == Keep::DepthOnly;
        event.depth      = e.depth;
        event.rival      = rivalOf(e);
        event.rivalDepth = e.rivalDepth;
        if (e.moved) event.unmovedDepth = e.unmovedDepth;
        note(history, i, std::move(event));
    }
}

void PixelHistories::observe(const plain::IntervalDecided& e)
{
    if (!m_hasPixels[static_cast<std::size_t>(e.y)]) return;
    const Moment moment = m_steps.of(e);
    for (int x = e.x0; x < e.x1; ++x) {
        const std::int32_t place = m_place.at(x, e.y);
        if (place < 0) continue;
        History& history = m_histories[static_cast<std::size_t>(place)];
        if (!e.winner) {
            history.comparedBecause = e.reason;
            continue;
        }
        for (const std::uint32_t part : e.open) {
            const plain::Polygon& polygon = e.polygons[part];
            const bool            isIt    = polygon.id == e.winner->id;
            Event event    = begin(isIt ? Happening::IntervalWon : Happening::IntervalLost, moment, Grain::Interval);
            event.depth    = depthOf(polygon.depth, x, e.y);
            event.interval = PixelBox{e.x0, e.y, e.x1, e.y + 1};
            event.reason   = e.reason;
            if (!isIt) event.rival = e.winner->id, event.rivalDepth = depthOf(e.winner->depth, x, e.y);
            const Range range = rangeOrNew(history, polygon.id);
            for (std::size_t i = range.first; i < range.end; ++i) note(history, i, event);
        }
    }
}

void PixelHistories::observe(const PixelBlended& e)
{
    const std::int32_t place = m_place.at(e.x, e.y);
    if (place >= 0) m_histories[static_cast<std::size_t>(place)].blended = m_steps.of(e);
}

TriangleHistory::TriangleHistory(const Scene& scene, TriangleId triangle, bool byFace, const StepCounter& steps)
    : m_scene(scene), m_steps(steps), m_triangle(triangle), m_drawnAs(byFace ? scene.firstOfFace(triangle) : triangle),
      m_instance(scene.instanceOf(triangle))
{}

bool TriangleHistory::holds(const NodePlace& place) const
{
    if (!place.isInstanceTree && place.instance != m_instance) return false;
    const std::uint32_t item =
        place.isInstanceTree ? m_instance.value : m_triangle.value - m_scene.firstTriangle[m_instance.value];
    const Bounds box = place.tree.boxOf(item), &all = place.node.bounds;
    const bool   mayHold = all.min.x <= box.min.x && all.min.y <= box.min.y && all.min.z <= box.min.z
                         && box.max.x <= all.max.x && box.max.y <= all.max.y && box.max.z <= all.max.z;
    const auto items = place.tree.allItems(place.node);
    return mayHold && std::find(items.begin(), items.end(), item) != items.end();
}

Event TriangleHistory::begin(Happening happening, const Moment& moment, Grain grain) const
{
    Event event;
    event.happening = happening;
    event.moment    = moment;
    event.grain     = grain;
    event.isPrepass = m_isPrepass;
    event.pass      = m_pass;
    return event;
}

void TriangleHistory::note(Event event)
{
    if (m_events.size() < TriangleExplanation::kMostEvents)
        m_events.push_back(std::move(event));
    else
        ++m_leftOut;
}

void TriangleHistory::noteOnce(Event event, bool& noted)
{
    if (!noted) note(std::move(event));
    noted = true;
}

void TriangleHistory::observe(const NodeJudged& e)
{
    if (m_isPrepass || !holds(e.place)) return;
    Event event = begin(happeningOf(e.verdict), m_steps.of(e), Grain::Node);
    event.node  = nameOf(e.place);
    if (e.query) event.query = *e.query, event.depth = e.query->nearest;
    note(std::move(event));
}

void TriangleHistory::observe(const NodeRecalled& e)
{
    if (!holds(e.place)) return;
    Event event = begin(Happening::NodeRecalled, m_steps.of(e), Grain::Node);
    event.node  = nameOf(e.place);
    note(std::move(event));
}

void TriangleHistory::observe(const TriangleSetUp& e)
{
    if (m_isPrepass || e.triangle != m_triangle) return;
    Event event = begin(Happening::SetUp, m_steps.next(), Grain::Stage);
    event.setUp = e.fate;
    event.isCut = e.cut;
    note(std::move(event));
}

void TriangleHistory::observe(const PyramidAsked& e)
{
    if (!e.node) m_asked = m_steps.of(e);
}

void TriangleHistory::observe(const TriangleHidden& e)
{
    if (m_isPrepass || e.triangle != m_drawnAs) return;
    Event event = begin(Happening::TriangleHidden, m_asked, Grain::Query);
    event.query = e.query;
    event.depth = e.query.nearest;
    note(std::move(event));
}

void TriangleHistory::observe(const TrianglePassed& e)
{
    if (m_isPrepass || e.triangle != m_drawnAs) return;
    Event event = begin(Happening::TrianglePassed, m_asked, Grain::Query);
    event.query = e.query;
    event.depth = e.query.nearest;
    note(std::move(event));
}

void TriangleHistory::observe(const TileTested& e)
{
    if (!e.rejected || e.triangle != m_drawnAs) return;
    m_tally.tileRejected += e.box.area();
    if (m_wasRejected) return;
    Event event = begin(Happening::TileRejected, m_steps.of(e), Grain::Query);
    event.tile  = e;
    event.depth = e.nearest;
    noteOnce(std::move(event), m_wasRejected);
}

void TriangleHistory::observe(const PixelTested& e)
{
    if (e.triangle != m_drawnAs) return;
    const bool inPrepass = e.keep == Keep::DepthOnly;
    ++(inPrepass ? m_tally.prepassTested : m_tally.tested);
    if (e.won) ++(inPrepass ? m_tally.prepassPassed : m_tally.passed);
    const Happening happening = happeningOf(e);
    bool&           noted     = happening == Happening::Discarded ? m_wasDiscarded
                                : !e.won                          ? m_hasLost
                                : inPrepass                       ? m_wonInPrepass
                                                                  : m_hasWon;
    if (noted || (inPrepass && !e.won)) return;
    Event event      = begin(happening, m_steps.of(e), Grain::Pixel);
    event.isPrepass  = inPrepass;
    event.depth      = e.depth;
    event.rival      = rivalOf(e);
    event.rivalDepth = e.rivalDepth;
    if (e.moved) event.unmovedDepth = e.unmovedDepth;
    event.pixel = PixelPosition{e.x, e.y};
    noteOnce(std::move(event), noted);
}

void TriangleHistory::observe(const plain::IntervalDecided& e)
{
    if (!e.winner) return;
    const auto mine =
        std::ranges::find_if(e.open, [&](std::uint32_t part) { return e.polygons[part].id == m_drawnAs; });
    if (mine == e.open.end()) return;
    const bool won = e.winner->id == m_drawnAs;
    (won ? m_tally.intervalWon : m_tally.intervalLost) += static_cast<std::uint64_t>(e.x1 - e.x0);
    if (won ? m_hadInterval : m_lostInterval) return;
    Event event    = begin(won ? Happening::IntervalWon : Happening::IntervalLost, m_steps.of(e), Grain::Interval);
    event.depth    = depthOf(e.polygons[*mine].depth, e.x0, e.y);
    event.interval = PixelBox{e.x0, e.y, e.x1, e.y + 1};
    event.reason   = e.reason;
    if (!won) event.rival = e.winner->id, event.rivalDepth = depthOf(e.winner->depth, e.x0, e.y);
    noteOnce(std::move(event), won ? m_hadInterval : m_lostInterval);
}

}  // namespace zscope
