// Resolves a line of the sweep by intervals: between two neighbouring active edges the same polygons are open, so the
// nearest of them is found once for the whole interval, without a z-buffer.
//
// Nearest    judged at both end pixels. Depth is affine along the line, so a polygon that leads every rival by more
//            than kLead float32 steps at both ends, with no depth limited there, leads everywhere between
// Patterns   a polygon that has holes or a relief covers no interval whole, and does not lead: its plane is only the
//            nearest that it can be. As a rival that is what counts
// Crossing   an interval that nobody leads like that (polygons that cross, touch or are equally near) is compared pixel
//            by pixel, which is where the textbook's one test per interval goes wrong
// Promise    the same pixels as LineZBuffer
// Cost       per interval one evaluation per open polygon and end; lines with more than kCrowd polygons open at once
//            are resolved like LineZBuffer, whose cost does not grow with the number of intervals
// Source     Watkins: A Real Time Visible Surface Algorithm, 1970; docs/correctness.md, Rules that make methods exact
#if defined(ZSCOPE_INTERVALS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_INTERVALS_INL_H
#undef ZSCOPE_INTERVALS_INL_H
#else
#define ZSCOPE_INTERVALS_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "core/fast/lanes/depth_test-inl.h"
#include "core/fast/lanes/line_zbuffer-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

template <class Rules>
class Intervals {
public:
    Intervals(VisibilityBuffer& visible, const PatternFinder& patterns, const Rules& rules)
        : m_visible(visible), m_patterns(patterns), m_rules(rules)
    {}

    void line(int y, std::span<const ActiveEdge> active, ActivePolygons& polygons)
    {
        LineZBuffer byPixels(m_visible, m_patterns, m_rules);
        Open        open;
        int         from = 0;
        for (const ActiveEdge& edge : active) {
            const int to = std::clamp(edge.firstPixel(), 0, m_visible.width());
            if (from < to && open.count > 0) resolve(y, from, to, open.view(), polygons);
            from = to;
            if (edge.isShared())
                passShared(polygons, edge, open);
            else
                pass(polygons, edge, edge.polygon(), open);
            if (open.count > kCrowd) {  // seen on the way: what has been stored wins again
                for (const ActiveEdge& passed : active) {
                    polygons.spanOf(passed.polygon()) = {};
                    if (passed.isShared()) polygons.spanOf(passed.opens()) = {};
                }
                return byPixels.line(y, active, polygons);
            }
        }
    }

private:
    static constexpr std::uint32_t kLead  = 2;    // float32 steps
    static constexpr std::size_t   kCrowd = 256;  // polygons

    /// The polygons that are open at a place of the line, by their part of the edge table, in no order.
    struct Open {
        std::array<std::uint32_t, 2 * kCrowd> polygon;  // an unclosed one may leave more than kCrowd
        std::size_t                           count = 0;

        std::span<const std::uint32_t> view() const { return std::span(polygon).first(count); }
    };

    /// A polygon's depth at one pixel: rounded and limited as the picture stores it.
    struct EndDepth {
        float depth;
        bool  limited;
    };

    EndDepth depthAt(const DepthPlane& plane, int x, int y) const
    {
        const double line = lineDepth(plane, y, m_rules);
        const double z    = plane.a * (x + 0.5) + line;
        const double kept = std::min(std::max(z, double{plane.farthest}), double{plane.nearest});
        return {m_rules.stored(kept), kept != z};
    }

    /// True if `near` is more than kLead steps nearer than `far`; depths are not negative, so their bits are ordered.
    static bool leads(float near, float far)
    {
        return std::bit_cast<std::uint32_t>(near) > std::bit_cast<std::uint32_t>(far) + kLead;
    }

