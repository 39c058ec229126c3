// Deferred shading: each pixel once, from the triangle that won it.
//
// Idea       base colour = table[rank]; a vector of pixels that all show one triangle needs a single look-up
#if defined(ZSCOPE_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_SHADE_INL_H
#undef ZSCOPE_SHADE_INL_H
#else
#define ZSCOPE_SHADE_INL_H
#endif

#include <algorithm>
#include <array>
#include <cstdint>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "core/depth/visibility_buffer.h"
#include "core/fast/lanes/fragment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Whom a pixel shows: background's key, or a smaller one, shows nobody.
inline std::uint32_t rankAt(const PixelKey* key, PixelKey background) { return rankOf(std::max(*key, background)); }

/// The same of as many keys as there are lanes.
template <class U32>
hn::Vec<U32> ranksAt(U32 u32, const PixelKey* keys, PixelKey background)
{
    if constexpr (hn::MaxLanes(U32()) == 1) {
        return hn::Set(u32, rankAt(keys, background));
    } else {
        const hn::RebindToSigned<U32> i32;
        const auto* halves = reinterpret_cast<const std::uint32_t*>(keys);  // lower, upper, lower, upper, ...
        const auto  first = hn::LoadU(u32, halves), second = hn::LoadU(u32, halves + hn::Lanes(u32));
        const auto  isShown = hn::BitCast(i32, hn::ConcatOdd(u32, second, first))
                             > hn::Set(i32, static_cast<std::int32_t>(background >> 32));
        return hn::IfThenElseZero(hn::RebindMask(u32, isShown), hn::Not(hn::ConcatEven(u32, second, first)));
    }
}

inline void baseColoursFromTable(const PixelKey* keys, PixelKey background, int width, const std::uint32_t* table,
                                 std::uint32_t* colour)
{
    const hn::ScalableTag<std::uint32_t> u32;
    const int                            lanes = static_cast<int>(hn::Lanes(u32));
    int                                  x     = 0;
    for (; x + lanes <= width; x += lanes) {
        const auto          ranks = ranksAt(u32, keys + x, background);
        const std::uint32_t first = hn::GetLane(ranks);
        if (hn::AllTrue(u32, ranks == hn::Set(u32, first))) {
            hn::StoreU(hn::Set(u32, table[first]), u32, colour + x);
            continue;
        }
        HWY_ALIGN std::array<std::uint32_t, hn::MaxLanes(decltype(u32)())> each;
        hn::Store(ranks, u32, each.data());
        for (int i = 0; i < lanes; ++i) colour[x + i] = table[each[static_cast<std::size_t>(i)]];
    }
    for (; x < width; ++x) colour[x] = table[rankAt(keys + x, background)];
}

/// Without a table: one computation per run of pixels that show the same triangle.
inline void baseColoursByRuns(const Painter& painter, const PixelKey* keys, PixelKey background, int width,
                              std::uint32_t* colour)
{
    std::uint32_t lastRank = 0, lastColour = kBackgroundColour;
    for (int x = 0; x < width; ++x) {
        if (const std::uint32_t rank = rankAt(keys + x, background); rank != lastRank) {
            lastRank   = rank;
            lastColour = painter.baseColour(lastRank);
        }
        colour[x] = lastColour;
    }
}

/// The fragment shader over the base colours of the pixels [x, width) of line y, those of the background left as they
/// are.
template <class U32>
int shadeRow(U32 u32, const PixelKey* keys, PixelKey background, int x, int width, int y, int operations,
             std::uint32_t* colour)
{
    const int lanes = static_cast<int>(hn::Lanes(u32));
    for (; x + lanes <= width; x += lanes) {
        const auto ranks = ranksAt(u32, keys + x, background);
        const auto shows = ranks != hn::Zero(u32);
        if (hn::AllFalse(u32, shows)) continue;
        const auto base   = hn::LoadU(u32, colour + x);
        const auto pixels = countFrom(u32, static_cast<std::uint32_t>(x) + (static_cast<std::uint32_t>(y) << 16));
        hn::StoreU(hn::IfThenElse(shows, shaded(u32, base, ranks, pixels, operations), base), u32, colour + x);
    }
    return x;
}

