// Set-up of a batch, several triangles side by side: which of them reach pixels, their edges and their depth planes.
//
// Sieve      in int32 lanes, from snapped corners: turn, box, and whether any pixel centre lies in it. Most triangles
//            end here. What is left is written densely, so that the lanes that follow have work
// Together   where all vertices of a batch lie within 126 pixels, inside the region, a lane's halves hold both
//            coordinates: half as much to fetch, and most of the sieve takes half as many instructions
// Edges      of compact triangles, by corners in halves of lanes: products of 16 bits, sums of 32, exact because the
//            sides are short
// Planes     in float64 lanes, in the order of depthPlane() (core/geometry/screen_triangle.h), nothing fused
// One by one triangles with a long side, and those with a corner that is not plain
// Hidden     if somebody knows which boxes of pixels can show nothing of the batch any more, the sieve drops what lies
//            in one
// Promise    the list holds what setUpTriangle() would have
//            made, but for the hidden
// Source     docs/correctness.md, Coverage, Depth and the winner
#if defined(ZSCOPE_SET_UP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_SET_UP_INL_H
#undef ZSCOPE_SET_UP_INL_H
#else
#define ZSCOPE_SET_UP_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>
#include <type_traits>
#include <utility>

#include <hwy/highway.h>

#include "core/fast/lanes/corner_rows-inl.h"
#include "core/fast/lanes/edge_steps-inl.h"
#include "core/fast/lanes/lane_order-inl.h"
#include "core/geometry/set_up.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where no box is known to be hidden.
struct NoHiddenBoxes {};

/// What was left out of the list, because nothing of it can be seen.
struct LeftOut {
    std::uint32_t triangles = 0;
    std::uint64_t pixels    = 0;  // of their boxes
};

/// `Hidden`: hidden(asked, left, above, width, height) says which of those boxes can show nothing of the batch any
/// more.
template <class Hidden = NoHiddenBoxes>
class BatchSetUp {
public:
    BatchSetUp(const BatchPlace& place, const ScreenVertices& vertices, const Projection& projection,
               FaceCulling culling, const PixelBox& region, const LaneRules& rules, TriangleList& out,
               const Hidden& hidden = {})
        : m_place(place), m_vertices(vertices), m_projection(projection), m_facing{culling, place.isMirrored()},
          m_region(region), m_rules(rules), m_out(out), m_hidden(hidden)
    {}

    LeftOut run()
    {
        const std::uint32_t first = m_place.batch.firstTriangle, end = first + m_place.batch.triangleCount;
        m_finished         = m_out.count;
        const bool areNear = lieTogether();
        for (PatchBits left = m_place.patches & m_place.batch.patches(); left != 0;) {
            const BitRun        run  = takeRun(left);
            const std::uint32_t t0   = first + kPatchTriangles * run.first,
                                stop = std::min(end, t0 + kPatchTriangles * run.count);
            for (std::uint32_t t = t0; t < stop; t += static_cast<std::uint32_t>(hn::Lanes(D())))
                areNear ? sieveNear(t, stop) : sieve(t, stop);
        }
        finish();
        m_out.mesh = &m_place.mesh, m_out.batch = &m_place.batch;
        m_out.compactReach = {
            hn::GetLane(hn::MinOfLanes(D(), lowerHalf(m_start))), hn::GetLane(hn::MinOfLanes(D(), upperHalf(m_start))),
            hn::GetLane(hn::MaxOfLanes(D(), lowerHalf(m_end))), hn::GetLane(hn::MaxOfLanes(D(), upperHalf(m_end)))};
        return {static_cast<std::uint32_t>(hn::GetLane(hn::SumOfLanes(D(), m_leftOut))),
                static_cast<std::uint64_t>(hn::GetLane(hn::SumOfLanes(D(), m_leftOutPixels)))};
    }

private:
    using D     = hn::ScalableTag<std::int32_t>;
    using V     = hn::Vec<D>;
    using M     = hn::Mask<D>;
    using F64   = hn::ScalableTag<double>;
    using I32   = hn::Rebind<std::int32_t, F64>;
    using I64   = hn::Rebind<std::int64_t, F64>;
    using F32   = hn::Rebind<float, F64>;
    using V64   = hn::Vec<F64>;
    using Three = std::array<V, 3>;