    /// An edge has been passed: its polygon opens, or closes, or stays as it is.
    void pass(ActivePolygons& polygons, const ActiveEdge& edge, std::uint32_t polygon, Open& open) const
    {
        ActivePolygons::Span& span    = polygons.spanOf(polygon);
        const bool            wasOpen = span.isOpen();
        if (span.pass(edge) == wasOpen) return;
        if (!wasOpen) {
            span.openAt                = static_cast<int>(open.count);  // where it stands among the open ones
            open.polygon[open.count++] = polygon;
            return;
        }
        const std::uint32_t last                            = open.polygon[--open.count];
        open.polygon[static_cast<std::size_t>(span.openAt)] = last;
        polygons.spanOf(last).openAt                        = span.openAt;
    }

    /// Where one polygon closes and another opens, that one takes the place of the first.
    void passShared(ActivePolygons& polygons, const ActiveEdge& edge, Open& open) const
    {
        ActivePolygons::Span &closes = polygons.spanOf(edge.polygon()), &opens = polygons.spanOf(edge.opens());
        if (!closes.isOpen() || opens.isOpen()) {  // edges that meet there stand the other way round
            pass(polygons, edge, edge.polygon(), open);
            pass(polygons, edge, edge.opens(), open);
            return;
        }
        closes.pass(edge), opens.pass(edge);
        opens.openAt                                         = closes.openAt;
        open.polygon[static_cast<std::size_t>(opens.openAt)] = edge.opens();
    }

    void resolve(int y, int x0, int x1, std::span<const std::uint32_t> open, const ActivePolygons& polygons)
    {
        if (const SweepPolygon* nearest = leaderOf(y, x0, x1, open, polygons)) {
            storeSpan(nearest->depth, nearest->rank(), y, x0, x1, m_visible, m_rules);
        } else {
            for (const std::uint32_t polygon : open)
                testPolygonSpan(polygons[polygon], y, x0, x1, m_visible, m_patterns, m_rules);
        }
    }

    /// The polygon that leads all other open ones all over [x0, x1), if one does for certain; else nullptr.
    const SweepPolygon* leaderOf(int y, int x0, int x1, std::span<const std::uint32_t> open,
                                 const ActivePolygons& polygons) const
    {
        if (!m_rules.comparesByEnds()) return nullptr;
        const SweepPolygon* best = &polygons[open[0]];
        if (open.size() == 1 && !best->patterned && best->depth.farthest > m_visible.empty()) return best;
        EndDepth bestLeft = depthAt(best->depth, x0, y);
        if (open.size() == 1) {
            const bool kept = bestLeft.depth > m_visible.empty() && isKept(*best, y, x1 - 1);
            return kept && !best->patterned ? best : nullptr;
        }
        for (const std::uint32_t polygon : open) {
            const EndDepth left = depthAt(polygons[polygon].depth, x0, y);
            if (left.depth <= bestLeft.depth) continue;
            best     = &polygons[polygon];
            bestLeft = left;
        }
        if (best->patterned) return nullptr;
        const EndDepth bestRight = depthAt(best->depth, x1 - 1, y);
        if (bestLeft.limited || bestRight.limited) return nullptr;
        if (bestLeft.depth <= m_visible.empty() || bestRight.depth <= m_visible.empty()) return nullptr;
        for (const std::uint32_t polygon : open) {
            const SweepPolygon& rival = polygons[polygon];
            if (&rival == best) continue;
            const EndDepth left = depthAt(rival.depth, x0, y), right = depthAt(rival.depth, x1 - 1, y);
            if (left.limited || right.limited) return nullptr;
            if (!leads(bestLeft.depth, left.depth) || !leads(bestRight.depth, right.depth)) return nullptr;
        }
        return best;
    }

    /// The far test at one end; with the other end it holds all over the run, because depth is affine, limited or not.
    bool isKept(const SweepPolygon& polygon, int y, int x) const
    {
        return depthAt(polygon.depth, x, y).depth > m_visible.empty();
    }

    VisibilityBuffer& m_visible;
    PatternFinder     m_patterns;
    const Rules&      m_rules;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_INTERVALS_INL_H
