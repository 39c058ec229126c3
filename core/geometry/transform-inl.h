// The vertex stage, several vertices side by side: world, view, screen and snapped position of one batch.
//
// Lanes      as many float64 as the instruction set holds; one lane is Projection::toView and toScreen to the bit
// Cost       one division and some twenty multiplications and additions per vertex, never fused
#if defined(ZSCOPE_TRANSFORM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_TRANSFORM_INL_H
#undef ZSCOPE_TRANSFORM_INL_H
#else
#define ZSCOPE_TRANSFORM_INL_H
#endif

#include <algorithm>
#include <array>

#include <hwy/highway.h>

#include "core/geometry/lane_order-inl.h"
#include "core/geometry/projection.h"
#include "core/geometry/rules.h"
#include "core/geometry/screen_vertices.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The vertex stage in the arithmetic of `Real`: double by definition, float as an approximation. The lanes are as many as
/// float64 has in either case.
template <class Real>
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

    template <class Rules>
    static void run(const MeshBatches& mesh, const Batch& batch, const Affine* toWorld, const Projection& p, const Rules& rules,
                    ScreenVertices& out)
    {
        const F64  d64;
        const auto one = hn::Set(d64, 1), guard = hn::Set(d64, kGuardBand);
        const auto near  = all(p.near);
        const auto snaps = hn::Set(d64, rules.snapsPerPixel());
        auto       worst = hn::Zero(d64);  // becomes 1 in a lane that meets a vertex that is not plain

        for (std::size_t i = 0; i < batch.vertexCount; i += hn::Lanes(d64)) {
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

            const auto d  = near / vz;
            const auto sx = wide(all(p.centreX) + (vx * d) * all(p.scale));
            const auto sy = wide(all(p.centreY) - (vy * d) * all(p.scale));
            auto       xs = hn::Round(sx * snaps), ys = hn::Round(sy * snaps);
            if constexpr (!Rules::kExact) {
                const auto subpixels = hn::Set(d64, kSubpixels / rules.snapsPerPixel());
                xs = xs * subpixels, ys = ys * subpixels;
            }

            // NaN compares false, so a vertex without a place is not plain either.
            const auto plain = hn::And(wide(vz) >= wide(near), hn::And(hn::Abs(xs) <= guard, hn::Abs(ys) <= guard));
            const auto isVertex = countFrom(d64, static_cast<double>(i)) < hn::Set(d64, batch.vertexCount);
            worst               = hn::Max(worst, hn::IfThenZeroElse(plain, hn::IfThenElseZero(isVertex, one)));

            hn::StoreInterleaved4(sx, sy, wide(d), wide(d), d64, out.rows.data() + ScreenVertices::kRow * i);
            hn::StoreU(xs, d64, out.xs.data() + i);
            hn::StoreU(ys, d64, out.ys.data() + i);
            if constexpr (Rules::kExact) {
                const hn::Rebind<std::int32_t, F64>  i32;
                const hn::Rebind<std::uint32_t, F64> u32;
                const hn::Rebind<std::uint64_t, F64> u64;
                const auto half = [&](hn::Vec<F64> whole) HWY_ATTR { return hn::PromoteTo(u64, hn::BitCast(u32, hn::DemoteTo(i32, whole))); };
                hn::StoreU(hn::Or(half(xs), hn::ShiftLeft<32>(half(ys))), u64, out.snapped.data() + i);
            }
        }
        out.plain = hn::GetLane(hn::MaxOfLanes(d64, worst)) == 0;
    }
};

/// `toWorld` is nullptr for the identity, which leaves a vertex as it is.
template <class Rules>
void transformBatch(const MeshBatches& mesh, const Batch& batch, const Affine* toWorld, const Projection& p, const Rules& rules,
                    ScreenVertices& out)
{
    if (rules.usesFloat32Vertices())
        VertexStage<float>::run(mesh, batch, toWorld, p, rules, out);
    else
        VertexStage<double>::run(mesh, batch, toWorld, p, rules, out);
}

/// Where the triangles of a plain batch may have pixels.
struct BatchReach {
    PixelBox pixels;
    float    nearest;  // no fragment of them is nearer
};

/// The largest d of the first `count` vertices.
inline double nearestOf(const ScreenVertices& vertices, std::size_t count)
{
    const hn::ScalableTag<double> d64;
    constexpr std::size_t kRow = ScreenVertices::kRow, kCount = hn::MaxLanes(d64);
    constexpr std::size_t kFirst = kRow - std::min(kRow, kCount), kRows = std::max(kRow, kCount) / kRow;  // d is last in a row
    const auto from = [&](std::size_t i) HWY_ATTR { return hn::LoadU(d64, vertices.rows.data() + kRow * i + kFirst); };
    std::array<hn::Vec<decltype(d64)>, 4> most;  // side by side, because each maximum waits for the one before
    most.fill(hn::Zero(d64));
    std::size_t i = 0;
    for (; i + 4 * kRows <= count; i += 4 * kRows)
        for (std::size_t k = 0; k < 4; ++k) most[k] = hn::Max(most[k], from(i + k * kRows));
    HWY_ALIGN std::array<double, kCount> lanes;
    hn::Store(hn::Max(hn::Max(most[0], most[1]), hn::Max(most[2], most[3])), d64, lanes.data());
    double nearest = 0;
    for (std::size_t lane = kRow - kFirst - 1; lane < kCount; lane += kRow) nearest = std::max(nearest, lanes[lane]);
    for (; i < count; ++i) nearest = std::max(nearest, vertices.rows[kRow * i + 2]);
    return nearest;
}

/// Of the first `count` vertices, at least one, inside `region`.
inline BatchReach reachOf(const ScreenVertices& vertices, std::size_t count, const PixelBox& region)
{
    const hn::ScalableTag<double> d64;
    const std::size_t lanes = hn::Lanes(d64);
    const auto        isVertex = hn::Iota(d64, 0.0) < hn::Set(d64, static_cast<double>(count));
    const auto        load = [&](const double* column, std::size_t at) HWY_ATTR {
        return hn::IfThenElse(isVertex, hn::LoadU(d64, column + at), hn::Set(d64, column[0]));
    };
    auto left = hn::Set(d64, vertices.xs[0]), right = left, above = hn::Set(d64, vertices.ys[0]), below = above;
    for (std::size_t i = 0; i < count; i += lanes) {
        const std::size_t at = count < lanes ? 0 : std::min(i, count - lanes);  // some of them twice
        const auto        x = load(vertices.xs.data(), at), y = load(vertices.ys.data(), at);
        left = hn::Min(left, x), right = hn::Max(right, x), above = hn::Min(above, y), below = hn::Max(below, y);
    }
    const auto first = [](double snapped) { return firstPixelCentreFrom(snapped); };
    return {{std::max(region.x0, first(hn::GetLane(hn::MinOfLanes(d64, left)))), std::max(region.y0, first(hn::GetLane(hn::MinOfLanes(d64, above)))),
             std::min(region.x1, first(hn::GetLane(hn::MaxOfLanes(d64, right)))), std::min(region.y1, first(hn::GetLane(hn::MaxOfLanes(d64, below))))},
            static_cast<float>(nearestOf(vertices, count))};
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_TRANSFORM_INL_H
