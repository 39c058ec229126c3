#include "core/lesson/explain_recorders.h"

#include <algorithm>

#include "core/lesson/explain_sentences.h"

namespace zscope {

NodeName nameOf(const NodePlace& place)
{
    return {place.isInstanceTree ? std::nullopt : std::optional(place.instance), pathOf(place.node)};
}

Event Histories::eventOf(const Outcome& outcome, Meaning meaning) const
{
    Event event{outcome, std::move(meaning)};
    event.moment    = m_steps.of(*m_heard);
    event.grain     = grainAtHand();
    event.isPrepass = m_isPrepass;
    event.pass      = m_pass;
    return event;
}

Event Histories::eventOf(const TriangleSetUp& e, TriangleId polygon) const
{
    const bool isDrawn = e.fate == SetUp::Drawn;
    Meaning    meaning;
    if (e.fate == SetUp::BackFacing) meaning.fate = fates::kBackFace;
    if (e.fate == SetUp::ClippedAway) meaning.fate = fates::kNearClip;
    meaning.values         = {{"set_up", std::string(wordOf(e.fate))}, {"cut", e.cut}};
    const InstanceId owner = m_scene.instanceOf(e.triangle);
    meaning.sentence = sentenceOf(e, m_telling.nameOf(polygon), m_scene.instances[owner.value].toWorld.isMirrored());
    Event event      = eventOf({.word = kSetUpWord, .effect = isDrawn ? Effect::Passes : Effect::Ends, .isOfAll = true},
                               std::move(meaning));
    event.isUsual    = isDrawn && !e.cut;
    return event;
}

PixelHistories::PixelHistories(const Scene& scene, int width, int height, std::span<const PixelPosition> pixels,
                               const std::vector<std::vector<PixelCover>>& covers, bool byFace,
                               const StepCounter& steps, const Telling& telling)
    : Histories(scene, byFace, steps, telling), m_place(width, height, -1),
      m_hasPixels(static_cast<std::size_t>(height), 0)
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

void PixelHistories::note(History& history, std::size_t candidate, Event event)
{
    if (history.met[candidate] == kNever) history.met[candidate] = m_clock++;
    history.candidates[candidate].events.push_back(std::move(event));
}

template <class Visit>
void PixelHistories::forEachIn(const PixelBox& box, const Visit& visit)
{
    for (int y = box.y0; y < box.y1; ++y) {
        if (!m_hasPixels[static_cast<std::size_t>(y)]) continue;
        for (int x = box.x0; x < box.x1; ++x)
            if (const std::int32_t place = m_place.at(x, y); place >= 0)
                visit(m_histories[static_cast<std::size_t>(place)], PixelPosition{x, y});
    }
}

template <class Visit>
void PixelHistories::forEachOf(TriangleId triangle, const PixelBox* box, const Visit& visit)
{
    const std::pair<std::uint32_t, std::uint32_t> from(triangle.value, 0);
    for (auto at = std::lower_bound(m_where.begin(), m_where.end(), from);
         at != m_where.end() && at->first == triangle.value; ++at) {
        if (box && !box->holds(m_pixels[at->second])) continue;
        History&    history = m_histories[at->second];
        const Range range   = rangeOf(history, m_byFace ? m_scene.firstOfFace(triangle) : triangle);
        for (std::size_t i = range.first; i < range.end; ++i)
            if (history.candidates[i].triangle == triangle) visit(history, i, m_pixels[at->second]);
    }
}

bool PixelHistories::asksAbout(const PixelBox& pixels) const
{
    for (int y = pixels.y0; y < pixels.y1; ++y) {
        if (!m_hasPixels[static_cast<std::size_t>(y)]) continue;
        for (int x = pixels.x0; x < pixels.x1; ++x)
            if (m_place.at(x, y) >= 0) return true;
    }
    return false;
}

bool PixelHistories::isMet(TriangleId triangle) const
{
    return std::binary_search(m_ids.begin(), m_ids.end(), triangle.value);
}

void PixelHistories::of(TriangleId polygon, const PixelBox& pixels, const Outcome& outcome, const Make& make)
{
    if (outcome.effect == Effect::Passes || !counts(outcome.effect)) return;
    const auto noteAt = [&](History& history, std::size_t candidate, PixelPosition at) {
        Event event  = eventOf(outcome, make(polygon, at));
        event.pixels = event.pixels.value_or(pixels);
        note(history, candidate, std::move(event));
    };
    // What is tested at a pixel is there, whatever the definition says.
    if (isTest(outcome.effect))
        forEachIn(pixels, [&](History& history, PixelPosition at) {
            const Range range = rangeOrNew(history, polygon);
            for (std::size_t i = range.first; i < range.end; ++i) noteAt(history, i, at);
        });
    else if (m_byFace)
        forEachIn(pixels, [&](History& history, PixelPosition at) {
            const Range range = rangeOf(history, polygon);
            for (std::size_t i = range.first; i < range.end; ++i) noteAt(history, i, at);
        });
    else if (isMet(polygon))
        forEachOf(polygon, &pixels, noteAt);
}

void PixelHistories::below(const NodePlace& place, const Outcome& outcome, const Make& make, const PixelBox* pixels)
{
    if (outcome.effect == Effect::Passes || !counts(outcome.effect)) return;
    forEachBelow(m_scene, place, m_ids, [&](std::uint32_t id) {
        forEachOf(TriangleId{id}, pixels, [&](History& history, std::size_t candidate, PixelPosition at) {
            Event event = eventOf(outcome, make(history.candidates[candidate].drawnAs, at));
            event.node  = nameOf(place);
            note(history, candidate, std::move(event));
        });
    });
}

void PixelHistories::remark(const PixelBox& pixels, const Remark& make)
{
    forEachIn(pixels, [&](History& history, PixelPosition) { history.remark = make(); });
}

void PixelHistories::setUp(const TriangleSetUp& e)
{
    if (!isMet(e.triangle)) return;
    forEachOf(e.triangle, nullptr, [&](History& history, std::size_t candidate, PixelPosition) {
        Event event = eventOf(e, history.candidates[candidate].drawnAs);
        if (!m_holder.path.empty()) event.node = m_holder;
        note(history, candidate, std::move(event));
    });
}

TriangleHistory::TriangleHistory(const Scene& scene, TriangleId triangle, bool byFace, const StepCounter& steps,
                                 const Telling& telling)
    : Histories(scene, byFace, steps, telling), m_triangle(triangle),
      m_drawnAs(byFace ? scene.firstOfFace(triangle) : triangle), m_instance(scene.instanceOf(triangle))
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

void TriangleHistory::note(Event event)
{
    if (m_events.size() < TriangleExplanation::kMostEvents)
        m_events.push_back(std::move(event));
    else
        ++m_leftOut;
}

void TriangleHistory::count(const PixelBox& pixels, const Outcome& outcome)
{
    if (outcome.effect == Effect::Wins && !m_isPrepass) m_tally.won += pixels.area();
    for (const std::string_view name : outcome.countedAs) {
        if (name.empty()) continue;
        const auto known = std::ranges::find(m_tally.counted, name, &std::pair<std::string_view, std::uint64_t>::first);
        if (known == m_tally.counted.end())
            m_tally.counted.emplace_back(name, pixels.area());
        else
            known->second += pixels.area();
    }
}

void TriangleHistory::of(TriangleId polygon, const PixelBox& pixels, const Outcome& outcome, const Make& make)
{
    if (polygon != m_drawnAs || outcome.effect == Effect::Overtaken || !counts(outcome.effect)) return;
    count(pixels, outcome);
    if (m_isPrepass && outcome.effect != Effect::Wins) return;
    if (!isToBeNoted(outcome)) return;
    const PixelPosition at{pixels.x0, pixels.y0};
    Event               event = eventOf(outcome, make(polygon, at));
    event.pixels              = event.pixels.value_or(pixels);
    if (event.grain == Grain::Pixel) event.pixel = at;
    note(std::move(event));
}

bool TriangleHistory::isToBeNoted(const Outcome& outcome)
{
    if (outcome.isOfAll) return true;
    const std::pair key(outcome.word, m_isPrepass);
    if (std::ranges::find(m_noted, key) != m_noted.end()) return false;
    m_noted.push_back(key);
    return true;
}

void TriangleHistory::below(const NodePlace& place, const Outcome& outcome, const Make& make, const PixelBox* pixels)
{
    if (!counts(outcome.effect) || !holds(place)) return;
    if (pixels) count(*pixels, outcome);
    if (!isToBeNoted(outcome)) return;
    Event event = eventOf(outcome, make(m_drawnAs, pixels ? PixelPosition{pixels->x0, pixels->y0} : PixelPosition()));
    event.node  = nameOf(place);
    note(std::move(event));
}

void TriangleHistory::setUp(const TriangleSetUp& e)
{
    if (e.triangle == m_triangle) note(eventOf(e, m_drawnAs));
}

}  // namespace zscope
