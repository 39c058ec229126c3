// A large triangle in one tile of the pyramid: all pixels of the tile, in passes and without a branch.
//
// Edges      only those that cross the tile: the others have all of it on their inner side. Values are integers below 2^53, in float64; the sign
//            says which side, and is all that is looked at
// Depth      as in depth_test-inl.h: float64 until it is stored. The limits are float32 values and rounding is monotone, so they may
//            be applied after it
// Promise    the same pixels as EdgeWalk, of the whole tile: beyond a triangle's box there is nothing inside of all three edges
// Source     Pineda: A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; docs/correctness.md, Coverage
#if defined(ZSCOPE_PART_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_PART_INL_H
#undef ZSCOPE_PART_INL_H
#else
#define ZSCOPE_PART_INL_H
#endif

#include <algorithm>
#include <array>

#include "core/depth/pyramid.h"
#include "core/geometry/half_plane.h"
#include "core/scan/pass_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// The passes of a tile: each is some lines of it, or a piece of one.
struct PartPasses {
    static constexpr int kSide = 1 << Pyramid::kTileLevel, kColumns = std::min(kPassPixels, kSide), kLines = kPassPixels / kColumns;

    static constexpr std::size_t              kVectors = 2 * kSide / kColumns;  // of float64 side by side: two for each pass
    static constexpr PassLanes<double, kSide> kLanesAt{};

    /// Pixels from the left of the tile to those of the i-th vector.
    static Vec64 right(std::size_t i)
    {
        return hn::Load(F64(), kLanesAt.right.data() + i % 2 * kOtherHalf) + hn::Set(F64(), static_cast<double>(i / 2) * kColumns);
    }
    /// And down from the first line of a pass: the same for both its vectors.
    static Vec64 down() { return hn::Load(F64(), kLanesAt.down.data()); }
};

/// Tests the tile that begins at (x, y), which lies in the picture, and stores what is won. `crossing` are the edges with pixels of the tile on
/// their outer side, counted from (x, y); `kNormal` as in DepthTest. Returns the least keys that the tile holds then, lane by lane.
template <Keep kKeep, bool kNormal, std::size_t kCrossing>
Keys testPart(const ScreenTriangle& triangle, const std::array<HalfPlane, kCrossing>& crossing, int x, int y, VisibilityBuffer& visible)
{
    using Passes = PartPasses;
    const F64         d64;
    const Pass32      f32;
    const DepthPlane& depth = triangle.depth;

    std::array<Vec64, Passes::kVectors> columns;  // a * (i + 0.5)
    for (std::size_t i = 0; i < Passes::kVectors; ++i) columns[i] = hn::Set(d64, depth.a) * (Passes::right(i) + hn::Set(d64, x + 0.5));
    std::array<std::array<Vec64, Passes::kVectors>, kCrossing> edges;
    for (std::size_t k = 0; k < kCrossing; ++k) {
        const HalfPlane& plane = crossing[k];
        const auto       first = hn::Set(d64, plane.origin + 0.0);  // a zero is inside, and so has to be the positive one
        for (std::size_t i = 0; i < Passes::kVectors; ++i)
            edges[k][i] = first + (Passes::right(i) * hn::Set(d64, plane.perPixel) + Passes::down() * hn::Set(d64, plane.perLine));
    }

    const auto farthest = hn::Set(f32, depth.farthest), nearest = hn::Set(f32, depth.nearest);
    const auto b = hn::Set(d64, depth.b), c = hn::Set(d64, depth.c);
    const auto lowers = lowerHalves<kKeep>(~triangle.rank());
    const float empty = visible.empty();

    const std::ptrdiff_t stride = visible.stride();
    PixelKey*            row    = visible.row(y) + x;
    auto                 centre = Passes::down() + hn::Set(d64, y + 0.5);
    auto                 least = hn::Set(I64(), kNearestKey), otherLeast = least;
    for (int line = 0; line < Passes::kSide; line += Passes::kLines, row += Passes::kLines * stride) {
        const auto start = b * centre + c;
        centre           = centre + hn::Set(d64, Passes::kLines);
        for (std::size_t i = 0; i < Passes::kVectors; i += 2) {
            const auto found  = together(hn::DemoteTo(F32(), columns[i + 1] + start), hn::DemoteTo(F32(), columns[i] + start));
            auto       uppers = hn::Min(hn::Max(found, farthest), nearest);
            if constexpr (kCrossing > 0) {
                const auto outside = [&](std::size_t half) HWY_ATTR {
                    if constexpr (kCrossing == 1)
                        return edges[0][half];
                    else
                        return hn::Or3(edges[0][half], edges[1][half], edges[2][half]);
                };
                uppers = hn::OrAnd(uppers, signsOf(outside(i + 1), outside(i)), hn::Set(f32, -0.0f));
                for (std::size_t k = 0; k < kCrossing; ++k)
                    for (std::size_t half = i; half < i + 2; ++half) edges[k][half] = edges[k][half] + hn::Set(d64, Passes::kLines * crossing[k].perLine);
            }
            PixelKey* const here  = row + static_cast<int>(i / 2) * Passes::kColumns;
            PixelKey* const other = here + kLanes / Passes::kSide * stride + kLanes % Passes::kSide;
            const auto      keys  = keysOf(uppers, lowers);
            const auto      kept      = keptOf<kKeep, kNormal>(keys[0], hn::LoadU(I64(), here), empty);
            const auto      otherKept = keptOf<kKeep, kNormal>(keys[1], hn::LoadU(I64(), other), empty);
            hn::StoreU(kept, I64(), here);
            hn::StoreU(otherKept, I64(), other);
            least = fartherOf<kNormal>(least, kept), otherLeast = fartherOf<kNormal>(otherLeast, otherKept);
        }
    }
    return fartherOf<kNormal>(least, otherLeast);
}

/// The farthest depth of a tile of the pyramid that holds these least keys, lane by lane.
HWY_INLINE float farthestOf(Keys least, const VisibilityBuffer& visible)
{
    return depthOf(std::max(hn::GetLane(hn::MinOfLanes(I64(), least)), visible.background()));
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_PART_INL_H
