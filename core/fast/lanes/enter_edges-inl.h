// Enters polygons in the edge table: triangles of a list several side by side, anything else one by one.
//
// Positions  one multiplication by 1/dy finds where an edge meets its first line, and what is added on every line
//            (LineCrossing says how exact that is)
// Lanes      the same side of neighbouring triangles, up to the row that the table keeps; those that are no edge, or
//            another triangle's, are stored like the others, and the next one over them
// Shared     at full speed a side that two triangles have in common is one edge (SharedSides). Whoever looks on sees
//            each triangle's own
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

#include "core/fast/lanes/edge_steps-inl.h"
#include "core/fast/lanes/lane_order-inl.h"
#include "core/fast/shared_sides/shared_sides.h"
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

/// Without its fraction; below 2^51 on either side of 0. Where the machine has no such instruction, Highway 1.0.3 takes
/// some thirty.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> truncated(D d, V value)
{
    const hn::RebindToSigned<D> i64;
#if HWY_TARGET == HWY_AVX3
    (void)d;
    return hn::ConvertTo(i64, value);
#else
    const V ones = hn::Set(d, 0x1.8p52);  // among numbers as large as this the lowest bit counts ones
    return hn::BitCast(i64, hn::Trunc(value) + ones) - hn::BitCast(i64, ones);
#endif
}

/// value / by in units of a LineCrossing, by at most one unit (two in the lowest bit) too large, and `more` subpixels.
/// Values are whole numbers that float64 holds; `inverse` is 1 / by.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> inUnits(D d, V value, V by, V inverse, V more)
{
    const hn::RebindToSigned<D> i64;
    // The quotient may be one off, or is the next towards zero; what remains of the value is exact in any case.
    const V whole = hn::Trunc(value * inverse);
    const V rest  = value - whole * by;
    // Two wholes more, so that what is cut off is a rounding down; and one unit, so that it is up.
    const V    two  = hn::Set(d, 2);
    const auto part = truncated(d, (rest * inverse + two) * hn::Set(d, 0x1p31)) + hn::Set(i64, 1);
    return hn::ShiftLeft<LineCrossing::kShift>(truncated(d, whole + more - two)) + hn::ShiftLeft<1>(part);
}

/// Where edges meet the centres of `line`, one each, which they cross. Inside the guard band, and lower than kTallest.
/// `opens`: the left edges of their triangles.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Crossings<D> crossingsOf(D d, const Falling<V>& edge, V line, hn::Mask<D> opens)
{
    const hn::RebindToSigned<D> i64;
    const V                     pixel = hn::Set(d, kSubpixels), dx = edge.xBottom - edge.xTop;
    const V    dy      = hn::Max(edge.yBottom - edge.yTop, hn::Set(d, 1));  // of those that cross no line, too
    const V    inverse = hn::Set(d, 1) / dy;
    const V    down    = line * pixel + hn::Set(d, 128) - edge.yTop;
    const auto bias    = hn::IfThenElse(hn::RebindMask(i64, opens), hn::Set(i64, 3 - LineCrossing::kToPixel),
                                        hn::Set(i64, 2 - LineCrossing::kToPixel));
    return {inUnits(d, dx * down, dy, inverse, edge.xTop) + bias, inUnits(d, dx * pixel, dy, inverse, hn::Zero(d))};
}

/// Enters polygons.
class EdgeEntry {
public:
    explicit EdgeEntry(EdgeTable& table) : m_table(table) {}

    /// They must have been set up for the lines of the table.
    void operator()(const TriangleList& triangles) const
    {
        m_table.reserve(triangles.count, 3 * triangles.count);
        if (!m_table.keepsSides()) {
            const SharedSides sides(triangles);
            for (std::size_t i = 0; i < triangles.count; i += hn::Lanes(D())) several(triangles, sides, i);
        } else {
            for (std::size_t i = 0; i < triangles.count; ++i) one(triangles[i]);
        }
    }
    /// `sides` are closed, however often they cross.
    void operator()(const ScreenFace& face, std::span<const ScreenSide> sides) const
    {
        m_table.reserve(1, sides.size());
        const Inside rule = face.isMended ? Inside::EvenOdd : Inside::AnyWinding;
        enter(SweepPolygon{face.depth, face.id, face.patterned}, rule, face.wide, sides);
    }

private:
    using D   = hn::ScalableTag<double>;
    using I32 = hn::Rebind<std::int32_t, D>;
    using I64 = hn::RebindToSigned<D>;
    using One = hn::CappedTag<double, 1>;
    using V   = hn::Vec<D>;