    static V all(std::int32_t value) { return hn::Set(D(), value); }
    static V least(const Three& of) { return hn::Min(hn::Min(of[0], of[1]), of[2]); }
    static V most(const Three& of) { return hn::Max(hn::Max(of[0], of[1]), of[2]); }
    /// First pixel whose centre is at or beyond a snapped position.
    static V firstCentreFrom(V snapped) { return hn::ShiftRight<8>(snapped + all(127)); }

    /// To the centre of a pixel, in subpixels: the lower 16 bits of both parts.
    static V centreOf(V pixel)
    {
        return inHalves(hn::ShiftLeft<8>(pixel), hn::ShiftLeft<8>(upperHalf(pixel))) + all(pixelsAndLines(128, 128));
    }

    /// Whether all vertices are plain and lie so near to each other, and so far inside the region, that the lower
    /// halves of their positions say all: triangles are compact, boxes need no cutting, and windows begin at their
    /// boxes.
    bool lieTogether() const
    {
        if (hn::MaxLanes(D()) == 1 || !m_vertices.plain) return false;
        const ScreenVertices::Reach& r           = m_vertices.reach;
        const auto                   firstCentre = [](std::int32_t snapped) { return (snapped + 127) >> 8; };
        return r.right - r.left < kNearSide && r.below - r.above < kNearSide && firstCentre(r.left) >= m_region.x0
               && firstCentre(r.right) <= m_region.x1 && firstCentre(r.above) >= m_region.y0
               && firstCentre(r.below) + kWindowSide - 1 <= m_region.y1;
    }
    /// Subpixels. From the pixel that holds the first of such vertices 15 bits hold the way to any, and half a pixel
    /// more.
    static constexpr std::int32_t kNearSide = 0x8000 - 256 - 128;
    static_assert(kNearSide <= kCompactSide);

    /// Where in the batch the k-th corners of the triangles from t on stand: as many triangles as a vector holds, even
    /// if there are fewer.
    const std::uint16_t* corners(std::size_t k, std::uint32_t t) const
    {
        static_assert(hn::MaxLanes(D()) <= kBatchPadding);
        return m_place.mesh.corners[k].data() + t;
    }

    /// x and y of their snapped positions.
    std::pair<V, V> positions(std::size_t k, std::uint32_t t) const
    {
        const hn::ScalableTag<std::uint64_t> u64;
        const auto                           first  = snappedAt(u64, m_vertices, corners(k, t));
        const auto                           second = snappedAt(u64, m_vertices, corners(k, t) + hn::MaxLanes(u64));
        const auto lower  = hn::ConcatEven(D(), hn::BitCast(D(), second), hn::BitCast(D(), first));
        const auto upper  = hn::ConcatOdd(D(), hn::BitCast(D(), second), hn::BitCast(D(), first));
        const auto lowerY = hn::BitCast(D(), hn::ShiftRight<16>(hn::BitCast(hn::RebindToUnsigned<D>(), lower)));
        return {inHalves(lower, upper), hn::Or(lowerY, hn::And(upper, all(-0x10000)))};
    }

    /// The triangles from t on, as far as they come before `end`.
    void sieve(std::uint32_t t, std::uint32_t end)
    {
        Three x, y;
        for (std::size_t k = 0; k < 3; ++k) std::tie(x[k], y[k]) = positions(k, t);
        const auto x0 = least(x), x1 = most(x), y0 = least(y), y1 = most(y);
        const auto isThere   = hn::Iota(D(), 0) < all(static_cast<std::int32_t>(end - t));
        const auto isPlain   = x1 < all(ScreenVertices::kNowhere);
        const auto isCompact = hn::And(hn::And(isThere, isPlain), hn::Max(x1 - x0, y1 - y0) < all(kCompactSide));
        const auto area      = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);

