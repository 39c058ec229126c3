#include "core/method/intervals.h"

#include <algorithm>
#include <bit>

#include "core/method/scanline.h"
#include "core/plain/depth_test.h"

namespace zscope::plain {

namespace {

constexpr std::uint32_t kLead  = 2;    // float32 steps by which a leader must be nearer
constexpr std::size_t   kCrowd = 256;  // with more polygons open at once a z-buffer is cheaper

struct Leader {
    const Polygon* polygon;  // nullptr: none leads for certain
    IntervalReason reason;
};

/// A polygon's depth at an end of an interval: clamped and rounded as the picture stores it.
struct EndDepth {
    float depth;
    bool  clamped;  // to the depths of the polygon's corners: the plane lies beyond them there
};

EndDepth depthAt(const DepthPlane& plane, int x, int y, const ChosenRules& rules)
{
    const double z    = plane.a * (x + 0.5) + (plane.b * (y + 0.5) + plane.c);
    const double kept = std::min(std::max(z, double{plane.farthest}), double{plane.nearest});
    return {rules.stored(kept), kept != z};
}

/// Whether `near` is nearer by more than kLead steps. A larger depth is nearer (it is near/z); depths are not negative,
/// so their bits are in order.
bool leads(float near, float far)
{
    return std::bit_cast<std::uint32_t>(near) > std::bit_cast<std::uint32_t>(far) + kLead;
}

/// The polygon that leads all other open ones all over [x0, x1), if one does for certain.
Leader leaderOf(const Work& work, int y, int x0, int x1)
{
    const auto  polygons = work.scratch.edges.polygons();
    const auto& open     = work.scratch.open;
    const float empty    = work.stripe.visible.empty();
    const auto  endDepth = [&](const Polygon& polygon, int x) { return depthAt(polygon.depth, x, y, work.rules); };
    if (!work.rules.comparesByEnds()) return {nullptr, IntervalReason::NotByEnds};  // an approximation

    const Polygon* best = &polygons[open[0]];
    for (const std::uint32_t index : open)
        if (endDepth(polygons[index], x0).depth > endDepth(*best, x0).depth) best = &polygons[index];
    if (best->patterned) return {nullptr, IntervalReason::HasPattern};
    const EndDepth left = endDepth(*best, x0), right = endDepth(*best, x1 - 1);
    const bool     isKept = left.depth > empty && right.depth > empty;  // the far test
    if (open.size() == 1)
        return isKept ? Leader{best, IntervalReason::Alone} : Leader{nullptr, IntervalReason::BeyondFar};
    if (work.rules.testsIntervalOnce()) return {best, IntervalReason::TestedOnce};  // a fault
    if (left.clamped || right.clamped) return {nullptr, IntervalReason::DepthLimited};
    if (!isKept) return {nullptr, IntervalReason::BeyondFar};
    for (const std::uint32_t index : open) {
        const Polygon& rival = polygons[index];
        if (&rival == best) continue;
        const EndDepth rivalLeft = endDepth(rival, x0), rivalRight = endDepth(rival, x1 - 1);
        if (rivalLeft.clamped || rivalRight.clamped) return {nullptr, IntervalReason::DepthLimited};
        if (!leads(left.depth, rivalLeft.depth) || !leads(right.depth, rivalRight.depth))
            return {nullptr, IntervalReason::NoClearLead};
    }
    return {best, IntervalReason::Leads};
}

/// After a comparison pixel by pixel: one span for each run of pixels that one polygon has won.
void tellRuns(const Work& work, int y, int x0, int x1)
{
    const auto rank = [&](int x) { return work.stripe.visible.rankAt(x, y); };
    for (int x = x0; x < x1;) {
        int end = x + 1;
        while (end < x1 && rank(end) == rank(x)) ++end;
        if (rank(x) != 0) {
            work.tally.add(Unit::Spans);
            work.tell(SpanFilled{.y = y, .x0 = x, .x1 = end, .triangle = TriangleId{rank(x) - 1}, .isInterval = true});
        }
        x = end;
    }
}

void decide(Work& work, int y, int x0, int x1)
{
    const auto   polygons = work.scratch.edges.polygons();
    const Leader leader   = leaderOf(work, y, x0, x1);
    if (leader.polygon) {
        const Pass nearest;
        DepthTest  test(work, nearest, leader.polygon->depth, leader.polygon->id, leader.polygon->patterned);
        test.beginLine(y, x0);
        for (int x = x0; x < x1; ++x) test.store(x);
        work.tally.add(Unit::Spans);
        work.tell(SpanFilled{.y = y, .x0 = x0, .x1 = x1, .triangle = leader.polygon->id, .isInterval = true});
    } else {
        for (const std::uint32_t index : work.scratch.open) offerSpan(work, polygons[index], y, x0, x1);
        tellRuns(work, y, x0, x1);
    }
    work.tell(IntervalDecided{y, x0, x1, work.scratch.open, polygons, leader.polygon, leader.reason});
}

/// An edge opens or closes its polygon, or (a face with a hole) does neither. The winding is Watkins' in/out flag, as a
/// count.
void cross(Work& work, const Edge& edge)
{
    PolygonSpan& span    = work.scratch.active.spanOf(edge.polygon);
    const bool   wasOpen = span.isOpen();
    span.winding += edge.winding;
    if (span.isOpen() == wasOpen) return;
    if (wasOpen)
        std::erase(work.scratch.open, edge.polygon);
    else
        work.scratch.open.push_back(edge.polygon);
}

/// Closes the polygons that a fault left open.
void closeAll(Work& work)
{
    for (const std::uint32_t index : work.scratch.open) work.scratch.active.spanOf(index) = {};
}

/// Goes through the edges of the line once: whether more than kCrowd polygons are open at once. Without a fault every
/// winding is 0 again at the end.
bool isCrowded(Work& work)
{
    std::size_t most = 0;
    if (work.scratch.active.edges().size() <= 2 * kCrowd) return false;  // an open polygon has an edge on either side
    std::size_t open = 0;
    for (const Edge& edge : work.scratch.active.edges()) {
        PolygonSpan& span = work.scratch.active.spanOf(edge.polygon);
        open -= span.isOpen();
        span.winding += edge.winding;
        open += span.isOpen();
        most = std::max(most, open);
    }
    if (open > 0)  // a fault left polygons open
        for (const Edge& edge : work.scratch.active.edges()) work.scratch.active.spanOf(edge.polygon) = {};
    return most > kCrowd;
}

}  // namespace

void resolveByIntervals(Call work, int y)
{
    if (isCrowded(*work)) return resolveByDepth(work, y);
    work->scratch.open.clear();
    int from = 0;
    for (const Edge& edge : work->scratch.active.edges()) {
        const int to = firstPixelRightOf(edge, work->stripe.visible.width(), work->rules);
        if (from < to && !work->scratch.open.empty()) decide(*work, y, from, to);
        from = to;
        cross(*work, edge);
    }
    closeAll(*work);  // without a fault none is open here
}

}  // namespace zscope::plain
