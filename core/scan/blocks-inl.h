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

/// From the triangles of a batch to the blocks that they may cover.
class BlockFinder {
public:
    /// `notOwned` is what an edge value is lowered by where the edge does not own its points.
    BlockFinder(const TriangleList& triangles, double notOwned, BlockList& list) : m_triangles(triangles), m_notOwned(notOwned), m_list(list)
    {
        list.clear();
        list.reserveTriangles(triangles.count);
    }

    /// The blocks of the triangles [first, end) that are drawn by blocks; calls others(i) for the rest, but for hidden ones.
    template <class Others>
    void add(std::size_t first, std::size_t end, const Others& others)
    {
        for (std::size_t i = first; i < end; i += hn::Lanes(F64())) {
            const auto isThere  = hn::Iota(F64(), static_cast<double>(i)) < hn::Set(F64(), static_cast<double>(end));
            const auto kind     = hn::LoadU(I32(), m_triangles.kind.data() + i);
            const auto lanes    = asLanes(isThere);
            const auto isHidden = hn::RebindMask(F32(), hn::TestBit(kind, hn::Set(I32(), TriangleList::kHidden)));
            const auto isDrawn  = hn::AndNot(isHidden, lanes);
            const auto special  = hn::And(kind, hn::Set(I32(), TriangleList::kWide | TriangleList::kPatterned)) != hn::Zero(I32());
            const auto byBlocks = hn::AndNot(hn::RebindMask(F32(), special), hn::And(isDrawn, findEdges(i)));
            addBlocks(i, byBlocks);
            forEach(hn::AndNot(byBlocks, isDrawn), i, others);
        }
    }

private:
    using I32  = hn::Rebind<std::int32_t, F64>;
    using VecF = hn::Vec<F32>;
    using VecI = hn::Vec<I32>;

    static hn::Mask<F32> asLanes(hn::Mask<F64> mask)
    {
        return hn::DemoteTo(F32(), hn::IfThenElseZero(mask, hn::Set(F64(), 1))) > hn::Zero(F32());
    }
    template <class Each>
    static void forEach(hn::Mask<F32> mask, std::size_t first, const Each& each)
    {
        if (hn::AllFalse(F32(), mask)) return;
        HWY_ALIGN std::array<float, hn::MaxLanes(F32())> lanes;
        hn::Store(hn::IfThenElseZero(mask, hn::Set(F32(), 1)), F32(), lanes.data());
        for (std::size_t lane = 0; lane < hn::Lanes(F32()); ++lane)
            if (lanes[lane] != 0) each(first + lane);
    }

