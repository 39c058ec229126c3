// Enters polygons in the edge table: triangles of a list several side by side, anything else one by one.
//
// Positions  one multiplication by 1/dy finds where an edge meets its first line, and what is added on every line (LineCrossing says
//            how exact that is)
// Lanes      the same side of neighbouring triangles; what is stored in the table is stored one by one
// Cost       one division per side, and storing it
#if defined(ZSCOPE_ENTER_EDGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_ENTER_EDGES_INL_H
#undef ZSCOPE_ENTER_EDGES_INL_H
#else
#define ZSCOPE_ENTER_EDGES_INL_H
#endif

#include <algorithm>
#include <array>
#include <span>

#include <hwy/highway.h>

#include "core/geometry/edge_steps-inl.h"
#include "core/geometry/triangle_list.h"
#include "core/sweep/edge_table.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Edges that run from their top down, corners on the snapped grid.
template <class V>
struct Falling {
    V xTop, yTop, xBottom, yBottom;
};

/// Positions and steps of LineCrossings.
template <class D>
struct Crossings {
    hn::Vec<hn::RebindToSigned<D>> x, step;
};

/// Without its fraction; below 2^51 on either side of 0. Where the machine has no such instruction, Highway 1.0.3 takes some thirty.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> truncated(D d, V value)
{
    const hn::RebindToSigned<D> i64;
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_SCALAR
    (void)d;
    return hn::ConvertTo(i64, value);
#else
    const V ones = hn::Set(d, 0x1.8p52);  // among numbers as large as this the lowest bit counts ones
    return hn::BitCast(i64, hn::Trunc(value) + ones) - hn::BitCast(i64, ones);
#endif
}

/// value / by in units of a LineCrossing, by at most one unit (two in the lowest bit) too large, and `more` subpixels. Values are
/// whole numbers that float64 holds; `inverse` is 1 / by.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> inUnits(D d, V value, V by, V inverse, V more)
{
    const hn::RebindToSigned<D> i64;
    // The quotient may be one off, or is the next towards zero; what remains of the value is exact in any case.
    const V whole = hn::Trunc(value * inverse);
    const V rest  = value - whole * by;
    // Two wholes more, so that what is cut off is a rounding down; and one unit, so that it is up.
    const V two  = hn::Set(d, 2);
    const auto part = truncated(d, (rest * inverse + two) * hn::Set(d, 0x1p31)) + hn::Set(i64, 1);
    return hn::ShiftLeft<LineCrossing::kShift>(truncated(d, whole + more - two)) + hn::ShiftLeft<1>(part);
}

/// Where edges meet the centres of `line`, one each, which they cross. Inside the guard band, and lower than kTallest. `opens`: the
/// left edges of their triangles.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Crossings<D> crossingsOf(D d, const Falling<V>& edge, V line, hn::Mask<D> opens)
{
    const hn::RebindToSigned<D> i64;
    const V    pixel = hn::Set(d, kSubpixels), dx = edge.xBottom - edge.xTop;
    const V    dy      = hn::Max(edge.yBottom - edge.yTop, hn::Set(d, 1));  // of those that cross no line, too
    const V    inverse = hn::Set(d, 1) / dy;
    const V    down    = line * pixel + hn::Set(d, 128) - edge.yTop;
    const auto bias    = hn::IfThenElse(hn::RebindMask(i64, opens), hn::Set(i64, 3 - LineCrossing::kToPixel), hn::Set(i64, 2 - LineCrossing::kToPixel));
    return {inUnits(d, dx * down, dy, inverse, edge.xTop) + bias, inUnits(d, dx * pixel, dy, inverse, hn::Zero(d))};
}

/// Enters polygons, of which `rules` tell the lines.
template <class Rules>
class EdgeEntry {
public:
    EdgeEntry(EdgeTable& table, const Rules& rules) : m_table(table), m_rules(rules) {}

    /// They must have been set up for the lines of the table.
    void operator()(const TriangleList& triangles) const
    {
        m_table.reserve(triangles.count, 3 * triangles.count);
        if constexpr (Rules::kExact) {
            for (std::size_t i = 0; i < triangles.count; i += hn::Lanes(D())) several(triangles, i);
        } else {
            for (std::size_t i = 0; i < triangles.count; ++i) one(triangles[i]);
        }
    }
    /// `sides` are closed, however often they cross.
    void operator()(const ScreenFace& face, std::span<const ScreenSide> sides) const
    {
        m_table.reserve(1, sides.size());
        const Inside rule = face.isMended ? Inside::EvenOdd : Inside::AnyWinding;
        enter(SweepPolygon{face.depth, face.id, face.patterned}, rule, face.wide, sides, face.top);
    }

private:
    using D   = hn::ScalableTag<double>;
    using One = hn::CappedTag<double, 1>;

    static constexpr std::size_t kMost = hn::MaxLanes(D());
    template <class T>
    using Lanes = std::array<T, kMost>;