    static constexpr std::size_t kMost = hn::MaxLanes(D());
    template <class T>
    using Lanes = std::array<T, kMost>;

    /// Some triangles side by side: their snapped corners, and which of them are entered so.
    struct Several {
        std::array<V, 3> x, y;
        hn::Mask<D>      together;
    };

    /// One side of several triangles, as it is stored.
    struct alignas(64) Rows {
        Lanes<ActiveEdge::Row>  row;
        Lanes<EdgeTable::Start> start;
        std::uint32_t           kept;  // bit i: of lane i
    };

    /// The triangles from `at` on, as many as there are lanes.
    HWY_ATTR void several(const TriangleList& triangles, const SharedSides& shared, std::size_t at) const
    {
        const std::size_t   count     = std::min(hn::Lanes(D()), triangles.count - at);
        const Several       corners   = cornersOf(triangles, at, count);
        const std::uint32_t firstPart = m_table.nextPart(), together = bitsOf(D(), corners.together);
        for (std::size_t i = at; i < at + count; ++i) {
            if ((together >> (i - at) & 1) == 0)
                one(triangles[i]);
            else
                m_table.add(SweepPolygon{
                    {triangles.a[i], triangles.b[i], triangles.c[i], triangles.farthest[i], triangles.nearest[i]},
                    triangles.id(i),
                    triangles.is(TriangleList::kPatterned, i)});
        }
        HWY_ALIGN std::array<Lanes<std::int32_t>, 3> beyond;
        std::array<Rows, 3>                          sides;
        shared.beyond(at, count, beyond);
        for (std::size_t k = 0; k < 3; ++k)
            rowsOf(corners, k, at, hn::Load(I32(), beyond[k].data()), firstPart, sides[k]);
        for (std::size_t lane = 0; lane < count; ++lane)
            for (const Rows& side : sides)
                m_table.add(ActiveEdge(side.row[lane]), side.start[lane], (side.kept >> lane & 1) != 0);
    }

