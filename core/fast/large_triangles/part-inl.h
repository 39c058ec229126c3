// A large triangle in one tile of the pyramid: all pixels of the tile, in passes and without a branch.
//
// Edges      only those that cross the tile: the others have all of it on their inner side. Values divided by 256 and
//            rounded down, which keeps their sign (core/geometry/triangle_list.h), so that int32 holds what they change
//            within a tile; the sign is all that is looked at
// Depth      as in depth_test-inl.h: float64 until it is stored. The limits are float32 values and rounding is
//            monotone, so they may be applied after it
// Promise    the same pixels as EdgeWalk, of the whole tile: beyond a triangle's box there is nothing inside of all
//            three edges
// Source     Pineda: A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; docs/correctness.md, Coverage
#if defined(ZSCOPE_PART_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_PART_INL_H
#undef ZSCOPE_PART_INL_H
#else
#define ZSCOPE_PART_INL_H
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/depth/pyramid.h"
#include "core/fast/lanes/pass_lanes-inl.h"
#include "core/geometry/half_plane.h"
#include "core/geometry/projection.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// The passes of a tile: each is some lines of it, or a piece of one.
struct PartPasses {
    static constexpr int kSide = 1 << Pyramid::kTileLevel, kColumns = std::min(kPassPixels, kSide),
                         kLines = kPassPixels / kColumns;

    // of float64 side by side: two for each pass
    static constexpr std::size_t              kVectors = 2 * kSide / kColumns;
    static constexpr PassLanes<double, kSide> kLanesAt{};

    /// Pixels from the left of the tile to those of the i-th vector.
    static Vec64 right(std::size_t i)
    {
        return hn::Load(F64(), kLanesAt.right.data() + i % 2 * kOtherHalf)
               + hn::Set(F64(), static_cast<double>(i / 2) * kColumns);
    }
    /// And down from the first line of a pass: the same for both its vectors.
    static Vec64 down() { return hn::Load(F64(), kLanesAt.down.data()); }
};

/// An edge of a triangle inside the guard band, in the tiles of the pyramid.
class PartEdge {
    using D = hn::RebindToSigned<Pass32>;

public:
    static constexpr std::size_t kAcross = PartPasses::kVectors / 2;  // passes side by side

    using V      = hn::Vec<D>;
    using Values = std::array<V, kAcross>;

    /// `plane` is counted from the pixel (x0, y0).
    PartEdge(const HalfPlane& plane, int x0, int y0)
        : m_perPixel(whole(plane.perPixel)), m_perLine(whole(plane.perLine))
    {
        m_origin            = whole(plane.origin) - m_perPixel * x0 - m_perLine * y0;
        const auto perPixel = hn::Set(D(), static_cast<std::int32_t>(m_perPixel)),
                   perLine  = hn::Set(D(), static_cast<std::int32_t>(m_perLine));
        for (std::size_t i = 0; i < kAcross; ++i) {
            const auto right =
                hn::Load(D(), kAt.right.data()) + hn::Set(D(), static_cast<int>(i) * PartPasses::kColumns);
            m_grown[i] = right * perPixel + hn::Load(D(), kAt.down.data()) * perLine;
        }
    }

    /// At the pixels of the first passes of the tile at (x, y), some of which lie on the inner side.
    HWY_INLINE Values at(int x, int y) const
    {
        // What is so far inside stays there all over the tile.
        const auto first =
            hn::Set(D(), static_cast<std::int32_t>(std::min(m_origin + m_perPixel * x + m_perLine * y, kFarInside)));
        Values values;
        for (std::size_t i = 0; i < kAcross; ++i) values[i] = first + m_grown[i];
        return values;
    }
    /// From there to the next passes below.
    HWY_INLINE V perPass() const { return hn::Set(D(), PartPasses::kLines * static_cast<std::int32_t>(m_perLine)); }

private:
    // From one pixel of a tile to another: up to 7 columns and 7 lines.
    static constexpr std::int64_t kMostPerStep = 2 * static_cast<std::int64_t>(kGuardBand),
                                  kMostInTile  = 2 * (PartPasses::kSide - 1) * kMostPerStep;
    static constexpr std::int64_t kFarInside   = 2 * kMostInTile;
    static_assert(kFarInside + kMostInTile <= std::numeric_limits<std::int32_t>::max());

    static constexpr PassLanes<std::int32_t, PartPasses::kSide> kAt{};

    static std::int64_t whole(double value) { return static_cast<std::int64_t>(std::floor(value / kSubpixels)); }

    std::int64_t m_perPixel, m_perLine, m_origin;
    Values       m_grown;  // from the first pixel of a tile to those of its first passes
};

