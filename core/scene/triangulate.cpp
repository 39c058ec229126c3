#include "core/scene/triangulate.h"

#include <algorithm>
#include <cassert>

namespace zscope {

namespace {

void fan(std::span<const std::uint32_t> outline, std::vector<PolygonSplitter::Triangle>& triangles)
{
    for (std::size_t i = 2; i < outline.size(); ++i) triangles.push_back({outline[0], outline[i - 1], outline[i]});
}

}  // namespace

PolygonSplit PolygonSplitter::split(std::span<const dvec3> positions, std::span<const std::uint32_t> outline,
                                    std::vector<Triangle>& triangles)
{
    assert(outline.size() >= 3);
    if (outline.size() == 3) {
        triangles.push_back({outline[0], outline[1], outline[2]});
        return PolygonSplit::Fan;
    }
    const Outline::Shape shape = m_outline.project(positions, outline);
    if (shape == Outline::Shape::Convex) {
        fan(outline, triangles);
        return PolygonSplit::Fan;
    }
    if (shape == Outline::Shape::Other) {
        if (outline.size() > kMaxConcaveCorners) return PolygonSplit::Refused;
        const std::size_t before = triangles.size();
        if (m_outline.untangle() != Outline::Turning::Tangled && cutEars(triangles)) return PolygonSplit::Ears;
        triangles.resize(before);
    }
    fan(outline, triangles);
    return PolygonSplit::MendedFan;
}

// Cuts corner after corner off the ring. A corner may go when it is
//   a spike    its neighbours coincide, or it coincides with one of them: nothing is cut but the spike
//   an ear     it turns left, the chord that closes the gap lies inside the ring where it starts and where it ends,
//              and no other corner lies in the triangle or on its border. Corners at the places of the chord's ends do
//              not count: whatever enters the triangle there also ends in it or leaves through one of its other
//              sides, which are the ring's own. One at the place of the ear itself may leave through the chord, so
//              its edges must not enter
// A cut changes only its two neighbours, which are then looked at again.
bool PolygonSplitter::cutEars(std::vector<Triangle>& triangles)
{
    for (const Outline::Repeat& repeat : m_outline.repeats())
        triangles.push_back({repeat.before, repeat.vertex, repeat.after});

    const std::span<const RingCorner> ring = m_outline.ring();
    const auto                        n    = static_cast<std::uint32_t>(ring.size());
    m_next.resize(n);
    m_previous.resize(n);
    m_points.clear();
    for (std::uint32_t i = 0; i < n; ++i) {
        m_next[i]     = i + 1 == n ? 0 : i + 1;
        m_previous[i] = i == 0 ? n - 1 : i - 1;
        m_points.push_back(ring[i].at);
    }
    m_corners.buildOverCorners(m_points);

    const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return orientation(ring[a].at, ring[b].at, ring[c].at);
    };
    const auto isSpike = [&](std::uint32_t v) {
        const Point2 &a = ring[m_previous[v]].at, &at = ring[v].at, &c = ring[m_next[v]].at;
        return a == c || at == a || at == c;
    };
    const auto isEar = [&](std::uint32_t v) {
        const std::uint32_t a = m_previous[v], c = m_next[v];
        if (turn(a, v, c) <= 0 || isSpike(a) || isSpike(c)) return false;
        // A corner of the ring that turns left sees only what lies between its two edges.
        if (turn(m_previous[a], a, v) > 0 && turn(a, c, m_previous[a]) < 0) return false;
        if (turn(v, c, m_next[c]) > 0 && turn(c, m_next[c], a) < 0) return false;
        const Point2 pa = ring[a].at, pv = ring[v].at, pc = ring[c].at;
        return !m_corners.anyNear(Triangle2{{pa, pv, pc}}, [&](std::size_t other) {
            const Point2& p = ring[other].at;
            if (p == pa || p == pc) return false;
            if (p == pv) {
                const auto enters = [&](std::uint32_t to) {
                    return orientation(pv, pc, ring[to].at) > 0 && orientation(pv, ring[to].at, pa) > 0;
                };
                return other != v && (enters(m_previous[other]) || enters(m_next[other]));
            }
            return orientation(pa, pv, p) >= 0 && orientation(pv, pc, p) >= 0 && orientation(pc, pa, p) >= 0;
        });
    };

    m_queue.resize(n);
    m_waiting.assign(n, 1);
    for (std::uint32_t i = 0; i < n; ++i) m_queue[i] = i;
    std::uint32_t remaining  = n;
    std::uint32_t survivor   = 0;      // some corner that is still in the ring
    bool          cutInRound = false;  // since the queue last held every corner
    const auto    look       = [&](std::uint32_t v) {
        if (m_waiting[v]) return;
        m_waiting[v] = 1;
        m_queue.push_back(v);
    };
    for (std::size_t head = 0; remaining > 3; ++head) {
        if (head == m_queue.size()) {
            // Nothing left to look at: one more round over the whole ring, unless the last one cut nothing.
            if (!cutInRound) return false;
            cutInRound = false;
            m_queue.clear();
            head = 0;
            for (std::uint32_t v = survivor, count = 0; count < remaining; v = m_next[v], ++count) look(v);
        }
        const std::uint32_t v = m_queue[head];
        m_waiting[v]          = 0;
        if (m_next[v] == v) continue;  // cut already
        if (!isSpike(v) && !isEar(v)) continue;
        const std::uint32_t a = m_previous[v], c = m_next[v];
        triangles.push_back({ring[a].vertex, ring[v].vertex, ring[c].vertex});
        m_next[a]     = c;
        m_previous[c] = a;
        m_next[v]     = v;
        m_corners.remove(v);
        --remaining;
        survivor   = a;
        cutInRound = true;
        look(a);
        look(c);
        // A spike next to them had kept their other neighbours waiting.
        look(m_previous[a]);
        look(m_next[c]);
    }
    const std::uint32_t b = m_next[survivor], c = m_next[b];
    if (turn(survivor, b, c) < 0) return false;
    triangles.push_back({ring[survivor].vertex, ring[b].vertex, ring[c].vertex});
    return true;
}

}  // namespace zscope
