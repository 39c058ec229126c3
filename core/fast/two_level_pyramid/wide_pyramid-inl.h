// What a wide pyramid (core/depth/pyramid.h) hides, a line of cells at a time.
//
// Tiles      of a small box are read at once; what any of them does not decide, a few pixels and then the tile itself
//            do
// Blocks     of a larger one come first. What is stored of a block was true when somebody last looked, and depths only
//            grow: if it does not hide, the block's tiles are looked through anew, and what they hold is stored
// Promise    as Pyramid::hides() has it: the same answers, whatever else is read on the way
// Source     Greene, Kass, Miller: Hierarchical Z-Buffer Visibility, SIGGRAPH 1993
#if defined(ZSCOPE_WIDE_PYRAMID_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_WIDE_PYRAMID_INL_H
#undef ZSCOPE_WIDE_PYRAMID_INL_H
#else
#define ZSCOPE_WIDE_PYRAMID_INL_H
#endif

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/depth/pyramid.h"
#include "core/fast/lanes/lane_order-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

class WidePyramid {
    using D = hn::ScalableTag<float>;

    // of a block, in tiles
    static constexpr int kShift = Pyramid::kBlockLevel - Pyramid::kTileLevel, kSide = 1 << kShift;
    static constexpr int kManyTiles = kSide * kSide;  // from so many on blocks are looked at first

public:
    explicit WidePyramid(Pyramid& pyramid) : m_pyramid(pyramid) {}

    /// True if nothing at depth `nearest` or farther, inside the box (not empty, inside the region) and of the shape,
    /// could win a pixel.
    template <class Shape>
    bool hides(const PixelBox& box, float nearest, const Shape& shape) const
    {
        const int      top = m_pyramid.firstRow();
        const PixelBox tiles{box.x0 >> Pyramid::kTileLevel, (box.y0 - top) >> Pyramid::kTileLevel,
                             ((box.x1 - 1) >> Pyramid::kTileLevel) + 1,
                             ((box.y1 - 1 - top) >> Pyramid::kTileLevel) + 1};
        bool           isAsked = false;
        const auto shows = [&] { return !std::exchange(isAsked, true) && m_pyramid.showsAtOnce(box, nearest, shape); };
        const auto tileHides = [&](int x, int y) { return !shows() && m_pyramid.tileHides(x, y, box, nearest, shape); };
        if (tiles.area() < kManyTiles) return allHide(m_pyramid.tiles(), tiles, nearest, tileHides);
        return blocksHide(tiles, nearest, shows, tileHides);
    }

private:
    /// Whether all of `cells` hide, by what is stored or as orElse(x, y) says, which is asked about the others until it
    /// says no.
    template <class OrElse>
    static bool allHide(GridView<const float> stored, const PixelBox& cells, float nearest, const OrElse& orElse)
    {
        const D    d;
        const auto depth = hn::Set(d, nearest);
        for (int y = cells.y0; y < cells.y1; ++y) {
            const float* row = stored.row(y).data();
            for (int x = cells.x0; x < cells.x1; x += static_cast<int>(hn::Lanes(d))) {
                const auto isCell = hn::RebindMask(
                    d, hn::Iota(hn::RebindToSigned<D>(), 0) < hn::Set(hn::RebindToSigned<D>(), cells.x1 - x));
                for (std::uint32_t open = bitsOf(d, hn::AndNot(depth < hn::LoadU(d, row + x), isCell)); open != 0;
                     open &= open - 1)
                    if (!orElse(x + std::countr_zero(open), y)) return false;
            }
        }
        return true;
    }

    template <class Shows, class OrElse>
    HWY_NOINLINE bool blocksHide(const PixelBox& tiles, float nearest, const Shows& shows, const OrElse& orElse) const
    {
        const GridView<float>       blocks = m_pyramid.blocks();
        const GridView<const float> stored = m_pyramid.tiles();
        const PixelBox              touched{tiles.x0 >> kShift, tiles.y0 >> kShift, ((tiles.x1 - 1) >> kShift) + 1,
                               ((tiles.y1 - 1) >> kShift) + 1};
        return allHide(blocks, touched, nearest, [&](int x, int y) {
            if (shows()) return false;
            const PixelBox all{x * kSide, y * kSide, std::min((x + 1) * kSide, stored.width),
                               std::min((y + 1) * kSide, stored.height)};
            float&         block = blocks.at(x, y);
            block                = farthest(stored, all);
            if (nearest < block) return true;
            const PixelBox here{std::max(all.x0, tiles.x0), std::max(all.y0, tiles.y0), std::min(all.x1, tiles.x1),
                                std::min(all.y1, tiles.y1)};
            return allHide(stored, here, nearest, orElse);
        });
    }

    static float farthest(GridView<const float> stored, const PixelBox& tiles)
    {
        const hn::CappedTag<float, kSide> d;
        auto                              least = hn::Set(d, stored.at(tiles.x0, tiles.y0));
        for (int y = tiles.y0; y < tiles.y1; ++y) {
            const float* row = stored.row(y).data();
            int          x   = tiles.x0;
            for (; x + static_cast<int>(hn::Lanes(d)) <= tiles.x1; x += static_cast<int>(hn::Lanes(d)))
                least = hn::Min(least, hn::LoadU(d, row + x));
            for (; x < tiles.x1; ++x) least = hn::Min(least, hn::Set(d, row[x]));
        }
        return hn::GetLane(hn::MinOfLanes(d, least));
    }

    Pyramid& m_pyramid;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_WIDE_PYRAMID_INL_H