/// Tests the tile that begins at (x, y), which lies in the picture, and stores what is won. `crossing` are the edges
/// with pixels of the tile on their outer side; `kNormal` as in DepthTest. Returns keys with the farthest depths that
/// the tile holds then, lane by lane.
template <Keep kKeep, bool kNormal, std::size_t kCrossing, class Fragments, class Rules>
Keys testPart(const ScreenTriangle& triangle, [[maybe_unused]] const Fragments& fragments,
              const std::array<const PartEdge*, kCrossing>& crossing, int x, int y, VisibilityBuffer& visible,
              const Rules& rules)
{
    using Passes              = PartPasses;
    constexpr bool    kShades = Fragments::kMoment != ShadingMoment::Never;
    const DepthLanes  depths(rules);
    const F64         d64;
    const Pass32      f32;
    const DepthPlane& depth = triangle.depth;

    std::array<Vec64, Passes::kVectors> columns;  // a * (i + 0.5)
    for (std::size_t i = 0; i < Passes::kVectors; ++i)
        columns[i] = depths.across(hn::Set(d64, depth.a), Passes::right(i) + hn::Set(d64, x + 0.5));
    std::array<PartEdge::Values, kCrossing> edges;
    std::array<PartEdge::V, kCrossing>      perPass;
    for (std::size_t k = 0; k < kCrossing; ++k) edges[k] = crossing[k]->at(x, y), perPass[k] = crossing[k]->perPass();

    const auto  farthest = hn::Set(f32, depth.farthest), nearest = hn::Set(f32, depth.nearest);
    const auto  b = hn::Set(d64, depth.b), c = hn::Set(d64, depth.c);
    const auto  farthest64 = hn::Set(d64, double{depth.farthest}), nearest64 = hn::Set(d64, double{depth.nearest});
    const auto  lowers = lowerHalves<kKeep>(~triangle.rank());
    const float empty  = visible.empty();

    const std::ptrdiff_t stride = visible.stride();
    PixelKey*            row    = visible.row(y) + x;
    auto                 centre = Passes::down() + hn::Set(d64, y + 0.5);
    auto                 least = hn::Set(I64(), kNearestKey), otherLeast = least;
    for (int line = 0; line < Passes::kSide; line += Passes::kLines, row += Passes::kLines * stride) {
        const auto start = depths.down(b, centre, c);
        centre           = centre + hn::Set(d64, Passes::kLines);
        for (std::size_t i = 0; i < Passes::kVectors; i += 2) {
            const auto stored = [&](std::size_t k)
                                    HWY_ATTR { return depths.stored(columns[k] + start, farthest64, nearest64); };
            auto uppers = together(stored(i + 1), stored(i));
            if constexpr (Rules::kExactDepths) uppers = hn::Min(hn::Max(uppers, farthest), nearest);
            if constexpr (kCrossing > 0) {
                const auto outside = [&edges](std::size_t pass) HWY_ATTR {
                    if constexpr (kCrossing == 1)
                        return edges[0][pass];
                    else
                        return hn::Or3(edges[0][pass], edges[1][pass], edges[2][pass]);
                };
                const auto none = hn::Set(f32, -0.0f);
                if constexpr (Rules::kExactDepths)
                    uppers = hn::OrAnd(uppers, hn::BitCast(f32, outside(i / 2)), none);
                else
                    uppers = hn::IfNegativeThenElse(hn::BitCast(f32, outside(i / 2)), none, uppers);
                for (std::size_t k = 0; k < kCrossing; ++k) edges[k][i / 2] = edges[k][i / 2] + perPass[k];
            }
            constexpr int   kOtherRight = kLanes % Passes::kSide, kOtherDown = kLanes / Passes::kSide;
            const int       right = static_cast<int>(i / 2) * Passes::kColumns;
            PixelKey* const here  = row + right;
            PixelKey* const other = here + kOtherDown * stride + kOtherRight;
            const auto      keys  = keysOf(uppers, lowers);
            const auto      keep  = [&](Keys offered, PixelKey* to, [[maybe_unused]] int atX,
                                  [[maybe_unused]] int atY) HWY_ATTR {
                const auto held = hn::LoadU(I64(), to);
                auto       kept = held;
                if constexpr (kShades) {
                    const auto won = winners<true>(offered, held, empty);
                    kept           = hn::IfThenElse(won, offered, held);
                    if constexpr (Fragments::kMoment == ShadingMoment::AfterTest) {
                        if (!hn::AllFalse(I64(), won)) fragments.shade(U32(), narrowed(won), narrowed(won), atX, atY);
                    } else {
                        fragments.shade(U32(), narrowed(areCovered<!Rules::kExactDepths>(offered)), narrowed(won), atX,
                                              atY);
                    }
                } else {
                    kept = nearerOf<kNormal>(offered, held);
                }
                hn::StoreU(kept, I64(), to);
                return kept;
            };
            const auto kept      = keep(keys[0], here, x + right, y + line);
            const auto otherKept = keep(keys[1], other, x + right + kOtherRight, y + line + kOtherDown);
            least = fartherOf(least, kept), otherLeast = fartherOf(otherLeast, otherKept);
        }
    }
    return fartherOf(least, otherLeast);
}

/// The farthest depth of a tile of the pyramid of which these keys are the farthest, lane by lane.
HWY_INLINE float farthestOf(Keys least, const VisibilityBuffer& visible)
{
    return depthOf(std::max(hn::GetLane(hn::MinOfLanes(I64(), least)), visible.background()));
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_PART_INL_H
