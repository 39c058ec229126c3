#include "core/scene/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace zscope {

namespace {

bool before(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// For p on the line through a and b: strictly between them?
bool strictlyBetween(const Point2& p, const Point2& a, const Point2& b)
{
    return (before(a, p) && before(p, b)) || (before(b, p) && before(p, a));
}

/// Newell normal. Differences to the first corner keep it exact far from the origin; where they leave the range of
/// float64 the polygon is made smaller first.
dvec3 newellNormal(std::span<const dvec3> positions, std::span<const std::uint32_t> outline, double scale)
{
    const dvec3 origin = positions[outline.front()] * scale;
    dvec3       sum{0.0};
    dvec3       p = positions[outline.back()] * scale - origin;
    for (const std::uint32_t corner : outline) {
        const dvec3 q = positions[corner] * scale - origin;
        sum.x += (p.y - q.y) * (p.z + q.z);
        sum.y += (p.z - q.z) * (p.x + q.x);
        sum.z += (p.x - q.x) * (p.y + q.y);
        p = q;
    }
    return sum;
}

/// The power of two that brings the largest coordinate near one.
double scaleToOne(std::span<const dvec3> positions, std::span<const std::uint32_t> outline)
{
    double largest = 0;
    for (const std::uint32_t corner : outline) {
        const dvec3& p = positions[corner];
        largest        = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    return largest > 0 ? std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1022, 1022)) : 1.0;
}

}  // namespace

Outline::Shape Outline::project(std::span<const dvec3> positions, std::span<const std::uint32_t> outline)
{
    m_ring.clear();
    m_repeats.clear();
    dvec3      normal   = newellNormal(positions, outline, 1.0);
    const auto tooSmall = [](const dvec3& n) {
        return std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}) < 1e-280;
    };
    if (!isFinite(normal) || tooSmall(normal))
        normal = newellNormal(positions, outline, scaleToOne(positions, outline));
    const double nx = std::fabs(normal.x), ny = std::fabs(normal.y), nz = std::fabs(normal.z);
    if (!(nx > 0 || ny > 0 || nz > 0)) return Shape::NoArea;

    // The plane's axes follow the dropped one in the order x, y, z, x.
    const int  dropped = nx >= ny && nx >= nz ? 0 : ny >= nz ? 1 : 2;
    const int  first   = (dropped + 1) % 3;
    const int  second  = (dropped + 2) % 3;
    const auto flat = [&](std::uint32_t corner) { return Point2{positions[corner][first], positions[corner][second]}; };
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const RingCorner    corner{flat(outline[i]), outline[i]};
        const std::uint32_t after = outline[(i + 1) % outline.size()];
        const bool          last  = i + 1 == outline.size();
        const bool          isRepeated =
            !m_ring.empty()
            && (corner.at == m_ring.back().at || (last && m_ring.size() > 1 && corner.at == m_ring.front().at));
        if (isRepeated)
            m_repeats.push_back({m_ring.back().vertex, corner.vertex, after});
        else
            m_ring.push_back(corner);
    }
    return shape();
}

/// Convex: all turns alike, and left-to-right changes into right-to-left and back just once.
Outline::Shape Outline::shape() const
{
    const std::size_t n = m_ring.size();
    if (n < 3) return Shape::NoArea;
    int  turns[2] = {0, 0};  // right, left
    int  changes  = 0;
    bool forwards = before(m_ring[n - 1].at, m_ring[0].at);
    for (std::size_t i = 0; i < n; ++i) {
        const Point2& a    = m_ring[i == 0 ? n - 1 : i - 1].at;
        const Point2& b    = m_ring[i].at;
        const Point2& c    = m_ring[i + 1 == n ? 0 : i + 1].at;
        const int     turn = orientation(a, b, c);
        if (turn != 0) turns[turn > 0] = 1;
        const bool next = before(b, c);
        changes += next != forwards;
        forwards = next;
    }
    if (turns[0] == 0 && turns[1] == 0) return Shape::NoArea;
    return turns[0] + turns[1] == 1 && changes == 2 ? Shape::Convex : Shape::Other;
}

