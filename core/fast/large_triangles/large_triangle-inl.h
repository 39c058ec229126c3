// Large triangles at full speed: first which tiles of the pyramid they have pixels of, then those tiles, one kind after
// the other.
//
// Find       what the edges say of a line of tiles of the visibility buffer is found side by side; then, of those that
//            an edge crosses, what they say of the tiles of the pyramid in there. What is outside of one edge is not
//            listed. From there on no branch asks what nobody can foretell: whatever is found is written to the end of
//            a list, which then grows by it or does not
// Hidden     a tile of the pyramid whose stored depth hides the triangle is left out, where stale cells wait for a
//            query
// Kinds      by the edges that cross a tile: none, one of the three, or more. Tiles of a kind are tested one after the
//            other (part-inl.h)
// Wide       of triangles beyond the guard band float64 says what is so far from an edge that no rounding matters; 128
//            bits find the edges of other tiles anew, of which only those of the pyramid's that no edge crosses are
//            drawn here
// Pyramid    a tile's farthest depth was in registers when it was tested, and is told when all of a kind have been
// Planes     a tile of the visibility buffer that is covered whole may be kept as a plane (tile_plane-inl.h)
// Promise    the same pixels as EdgeWalk. Edge values are integers below 2^53, so float64 lanes hold them exactly
// Source     Pineda: A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; docs/correctness.md, Coverage
#if defined(ZSCOPE_LARGE_TRIANGLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_LARGE_TRIANGLE_INL_H
#undef ZSCOPE_LARGE_TRIANGLE_INL_H
#else
#define ZSCOPE_LARGE_TRIANGLE_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/depth/pyramid.h"
#include "core/fast/lanes/lane_order-inl.h"
#include "core/fast/large_triangles/part-inl.h"
#include "core/fast/tile_planes/tile_plane-inl.h"
#include "core/geometry/half_plane.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

/// A triangle without patterns. `kNormal` as in DepthTest; `Upkeep`: TileUpkeep.
template <Keep kKeep, bool kNormal, class Fragments, class Upkeep, class Rules>
class LargeTriangle {
    static constexpr int         kSide  = PartPasses::kSide;  // of a part: what lies in one tile of the pyramid
    static constexpr int         kWidth = VisibilityBuffer::kTileWidth, kLines = VisibilityBuffer::kTileLines;
    static constexpr std::size_t kParts      = kWidth / kSide,
                                 kVectors    = (kParts + hn::MaxLanes(F64()) - 1) / hn::MaxLanes(F64());
    static constexpr std::uint32_t kAllParts = (1u << kParts) - 1;
    static_assert(kSide == kLines && kParts == 8, "a line of parts is a byte of bits");

public:
    /// `edges` of a wide triangle are rounded.
    LargeTriangle(const ScreenTriangle& triangle, const Fragments& fragments, const HalfPlanes& edges,
                  const Upkeep& upkeep, VisibilityBuffer& visible, const Rules& rules)
        : m_triangle(triangle), m_fragments(fragments),
          m_edges(edges), m_partEdges{partEdge(0), partEdge(1), partEdge(2)}, m_upkeep(upkeep), m_visible(visible),
          m_rules(rules)
    {}

