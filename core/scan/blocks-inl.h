// Small triangles to pixels by blocks: a list of (triangle, block) that is worked off without asking which triangle comes next.
//
// Block      a vector of neighbouring pixels on kBlockLines lines, on a fixed grid, so that what one block stores the next
//            can load whole
// Edges      a value at a pixel centre is 256 times an integer plus what it is at the first pixel. Divided by 256 and rounded
//            down it keeps its sign; where no side is longer than kCompactSide it is an integer below 2^24, which float32 lanes
//            hold exactly
// Depth      as in depth_test-inl.h: float64 until it is stored. The limits are float32 values and rounding is monotone, so
//            they may be applied after it
// List       triangles of one batch, because a loop over one triangle's few blocks is mispredicted at every triangle
// Promise    the same pixels as HalfSpace and EdgeWalk. A block may reach beyond its triangle's box, never beyond the stripe,
//            whose borders are on the grid, but for the picture's padding (core/depth/visibility_buffer.h)
// Source     Pineda: A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; docs/correctness.md, Coverage
#if defined(ZSCOPE_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_BLOCKS_INL_H
#undef ZSCOPE_BLOCKS_INL_H
#else
#define ZSCOPE_BLOCKS_INL_H
#endif

#include <algorithm>
#include <array>
#include <cmath>

#include <hwy/cache_control.h>

#include "core/geometry/half_plane.h"
#include "core/scan/block_list.h"
#include "core/scan/depth_test-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR
inline constexpr int kBlockLines = 1;
using Block32                    = F32;
inline hn::Vec<Block32> bothLines(hn::Vec<F32> upper, hn::Vec<F32>) { return upper; }
inline hn::Vec<Block32> loadBlock(const float* row, std::ptrdiff_t) { return hn::LoadU(F32(), row); }
inline void storeBlock(hn::Vec<Block32> block, float* row, std::ptrdiff_t) { hn::StoreU(block, F32(), row); }
inline hn::Vec<U32> loadBlock(const std::uint32_t* row, std::ptrdiff_t) { return hn::LoadU(U32(), row); }
inline void storeBlock(hn::Vec<U32> block, std::uint32_t* row, std::ptrdiff_t) { hn::StoreU(block, U32(), row); }
#else
inline constexpr int kBlockLines = 2;
using Block32                    = hn::Twice<F32>;
inline hn::Vec<Block32> bothLines(hn::Vec<F32> upper, hn::Vec<F32> lower) { return hn::Combine(Block32(), lower, upper); }
template <class T>
auto loadBlock(const T* row, std::ptrdiff_t stride)
{
    const hn::Rebind<T, F32> line;
    return hn::Combine(hn::Rebind<T, Block32>(), hn::LoadU(line, row + stride), hn::LoadU(line, row));
}
template <class T>
void storeBlock(hn::Vec<hn::Rebind<T, Block32>> block, T* row, std::ptrdiff_t stride)
{
    const hn::Rebind<T, F32> line;
    hn::StoreU(hn::LowerHalf(line, block), line, row);
    hn::StoreU(hn::UpperHalf(line, block), line, row + stride);
}
#endif

/// Takes a triangle into the list, and those of its blocks that it may cover. isCompact(triangle) must be true.
inline void addBlocks(const ScreenTriangle& triangle, const std::array<HalfPlane, 3>& planes, BlockList& list)
{
    const hn::ScalableTag<float>              f32;
    const hn::RebindToUnsigned<decltype(f32)> u32;
    const hn::RebindToSigned<decltype(f32)>   i32;
    const std::size_t                         lanes = hn::Lanes(f32);

    const PixelBox& box = triangle.box;
    BlockTriangle&  to  = list.nextTriangle();
    to.x0               = box.x0;
    to.y0               = box.y0;
    for (std::size_t i = 0; i < 3; ++i) {
        to.origin[i]   = static_cast<float>(std::floor(planes[i].origin * (1 / kSubpixels)));
        to.perPixel[i] = static_cast<float>(planes[i].perPixel * (1 / kSubpixels));
        to.perLine[i]  = static_cast<float>(planes[i].perLine * (1 / kSubpixels));
    }
    to.depth = triangle.depth;
    to.rank  = triangle.rank();

    const int  width = laneCount(), x0 = box.x0 & -width, y0 = box.y0 & -kBlockLines;
    const int  columns = (box.x1 - x0 + width - 1) / width, lines = (box.y1 - y0 + kBlockLines - 1) / kBlockLines;
    const int  count   = columns * lines;
    if (columns <= 2 && lines <= 2) {  // too few to choose from: all of them, without a branch
        const BlockList::Room room  = list.room(4);
        const auto            first = static_cast<std::uint32_t>(x0) + (static_cast<std::uint32_t>(y0) << 16);
        const std::uint32_t   below = std::uint32_t{kBlockLines} << 16;
        room.places[0] = first;
        room.places[1] = first + (columns == 2 ? static_cast<std::uint32_t>(width) : below);
        room.places[2] = first + below;
        room.places[3] = first + below + static_cast<std::uint32_t>(width);
        for (int i = 0; i < 4; ++i) room.triangles[i] = room.triangle;
        list.keep(static_cast<std::size_t>(count));
        return;
    }

    // Several blocks side by side, each judged at the pixel that lies farthest inside for the edge.
    const auto perColumn = hn::Set(f32, static_cast<float>(width)), perRow = hn::Set(f32, static_cast<float>(kBlockLines));
    const auto across = hn::Set(f32, static_cast<float>(columns)), step = hn::Set(f32, 1 / static_cast<float>(columns));
    for (int first = 0; first < count; first += static_cast<int>(lanes)) {
        const auto at    = hn::Iota(f32, static_cast<float>(first));
        const auto row   = hn::Floor((at + hn::Set(f32, 0.5f)) * step);
        const auto right = (at - row * across) * perColumn + hn::Set(f32, static_cast<float>(x0 - box.x0));
        const auto down  = row * perRow + hn::Set(f32, static_cast<float>(y0 - box.y0));
        const auto best  = [&](std::size_t i) HWY_ATTR {
            const float a = to.perPixel[i], b = to.perLine[i];
            const float corner = to.origin[i] + std::max(a, 0.0f) * static_cast<float>(width - 1) + std::max(b, 0.0f) * (kBlockLines - 1);
            return hn::Set(f32, corner) + right * hn::Set(f32, a) + down * hn::Set(f32, b);
        };
        const auto inside = hn::Min(hn::Min(best(0), best(1)), best(2)) >= hn::Zero(f32);
        const auto kept   = hn::And(inside, at < hn::Set(f32, static_cast<float>(count)));
        const auto x      = hn::BitCast(u32, hn::ConvertTo(i32, right)) + hn::Set(u32, static_cast<std::uint32_t>(box.x0));
        const auto y      = hn::BitCast(u32, hn::ConvertTo(i32, down)) + hn::Set(u32, static_cast<std::uint32_t>(box.y0));
        const BlockList::Room room = list.room(lanes);
        hn::StoreU(hn::Compress(hn::Or(x, hn::ShiftLeft<16>(y)), hn::RebindMask(u32, kept)), u32, room.places);
        hn::StoreU(hn::Set(u32, room.triangle), u32, room.triangles);
        list.keep(hn::CountTrue(f32, kept));
    }
}

