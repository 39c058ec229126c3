// Tiles of the visibility buffer that are kept as a plane (core/depth/tile_plane.h), in the lanes of the depth test.
//
// Keep       a triangle that covers a tile whole to which nothing was drawn becomes the tile's plane: no pixel is
//            touched
// Compare    where a pyramid is kept, which compares before pixels do: a triangle behind the tile's plane everywhere is
//            skipped, and one that covers it whole and is nearer everywhere takes its place. The z-buffer by itself
//            tests pixels
// Write      only when something else is drawn to the tile, or at the end to who reads pixels; then past the caches
// Promise    the picture is the one that pixel by pixel would give: keys are what TilePlane::keyAt() says, to the bit
// Source     Hasselgren, Akenine-Moller: Efficient Depth Buffer Compression, Graphics Hardware 2006
#if defined(ZSCOPE_TILE_PLANE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_TILE_PLANE_INL_H
#undef ZSCOPE_TILE_PLANE_INL_H
#else
#define ZSCOPE_TILE_PLANE_INL_H
#endif

#include <array>
#include <span>

#include <hwy/cache_control.h>

#include "core/depth/pyramid.h"
#include "core/fast/lanes/depth_test-inl.h"
#include "core/fast/lanes/lane_order-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// Writes the keys of a tile. `kLast`: nobody reads them soon.
template <bool kLast>
void storeTile(VisibilityBuffer& visible, const PixelBox& tile, const TilePlane& plane)
{
    const ExactRules                           rules;
    const DepthTest<Keep::Nearest, ExactRules> test(plane.depth, plane.rank, visible.empty(), rules);
    constexpr std::size_t                      kVectors = VisibilityBuffer::kTileWidth / hn::MaxLanes(F64());
    const std::size_t vectors = (static_cast<std::size_t>(tile.x1 - tile.x0) + hn::Lanes(F64()) - 1) / hn::Lanes(F64());
    std::array<Vec64, kVectors> columns;
    for (std::size_t i = 0; i < kVectors; ++i) columns[i] = test.column(tile.x0 + static_cast<int>(i) * laneCount());
    LineDepths lines(plane.depth, tile.y0, rules);
    for (int y = tile.y0; y < tile.y1; ++y, lines.toNext()) {
        const auto line = lines.here();
        PixelKey*  row  = visible.row(y) + tile.x0;
        // the last may reach into the padding of the row
        for (std::size_t i = 0; i < vectors; ++i, row += laneCount()) {
            if constexpr (kLast)
                hn::Stream(test.keys(columns[i], line), I64(), row);
            else
                hn::Store(test.keys(columns[i], line), I64(), row);
        }
    }
}

/// Makes the tiles under the box ready to be drawn to.
inline void openTiles(VisibilityBuffer& visible, const PixelBox& box)
{
    visible.open(box,
                 [&visible](const PixelBox& tile, const TilePlane& plane) { storeTile<false>(visible, tile, plane); });
}

/// Lines [first, end), which are whole lines of tiles or end with the picture: nothing in them is kept as a plane any
/// longer.
inline void storePlanes(VisibilityBuffer& visible, int first, int end)
{
    visible.storePlanes(first, end, [&visible](const PixelBox& tile, const TilePlane& plane) {
        storeTile<true>(visible, tile, plane);
    });
    hwy::FlushStream();  // before another thread reads them
}

/// The depths at the pixel of each part of a box that is nearest or farthest, as nearestOver() and farthestOver() have
/// them. The box lies in one tile; parts are cut along multiples of kSide, and those that the box does not meet mean
/// nothing.
template <int kSide, bool kNearest>
HWY_INLINE auto depthsAlong(const DepthPlane& plane, const PixelBox& box)
{
    HWY_ALIGN std::array<float, VisibilityBuffer::kTileWidth / kSide> depths;
    const F64                                                         d64;
    const bool   isRight = (plane.a > 0) == kNearest, isLow = (plane.b > 0) == kNearest;
    const double first = VisibilityBuffer::leftOfTile(box.x0) + (isRight ? kSide - 0.5 : 0.5);
    const double line  = plane.b * ((isLow ? box.y1 - 1 : box.y0) + 0.5) + plane.c;
    for (std::size_t i = 0; i < depths.size(); i += hn::Lanes(d64)) {
        const auto inTile = countFrom(d64, static_cast<double>(i)) * hn::Set(d64, kSide) + hn::Set(d64, first);
        const auto column = hn::Min(hn::Max(inTile, hn::Set(d64, box.x0 + 0.5)), hn::Set(d64, box.x1 - 0.5));
        const auto z      = hn::Set(d64, plane.a) * column + hn::Set(d64, line);
        hn::Store(hn::DemoteTo(F32(), hn::Min(hn::Max(z, hn::Set(d64, plane.farthest)), hn::Set(d64, plane.nearest))),
                  F32(), depths.data() + i);
    }
    return depths;
}

/// What becomes of the part of a triangle's box that lies in one tile.
enum class PlaneAnswer {
    Hidden,  // it is behind the tile's plane
    Kept,    // it is the tile's plane now
    Asked,   // neither: pixel by pixel
};

/// `isCovered`: all of `here` is, which lies in one tile. `compares`: planes with planes.
inline PlaneAnswer offerPlane(VisibilityBuffer& visible, const PixelBox& here, bool isCovered, const TilePlane& offered,
                              bool compares)
{
    const TilePlane* held    = visible.planeAt(here.x0, here.y0);
    const bool       isWhole = isCovered && visible.isWholeTile(here);
    if (held) {
        if (!compares) return PlaneAnswer::Asked;
        if (nearestOver(offered.depth, here) < farthestOver(held->depth, here)) return PlaneAnswer::Hidden;
        if (!isWhole || !(farthestOver(offered.depth, here) > nearestOver(held->depth, here)))
            return PlaneAnswer::Asked;
    } else if (!isWhole || visible.isOpen(here.x0, here.y0)) {
        return PlaneAnswer::Asked;
    }
    // some of it may lie beyond the far plane
    if (!(offered.depth.farthest > visible.empty())) return PlaneAnswer::Asked;
    visible.setPlane(here.x0, here.y0, offered);
    return PlaneAnswer::Kept;
}

/// True if the part of the triangle's box in one tile of the visibility buffer needs not be drawn, because planes say
/// all there is to say. Who is shaded as it comes gets its colours here.
template <class Fragments, class Upkeep>
bool isKeptAsPlane(const PixelBox& here, bool isInside, const ScreenTriangle& triangle,
                   [[maybe_unused]] const Fragments& fragments, const Upkeep& upkeep, VisibilityBuffer& visible)
{
    constexpr int     kSide  = 1 << Pyramid::kTileLevel;
    const PlaneAnswer answer = offerPlane(visible, here, isInside, {triangle.depth, triangle.rank()}, upkeep.isKept());
    if (answer != PlaneAnswer::Kept) return answer == PlaneAnswer::Hidden;
    if constexpr (Fragments::kMoment != ShadingMoment::Never) fragments.shadeAll(here);
    if (upkeep.isKept()) {
        const auto farthest = depthsAlong<kSide, false>(triangle.depth, here);
        upkeep.drawnTiles(here.x0, here.y0,
                          std::span(farthest).first(static_cast<std::size_t>((here.x1 - here.x0 + kSide - 1) / kSide)));
    } else {
        upkeep.touched(here);
    }
    return true;
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_TILE_PLANE_INL_H