    HWY_ATTR static Several cornersOf(const TriangleList& triangles, std::size_t at, std::size_t count)
    {
        const D    d;
        const auto kind = hn::LoadU(I32(), &triangles.kind[at]), start = hn::LoadU(I32(), &triangles.start[at]);
        const auto is = [&](TriangleList::Kind what)
                            HWY_ATTR { return hn::PromoteTo(d, hn::And(kind, hn::Set(I32(), what))) > hn::Zero(d); };
        const auto isCompact = is(TriangleList::kCompact);
        const auto from      = [&](auto pixels, auto subpixels, const TriangleList::Column<double>& other) HWY_ATTR {
            return hn::IfThenElse(isCompact,
                                       hn::PromoteTo(d, hn::ShiftLeft<8>(pixels) + hn::Set(I32(), 128) + subpixels),
                                       hn::LoadU(d, &other[at]));
        };
        Several all;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = hn::LoadU(I32(), &triangles.corner[k][at]);
            all.x[k]          = from(lowerHalf(start), lowerHalf(corner), triangles.x[k]);
            all.y[k]          = from(upperHalf(start), upperHalf(corner), triangles.y[k]);
        }
        const auto& [y0, y1, y2] = all.y;
        const auto height        = hn::Max(hn::Max(y0, y1), y2) - hn::Min(hn::Min(y0, y1), y2);
        const auto isAlone =
            hn::Or(is(TriangleList::kWide), height >= hn::Set(d, static_cast<double>(LineCrossing::kTallest)));
        all.together = hn::AndNot(isAlone, hn::FirstN(d, count));
        return all;
    }

    /// Side k of the triangles from `at` on, whose parts stand in the table from `firstPart` on. `beyond`: see
    /// SharedSides.
    HWY_ATTR HWY_INLINE void rowsOf(const Several& triangles, std::size_t k, std::size_t at, hn::Vec<I32> beyond,
                                    std::uint32_t firstPart, Rows& out) const
    {
        const D           d;
        const std::size_t to    = k < 2 ? k + 1 : 0;
        const auto        all   = [](std::int64_t value) HWY_ATTR { return hn::Set(I64(), value); };
        const auto        whole = [d](V value) HWY_ATTR { return hn::PromoteTo(I64(), hn::DemoteTo(I32(), value)); };
        const auto &      xa = triangles.x[k], &ya = triangles.y[k], &xb = triangles.x[to], &yb = triangles.y[to];
        const auto        runsDown = ya < yb;
        const Falling<V>  edge{hn::IfThenElse(runsDown, xa, xb), hn::Min(ya, yb), hn::IfThenElse(runsDown, xb, xa),
                              hn::Max(ya, yb)};
        const auto        first     = hn::Max(firstLineFrom(edge.yTop), hn::Set(d, m_table.firstLine()));
        const auto        end       = hn::Min(firstLineFrom(edge.yBottom), hn::Set(d, m_table.endLine()));
        const auto        crossings = crossingsOf(d, edge, first, hn::Not(runsDown));

        // What runs down closes its triangle.
        const auto place = hn::PromoteTo(I64(), beyond), own = countFrom(I64(), static_cast<std::int64_t>(at));
        const auto isShared = hn::Not(place < hn::Zero(I64())), closes = hn::RebindMask(I64(), runsDown);
        const auto isEntered =
            hn::AndNot(hn::And(isShared, place < own), hn::RebindMask(I64(), hn::And(triangles.together, first < end)));
        const auto toPart = all(static_cast<std::int64_t>(firstPart) - static_cast<std::int64_t>(at));
        const auto part = own + toPart, other = hn::IfThenElse(isShared, place, own) + toPart;
        const auto opens =
            hn::IfThenElseZero(isShared, hn::Or(hn::IfThenElse(closes, other, part), all(ActiveEdge::shared(0))));
        const auto winding =
            all(static_cast<std::int64_t>(std::uint64_t{ActiveEdge::windingOf(Inside::EvenOdd, true)} << 32));
        hn::StoreInterleaved4(
            crossings.x, crossings.step,
            hn::Or(hn::IfThenElse(closes, part, other), hn::ShiftLeft<32>(whole(end - hn::Set(d, 1)))),
            hn::Or(opens, winding), I64(), out.row[0].data());

        const auto column =
            hn::Min(hn::Max(hn::ShiftRight<LineCrossing::kToColumn - EdgeTable::kColumnBits>(crossings.x), all(-1)),
                    all(m_table.columns()))
            + all(1);
        const auto start = hn::Or(whole(first - hn::Set(d, m_table.firstLine())), hn::ShiftLeft<16>(column));
        const hn::Rebind<std::uint32_t, D> u32;
        hn::Store(hn::TruncateTo(u32, hn::BitCast(hn::Rebind<std::uint64_t, D>(), start)), u32,
                  reinterpret_cast<std::uint32_t*>(out.start.data()));
        out.kept = bitsOf(I64(), isEntered);
    }

    static V firstLineFrom(V y) { return hn::Floor((y + hn::Set(D(), 127)) * hn::Set(D(), 1 / kSubpixels)); }

    void one(const ScreenTriangle& part) const
    {
        const auto &                    x = part.x, &y = part.y;
        const std::array<ScreenSide, 3> sides{
            {{x[0], y[0], x[1], y[1]}, {x[1], y[1], x[2], y[2]}, {x[2], y[2], x[0], y[0]}}};
        enter(SweepPolygon{part.depth, part.id, part.patterned}, Inside::EvenOdd, part.wide, sides);
    }

    HWY_ATTR void enter(const SweepPolygon& polygon, Inside rule, bool wide, std::span<const ScreenSide> sides) const
    {
        const One           d;
        const std::uint32_t part = m_table.add(polygon);
        for (const ScreenSide& side : sides) {
            const auto [first, end] = m_table.linesOf(side);
            if (first >= end) continue;
            const bool          runsDown = side.ya < side.yb, isWide = wide || ActiveEdge::isTooTall(side);
            const std::uint32_t winding = ActiveEdge::windingOf(rule, runsDown);
            const std::uint32_t place   = m_table.add(side, isWide);
            if (isWide) {
                m_table.add(ActiveEdge(side, part, first, end - 1, place, winding), first);
                continue;
            }
            const auto                  set = [d](double value) HWY_ATTR { return hn::Set(d, value); };
            const Falling<hn::Vec<One>> edge{set(runsDown ? side.xa : side.xb), set(std::min(side.ya, side.yb)),
                                             set(runsDown ? side.xb : side.xa), set(std::max(side.ya, side.yb))};
            const auto                  crossings = crossingsOf(d, edge, set(first), set(side.ya) > set(side.yb));
            m_table.add(ActiveEdge(LineCrossing(hn::GetLane(crossings.x), hn::GetLane(crossings.step)), part, end - 1,
                                   place, winding),
                        first);
        }
    }

    EdgeTable& m_table;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_ENTER_EDGES_INL_H