Outline::Turning Outline::untangle()
{
    if (!findContacts()) return Turning::Tangled;
    insertContacts();
    const Turning turning = placesCoincide() ? windingOfPlaces() : turningOfSimpleRing();
    if (turning == Turning::Clockwise)
        for (RingCorner& corner : m_ring) std::swap(corner.at.x, corner.at.y);
    return turning;
}

/// False if two edges cross, or if there are far more contacts than any outline made on purpose has.
bool Outline::findContacts()
{
    const std::size_t n = m_ring.size();
    m_contacts.clear();
    m_points.clear();
    for (const RingCorner& corner : m_ring) m_points.push_back(corner.at);
    m_edges.buildOverEdges(m_points);
    const auto edgeAt = [&](std::size_t i) { return std::array{m_points[i], m_points[i + 1 == n ? 0 : i + 1]}; };

    const std::size_t limit = 4 * n + 64;
    for (std::size_t i = 0; i < n; ++i) {
        const Point2 a = edgeAt(i)[0], b = edgeAt(i)[1];  // not bindings: clang 14 cannot capture those
        const bool   isTangled = m_edges.anyNear(Segment2{{a, b}}, [&](std::size_t j) {
            if (j <= i) return false;  // each pair once
            const auto [c, d] = edgeAt(j);
            const int ofC = orientation(a, b, c), ofD = orientation(a, b, d);
            if (ofC * ofD > 0) return false;
            const int ofA = orientation(c, d, a), ofB = orientation(c, d, b);
            if (ofA * ofB > 0) return false;
            if (ofC * ofD < 0 && ofA * ofB < 0) return true;
            const auto note = [&](int side, std::size_t edgeIndex, std::size_t corner, const Point2& from,
                                  const Point2& to) {
                if (side == 0 && strictlyBetween(m_points[corner], from, to))
                    m_contacts.push_back({static_cast<std::uint32_t>(edgeIndex), static_cast<std::uint32_t>(corner)});
            };
            note(ofC, i, j, a, b);
            note(ofD, i, j + 1 == n ? 0 : j + 1, a, b);
            note(ofA, j, i, c, d);
            note(ofB, j, i + 1 == n ? 0 : i + 1, c, d);
            return m_contacts.size() > limit;
        });
        if (isTangled) return false;
    }
    return true;
}

void Outline::insertContacts()
{
    if (m_contacts.empty()) return;
    const auto along = [this](const Contact& l, const Contact& r) {
        if (l.edge != r.edge) return l.edge < r.edge;
        const Point2& p = m_ring[l.corner].at;
        const Point2& q = m_ring[r.corner].at;
        if (p == q) return l.corner < r.corner;
        const bool forwards = before(m_ring[l.edge].at, m_ring[l.edge + 1 == m_ring.size() ? 0 : l.edge + 1].at);
        return before(p, q) == forwards;
    };
    std::sort(m_contacts.begin(), m_contacts.end(), along);
    m_longer.clear();
    std::size_t contact = 0;
    for (std::size_t edge = 0; edge < m_ring.size(); ++edge) {
        m_longer.push_back(m_ring[edge]);
        for (; contact < m_contacts.size() && m_contacts[contact].edge == edge; ++contact) {
            const RingCorner& corner = m_ring[m_contacts[contact].corner];
            if (corner.at != m_longer.back().at) m_longer.push_back(corner);
        }
    }
    m_ring.swap(m_longer);
}

/// Numbers the positions from left to right; says whether two corners share one.
bool Outline::placesCoincide()
{
    m_order.resize(m_ring.size());
    std::iota(m_order.begin(), m_order.end(), 0u);
    std::sort(m_order.begin(), m_order.end(), [this](std::uint32_t l, std::uint32_t r) {
        return m_ring[l].at == m_ring[r].at ? l < r : before(m_ring[l].at, m_ring[r].at);
    });
    m_place.resize(m_ring.size());
    m_placeAt.clear();
    for (const std::uint32_t corner : m_order) {
        if (m_placeAt.empty() || m_ring[corner].at != m_placeAt.back()) m_placeAt.push_back(m_ring[corner].at);
        m_place[corner] = static_cast<std::uint32_t>(m_placeAt.size() - 1);
    }
    return m_placeAt.size() != m_ring.size();
}

