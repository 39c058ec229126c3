// Hidden squares from the visibility buffer, lines side by side; and questions about the boxes of several triangles
// side by side.
//
// Promise    a yes is true of every triangle of the batch whose pixels lie in the box: each loses all of them. A no
//            says nothing
// Cost       one comparison per pixel of the reach, then for each side four ands per 32 pixels of a line; per vector of
//            boxes one load for each
// Source     core/fast/hidden_squares/hidden_squares.h
#if defined(ZSCOPE_HIDDEN_SQUARES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_HIDDEN_SQUARES_INL_H
#undef ZSCOPE_HIDDEN_SQUARES_INL_H
#else
#define ZSCOPE_HIDDEN_SQUARES_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <hwy/highway.h>

#include "core/depth/tile_plane.h"
#include "core/depth/visibility_buffer.h"
#include "core/fast/hidden_squares/hidden_squares.h"
#include "core/fast/lanes/lane_loads-inl.h"
#include "core/fast/lanes/lane_order-inl.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

class HiddenSquaresFinder {
    using D = hn::ScalableTag<std::uint32_t>;
    using V = hn::Vec<D>;

    static constexpr int kWordPixels = HiddenSquares::kWordPixels;
    static constexpr int kGroup      = kWordPixels / 2;  // pixels that are compared together; they lie in one tile
    static_assert(VisibilityBuffer::kTileWidth % kGroup == 0 && kGroup <= kRowPadding);
    static constexpr std::uint32_t kWholeGroup = 0xFFFF;

public:
    /// Finds the squares of a batch that reaches the pixels of `reach` (not empty, inside the picture), nowhere nearer
    /// than `nearest`. If the reach is too large, nobody looks.
    static HiddenPart find(const VisibilityBuffer& visible, const PixelBox& reach, float nearest, HiddenSquares& out)
    {
        out.levels        = 0;
        out.reach         = reach;
        out.left          = reach.x0 / kGroup * kGroup;
        const int columns = (reach.x1 - out.left + kWordPixels - 1) / kWordPixels, lines = reach.y1 - reach.y0;
        if (columns > HiddenSquares::kMostColumns || lines > HiddenSquares::kMostLines) return HiddenPart::Nothing;
        out.lineShift  = std::bit_width(static_cast<unsigned>(lines + kSpareLines - 1));
        out.levelShift = out.lineShift + std::bit_width(static_cast<unsigned>(columns - 1));
        HiddenSquaresFinder finder(visible, nearest, columns, lines, out);
        finder.comparePixels();
        if (const HiddenPart part = finder.finishPixels(); part != HiddenPart::Squares) return part;
        out.levels        = 1;
        const auto& sides = HiddenSquares::kSides;
        for (std::size_t level = 1; level < sides.size() && finder.grow(sides[level] - sides[level - 1]); ++level)
            ++out.levels;
        return HiddenPart::Squares;
    }

private:
    static constexpr int kSpareLines = 32;  // of a column, behind its last: whole vectors are written there
    static_assert(HiddenSquares::kMostLines + kSpareLines <= HiddenSquares::kColumnWords);

    HiddenSquaresFinder(const VisibilityBuffer& visible, float nearest, int columns, int lines, HiddenSquares& out)
        : m_visible(visible), m_nearest(nearest), m_columns(columns), m_lines(lines), m_out(out)
    {}

    /// The words of a column, of the level after the last that is there, or of that one.
    std::uint32_t* next(int column) const { return at(m_out.levels, column); }
    std::uint32_t* last(int column) const { return at(m_out.levels - 1, column); }
    std::uint32_t* at(int level, int column) const
    {
        return m_out.words.data()
               + (static_cast<std::size_t>(level) << m_out.levelShift
                  | static_cast<std::size_t>(column) << m_out.lineShift);
    }

    void comparePixels() const
    {
        const PixelBox& reach = m_out.reach;
        for (int top = reach.y0; top < reach.y1;) {
            const int bottom =
                std::min(reach.y1, (top / VisibilityBuffer::kTileLines + 1) * VisibilityBuffer::kTileLines);
            for (int column = 0; column < m_columns; ++column) {
                const int x = m_out.left + kWordPixels * column;
                compareGroup<0>(x, top, bottom, next(column));
                compareGroup<kGroup>(x + kGroup, top, bottom, next(column));
            }
            top = bottom;
        }
    }

    /// `kShift`: which half of the words the group is; the lower one comes first.
    template <int kShift>
    void compareGroup(int x, int top, int bottom, std::uint32_t* column) const
    {
        const PixelBox& reach = m_out.reach;
        const auto      put   = [&](int y, std::uint32_t bits) {
            std::uint32_t& word = column[y - reach.y0];
            word                = kShift == 0 ? bits : word | bits << kShift;
        };
        std::uint32_t all = kWholeGroup;
        if (x < reach.x1) {
            if (!m_visible.isReadable(x, top)) {
                all = 0;
            } else if (const TilePlane* plane = m_visible.planeAt(x, top)) {
                all = farthestOver(plane->depth, {x, top, std::min(x + kGroup, m_visible.width()), bottom}) > m_nearest
                          ? kWholeGroup
                          : 0;
            } else {
                const std::ptrdiff_t stride = m_visible.stride();
                const PixelKey*      row    = m_visible.row(top) + x;
                for (int y = top; y < bottom; ++y, row += stride) put(y, nearerThanBatch(row));
                return;
            }
        }
        for (int y = top; y < bottom; ++y) put(y, all);
    }

