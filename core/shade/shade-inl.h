// Deferred shading: each pixel once, from the triangle that won it.
//
// Idea       base colour = table[rank]; a vector of pixels that all show one triangle needs a single look-up
#if defined(ZSCOPE_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_SHADE_INL_H
#undef ZSCOPE_SHADE_INL_H
#else
#define ZSCOPE_SHADE_INL_H
#endif

#include <hwy/highway.h>

#include "core/depth/visibility_buffer.h"
#include "core/shade/fragment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline void baseColoursFromTable(const std::uint32_t* rank, int width, const std::uint32_t* table, std::uint32_t* colour)
{
    const hn::ScalableTag<std::uint32_t> u32;
    const int                            lanes = static_cast<int>(hn::Lanes(u32));
    int                                  x     = 0;
    for (; x + lanes <= width; x += lanes) {
        const auto ranks = hn::LoadU(u32, rank + x);
        if (hn::AllTrue(u32, ranks == hn::Set(u32, rank[x]))) {
            hn::StoreU(hn::Set(u32, table[rank[x]]), u32, colour + x);
            continue;
        }
        hn::StoreU(hn::GatherIndex(u32, table, hn::BitCast(hn::RebindToSigned<decltype(u32)>(), ranks)), u32, colour + x);
    }
    for (; x < width; ++x) colour[x] = table[rank[x]];
}

/// Without a table: one computation per run of pixels that show the same triangle.
inline void baseColoursByRuns(const Painter& painter, const std::uint32_t* rank, int width, std::uint32_t* colour)
{
    std::uint32_t lastRank = 0, lastColour = kBackgroundColour;
    for (int x = 0; x < width; ++x) {
        if (rank[x] != lastRank) {
            lastRank   = rank[x];
            lastColour = painter.baseColour(lastRank);
        }
        colour[x] = lastColour;
    }
}

/// The fragment shader over the base colours of the pixels [x, width) of line y, those of the background left as they are.
template <class U32>
int shadeRow(U32 u32, const std::uint32_t* rank, int x, int width, int y, int operations, std::uint32_t* colour)
{
    const int lanes = static_cast<int>(hn::Lanes(u32));
    for (; x + lanes <= width; x += lanes) {
        const auto ranks = hn::LoadU(u32, rank + x);
        const auto shows = ranks != hn::Zero(u32);
        if (hn::AllFalse(u32, shows)) continue;
        const auto base = hn::LoadU(u32, colour + x);
        hn::StoreU(hn::IfThenElse(shows, shaded(u32, base, ranks, x, y, operations), base), u32, colour + x);
    }
    return x;
}

/// Lines [first, end).
inline void shadeRows(const Painter& painter, const VisibilityBuffer& visible, int first, int end)
{
    const int width = visible.width();
    for (int y = first; y < end; ++y) {
        const std::uint32_t* rank   = visible.rankRow(y);
        std::uint32_t*       colour = painter.colour.row(y).data();
        if (painter.table.isComplete())
            baseColoursFromTable(rank, width, painter.table.data(), colour);
        else
            baseColoursByRuns(painter, rank, width, colour);
        if (painter.operations == 0) continue;
        const int rest = shadeRow(hn::ScalableTag<std::uint32_t>(), rank, 0, width, y, painter.operations, colour);
        shadeRow(hn::CappedTag<std::uint32_t, 1>(), rank, rest, width, y, painter.operations, colour);
    }
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_SHADE_INL_H
