// What can be known of a batch's patches before their triangles are looked at, several patches side by side: which face
// away, and which pixels the others may have, how near.
//
// Away       their cones of normals (BehindQuestion::holdsOf, core/geometry/normal_cone.h), patch by patch
// Reach      the spheres that hold them, projected as boxes around them: along x and y a slope is largest at the
//            sphere's near or far side
// Margins    view space as PlacedView promises it; on the screen the snapping and as much again, far above what
//            roundings make of places that matter (1e9 pixels away nothing does)
// Promise    every triangle of a patch that faces away is SetUp::BackFacing. Every triangle of another one has its
//            pixels inside that one's box, and nowhere a depth beyond its `nearest`. The same answers in every
//            instruction set
// Source     as core/cull/node_reach.h, of spheres in place of boxes: a patch is round rather than long
#if defined(ZSCOPE_PATCHES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_PATCHES_INL_H
#undef ZSCOPE_PATCHES_INL_H
#else
#define ZSCOPE_PATCHES_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

#include "core/fast/lanes/lane_order-inl.h"
#include "core/geometry/batches.h"
#include "core/geometry/pixel_box.h"
#include "core/geometry/placed_view.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Calls each(block, patches before it) for the blocks of the batch.
template <class Each>
HWY_INLINE void forEachBlock(const MeshBatches& mesh, const Batch& batch, const Each& each)
{
    std::uint32_t before = 0;
    for (const PatchBlock& block : mesh.patchesOf(batch)) each(block, before), before += PatchBlock::kPatches;
}

inline PatchBits facingAway(const PatchBlock& block, const BehindQuestion& asked)
{
    const hn::ScalableTag<double> d;
    static_assert(PatchBlock::kPatches % hn::MaxLanes(d) == 0);
    const auto all  = [d](double value) HWY_ATTR { return hn::Set(d, value); };
    PatchBits  away = 0;
    for (std::size_t i = 0; i < PatchBlock::kPatches; i += hn::Lanes(d)) {
        const auto at    = [&](const PatchBlock::Column& column) HWY_ATTR { return hn::Load(d, column.data() + i); };
        const auto axisX = at(block.axis[0]), axisY = at(block.axis[1]), axisZ = at(block.axis[2]);
        const auto apexX = at(block.apex[0]), apexY = at(block.apex[1]), apexZ = at(block.apex[2]);
        const auto aheadX = apexX - all(asked.eye.x), aheadY = apexY - all(asked.eye.y),
                   aheadZ = apexZ - all(asked.eye.z);
        const auto along  = (aheadX * axisX + aheadY * axisY) + aheadZ * axisZ;
        const auto asideX = aheadX - axisX * along, asideY = aheadY - axisY * along, asideZ = aheadZ - axisZ * along;
        const auto aside = hn::Sqrt((asideX * asideX + asideY * asideY) + asideZ * asideZ);
        const auto place = (hn::Abs(apexX) + hn::Abs(apexY)) + hn::Abs(apexZ);
        const auto distance =
            (along * at(block.cosine) - aside * at(block.sine)) - (all(asked.slack) + all(kConeSlack) * place);
        const auto altitude = at(block.altitude);
        const auto area     = ((all(asked.areaPerDistance) * altitude) * distance) * altitude;
        const auto behind   = hn::And(along > hn::Zero(d), distance > hn::Zero(d));
        away |= bitsOf(d, hn::And(behind, area > all(asked.change) * altitude + all(asked.changePerAltitude))) << i;
    }
    return away;
}

/// The batch's patches that may show a front.
inline PatchBits towardsEye(const MeshBatches& mesh, const Batch& batch, const BehindQuestion& asked)
{
    PatchBits away = 0;
    forEachBlock(mesh, batch, [&](const PatchBlock& block, std::uint32_t before) HWY_ATTR {
        away |= facingAway(block, asked) << before;
    });
    return batch.patches() & ~away;
}

/// The groups of vertices that those patches use.
inline std::uint64_t vertexGroupsOf(const MeshBatches& mesh, const Batch& batch, PatchBits patches)
{
    std::uint64_t   groups = 0;
    const std::span blocks = mesh.patchesOf(batch);
    for (PatchBits left = patches & batch.patches(); left != 0; left &= left - 1) {
        const auto patch = static_cast<std::size_t>(std::countr_zero(left));
        groups |= blocks[patch / PatchBlock::kPatches].vertexGroups[patch % PatchBlock::kPatches];
    }
    return groups;
}