    /// drawOther(pixels of the box) is left with what lies in tiles of the visibility buffer that reach beyond the
    /// picture, and with what an edge crosses of a wide triangle.
    template <class Other>
    void draw(const Other& drawOther)
    {
        const PixelBox& box = m_triangle.box;
        findRanges();
        const int columns = (box.x1 - VisibilityBuffer::leftOfTile(box.x0) + kWidth - 1) / kWidth;
        for (int top = VisibilityBuffer::topOfTile(box.y0); top < box.y1; top += kLines) {
            const int         y0 = std::max(top, box.y0), y1 = std::min(top + kLines, box.y1);
            const LineOfTiles line{VisibilityBuffer::leftOfTile(box.x0),
                                   top,
                                   {overLine(0, top, y0, y1), overLine(1, top, y0, y1), overLine(2, top, y0, y1)}};
            for (int first = 0; first < columns; first += static_cast<int>(hn::Lanes(F64()))) {
                const Tiles tiles = tilesOf(line, first, columns);
                for (std::uint32_t rest = tiles.reached; rest != 0; rest &= rest - 1) {
                    const int left = line.left + (first + std::countr_zero(rest)) * kWidth;
                    const int x0 = std::max(left, box.x0), x1 = std::min(left + kWidth, box.x1);
                    if (left + kWidth > m_visible.width() || top + kLines > m_visible.height()) [[unlikely]]
                        drawOther(PixelBox{x0, y0, x1, y1});
                    else if (rest & -rest & tiles.inside)
                        m_tiles[m_tileCount++] = {
                            left, top, partsBetween(x0 - left, x1 - 1 - left), {kAllParts, kAllParts, kAllParts}};
                    else
                        find(left, top, line, partsBetween(x0 - left, x1 - 1 - left));
                    if (m_tileCount == kRoom) drawTiles(drawOther);
                }
            }
        }
        drawTiles(drawOther);
        drawParts();
    }

private:
    /// What an edge says of a line of tiles: its value at the first pixel of the first tile, and what that grows by, in
    /// the same column, to where it is largest in the lines of the box, and least in all lines.
    struct EdgeOverLine {
        double first, toMost, toLeast;
    };
    struct LineOfTiles {
        int                         left, top;
        std::array<EdgeOverLine, 3> edges;
    };
    /// Tiles side by side, bit by bit from the left: not wholly on the outer side of an edge, and wholly on the inner
    /// side of all, as far as that is certain.
    struct Tiles {
        std::uint32_t reached, inside;
    };
    /// Parts of a tile of the visibility buffer, bit by bit from the left.
    struct Found {
        std::int32_t                 left, top;
        std::uint32_t                reached;  // not wholly on the outer side of an edge
        std::array<std::uint32_t, 3> inside;   // wholly on the inner side of the k-th
    };
    /// The kinds: no edge crosses a part; the first, second or third alone does (1 to 3); more do.
    static constexpr std::size_t kNone = 0, kMore = 4, kKinds = 5;
    static constexpr std::size_t kRoom = 64;  // tiles in the list, and parts of a kind before they are drawn
    /// Edge values of wide triangles stay below 2^76, and so what float64 makes of them is wrong by much less than
    /// this.
    static constexpr double kWideMargin = 0x1p40;

    using Vectors = std::array<Vec64, kVectors>;

    /// Those that hold the pixels [right, lastRight] of a line, counted from the left of the tile.
    static std::uint32_t partsBetween(int right, int lastRight)
    {
        return (2u << (static_cast<unsigned>(lastRight) / kSide)) - (1u << (static_cast<unsigned>(right) / kSide));
    }

    /// From the first pixel of a tile to where an edge is largest and least in each of its parts, in the same line.
    void findRanges()
    {
        const F64 d64;
        for (std::size_t k = 0; k < 3; ++k) {
            const double step = m_edges.planes[k].perPixel, far = step * (kSide - 1);
            for (std::size_t i = 0; i < kVectors; ++i) {
                const auto first = countFrom(d64, static_cast<double>(i * hn::Lanes(d64))) * hn::Set(d64, step * kSide);
                m_most[k][i]     = first + hn::Set(d64, std::max(far, 0.0));
                m_least[k][i]    = first + hn::Set(d64, std::min(far, 0.0));
            }
        }
    }

    EdgeOverLine overLine(std::size_t k, int top, int y0, int y1) const
    {
        const HalfPlane& plane = m_edges.planes[k];
        return {plane.at(VisibilityBuffer::leftOfTile(m_triangle.box.x0) - m_edges.x0, top - m_edges.y0),
                std::max(plane.perLine * (y0 - top), plane.perLine * (y1 - 1 - top)),
                std::min(plane.perLine * (kLines - 1), 0.0)};
    }

    /// Those of the line from the `first` on, as many as there are lanes.
    HWY_INLINE Tiles tilesOf(const LineOfTiles& line, int first, int columns) const
    {
        const F64    d64;
        const double margin  = m_triangle.wide ? kWideMargin : 0;
        const auto   right   = countFrom(d64, first) * hn::Set(d64, kWidth);
        auto         reached = countFrom(d64, first) < hn::Set(d64, columns), inside = reached;
        for (std::size_t k = 0; k < 3; ++k) {
            const EdgeOverLine& edge = line.edges[k];
            const double        step = m_edges.planes[k].perPixel, across = step * (kWidth - 1);
            const auto          here = hn::Set(d64, edge.first) + hn::Set(d64, step) * right;
            reached =
                hn::And(reached, here + hn::Set(d64, edge.toMost + std::max(across, 0.0)) >= hn::Set(d64, -margin));
            inside = hn::And(inside, here + hn::Set(d64, edge.toLeast + std::min(across, 0.0)) >= hn::Set(d64, margin));
        }
        return {bitsOf(d64, reached), bitsOf(d64, inside)};
    }

