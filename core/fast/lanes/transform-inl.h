// The vertex stage, several vertices side by side: world, view, screen and snapped position of one batch.
//
// Lanes      as many float64 as the instruction set holds; one lane is Projection::toView and toScreen to the bit
// Fused      nothing but the last step, from pixels to the snapped position: its product, by a power of two, is exact
//            either way
// Cost       one division and some twenty multiplications and additions per vertex
#if defined(ZSCOPE_TRANSFORM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_TRANSFORM_INL_H
#undef ZSCOPE_TRANSFORM_INL_H
#else
#define ZSCOPE_TRANSFORM_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>

#include <hwy/highway.h>

#include "core/fast/lanes/lane_order-inl.h"
#include "core/geometry/projection.h"
#include "core/geometry/rules.h"
#include "core/geometry/screen_vertices.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The bits of positions (ScreenVertices::snappedBits()) whose whole numbers stand in the lower halves of x and y.
template <class V>
HWY_INLINE V snappedBits(V x, V y)
{
    const hn::DFromV<V>                                     u64;
    const hn::Repartition<std::uint8_t, decltype(u64)>      u8;
    HWY_ALIGN static constexpr std::array<std::uint8_t, 16> kPlaces{0, 1, 4,  5,  2,  3,  6,  7,
                                                                    8, 9, 12, 13, 10, 11, 14, 15};
    const auto both = hn::OrAnd(hn::ShiftLeft<32>(y), x, hn::Set(u64, 0xFFFFFFFF));
    return hn::BitCast(u64, hn::TableLookupBytes(hn::BitCast(u8, both), hn::LoadDup128(u8, kPlaces.data())));
}

/// The least and the most of snapped positions, lane by lane.
class VertexReach {
    using F64 = hn::ScalableTag<double>;
    using V   = hn::Vec<F64>;

public:
    VertexReach()
        : m_left(hn::Set(F64(), kBeyond)), m_above(m_left), m_right(hn::Set(F64(), -kBeyond)), m_below(m_right)
    {}

    /// `count`: of the first lanes, if there are fewer than a vector has. Whole numbers stand in the lower halves.
    void add(V x, V y, std::size_t count)
    {
        if (count < hn::Lanes(F64())) {
            const auto isThere = hn::FirstN(F64(), count);
            x                  = hn::IfThenElse(isThere, x, hn::Set(F64(), hn::GetLane(x))),
            y                  = hn::IfThenElse(isThere, y, hn::Set(F64(), hn::GetLane(y)));
        }
        m_left = hn::Min(m_left, x), m_above = hn::Min(m_above, y), m_right = hn::Max(m_right, x),
        m_below = hn::Max(m_below, y);
    }
    ScreenVertices::Reach all() const
    {
        const auto whole = [](double number) {
            return static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(number));
        };
        return {whole(hn::GetLane(hn::MinOfLanes(F64(), m_left))), whole(hn::GetLane(hn::MinOfLanes(F64(), m_above))),
                whole(hn::GetLane(hn::MaxOfLanes(F64(), m_right))), whole(hn::GetLane(hn::MaxOfLanes(F64(), m_below)))};
    }

private:
    static constexpr double kBeyond = 0x1p60;  // any position
    V                       m_left, m_above, m_right, m_below;
};

/// Where somebody knows already what they lie between.
struct KnownReach {
    ScreenVertices::Reach known;
    template <class V>
    void add(V, V, std::size_t) const
    {}
    const ScreenVertices::Reach& all() const { return known; }
};

/// The vertex stage in the arithmetic of `Real`: double by definition, float as an approximation. The lanes are as many
/// as float64 has in either case. `kCoarse`: snapped to the coarse grid.
template <class Real, bool kCoarse>
struct VertexStage {
    using F64 = hn::ScalableTag<double>;
    using Tag = hn::Rebind<Real, F64>;
    using Vec = hn::Vec<Tag>;

    static Vec all(double value) { return hn::Set(Tag(), static_cast<Real>(value)); }
    static Vec load(const double* from)
    {
        if constexpr (sizeof(Real) == sizeof(double))
            return hn::LoadU(F64(), from);
        else
            return hn::DemoteTo(Tag(), hn::LoadU(F64(), from));
    }
    static hn::Vec<F64> wide(Vec value)
    {
        if constexpr (sizeof(Real) == sizeof(double))
            return value;
        else
            return hn::PromoteTo(F64(), value);
    }

    /// Pixels to subpixels, rounded to the grid, plus kWhole.
    static hn::Vec<F64> snapped(hn::Vec<F64> pixels)
    {
        const auto whole = [](double least) HWY_ATTR { return hn::Set(F64(), ScreenVertices::kWhole * least); };
        const auto fine  = hn::Set(F64(), kSubpixels);  // a power of two: nothing is rounded but the sum
        if constexpr (!kCoarse) return hn::MulAdd(pixels, fine, whole(1));
        constexpr double kStep = kSubpixels / kCoarseSnaps;
        return hn::MulAdd(pixels, fine, whole(kStep)) - whole(kStep) + whole(1);
    }