    /// Bit i: row[i] is nearer than the whole batch.
    std::uint32_t nearerThanBatch(const PixelKey* row) const
    {
        const std::int32_t                  nearest = inOrder(std::bit_cast<std::int32_t>(m_nearest));
        std::uint32_t                       bits    = 0;
        const hn::ScalableTag<std::int32_t> d;
        const hn::ScalableTag<PixelKey>     keys;
        for (std::size_t i = 0; i < kGroup; i += hn::Lanes(d)) {
            const auto uppers = hn::ConcatOdd(d, hn::BitCast(d, hn::LoadU(keys, row + i + hn::Lanes(keys))),
                                              hn::BitCast(d, hn::LoadU(keys, row + i)));
            // Read as it is written: bytes put together from two stores would wait for both.
            std::conditional_t<hn::MaxLanes(d) == kGroup, std::uint16_t, std::uint8_t> mask = 0;
            std::array<std::uint8_t, 8>                                                stored;
            hn::StoreMaskBits(d, uppers > hn::Set(d, nearest), stored.data());
            std::memcpy(&mask, stored.data(), sizeof mask);
            bits |= std::uint32_t{mask} << i;
        }
        return bits;
    }

    /// Makes what lies outside the reach as good as hidden, and says what is in there.
    HiddenPart finishPixels() const
    {
        auto any = hn::Zero(D()), every = all();
        for (int column = 0; column < m_columns; ++column) {
            std::uint32_t* words   = next(column);
            const auto     outside = hn::Set(D(), outsideOf(column));
            for (int line = 0; line < m_lines; line += kStep) {
                const auto beyond = hn::Or(outside, hn::Not(linesThere(line)));
                const auto found  = hn::Load(D(), words + line);
                const auto hidden = hn::Or(found, beyond);
                any               = hn::Or(any, hn::AndNot(beyond, found));
                every             = hn::And(every, hidden);
                hn::Store(hidden, D(), words + line);
            }
            spare(words);
        }
        if (hn::AllTrue(D(), every == all())) return HiddenPart::Everything;
        return hn::AllTrue(D(), any == hn::Zero(D())) ? HiddenPart::Nothing : HiddenPart::Squares;
    }

    /// Squares that reach `step` pixels farther than those of the last level; false if there is none.
    bool grow(int step) const
    {
        const hn::RebindToSigned<D> i32;
        const auto                  lane    = countFrom(i32, step);
        const auto                  isBelow = hn::RebindMask(D(), hn::Not(lane < hn::Set(i32, kStep)));
        const auto                  to      = hn::IndicesFromVec(D(), hn::And(lane, hn::Set(i32, kStep - 1)));
        // Lines and those `step` below them. Whole vectors are read as they were written, which the processor can do at
        // once.
        const auto pairs = [&](const std::uint32_t* words, int line) HWY_ATTR {
            if constexpr (kStep == 1) return hn::And(hn::Load(D(), words + line), hn::Load(D(), words + line + step));
            const auto here = hn::Load(D(), words + line), next = hn::Load(D(), words + line + kStep);
            return hn::And(here,
                           hn::IfThenElse(isBelow, hn::TableLookupLanes(next, to), hn::TableLookupLanes(here, to)));
        };
        auto any = hn::Zero(D());
        for (int column = 0; column < m_columns; ++column) {
            const std::uint32_t* here    = last(column);
            std::uint32_t*       words   = next(column);
            const auto           outside = hn::Set(D(), outsideOf(column));
            for (int line = 0; line < m_lines; line += kStep) {
                const auto pair  = pairs(here, line);
                const auto after = column + 1 < m_columns ? pairs(last(column + 1), line) : all();
                const auto found =
                    hn::And(pair, hn::Or(hn::ShiftRightSame(pair, step), hn::ShiftLeftSame(after, kWordPixels - step)));
                any = hn::Or(any, hn::AndNot(hn::Or(outside, hn::Not(linesThere(line))), found));
                hn::Store(found, D(), words + line);
            }
            spare(words);
        }
        return !hn::AllTrue(D(), any == hn::Zero(D()));
    }

    static constexpr int kStep       = static_cast<int>(hn::MaxLanes(D()));  // lines in a vector
    static constexpr int kMostGrowth = 4;                                    // from one side to the next