    /// `inBox`: the parts of the tile at (left, top) that the box meets.
    HWY_INLINE void find(int left, int top, const LineOfTiles& line, std::uint32_t inBox)
    {
        const F64             d64;
        Found                 found{left, top, inBox, {}};
        std::array<double, 3> firsts;
        if (m_triangle.wide) [[unlikely]] {
            const auto planes = wideHalfPlanesOf(m_triangle, left, top);
            for (std::size_t k = 0; k < 3; ++k) firsts[k] = planes[k].origin;
        } else {
            for (std::size_t k = 0; k < 3; ++k)
                firsts[k] = line.edges[k].first + m_edges.planes[k].perPixel * (left - line.left);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const auto most       = hn::Set(d64, firsts[k] + line.edges[k].toMost),
                       least      = hn::Set(d64, firsts[k] + line.edges[k].toLeast);
            std::uint32_t reached = 0, inside = 0;
            for (std::size_t i = 0; i < kVectors; ++i) {
                reached |= bitsOf(d64, m_most[k][i] + most >= hn::Zero(d64)) << i * hn::Lanes(d64);
                inside |= bitsOf(d64, m_least[k][i] + least >= hn::Zero(d64)) << i * hn::Lanes(d64);
            }
            found.reached &= reached;
            found.inside[k] = inside;
        }
        m_tiles[m_tileCount] = found;
        m_tileCount += found.reached != 0;
    }

    /// No depth of the triangle that is stored in a part of `here` is nearer.
    HWY_INLINE auto nearestOfParts(const PixelBox& here) const
    {
        if constexpr (Rules::kExactDepths) {
            return depthsAlong<kSide, true>(m_triangle.depth, here);
        } else {
            HWY_ALIGN std::array<float, kParts> all;
            all.fill(m_rules.stored(m_triangle.depth.nearest));
            return all;
        }
    }

    /// The parts of the tile that `here` lies in where the triangle could win over what the pyramid holds, as it
    /// stands.
    std::uint32_t unhidden(const PixelBox& here) const
    {
        const auto    nearest = nearestOfParts(here);
        const float*  stored  = m_upkeep.pyramid->storedTiles(VisibilityBuffer::leftOfTile(here.x0), here.y0);
        const F32     f32;
        std::uint32_t hidden = 0;
        for (std::size_t i = 0; i < kParts; i += hn::Lanes(f32))
            hidden |= bitsOf(f32, hn::Load(f32, nearest.data() + i) < hn::LoadU(f32, stored + i)) << i;
        return ~hidden;
    }

    /// Keeps planes, opens tiles and lists parts of what was found. Parts are drawn when a list is full.
    template <class Other>
    void drawTiles(const Other& drawOther)
    {
        const PixelBox& box = m_triangle.box;
        for (std::size_t i = 0; i < m_tileCount; ++i) {
            const Found&        found  = m_tiles[i];
            const auto&         inside = found.inside;
            const int           left = found.left, top = found.top;
            const PixelBox      tile{left, top, left + kWidth, top + kLines};
            const PixelBox      here{std::max(left, box.x0), std::max(top, box.y0), std::min(tile.x1, box.x1),
                                std::min(tile.y1, box.y1)};
            const std::uint32_t none = inside[0] & inside[1] & inside[2];
            if constexpr (kKeep == Keep::Nearest && Rules::kExactDepths) {
                if (m_upkeep.takesPlanes && (none == kAllParts || m_visible.planeAt(left, top))
                    && isKeptAsPlane(here, none == kAllParts, m_triangle, m_fragments, m_upkeep, m_visible))
                    continue;
            }
            const std::uint32_t drawn = m_upkeep.isKept() ? found.reached & unhidden(here) : found.reached;
            if (!m_visible.isDrawn(left, top)) {
                if (drawn == 0) continue;
                openTiles(m_visible, tile);
            }
            list(kNone, drawn & none, left, top);
            if (none == kAllParts) {
                // Nothing else is left.
            } else if (m_triangle.wide) [[unlikely]] {
                for (std::uint32_t rest = drawn & ~none; rest != 0; rest &= rest - 1) {
                    const int x = left + std::countr_zero(rest) * kSide;
                    drawOther(PixelBox{std::max(x, here.x0), here.y0, std::min(x + kSide, here.x1), here.y1});
                }
            } else {
                const auto one = [&](std::size_t a, std::size_t b, std::size_t crossing) {
                    return inside[a] & inside[b] & ~inside[crossing];
                };
                const std::array<std::uint32_t, 3> ones{one(1, 2, 0), one(0, 2, 1), one(0, 1, 2)};
                for (std::size_t k = 0; k < 3; ++k) list(1 + k, drawn & ones[k], left, top);
                list(kMore, drawn & ~(none | ones[0] | ones[1] | ones[2]), left, top);
            }
            if (std::ranges::max(m_counts) > kRoom) drawParts();
        }
        m_tileCount = 0;
    }