        const auto left      = hn::Max(all(m_region.x0), firstCentreFrom(x0)),
                   right     = hn::Min(all(m_region.x1), firstCentreFrom(x1));
        const auto above     = hn::Max(all(m_region.y0), firstCentreFrom(y0)),
                   below     = hn::Min(all(m_region.y1), firstCentreFrom(y1));
        const auto hasCentre = hn::And(left < right, above < below);
        const auto isTurned  = isDrawnAs(area);
        // Windows begin where all of them end inside the region.
        const auto lines = hn::And(below - above + all(kWindowSide - 1), all(-kWindowSide));
        const auto top   = hn::Min(above, all(m_region.y1) - lines);
        const auto fits  = hn::Not(top < all(m_region.y0));
        const auto drawn = hn::And(hn::And(isCompact, hasCentre), hn::And(isTurned, fits));
        const auto kept  = leaveOutHidden(drawn, left, above, right - left, below - above);
        // To be set up one by one.
        const auto mayReach = hn::And(isThere, hn::Or(hn::Not(isPlain), hasCentre));
        const auto alone    = hn::AndNot(hn::And(isCompact, fits), mayReach);

        if (!hn::AllFalse(D(), kept)) {
            const auto start = inHalves(left, above), centre = centreOf(start),
                       raised = hn::ShiftLeft<TriangleList::kRaised>(above - top);
            const auto corner = [&](std::size_t k) HWY_ATTR { return minusHalves(inHalves(x[k], y[k]), centre); };
            list(t, kept, {corner(0), corner(1), corner(2)}, area > hn::Zero(D()), start, inHalves(right, below),
                 raised);
        }
        if (hn::AllFalse(D(), alone)) return;
        finish();
        forEach(alone, [&](std::uint32_t lane) {
            const auto corner = [&, lane](std::size_t k) { return std::size_t{m_place.mesh.corners[k][t + lane]}; };
            setUpAlone(t + lane,
                       m_vertices.isPlain(corner(0)) && m_vertices.isPlain(corner(1)) && m_vertices.isPlain(corner(2)));
        });
        m_finished = m_out.count;
    }

    /// The same where all vertices lie together: both coordinates in the halves of a lane, seen from the pixel that
    /// holds the first of the vertices.
    void sieveNear(std::uint32_t t, std::uint32_t end)
    {
        const int  column = m_vertices.reach.left >> 8, line = m_vertices.reach.above >> 8;
        const auto origin = all(pixelsAndLines(256 * column, 256 * line));
        const auto at     = [&](std::size_t k)
                            HWY_ATTR { return minusHalves(snappedAt(D(), m_vertices, corners(k, t)), origin); };
        const Three p{at(0), at(1), at(2)};
        const auto  nearly = all(pixelsAndLines(127, 127));  // to the next centre
        const auto  first  = inPixels(plusHalves(leastHalves(leastHalves(p[0], p[1]), p[2]), nearly));
        const auto  size   = minusHalves(inPixels(plusHalves(mostHalves(mostHalves(p[0], p[1]), p[2]), nearly)), first);
        // Twice the area, but for the sign.
        const auto turned   = growth(minusHalves(p[1], p[0]), acrossEdge(minusHalves(p[2], p[0])));
        const auto isTurned = isDrawnAs(hn::Zero(D()) - turned);
        const auto belowOne =
            hn::And(minusHalves(size, all(pixelsAndLines(1, 1))), all(pixelsAndLines(-0x8000, -0x8000)));
        const auto isThere = hn::Iota(D(), 0) < all(static_cast<std::int32_t>(end - t));
        const auto drawn   = hn::And(hn::And(isThere, isTurned), belowOne == hn::Zero(D()));
        if (hn::AllFalse(D(), drawn)) return;
        const auto start = plusHalves(first, all(pixelsAndLines(column, line)));
        const auto kept  = leaveOutHidden(drawn, lowerHalf(start), upperHalf(start), lowerHalf(size), upperHalf(size));
        if (hn::AllFalse(D(), kept)) return;
        const auto  centre = centreOf(first);
        const Three corner{minusHalves(p[0], centre), minusHalves(p[1], centre), minusHalves(p[2], centre)};
        list(t, kept, corner, turned < hn::Zero(D()), start, plusHalves(start, size), hn::Zero(D()));
    }

    /// True where twice the snapped area is not 0, and not of a back that is culled.
    M isDrawnAs(V area) const
    {
        if (m_facing.culling != FaceCulling::Back) return area != hn::Zero(D());
        return m_facing.isMirrored ? area > hn::Zero(D()) : area < hn::Zero(D());
    }

    /// Subpixels to pixels, half by half, of numbers that are not negative.
    static V inPixels(V subpixels) { return hn::And(hn::ShiftRight<8>(subpixels), all(pixelsAndLines(0xFF, 0xFF))); }

    /// Puts the triangles that `kept` names, of those from t on, at the end of the list. `raised`: what of their kind
    /// says where their windows begin.
    HWY_INLINE void list(std::uint32_t t, M kept, const Three& corner, M isClockwise, V start, V end, V raised)
    {
        const hn::Rebind<std::uint16_t, D> u16;
        const hn::RebindToUnsigned<D>      u32;
        const auto vertex = [&](std::size_t k) HWY_ATTR { return hn::PromoteTo(D(), hn::LoadU(u16, corners(k, t))); };
        const auto id     = hn::LoadU(u32, m_place.mesh.meshTriangle.data() + t);
        const auto kind   = hn::Or(raised, hn::IfThenElse(isClockwise, all(TriangleList::kCompact),
                                                          all(TriangleList::kCompact | TriangleList::kCounterClockwise)));
        const auto pair   = hn::Or(vertex(0), hn::ShiftLeft<16>(vertex(1))),
                   last   = hn::Or(vertex(2), hn::ShiftLeft<16>(countFrom(
                                                  D(), static_cast<std::int32_t>(t - m_place.batch.firstTriangle))));
        // The order that puts them side by side, found once: to compress each column by itself costs more.
        const auto order = hn::IndicesFromVec(D(), keptFirst(D(), kept));
        // Read before the first store, which could change them for all the compiler knows.
        TriangleList&     out   = m_out;
        const std::size_t count = out.count;
        const auto        keep  = [&, order, count](V values, auto& column) HWY_ATTR {
            hn::StoreU(hn::TableLookupLanes(values, order), D(),
                               reinterpret_cast<std::int32_t*>(column.data()) + count);
        };
        keep(corner[0], out.corner[0]);
        keep(hn::IfThenElse(isClockwise, corner[1], corner[2]), out.corner[1]),
            keep(hn::IfThenElse(isClockwise, corner[2], corner[1]), out.corner[2]);
        keep(start, out.start), keep(end, out.end), keep(kind, out.kind);
        const auto own = hn::BitCast(D(), id + hn::Set(u32, m_place.firstTriangle));
        keep(all(-2) - own, out.notRank);  // ~(own + 1)
        keep(pair, out.firstTwo), keep(last, out.thirdAndPlace);
        m_start   = leastHalves(m_start, hn::IfThenElse(kept, start, m_start)),
        m_end     = mostHalves(m_end, hn::IfThenElse(kept, end, m_end));
        out.count = count + hn::CountTrue(D(), kept);
        if (!m_place.mesh.patterned.empty()) markPatterned(t, kept, count);
    }

    void setUpAlone(std::uint32_t t, bool isPlain)
    {
        if (isPlain)
            setUpOne(m_place, t, m_vertices, m_facing, m_region, m_rules, m_out);
        else
            setUpCarefully(m_place, t, m_projection, m_facing, m_region, m_rules, m_out);
    }

    /// Those of `drawn` that may be seen.
    M leaveOutHidden(M drawn, V left, V above, V width, V height)
    {
        if constexpr (std::is_same_v<Hidden, NoHiddenBoxes>) {
            return drawn;
        } else {
            if (hn::AllFalse(D(), drawn)) return drawn;
            const auto hidden = m_hidden(drawn, left, above, width, height);
            m_leftOut         = m_leftOut + hn::IfThenElseZero(hidden, all(1));
            m_leftOutPixels   = m_leftOutPixels + hn::IfThenElseZero(hidden, width * height);
            return hn::AndNot(hidden, drawn);
        }
    }

    template <class Each>
    static void forEach(M mask, const Each& each)
    {
        HWY_ALIGN std::array<std::int32_t, hn::MaxLanes(D())> lanes;
        hn::Store(hn::IfThenElseZero(mask, all(1)), D(), lanes.data());
        for (std::uint32_t lane = 0; lane < hn::Lanes(D()); ++lane)
            if (lanes[lane] != 0) each(lane);
    }

    void markPatterned(std::uint32_t t, M kept, std::size_t at)
    {
        forEach(kept, [&](std::uint32_t lane) {
            if (m_place.mesh.isPatterned(t + lane)) {
                m_out.kind[at] |= TriangleList::kPatterned;
                m_out.listAlone(at);
            }
            ++at;
        });
    }

    /// Edges and planes of what the sieve has left.
    void finish()
    {
        for (std::size_t i = m_finished; i < m_out.count; i += hn::Lanes(D())) findEdges(i);
        for (std::size_t i = m_finished; i < m_out.count; i += hn::Lanes(F64())) findPlanes(i);
        m_finished = m_out.count;
    }

    void findEdges(std::size_t i)
    {
        const auto  at = [i](const auto& column) HWY_ATTR { return hn::LoadU(D(), column.data() + i); };
        const Three corner{at(m_out.corner[0]), at(m_out.corner[1]), at(m_out.corner[2])};
        const auto  start = at(m_out.start);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto way   = minusHalves(corner[(k + 1) % 3], corner[k]);
            const auto steps = acrossEdge(way);
            // Runs up, or level and to the right: of the way, which is not 0, the upper half is below 0, or all of it a
            // lower half above 0.
            const auto owns = way < all(0x8000);
            // at the centre of the box's first pixel
            const auto edge = hn::IfThenElse(owns, hn::Zero(D()), all(-1)) - growth(steps, corner[k]);
            const auto here = hn::ShiftRight<8>(edge), risen = growth(steps, start);
            hn::StoreU(steps, D(), m_out.steps[k].data() + i);
            if (k < 2)
                hn::StoreU(risen - here, D(), m_out.leastRise[k].data() + i);
            else
                hn::StoreU(here - risen, D(), m_out.mostRise.data() + i);
        }
    }

    void findPlanes(std::size_t i)
    {
        const F64                  d64;
        const std::uint32_t* const pairs = m_out.firstTwo.data() + i;
        const auto first = cornersAt<false>(m_vertices, pairs), second = cornersAt<true>(m_vertices, pairs),
                   third = cornersAt<false>(m_vertices, m_out.thirdAndPlace.data() + i);
        const auto d0 = first.d, d1 = second.d, d2 = third.d;
        auto       x0 = first.x, y0 = first.y;
        auto       e1x = second.x - x0, e1y = second.y - y0;
        auto       e2x = third.x - x0, e2y = third.y - y0;
        auto       det = e1x * e2y - e2x * e1y;

        const auto longest = hn::Max(hn::Max(hn::Abs(e1x), hn::Abs(e1y)), hn::Max(hn::Abs(e2x), hn::Abs(e2y)));
        const auto isThin  = hn::Not(hn::Abs(det) > longest * hn::Set(d64, 0x1p-10));
        if (!hn::AllFalse(d64, isThin)) {  // thinner than a quarter of a snapping step: the snapped plane
            const auto snapped = [&](std::size_t k) HWY_ATTR {
                const hn::Rebind<std::uint64_t, F64> u64;
                const hn::Rebind<std::uint32_t, F64> u32;
                const auto                           pair =
                    hn::BitCast(I32(), hn::LoadU(u32, (k < 2 ? m_out.firstTwo : m_out.thirdAndPlace).data() + i));
                const auto vertex = hn::PromoteTo(I64(), k == 1 ? upperHalf(pair) : lowerHalf(pair));
                const auto last   = hn::ShiftLeft<std::countr_zero(ScreenVertices::kRow)>(vertex)
                                  + hn::Set(I64(), ScreenVertices::kRow - 1);
                const auto both   = hn::BitCast(u64, hn::GatherIndex(d64, m_vertices.rows.data(), last));
                const auto lower  = hn::BitCast(I32(), hn::TruncateTo(u32, both)),
                           upper  = hn::BitCast(I32(), hn::TruncateTo(u32, hn::ShiftRight<32>(both)));
                const auto pixels = [&](auto whole)
                                        HWY_ATTR { return hn::PromoteTo(d64, whole) * hn::Set(d64, 1 / kSubpixels); };
                return std::pair(pixels(inHalves(lower, upper)), pixels(inHalves(upperHalf(lower), upperHalf(upper))));
            };
            const auto choose   = [&](V64 thin, V64& other) HWY_ATTR { other = hn::IfThenElse(isThin, thin, other); };
            const auto [sx, sy] = snapped(0);
            const auto [tx, ty] = snapped(1);
            const auto [ux, uy] = snapped(2);
            choose(tx - sx, e1x), choose(ty - sy, e1y), choose(ux - sx, e2x), choose(uy - sy, e2y);
            choose(sx, x0), choose(sy, y0);
            det = e1x * e2y - e2x * e1y;
        }
        const auto nearest = hn::DemoteTo(F32(), hn::Max(hn::Max(d0, d1), d2));
        const auto flat    = det == hn::Zero(d64);
        const auto inv     = hn::Set(d64, 1) / det;
        const auto f1 = d1 - d0, f2 = d2 - d0;
        const auto a = hn::IfThenZeroElse(flat, (f1 * e2y - f2 * e1y) * inv),
                   b = hn::IfThenZeroElse(flat, (f2 * e1x - f1 * e2x) * inv);
        const auto c = hn::IfThenElse(flat, hn::PromoteTo(d64, nearest), d0 - (a * x0 + b * y0));
        hn::StoreU(a, d64, m_out.a.data() + i);
        hn::StoreU(b, d64, m_out.b.data() + i);
        hn::StoreU(c, d64, m_out.c.data() + i);
        hn::StoreU(nearest, F32(), m_out.nearest.data() + i);
        hn::StoreU(hn::DemoteTo(F32(), hn::Min(hn::Min(d0, d1), d2)), F32(), m_out.farthest.data() + i);
    }

    const BatchPlace&            m_place;
    const ScreenVertices&        m_vertices;
    const Projection&            m_projection;
    Facing                       m_facing;
    const PixelBox&              m_region;
    const LaneRules&             m_rules;
    TriangleList&                m_out;
    [[no_unique_address]] Hidden m_hidden;
    std::size_t                  m_finished = 0;  // entries of the list whose edges and planes are there

    // The boxes of all that the sieve has left, lane by lane: ways to the first pixel of all, and behind the last.
    V m_start = all(pixelsAndLines(0x7FFF, 0x7FFF)), m_end = all(pixelsAndLines(-0x8000, -0x8000));

    V m_leftOut = hn::Zero(D()), m_leftOutPixels = m_leftOut;  // see LeftOut
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_SET_UP_INL_H