    /// All bits of the lines that there are.
    V linesThere(int line) const
    {
        const hn::RebindToSigned<D> i32;
        return hn::BitCast(D(), hn::VecFromMask(i32, countFrom(i32, line) < hn::Set(i32, m_lines)));
    }
    /// Bits of a column's pixels that lie left or right of the reach.
    std::uint32_t outsideOf(int column) const
    {
        const int first = m_out.left + kWordPixels * column, before = m_out.reach.x0 - first,
                  end         = m_out.reach.x1 - first;
        std::uint32_t outside = 0;
        if (before > 0) outside |= before < kWordPixels ? (1u << before) - 1 : ~0u;
        if (end < kWordPixels) outside |= ~0u << std::max(end, 0);
        return outside;
    }
    /// The lines below the reach, as far as a larger square may look.
    void spare(std::uint32_t* words) const
    {
        static_assert(kStep == 1 || kStep >= kMostGrowth);
        const int end = (m_lines + kStep - 1) / kStep * kStep;
        for (int line = end; line < end + kMostGrowth; line += kStep) hn::Store(all(), D(), words + line);
    }
    static V all() { return hn::Set(D(), ~std::uint32_t{0}); }

    const VisibilityBuffer& m_visible;
    float                   m_nearest;
    int                     m_columns, m_lines;
    HiddenSquares&          m_out;
};

/// Asks of boxes, as many side by side as there are int32.
class HiddenBoxes {
    using D = hn::ScalableTag<std::int32_t>;
    using V = hn::Vec<D>;

public:
    explicit HiddenBoxes(const HiddenSquares& squares) : m_squares(squares) {}

    /// Which of the boxes that `asked` names, all of them in the reach and not empty, are hidden.
    hn::Mask<D> operator()(hn::Mask<D> asked, V left, V above, V width, V height) const
    {
        const auto side    = hn::Max(width, height);
        const auto isLarge = side > all(HiddenSquares::kSides.back());
        const auto level   = levelOf(hn::IfThenElse(isLarge, all(1), side));
        const auto known   = hn::And(hn::AndNot(isLarge, asked), level < all(m_squares.levels));
        return squaresAt(known, level, left, above);
    }

    /// The same of boxes with sides of up to twice the largest square: by four of these, one in each corner.
    hn::Mask<D> ofLarge(hn::Mask<D> asked, V left, V above, V width, V height) const
    {
        constexpr int kSide   = HiddenSquares::kSides.back();
        const auto    side    = hn::Max(width, height);
        const auto    isLarge = hn::And(hn::And(asked, side > all(kSide)), side < all(2 * kSide + 1));
        if (static_cast<std::size_t>(m_squares.levels) < HiddenSquares::kSides.size() || hn::AllFalse(D(), isLarge))
            return hn::And(asked, all(1) < all(0));
        const auto level = all(static_cast<int>(HiddenSquares::kSides.size()) - 1),
                   x     = left + hn::Max(width - all(kSide), hn::Zero(D())),
                   y     = above + hn::Max(height - all(kSide), hn::Zero(D()));
        auto hidden      = isLarge;
        for (const auto& [atX, atY] :
             {std::pair(left, above), std::pair(x, above), std::pair(left, y), std::pair(x, y)})
            hidden = squaresAt(hidden, level, atX, atY);
        return hidden;
    }

private:
    static V all(int value) { return hn::Set(D(), value); }

    /// Of `asked`, those whose squares of the level that begin there are hidden.
    hn::Mask<D> squaresAt(hn::Mask<D> asked, V level, V left, V above) const
    {
        const auto x = left - all(m_squares.left), y = above - all(m_squares.reach.y0);
        const auto place = hn::ShiftLeftSame(level, m_squares.levelShift)
                           + hn::ShiftLeftSame(hn::ShiftRight<std::bit_width(kLastBit)>(x), m_squares.lineShift) + y;
        HWY_ALIGN std::array<std::int32_t, hn::MaxLanes(D())> places;
        hn::Store(hn::IfThenElseZero(asked, place), D(), places.data());
        const auto* words = reinterpret_cast<const std::int32_t*>(m_squares.words.data());
        const auto  word  = loadLanes(D(), [words, &places](std::size_t i) { return words + places[i]; });
        const auto  bit   = all(1) << hn::And(x, all(kLastBit));
        return hn::And(asked, hn::TestBit(word, bit));
    }

    /// The first level whose squares have sides of so many pixels or more.
    static V levelOf(V side)
    {
        // of sides 1, 2, ...
        HWY_ALIGN static constexpr std::array<std::uint8_t, 16> kLevels{0, 1, 2, 3, 4, 4, 5, 5, 6, 6, 6, 6, 7, 7, 7, 7};
        const hn::Repartition<std::uint8_t, D>                  u8;
        return hn::BitCast(
            D(), hn::TableLookupBytes(hn::LoadDup128(u8, kLevels.data()), hn::BitCast(u8, side - hn::Set(D(), 1))));
    }

    static constexpr unsigned kLastBit = HiddenSquares::kWordPixels - 1;

    const HiddenSquares& m_squares;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_HIDDEN_SQUARES_INL_H