    HWY_INLINE void list(std::size_t kind, std::uint32_t parts, int left, int top)
    {
        std::size_t&                        count = m_counts[kind];
        const hn::Rebind<std::uint8_t, I32> u8;
        for (std::size_t i = 0; i < kParts; i += hn::Lanes(I32())) {
            const auto right = hn::PromoteTo(I32(), hn::LoadU(u8, kSetBits[parts].data() + i));
            hn::StoreU(hn::ShiftLeft<Pyramid::kTileLevel>(right) + hn::Set(I32(), left), I32(),
                       m_lefts[kind].data() + count + i);
            hn::StoreU(hn::Set(I32(), top), I32(), m_tops[kind].data() + count + i);
        }
        count += static_cast<std::size_t>(std::popcount(parts));
    }

    /// What the lists hold, which are empty then.
    void drawParts()
    {
        drawKind<kNone>();
        drawKind<1>();
        drawKind<2>();
        drawKind<3>();
        drawKind<kMore>();
    }

    template <std::size_t kKind>
    void drawKind()
    {
        constexpr std::size_t kLaneKeys = hn::MaxLanes(I64());
        HWY_ALIGN std::array<PixelKey, (kRoom + kParts) * kLaneKeys> leasts;
        const std::size_t                                            count = std::exchange(m_counts[kKind], 0);
        for (std::size_t i = 0; i < count; ++i)
            hn::Store(test<kKind>(m_lefts[kKind][i], m_tops[kKind][i]), I64(), leasts.data() + i * kLaneKeys);
        if (m_upkeep.isKept()) {
            for (std::size_t i = 0; i < count; ++i)
                m_upkeep.pyramid->drawnTile(m_lefts[kKind][i], m_tops[kKind][i],
                                            farthestOf(hn::Load(I64(), leasts.data() + i * kLaneKeys), m_visible));
        } else if (m_upkeep.pyramid) {
            for (std::size_t i = 0; i < count; ++i)
                m_upkeep.touched(
                    {m_lefts[kKind][i], m_tops[kKind][i], m_lefts[kKind][i] + kSide, m_tops[kKind][i] + kSide});
        }
    }

    template <std::size_t kKind>
    HWY_INLINE Keys test(int x, int y) const
    {
        if constexpr (kKind == kNone)
            return testPart<kKeep, kNormal, 0>(m_triangle, m_fragments, {}, x, y, m_visible, m_rules);
        else if constexpr (kKind == kMore)
            return testPart<kKeep, kNormal, 3>(
                m_triangle, m_fragments, {&m_partEdges[0], &m_partEdges[1], &m_partEdges[2]}, x, y, m_visible, m_rules);
        else
            return testPart<kKeep, kNormal, 1>(m_triangle, m_fragments, {&m_partEdges[kKind - 1]}, x, y, m_visible,
                                               m_rules);
    }

    PartEdge partEdge(std::size_t k) const
    {
        return m_triangle.wide ? PartEdge({}, 0, 0) : PartEdge(m_edges.planes[k], m_edges.x0, m_edges.y0);
    }

    const ScreenTriangle&   m_triangle;
    const Fragments&        m_fragments;
    const HalfPlanes&       m_edges;
    std::array<PartEdge, 3> m_partEdges;  // not of a wide triangle
    const Upkeep&           m_upkeep;
    VisibilityBuffer&       m_visible;
    const Rules&            m_rules;

    std::array<Vectors, 3>   m_most, m_least;
    std::array<Found, kRoom> m_tiles;
    std::size_t              m_tileCount = 0;

    using Column = std::array<std::int32_t, kRoom + 2 * kParts>;
    std::array<Column, kKinds>      m_lefts, m_tops;
    std::array<std::size_t, kKinds> m_counts{};
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_LARGE_TRIANGLE_INL_H
