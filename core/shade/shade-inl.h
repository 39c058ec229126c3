// Deferred shading: each pixel once, from the triangle that won it.
//
// Idea       colour = table[rank]; a vector of pixels that all show one triangle needs a single look-up
#if defined(ZSCOPE_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_SHADE_INL_H
#undef ZSCOPE_SHADE_INL_H
#else
#define ZSCOPE_SHADE_INL_H
#endif

#include <hwy/highway.h>

#include "core/depth/visibility_buffer.h"
#include "core/shade/colour_table.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline void shadeRowFromTable(const std::uint32_t* rank, int width, const std::uint32_t* table, std::uint32_t* colour)
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
inline void shadeRowByRuns(const Scene& scene, const std::uint32_t* rank, int width, std::uint32_t* colour)
{
    std::uint32_t lastRank = 0, lastColour = kBackgroundColour;
    for (int x = 0; x < width; ++x) {
        if (rank[x] != lastRank) {
            lastRank                  = rank[x];
            const InstanceId instance = lastRank == 0 ? InstanceId{} : scene.instanceOf(TriangleId{lastRank - 1});
            lastColour = lastRank == 0 ? kBackgroundColour
                                       : colourOf(scene, instance, lastRank - 1 - scene.firstTriangle[instance.value]);
        }
        colour[x] = lastColour;
    }
}

/// Lines [first, end). `colour` has the picture's size.
inline void shadeRows(const Scene& scene, const ColourTable& table, const VisibilityBuffer& visible, int first, int end,
                      GridView<std::uint32_t> colour)
{
    for (int y = first; y < end; ++y) {
        if (table.isComplete())
            shadeRowFromTable(visible.rankRow(y), visible.width(), table.data(), colour.row(y).data());
        else
            shadeRowByRuns(scene, visible.rankRow(y), visible.width(), colour.row(y).data());
    }
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_SHADE_INL_H