    /// The triangles from `at` on, as many as there are lanes.
    HWY_ATTR void several(const TriangleList& triangles, std::size_t at) const
    {
        const D d;
        const hn::Rebind<std::int32_t, D> i32;
        HWY_ALIGN std::array<Lanes<std::int64_t>, 3> x, step;
        HWY_ALIGN std::array<Lanes<double>, 3>       first, end;
        HWY_ALIGN Lanes<double>                      tallest;
        auto                                         most = hn::Zero(d);
        const auto isCompact = hn::PromoteTo(d, hn::And(hn::LoadU(i32, &triangles.kind[at]), hn::Set(i32, TriangleList::kCompact))) > hn::Zero(d);
        const auto start     = hn::LoadU(i32, &triangles.start[at]);
        const auto from      = [&](auto pixels, auto subpixels, const TriangleList::Column<double>& other) HWY_ATTR {
            return hn::IfThenElse(isCompact, hn::PromoteTo(d, hn::ShiftLeft<8>(pixels) + hn::Set(i32, 128) + subpixels), hn::LoadU(d, &other[at]));
        };
        const auto xOf = [&](std::size_t k) HWY_ATTR { return from(lowerHalf(start), lowerHalf(hn::LoadU(i32, &triangles.corner[k][at])), triangles.x[k]); };
        const auto yOf = [&](std::size_t k) HWY_ATTR { return from(upperHalf(start), upperHalf(hn::LoadU(i32, &triangles.corner[k][at])), triangles.y[k]); };
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t to = k < 2 ? k + 1 : 0;
            const auto xa = xOf(k), ya = yOf(k), xb = xOf(to), yb = yOf(to);
            const auto runsDown = ya < yb;
            const Falling<hn::Vec<D>> edge{hn::IfThenElse(runsDown, xa, xb), hn::Min(ya, yb), hn::IfThenElse(runsDown, xb, xa), hn::Max(ya, yb)};
            const auto top = hn::Max(firstLineFrom(edge.yTop), hn::Set(d, m_table.firstLine()));
            const auto crossings = crossingsOf(d, edge, top, hn::Not(runsDown));
            hn::Store(crossings.x, hn::RebindToSigned<D>(), x[k].data());
            hn::Store(crossings.step, hn::RebindToSigned<D>(), step[k].data());
            hn::Store(top, d, first[k].data());
            hn::Store(hn::Min(firstLineFrom(edge.yBottom), hn::Set(d, m_table.endLine())), d, end[k].data());
            most = hn::Max(most, edge.yBottom - edge.yTop);
        }
        hn::Store(most, d, tallest.data());

        const std::size_t count = std::min(hn::Lanes(d), triangles.count - at);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const std::size_t i = at + lane;
            if ((triangles.kind[i] & TriangleList::kWide) != 0 || tallest[lane] >= static_cast<double>(LineCrossing::kTallest)) {
                one(triangles[i]);
                continue;
            }
            const std::uint32_t part = m_table.add(SweepPolygon{{triangles.a[i], triangles.b[i], triangles.c[i], triangles.farthest[i], triangles.nearest[i]},
                                                                triangles.id(i), (triangles.kind[i] & TriangleList::kPatterned) != 0});
            for (std::size_t k = 0; k < 3; ++k) {
                if (!(first[k][lane] < end[k][lane])) continue;
                const std::size_t to = k < 2 ? k + 1 : 0;
                const std::uint32_t side = m_table.add(ScreenSide{triangles.cornerX(k, i), triangles.cornerY(k, i), triangles.cornerX(to, i), triangles.cornerY(to, i)}, false);
                m_table.add(ActiveEdge(LineCrossing(x[k][lane], step[k][lane]), part, static_cast<int>(end[k][lane]) - 1, side,
                                       ActiveEdge::windingOf(Inside::EvenOdd, true)),
                            static_cast<int>(first[k][lane]));
            }
        }
    }

    static hn::Vec<D> firstLineFrom(hn::Vec<D> y) { return hn::Floor((y + hn::Set(D(), 127)) * hn::Set(D(), 1 / kSubpixels)); }

    void one(const ScreenTriangle& part) const
    {
        const auto &x = part.x, &y = part.y;
        const std::array<ScreenSide, 3> sides{{{x[0], y[0], x[1], y[1]}, {x[1], y[1], x[2], y[2]}, {x[2], y[2], x[0], y[0]}}};
        enter(SweepPolygon{part.depth, part.id, part.patterned}, Inside::EvenOdd, part.wide, sides, std::min({y[0], y[1], y[2]}));
    }

    HWY_ATTR void enter(const SweepPolygon& polygon, Inside rule, bool wide, std::span<const ScreenSide> sides, double top) const
    {
        const One           d;
        const std::uint32_t part = m_table.add(polygon);
        for (const ScreenSide& side : sides) {
            const auto [first, end] = m_table.linesOf(side, top, m_rules);
            if (first >= end) continue;
            const bool          runsDown = side.ya < side.yb, isWide = wide || ActiveEdge::isTooTall(side);
            const std::uint32_t winding  = ActiveEdge::windingOf(rule, runsDown);
            const std::uint32_t place    = m_table.add(side, isWide);
            if (isWide) {
                m_table.add(ActiveEdge(side, part, first, end - 1, place, winding), first);
                continue;
            }
            const auto set = [d](double value) HWY_ATTR { return hn::Set(d, value); };
            const Falling<hn::Vec<One>> edge{set(runsDown ? side.xa : side.xb), set(std::min(side.ya, side.yb)), set(runsDown ? side.xb : side.xa),
                                             set(std::max(side.ya, side.yb))};
            const auto crossings = crossingsOf(d, edge, set(first), set(side.ya) > set(side.yb));
            m_table.add(ActiveEdge(LineCrossing(hn::GetLane(crossings.x), hn::GetLane(crossings.step)), part, end - 1, place, winding), first);
        }
    }

    EdgeTable&   m_table;
    const Rules& m_rules;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_ENTER_EDGES_INL_H