/// One colour for `width` pixels. Whole vectors are written past the caches: nobody reads them in this frame, and to
/// fetch what they overwrite would cost as much as to write them.
inline void fillColours(std::uint32_t* colour, int width, std::uint32_t value)
{
    const hn::ScalableTag<std::uint32_t> u32;
    const int                            lanes = static_cast<int>(hn::Lanes(u32));
    int                                  x     = 0;
    for (; x < width && reinterpret_cast<std::uintptr_t>(colour + x) % (hn::Lanes(u32) * sizeof(value)) != 0; ++x)
        colour[x] = value;
    for (; x + lanes <= width; x += lanes) hn::Stream(hn::Set(u32, value), u32, colour + x);
    for (; x < width; ++x) colour[x] = value;
}

/// Pixels [x0, x1) of line y.
inline void shadeSpan(const Painter& painter, const VisibilityBuffer& visible, int x0, int x1, int y)
{
    const PixelKey* keys       = visible.row(y);
    const PixelKey  background = visible.background();
    std::uint32_t*  colour     = painter.colour.row(y).data();
    if (painter.table.isComplete())
        baseColoursFromTable(keys + x0, background, x1 - x0, painter.table.data(), colour + x0);
    else
        baseColoursByRuns(painter, keys + x0, background, x1 - x0, colour + x0);
    if (painter.operations == 0) return;
    const int rest =
        shadeRow(hn::ScalableTag<std::uint32_t>(), keys, background, x0, x1, y, painter.operations, colour);
    shadeRow(hn::CappedTag<std::uint32_t, 1>(), keys, background, rest, x1, y, painter.operations, colour);
}

/// Gives the colour of background to the tiles that nothing was drawn to, if they had other colours before. Lines
/// [first, end) are whole lines of tiles, or end with the picture.
inline void colourUnopened(const Painter& painter, const VisibilityBuffer& visible, int first, int end)
{
    constexpr int kWidth = VisibilityBuffer::kTileWidth, kLines = VisibilityBuffer::kTileLines;
    for (int top = first; top < end; top += kLines)
        for (int left = 0; left < visible.width(); left += kWidth) {
            std::uint8_t& painted = painter.painted.at(left / kWidth, top / kLines);
            const bool    isOpen  = visible.isOpen(left, top);
            if (!isOpen && painted != 0)
                for (int y = top; y < std::min(top + kLines, end); ++y)
                    fillColours(painter.colour.row(y).data() + left, std::min(kWidth, visible.width() - left),
                                kBackgroundColour);
            painted = isOpen;
        }
    hwy::FlushStream();  // before another thread reads them
}

/// Lines [first, end), which are whole lines of tiles or end with the picture. Tiles that nothing was drawn to are
/// background, and need no colours if they had those before; tiles that show one triangle need no look at their pixels.
inline void shadeRows(const Painter& painter, const VisibilityBuffer& visible, int first, int end)
{
    constexpr int kWidth = VisibilityBuffer::kTileWidth, kLines = VisibilityBuffer::kTileLines;
    const int     tiles = (visible.width() + kWidth - 1) / kWidth;
    for (int top = first; top < end; top += kLines) {
        const int  bottom   = std::min(top + kLines, end);
        const auto isOpen   = [&](int tile) { return visible.isOpen(tile * kWidth, top); };
        const auto soleRank = [&](int tile) {
            const TilePlane* plane = visible.planeAt(tile * kWidth, top);
            return plane ? plane->rank : 0;
        };
        for (int tile = 0; tile < tiles;) {
            const bool          open = isOpen(tile);
            const std::uint32_t sole = soleRank(tile);
            const int           from = tile;
            bool                old  = false;  // some tile of the run has colours
            for (; tile < tiles && isOpen(tile) == open && soleRank(tile) == sole; ++tile) {
                if (!painter.painted.data) {
                    old = true;
                    continue;
                }
                std::uint8_t& painted = painter.painted.at(tile, top / kLines);
                old                   = old || painted != 0;
                painted               = open;
            }
            const int           x0 = from * kWidth, x1 = std::min(tile * kWidth, visible.width());
            const std::uint32_t colour = sole != 0 ? painter.baseColour(sole) : kBackgroundColour;
            for (int y = top; y < bottom && (open || old); ++y) {
                if (open && sole == 0)
                    shadeSpan(painter, visible, x0, x1, y);
                else
                    fillColours(painter.colour.row(y).data() + x0, x1 - x0, colour);
            }
        }
    }
    hwy::FlushStream();  // before another thread reads them
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_SHADE_INL_H