    /// The edges of the triangles i, i + 1, ...; which of them have no side longer than kCompactSide.
    hn::Mask<F32> findEdges(std::size_t i)
    {
        const F64  d64;
        const auto at = [&](const std::vector<double>& column) HWY_ATTR { return hn::LoadU(d64, column.data() + i); };
        const std::array<Vec64, 3> x{at(m_triangles.x[0]), at(m_triangles.x[1]), at(m_triangles.x[2])};
        const std::array<Vec64, 3> y{at(m_triangles.y[0]), at(m_triangles.y[1]), at(m_triangles.y[2])};
        const auto centre = [&](const std::vector<std::int32_t>& column) HWY_ATTR {
            return hn::PromoteTo(d64, hn::LoadU(I32(), column.data() + i)) * hn::Set(d64, kSubpixels) + hn::Set(d64, 128);
        };
        const auto px = centre(m_triangles.x0), py = centre(m_triangles.y0);
        auto       longest = hn::Zero(d64);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const auto        dx = x[next] - x[k], dy = y[next] - y[k];
            longest              = hn::Max(longest, hn::Max(hn::Abs(dx), hn::Abs(dy)));
            const auto owns = hn::Or(dy < hn::Zero(d64), hn::And(dy == hn::Zero(d64), dx > hn::Zero(d64)));
            const auto edge = (dx * (py - y[k]) - dy * (px - x[k])) - hn::IfThenZeroElse(owns, hn::Set(d64, m_notOwned));
            keep(hn::Floor(edge * hn::Set(d64, 1 / kSubpixels)), m_list.origin[k], i);
            keep(hn::Neg(dy), m_list.perPixel[k], i);
            keep(dx, m_list.perLine[k], i);
        }
        return asLanes(longest <= hn::Set(d64, kCompactSide));
    }
    static void keep(Vec64 value, std::vector<float>& column, std::size_t i) { hn::StoreU(hn::DemoteTo(F32(), value), F32(), column.data() + i); }

    /// The blocks of those of the triangles i, i + 1, ... that `mask` names. Up to two by two of them are judged for all triangles
    /// side by side; a triangle with more has its blocks judged side by side.
    void addBlocks(std::size_t i, hn::Mask<F32> mask)
    {
        if (hn::AllFalse(F32(), mask)) return;
        const auto box   = [&](const std::vector<std::int32_t>& column) HWY_ATTR { return hn::LoadU(I32(), column.data() + i); };
        const auto x0 = box(m_triangles.x0), y0 = box(m_triangles.y0), x1 = box(m_triangles.x1), y1 = box(m_triangles.y1);
        const auto width = hn::Set(I32(), laneCount()), lines = hn::Set(I32(), kBlockLines);
        const auto left = hn::And(x0, hn::Set(I32(), -laneCount())), top = hn::And(y0, hn::Set(I32(), -kBlockLines));
        const auto isSecondColumn = hn::RebindMask(F32(), left + width < x1), isSecondLine = hn::RebindMask(F32(), top + lines < y1);
        const auto hasMore = hn::Or(hn::RebindMask(F32(), left + width + width < x1), hn::RebindMask(F32(), top + lines + lines < y1));
        const auto hasFew  = hn::AndNot(hasMore, mask);

        const auto owner = hn::Iota(U32(), static_cast<std::uint32_t>(i));
        const auto place = hn::BitCast(U32(), left) + hn::ShiftLeft<16>(hn::BitCast(U32(), top));
        const auto right = hn::ConvertTo(F32(), left - x0), down = hn::ConvertTo(F32(), top - y0);
        std::array<VecF, 3> best, across, below;  // per edge: at the innermost pixel of the first block; from block to block
        for (std::size_t k = 0; k < 3; ++k) {
            const auto perPixel = hn::LoadU(F32(), m_list.perPixel[k].data() + i), perLine = hn::LoadU(F32(), m_list.perLine[k].data() + i);
            const auto origin   = hn::LoadU(F32(), m_list.origin[k].data() + i);
            best[k]             = hn::MulAdd(right, perPixel, hn::MulAdd(down, perLine, origin)) +
                      hn::MulAdd(hn::Max(perPixel, hn::Zero(F32())), hn::Set(F32(), static_cast<float>(laneCount() - 1)),
                                 hn::Max(perLine, hn::Zero(F32())) * hn::Set(F32(), static_cast<float>(kBlockLines - 1)));
            across[k] = perPixel * hn::Set(F32(), static_cast<float>(laneCount()));
            below[k]  = perLine * hn::Set(F32(), static_cast<float>(kBlockLines));
        }
        m_list.reserveBlocks(4 * hn::Lanes(F32()));
        const auto judge = [&](std::array<VecF, 3> edge, hn::Mask<F32> exists, std::uint32_t offset) HWY_ATTR {
            const auto kept = hn::And(exists, hn::Min(hn::Min(edge[0], edge[1]), edge[2]) >= hn::Zero(F32()));
            const auto mine = hn::RebindMask(U32(), kept);
            hn::StoreU(hn::Compress(place + hn::Set(U32(), offset), mine), U32(), m_list.places.data() + m_list.count);
            hn::StoreU(hn::Compress(owner, mine), U32(), m_list.owners.data() + m_list.count);
            m_list.count += hn::CountTrue(F32(), kept);
        };
        const auto moved = [](std::array<VecF, 3> edge, const std::array<VecF, 3>& by) HWY_ATTR {
            return std::array<VecF, 3>{edge[0] + by[0], edge[1] + by[1], edge[2] + by[2]};
        };
        const std::uint32_t next = static_cast<std::uint32_t>(laneCount()), under = std::uint32_t{kBlockLines} << 16;
        judge(best, hasFew, 0);
        judge(moved(best, across), hn::And(hasFew, isSecondColumn), next);
        const auto hasLower = hn::And(hasFew, isSecondLine);
        if (!hn::AllFalse(F32(), hasLower)) {
            const auto lower = moved(best, below);
            judge(lower, hasLower, under);
            judge(moved(lower, across), hn::And(hasLower, isSecondColumn), under + next);
        }
        forEach(hn::And(mask, hasMore), i, [this](std::size_t t) { addMany(t); });
    }

    /// The blocks of one triangle, each judged at the pixel that lies farthest inside for the edge.
    void addMany(std::size_t t)
    {
        const hn::ScalableTag<float>              f32;
        const hn::RebindToUnsigned<decltype(f32)> u32;
        const hn::RebindToSigned<decltype(f32)>   i32;
        const std::size_t                         lanes = hn::Lanes(f32);

        const PixelBox box   = m_triangles.box(t);
        const int      width = laneCount(), x0 = box.x0 & -width, y0 = box.y0 & -kBlockLines;
        const int      columns = (box.x1 - x0 + width - 1) / width, lines = (box.y1 - y0 + kBlockLines - 1) / kBlockLines;
        const int      count   = columns * lines;
        m_list.reserveBlocks(static_cast<std::size_t>(count) + lanes);

        std::array<float, 3> corner, perPixel, perLine;
        for (std::size_t k = 0; k < 3; ++k) {
            perPixel[k] = m_list.perPixel[k][t];
            perLine[k]  = m_list.perLine[k][t];
            corner[k]   = m_list.origin[k][t] + std::max(perPixel[k], 0.0f) * static_cast<float>(width - 1) + std::max(perLine[k], 0.0f) * (kBlockLines - 1);
        }
        const auto perColumn = hn::Set(f32, static_cast<float>(width)), perRow = hn::Set(f32, static_cast<float>(kBlockLines));
        const auto across = hn::Set(f32, static_cast<float>(columns)), step = hn::Set(f32, 1 / static_cast<float>(columns));
        for (int first = 0; first < count; first += static_cast<int>(lanes)) {
            const auto at    = hn::Iota(f32, static_cast<float>(first));
            const auto row   = hn::Floor((at + hn::Set(f32, 0.5f)) * step);
            const auto right = (at - row * across) * perColumn + hn::Set(f32, static_cast<float>(x0 - box.x0));
            const auto down  = row * perRow + hn::Set(f32, static_cast<float>(y0 - box.y0));
            const auto best  = [&](std::size_t k) HWY_ATTR {
                return hn::MulAdd(right, hn::Set(f32, perPixel[k]), hn::MulAdd(down, hn::Set(f32, perLine[k]), hn::Set(f32, corner[k])));
            };
            const auto inside = hn::Min(hn::Min(best(0), best(1)), best(2)) >= hn::Zero(f32);
            const auto kept   = hn::And(inside, at < hn::Set(f32, static_cast<float>(count)));
            const auto x      = hn::BitCast(u32, hn::ConvertTo(i32, right)) + hn::Set(u32, static_cast<std::uint32_t>(box.x0));
            const auto y      = hn::BitCast(u32, hn::ConvertTo(i32, down)) + hn::Set(u32, static_cast<std::uint32_t>(box.y0));
            hn::StoreU(hn::Compress(hn::Or(x, hn::ShiftLeft<16>(y)), hn::RebindMask(u32, kept)), u32, m_list.places.data() + m_list.count);
            hn::StoreU(hn::Set(u32, static_cast<std::uint32_t>(t)), u32, m_list.owners.data() + m_list.count);
            m_list.count += hn::CountTrue(f32, kept);
        }
    }

    const TriangleList& m_triangles;
    double              m_notOwned;
    BlockList&          m_list;
};