/// No crossing, no contact, no shared place: the leftmost corner, which sticks out, tells the way round.
Outline::Turning Outline::turningOfSimpleRing() const
{
    const std::size_t n = m_ring.size();
    const std::size_t i = m_order.front();
    const int turn = orientation(m_ring[i == 0 ? n - 1 : i - 1].at, m_ring[i].at, m_ring[i + 1 == n ? 0 : i + 1].at);
    if (turn == 0) return Turning::Tangled;
    return turn > 0 ? Turning::CounterClockwise : Turning::Clockwise;
}

Outline::Turning Outline::windingOfPlaces()
{
    const std::size_t n      = m_ring.size();
    const std::size_t places = m_placeAt.size();
    m_firstRay.assign(places + 1, 0);
    for (const std::uint32_t place : m_place) m_firstRay[place + 1] += 2;
    std::partial_sum(m_firstRay.begin(), m_firstRay.end(), m_firstRay.begin());
    m_rays.resize(2 * n);
    std::vector<std::uint32_t> free(m_firstRay.begin(), m_firstRay.end() - 1);
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint32_t from = m_place[i], to = m_place[i + 1 == n ? 0 : i + 1],
                            edge = static_cast<std::uint32_t>(i);
        m_rays[free[from]++]     = {to, edge, true};
        m_rays[free[to]++]       = {from, edge, false};
    }
    m_leftOfEdge.assign(n, 0);
    m_settled.assign(places, 0);
    int lowest = 0, highest = 0;

    // Sorts the rays of a place counter-clockwise from straight down, and gives every sector its winding, knowing
    // that of the sector clockwise of the ray of `arrival` (or, at the leftmost place, that to the left is outside).
    const auto settle = [&](std::uint32_t place, const std::uint32_t* arrival) {
        m_settled[place]     = 1;
        const Point2& centre = m_placeAt[place];
        const auto    rays   = std::span(m_rays).subspan(m_firstRay[place], m_firstRay[place + 1] - m_firstRay[place]);
        std::sort(rays.begin(), rays.end(), [&](const Ray& l, const Ray& r) {
            const bool lRight = l.to > place, rRight = r.to > place;  // places are numbered from left to right
            if (lRight != rRight) return lRight;
            if (l.to != r.to) return orientation(centre, m_placeAt[l.to], m_placeAt[r.to]) > 0;
            return l.edge != r.edge ? l.edge < r.edge : l.outgoing < r.outgoing;
        });
        int start = 0;  // winding of the sector before the first ray
        if (arrival) {
            int sum = 0, sumBeforeGroup = 0;
            for (std::size_t k = 0; k < rays.size(); ++k) {
                if (k == 0 || rays[k].to != rays[k - 1].to) sumBeforeGroup = sum;
                if (rays[k].edge == *arrival && !rays[k].outgoing) {
                    start = m_leftOfEdge[*arrival] - sumBeforeGroup;
                    break;
                }
                sum += rays[k].outgoing ? 1 : -1;
            }
        }
        int winding = start;
        for (std::size_t k = 0; k < rays.size();) {
            std::size_t end = k;
            for (; end < rays.size() && rays[end].to == rays[k].to; ++end) winding += rays[end].outgoing ? 1 : -1;
            for (; k < end; ++k)
                if (rays[k].outgoing) m_leftOfEdge[rays[k].edge] = winding;
            lowest  = std::min(lowest, winding);
            highest = std::max(highest, winding);
        }
    };
    const std::uint32_t start = m_order.front();
    settle(m_place[start], nullptr);
    for (std::size_t step = 0; step < n; ++step) {
        const auto          edge = static_cast<std::uint32_t>((start + step) % n);
        const std::uint32_t to   = m_place[edge + 1 == n ? 0 : edge + 1];
        if (!m_settled[to]) settle(to, &edge);
    }
    if (lowest == 0 && highest == 1) return Turning::CounterClockwise;
    if (lowest == -1 && highest == 0) return Turning::Clockwise;
    return Turning::Tangled;
}

}  // namespace zscope