/// The pixels that patches of a batch may have in a region, and how near.
class PatchReach {
    using F64 = hn::ScalableTag<double>;
    using Vec = hn::Vec<F64>;
    using I32 = hn::ScalableTag<std::int32_t>;
    using F32 = hn::Rebind<float, F64>;

public:
    /// Of the patches in `chosen`; no other is looked at further.
    PatchReach(const MeshBatches& mesh, const Batch& batch, PatchBits chosen, const PlacedView& view,
               const Projection& projection, const PixelBox& region)
        : m_view(view), m_projection(projection), m_region(region),
          m_error(PlacedView::kError * view(batch.bounds).magnitude)
    {
        auto left = all(region.x1), above = all(region.y1), right = all(region.x0), below = all(region.y0),
             nearest = all(0);
        forEachBlock(mesh, batch, [&](const PatchBlock& block, std::uint32_t before) HWY_ATTR {
            for (std::uint32_t i = 0; i < PatchBlock::kPatches; i += static_cast<std::uint32_t>(hn::Lanes(F64()))) {
                const Sides sides  = sidesOf(block, i);
                const auto  isKept = hn::And(maskOf(F64(), chosen >> (before + i)),
                                             hn::And(sides.left < sides.right, sides.above < sides.below));
                m_patches |= bitsOf(F64(), isKept) << (before + i);
                keep(sides.left, m_left, before + i), keep(sides.above, m_above, before + i);
                keep(sides.right, m_right, before + i), keep(sides.below, m_below, before + i);
                hn::Store(nextUp(hn::DemoteTo(F32(), sides.nearest)), F32(), m_depths.data() + before + i);
                left    = hn::Min(left, hn::IfThenElse(isKept, sides.left, left)),
                above   = hn::Min(above, hn::IfThenElse(isKept, sides.above, above));
                right   = hn::Max(right, hn::IfThenElse(isKept, sides.right, right)),
                below   = hn::Max(below, hn::IfThenElse(isKept, sides.below, below));
                nearest = hn::Max(nearest, hn::IfThenElseZero(isKept, sides.nearest));
            }
        });
        const auto whole = [](double value) { return static_cast<int>(value); };
        m_pixels = {whole(hn::GetLane(hn::MinOfLanes(F64(), left))), whole(hn::GetLane(hn::MinOfLanes(F64(), above))),
                    whole(hn::GetLane(hn::MaxOfLanes(F64(), right))), whole(hn::GetLane(hn::MaxOfLanes(F64(), below)))};
        // The next float32 up, as nextafter() finds it of a number that is not negative.
        m_nearest = std::bit_cast<float>(
            std::bit_cast<std::uint32_t>(static_cast<float>(hn::GetLane(hn::MaxOfLanes(F64(), nearest)))) + 1);
    }

    /// Those that may have pixels in the region.
    PatchBits patches() const { return m_patches; }
    /// Of all of them: all their pixels, and no depth of theirs is larger. Of none: empty.
    const PixelBox& pixels() const { return m_pixels; }
    float           nearest() const { return m_nearest; }

    float    nearestOf(std::size_t patch) const { return m_depths[patch]; }
    PixelBox pixelsOf(std::size_t patch) const
    {
        return {m_left[patch], m_above[patch], m_right[patch], m_below[patch]};
    }

    /// Of patches(), those whose boxes are hidden: hidden(asked, left, above, width, height) says which of several
    /// boxes are.
    template <class Hidden>
    PatchBits hiddenAmong(const Hidden& hidden) const
    {
        const I32 i32;
        PatchBits found = 0;
        for (std::size_t i = 0; i < kMost && m_patches >> i != 0; i += hn::Lanes(i32)) {
            const auto at   = [&](const Column& column) HWY_ATTR { return hn::Load(i32, column.data() + i); };
            const auto left = at(m_left), above = at(m_above), width = at(m_right) - left, height = at(m_below) - above;
            const auto asked = maskOf(i32, m_patches >> i);
            found |= bitsOf(i32, hn::Or(hidden(asked, left, above, width, height),
                                        hidden.ofLarge(asked, left, above, width, height)))
                     << i;
        }
        return found;
    }

private:
    static constexpr std::size_t kMost = 32;  // patches of a batch
    using Column                       = std::array<std::int32_t, kMost>;