/// Tests one block and stores what it wins.
template <Keep kKeep, class Probe>
HWY_INLINE void testBlock(const BlockTriangle& triangle, int x, int y, VisibilityBuffer& visible, [[maybe_unused]] const Probe& probe)
{
    const F64                              d64;
    const F32                              d32;
    const Block32                          f32;
    const hn::Rebind<std::uint32_t, Block32> u32;

    const auto columns = hn::Iota(d32, static_cast<float>(x - triangle.x0));
    const auto right   = bothLines(columns, columns);
    const auto top     = static_cast<float>(y - triangle.y0);
    const auto down    = bothLines(hn::Set(d32, top), hn::Set(d32, top + 1));
    const auto edge    = [&](std::size_t i) HWY_ATTR {
        return hn::Set(f32, triangle.origin[i]) + right * hn::Set(f32, triangle.perPixel[i]) + down * hn::Set(f32, triangle.perLine[i]);
    };
    const auto inside = hn::Min(hn::Min(edge(0), edge(1)), edge(2)) >= hn::Zero(f32);

    const DepthPlane& plane  = triangle.depth;
    const auto        column = hn::Set(d64, plane.a) * (hn::Iota(d64, 0.0) + hn::Set(d64, x + 0.5));
    const auto        line   = [&](int at) HWY_ATTR {
        return hn::DemoteTo(d32, column + hn::Set(d64, plane.b * (at + 0.5) + plane.c));
    };
    const auto z     = hn::Min(hn::Max(bothLines(line(y), line(y + kBlockLines - 1)), hn::Set(f32, plane.farthest)), hn::Set(f32, plane.nearest));
    const auto depth = hn::IfThenElse(inside, z, hn::Set(f32, static_cast<float>(kNotCovered)));

    float* const         depthAt = visible.depthRow(y) + x;
    std::uint32_t* const rankAt  = visible.rankRow(y) + x;
    const auto           stored  = loadBlock(depthAt, visible.stride());
    const auto           holder  = loadBlock(rankAt, visible.stride());
    const auto           rank    = hn::Set(u32, triangle.rank);
    const auto           won     = winners<kKeep>(f32, depth, stored, rank, holder, visible.empty());
    if constexpr (kKeep != Keep::Equal) storeBlock(hn::IfThenElse(won, depth, stored), depthAt, visible.stride());
    if constexpr (kKeep != Keep::DepthOnly)
        storeBlock(hn::IfThenElse(hn::RebindMask(u32, won), rank, holder), rankAt, visible.stride());

    if constexpr (Probe::listens) {
        static_assert(!Probe::listens || hn::MaxLanes(F64()) == 1, "a run that is listened to uses one lane");
        if (hn::AllFalse(f32, inside)) return;
        probe(PixelTested{x, y, TriangleId{triangle.rank - 1}, hn::GetLane(depth), !hn::AllFalse(f32, won), hn::GetLane(holder),
                          hn::GetLane(stored), kKeep, false, false});
    }
}

/// Works the list off and empties it.
template <Keep kKeep, class Probe>
void testBlocks(BlockList& list, VisibilityBuffer& visible, const Probe& probe)
{
    constexpr std::size_t kAhead = 12;  // blocks, so that memory has time to answer
    const std::size_t     count  = list.size();
    for (std::size_t i = 0; i < count; ++i) {
        const BlockPlace soon = list.block(std::min(i + kAhead, count - 1));
        for (int line = 0; line < kBlockLines; ++line) {
            hwy::Prefetch(visible.depthRow(soon.y + line) + soon.x);
            hwy::Prefetch(visible.rankRow(soon.y + line) + soon.x);
        }
        const BlockPlace block = list.block(i);
        testBlock<kKeep>(list.triangle(i), block.x, block.y, visible, probe);
    }
    list.clear();
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_BLOCKS_INL_H