    /// Of the vertices [first, end); whether all of them are plain.
    template <class Reach>
    static bool run(const MeshBatches& mesh, const Batch& batch, std::size_t first, std::size_t end,
                    const Affine* toWorld, const Projection& p, ScreenVertices& out, [[maybe_unused]] Reach& reach)
    {
        const F64  d64;
        const auto depthAtOne = all(p.depthAtOne);
        auto       worst      = hn::Zero(d64) > hn::Zero(d64);  // lanes that have met a vertex that is not plain

        for (std::size_t i = first; i < end; i += hn::Lanes(d64)) {
            auto x = load(mesh.x.data() + batch.firstVertex + i);
            auto y = load(mesh.y.data() + batch.firstVertex + i);
            auto z = load(mesh.z.data() + batch.firstVertex + i);
            if (toWorld) {
                const auto& m  = toWorld->rows;
                const auto  wx = ((all(m[0][0]) * x + all(m[0][1]) * y) + all(m[0][2]) * z) + all(m[0][3]);
                const auto  wy = ((all(m[1][0]) * x + all(m[1][1]) * y) + all(m[1][2]) * z) + all(m[1][3]);
                const auto  wz = ((all(m[2][0]) * x + all(m[2][1]) * y) + all(m[2][2]) * z) + all(m[2][3]);
                x = wx, y = wy, z = wz;
            }
            const auto dx = x - all(p.eye.x), dy = y - all(p.eye.y), dz = z - all(p.eye.z);
            const auto vx = (all(p.right.x) * dx + all(p.right.y) * dy) + all(p.right.z) * dz;
            const auto vy = (all(p.up.x) * dx + all(p.up.y) * dy) + all(p.up.z) * dz;
            const auto vz = (all(p.forward.x) * dx + all(p.forward.y) * dy) + all(p.forward.z) * dz;

            const auto d  = depthAtOne / vz;
            const auto sx = wide(all(p.centreX) + (vx * d) * all(p.scale));
            const auto sy = wide(all(p.centreY) - (vy * d) * all(p.scale));
            // NaN compares false, so a vertex without a place is not plain either.
            auto       plain = hn::RebindMask(d64, wide(vz) >= hn::Set(d64, p.near));
            const auto xs = snapped(sx), ys = snapped(sy);
            const auto isWithin = [&](hn::Vec<F64> whole) HWY_ATTR {
                return hn::And(whole >= hn::Set(d64, ScreenVertices::kWhole - kGuardBand),
                               whole <= hn::Set(d64, ScreenVertices::kWhole + kGuardBand));
            };
            plain = hn::And(plain, hn::And(isWithin(xs), isWithin(ys)));
            const hn::Rebind<std::uint64_t, F64> u64;
            const auto                           bits = snappedBits(hn::BitCast(u64, xs), hn::BitCast(u64, ys));
            const auto                           nowhere =
                hn::Set(u64, ScreenVertices::snappedBits(ScreenVertices::kNowhere, ScreenVertices::kNowhere));
            hn::StoreInterleaved4(sx, sy, wide(d),
                                  hn::IfThenElse(plain, hn::BitCast(d64, bits), hn::BitCast(d64, nowhere)), d64,
                                  out.rows.data() + ScreenVertices::kRow * i);
            reach.add(xs, ys, end - i);
            worst = hn::Or(worst, hn::AndNot(plain, hn::FirstN(d64, end - i)));
        }
        return hn::AllFalse(d64, worst);
    }
};

/// The batch's vertices [first, end). `toWorld` is nullptr for the identity, which leaves a vertex as it is. Whether
/// all of them are plain.
template <class Reach>
bool transformVertices(const MeshBatches& mesh, const Batch& batch, std::size_t first, std::size_t end,
                       const Affine* toWorld, const Projection& p, const LaneRules& rules, ScreenVertices& out,
                       Reach& reach)
{
    const auto run = [&]<class Real, bool kCoarse>() {
        return VertexStage<Real, kCoarse>::run(mesh, batch, first, end, toWorld, p, out, reach);
    };
    if (!rules.movesCorners()) return run.template operator()<double, false>();
    const bool isCoarse = rules.snapsPerPixel() != kSubpixels;
    if (!rules.usesFloat32Vertices()) return run.template operator()<double, true>();
    return isCoarse ? run.template operator()<float, true>() : run.template operator()<float, false>();
}

/// All of them.
inline void transformBatch(const MeshBatches& mesh, const Batch& batch, const Affine* toWorld, const Projection& p,
                           const LaneRules& rules, ScreenVertices& out)
{
    VertexReach reach;
    out.plain = transformVertices(mesh, batch, 0, batch.vertexCount, toWorld, p, rules, out, reach);
    out.reach = reach.all();
}

/// Those in `groups` (PatchBlock::vertexGroups).
template <class Reach = VertexReach>
void transformGroups(const MeshBatches& mesh, const Batch& batch, std::uint64_t groups, const Affine* toWorld,
                     const Projection& p, const LaneRules& rules, ScreenVertices& out, Reach reach = {})
{
    static_assert(kVertexGroup % hn::MaxLanes(hn::ScalableTag<double>()) == 0);
    out.plain = true;
    while (groups != 0) {
        const BitRun      run   = takeRun(groups);
        const std::size_t first = kVertexGroup * run.first,
                          end   = std::min<std::size_t>(first + kVertexGroup * run.count, batch.vertexCount);
        out.plain &= transformVertices(mesh, batch, first, end, toWorld, p, rules, out, reach);
    }
    out.reach = reach.all();
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_TRANSFORM_INL_H