/// Tests one block of triangle t and stores what it wins.
template <Keep kKeep, class Probe>
HWY_INLINE void testBlock(const TriangleList& triangles, const BlockList& list, std::size_t t, int x, int y, VisibilityBuffer& visible,
                          [[maybe_unused]] const Probe& probe)
{
    const F64                                d64;
    const F32                                d32;
    const Block32                            f32;
    const hn::Rebind<std::uint32_t, Block32> u32;

    const auto columns = hn::Iota(d32, static_cast<float>(x - triangles.x0[t]));
    const auto right   = bothLines(columns, columns);
    const auto top     = static_cast<float>(y - triangles.y0[t]);
    const auto down    = bothLines(hn::Set(d32, top), hn::Set(d32, top + 1));
    const auto edge    = [&](std::size_t k) HWY_ATTR {
        return hn::MulAdd(right, hn::Set(f32, list.perPixel[k][t]), hn::MulAdd(down, hn::Set(f32, list.perLine[k][t]), hn::Set(f32, list.origin[k][t])));
    };
    const auto inside = hn::Min(hn::Min(edge(0), edge(1)), edge(2)) >= hn::Zero(f32);

    const double a = triangles.a[t], b = triangles.b[t], c = triangles.c[t];
    const auto   column = hn::Set(d64, a) * (hn::Iota(d64, 0.0) + hn::Set(d64, x + 0.5));
    const auto   line   = [&](int at) HWY_ATTR { return hn::DemoteTo(d32, column + hn::Set(d64, b * (at + 0.5) + c)); };
    const auto   z      = hn::Min(hn::Max(bothLines(line(y), line(y + kBlockLines - 1)), hn::Set(f32, triangles.farthest[t])),
                                  hn::Set(f32, triangles.nearest[t]));
    const auto   depth  = hn::IfThenElse(inside, z, hn::Set(f32, static_cast<float>(kNotCovered)));

    float* const         depthAt = visible.depthRow(y) + x;
    std::uint32_t* const rankAt  = visible.rankRow(y) + x;
    const auto           stored  = loadBlock(depthAt, visible.stride());
    const auto           holder  = loadBlock(rankAt, visible.stride());
    const auto           rank    = hn::Set(u32, triangles.id[t] + 1);
    const auto           won     = winners<kKeep>(f32, depth, stored, rank, holder, visible.empty());
    if constexpr (kKeep != Keep::Equal) storeBlock(hn::IfThenElse(won, depth, stored), depthAt, visible.stride());
    if constexpr (kKeep != Keep::DepthOnly)
        storeBlock(hn::IfThenElse(hn::RebindMask(u32, won), rank, holder), rankAt, visible.stride());

    if constexpr (Probe::listens) {
        static_assert(!Probe::listens || hn::MaxLanes(F64()) == 1, "a run that is listened to uses one lane");
        if (hn::AllFalse(f32, inside)) return;
        probe(PixelTested{x, y, TriangleId{triangles.id[t]}, hn::GetLane(depth), !hn::AllFalse(f32, won), hn::GetLane(holder),
                          hn::GetLane(stored), kKeep, false, false});
    }
}

/// Works the list off and empties it.
template <Keep kKeep, class Probe>
void testBlocks(const TriangleList& triangles, BlockList& list, VisibilityBuffer& visible, const Probe& probe)
{
    constexpr std::size_t kAhead = 12;  // blocks, so that memory has time to answer
    const std::size_t     count  = list.count;
    for (std::size_t i = 0; i < count; ++i) {
        const BlockPlace soon = list.block(std::min(i + kAhead, count - 1));
        for (int line = 0; line < kBlockLines; ++line) {
            hwy::Prefetch(visible.depthRow(soon.y + line) + soon.x);
            hwy::Prefetch(visible.rankRow(soon.y + line) + soon.x);
        }
        const BlockPlace block = list.block(i);
        testBlock<kKeep>(triangles, list, list.owners[i], block.x, block.y, visible, probe);
    }
    list.clear();
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_BLOCKS_INL_H