    struct Sides {
        Vec left, above, right, below;  // whole numbers, in the region
        Vec nearest;                    // d
    };

    static Vec          all(double value) { return hn::Set(F64(), value); }
    static hn::Vec<F32> nextUp(hn::Vec<F32> value)
    {
        const hn::RebindToSigned<F32> i32;
        return hn::BitCast(F32(), hn::BitCast(i32, value) + hn::Set(i32, 1));
    }

    template <class D>
    static hn::Mask<D> maskOf(D d, PatchBits bits)
    {
        std::array<std::uint8_t, 8> bytes{};
        std::memcpy(bytes.data(), &bits, sizeof bits);
        return hn::LoadMaskBits(d, bytes.data());
    }

    static void keep(Vec values, Column& column, std::size_t at)
    {
        const hn::Rebind<std::int32_t, F64> i32;
        hn::Store(hn::DemoteTo(i32, values), i32, column.data() + at);
    }

    Sides sidesOf(const PatchBlock& block, std::size_t i) const
    {
        const auto at = [&](const PatchBlock::Column& column) HWY_ATTR { return hn::Load(F64(), column.data() + i); };
        const auto cx = at(block.centre[0]), cy = at(block.centre[1]), cz = at(block.centre[2]);
        const auto& [ax, ay, az] = m_view.axes();
        const auto& o            = m_view.origin();
        const auto  vx           = ((all(ax.x) * cx + all(ay.x) * cy) + all(az.x) * cz) + all(o.x);
        const auto  vy           = ((all(ax.y) * cx + all(ay.y) * cy) + all(az.y) * cz) + all(o.y);
        const auto  vz           = ((all(ax.z) * cx + all(ay.z) * cy) + all(az.z) * cz) + all(o.z);
        const auto  r            = at(block.radius) * all(m_view.longest()) + all(m_error);

        // Not so of NaN, nor of numbers that run over.
        const auto near    = vz - r;
        const auto isKnown = hn::And(near >= all(m_projection.near), hn::Abs(vx) + hn::Abs(vy) < all(1e300));
        const auto perNear = all(1) / near, perFar = all(1) / (vz + r), zero = hn::Zero(F64());
        const auto least    = [&](Vec v) HWY_ATTR { return v * hn::IfThenElse(v < zero, perNear, perFar); };
        const auto most     = [&](Vec v) HWY_ATTR { return v * hn::IfThenElse(v < zero, perFar, perNear); };
        const auto perSlope = all(m_projection.pixelsPerSlope()), slip = all(2 / kSubpixels), half = all(0.5);
        const auto x = all(m_projection.centreX), y = all(m_projection.centreY);
        const auto from = [&](Vec edge, int first) HWY_ATTR {
            return hn::IfThenElse(isKnown, hn::Max(hn::Ceil((edge - slip) - half), all(first)), all(first));
        };
        const auto until = [&](Vec edge, int end) HWY_ATTR {
            return hn::IfThenElse(isKnown, hn::Min(hn::Ceil((edge + slip) - half), all(end)), all(end));
        };
        return {from(x + least(vx - r) * perSlope, m_region.x0), from(y - most(vy + r) * perSlope, m_region.y0),
                until(x + most(vx + r) * perSlope, m_region.x1), until(y - least(vy - r) * perSlope, m_region.y1),
                hn::IfThenElse(isKnown, all(m_projection.depthAtOne) * perNear, all(m_projection.depthScale))};
    }

    const PlacedView& m_view;
    const Projection& m_projection;
    PixelBox          m_region;
    double            m_error;

    PatchBits m_patches = 0;
    PixelBox  m_pixels;
    float     m_nearest;
    alignas(64) Column m_left, m_above, m_right, m_below;
    alignas(64) std::array<float, kMost> m_depths;  // no depth of a patch is larger
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_PATCHES_INL_H
