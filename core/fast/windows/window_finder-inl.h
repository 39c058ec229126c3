// From the compact triangles of a batch to the windows that they may cover: kWindowSide x kWindowSide pixels each.
//
// Lines      a line of windows begins at the left of its triangle's box, or after the columns of its lines that hold
//            nothing of the triangle, so that most small triangles have one or two
// Lanes      triangles side by side, as long as they have few windows; those with more are put aside, because which
//            lanes they stand in nobody could predict
// Edges      int32, exact (core/geometry/triangle_list.h)
// Promise    every covered pixel of a triangle that is neither alone nor hidden nor tiny lies in one of its windows,
//            and in one only. A window may reach beyond the box, never beyond the lines of the stripe
// Used by    windows-inl.h, which works the list off
#if defined(ZSCOPE_WINDOW_FINDER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_WINDOW_FINDER_INL_H
#undef ZSCOPE_WINDOW_FINDER_INL_H
#else
#define ZSCOPE_WINDOW_FINDER_INL_H
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "core/fast/lanes/edge_steps-inl.h"
#include "core/fast/lanes/lane_order-inl.h"
#include "core/fast/windows/window_list.h"
#include "core/geometry/triangle_list.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Triangles of at most so many pixels and lines need no window.
inline constexpr int kTinySide = 2;

/// From the compact triangles of a batch to the windows that they may cover.
class WindowFinder {
    using D  = hn::ScalableTag<std::int32_t>;
    using DF = hn::RebindToFloat<D>;
    using DU = hn::RebindToUnsigned<D>;
    using V  = hn::Vec<D>;

    /// Of the three edges of a triangle: values at the first pixel of a window, steps (edge_steps-inl.h), or what they
    /// grow by.
    using Edges = std::array<V, 3>;

    static V all(std::int32_t value) { return hn::Set(D(), value); }
    template <class T>
    static hn::Vec<hn::Rebind<T, D>> load(const TriangleList::Column<T>& column, std::size_t i)
    {
        return hn::LoadU(hn::Rebind<T, D>(), column.data() + i);
    }

public:
    WindowFinder(const TriangleList& triangles, WindowList& list) : m_triangles(triangles), m_list(list)
    {
        list.clear();
    }

    /// The windows of the triangles [first, end), but of those that stand alone, are hidden or tiny.
    void add(std::size_t first, std::size_t end)
    {
        for (std::size_t i = first; i < end; i += hn::Lanes(D())) {
            const auto isThere = hn::Iota(D(), 0) < all(static_cast<std::int32_t>(end - i));
            const auto asked   = all(TriangleList::kPatterned | TriangleList::kCompact | TriangleList::kHidden);
            const auto kind    = hn::And(load(m_triangles.kind, i), asked);
            addWindows(i, hn::And(isThere, kind == all(TriangleList::kCompact)));
        }
        // Not where they are found: which lanes they stand in, nobody could predict.
        for (std::size_t m = 0; m < m_list.some.count; m += hn::Lanes(D())) addSome(m);
        for (std::size_t m = 0; m < m_list.manyCount; ++m) addMany(m_list.many[m]);
    }

private:
    /// The windows of those of the triangles i, i + 1, ... that `mask` names, if there are up to two by two of them:
    /// they are judged for all triangles side by side. Triangles with more are put aside, for addSome() and addMany().
    void addWindows(std::size_t i, hn::Mask<D> mask)
    {
        if (hn::AllFalse(D(), mask)) return;
        const auto start = load(m_triangles.start, i), size = minusHalves(load(m_triangles.end, i), start);
        const auto raised = hn::ShiftRight<TriangleList::kRaised>(load(m_triangles.kind, i));
        const auto width = lowerHalf(size), height = upperHalf(size) + raised;
        const auto isWide = width > all(kWindowSide), isHigh = height > all(kWindowSide);
        const auto hasMore = hn::Max(width, height) > all(2 * kWindowSide),
                   hasMany = hn::Max(width, height) > all(WindowList::Some::kMost * kWindowSide);
        const auto hasFew  = hn::And(hn::AndNot(hasMore, mask), hn::Max(width, height) > all(kTinySide));
        if (hn::AllFalse(D(), hn::Or(hasFew, hn::And(hasMore, mask)))) return;

        const Edges steps{load(m_triangles.steps[0], i), load(m_triangles.steps[1], i), load(m_triangles.steps[2], i)};
        const auto  corner = start - hn::ShiftLeft<16>(raised);
        const Edges first  = edgesAt(
             corner, steps,
             {load(m_triangles.leastRise[0], i), load(m_triangles.leastRise[1], i), load(m_triangles.mostRise, i)});
        const Reach  reach(steps);
        WindowChunk& chunk   = m_list.withRoomFor(4 * hn::Lanes(D()));
        const auto   owners  = countFrom(DU(), static_cast<std::uint32_t>(i));
        const auto   addLine = [&](const Edges& line, hn::Mask<D> exists, V left) HWY_ATTR {
            const auto hasTwo = hn::And(exists, isWide);
            const Line of     = withoutEmptyColumns(line, steps, reach, hasTwo, left);
            judge(of.edges, reach, exists, owners, of.first, chunk);
            if (!hn::AllFalse(D(), hasTwo))
                judge(plus(of.edges, growths(steps, kWindowSide, 0)), reach,
                        hn::And(hasTwo, width > of.skipped + all(kWindowSide)), owners,
                        of.first + all(pixelsAndLines(kWindowSide, 0)), chunk);
        };
        addLine(first, hasFew, corner);
        const auto high = hn::And(hasFew, isHigh);
        if (!hn::AllFalse(D(), high))
            addLine(plus(first, growths(steps, 0, kWindowSide)), high, corner + all(pixelsAndLines(0, kWindowSide)));
        if (hn::AllFalse(D(), hn::And(mask, hasMore))) return;  // as most often
        const auto many = hn::And(mask, hasMany);
        hn::StoreU(hn::TableLookupLanes(owners, hn::IndicesFromVec(DU(), keptFirst(D(), many))), DU(),
                   m_list.many.data() + m_list.manyCount);
        m_list.manyCount += hn::CountTrue(D(), many);

        const auto        some  = hn::AndNot(hasMany, hn::And(mask, hasMore));
        const auto        order = keptFirst(D(), some);
        WindowList::Some& to    = m_list.some;
        const std::size_t count = to.count;
        const auto        keep  = [&](auto d, auto values, auto& column) HWY_ATTR {
            hn::StoreU(hn::TableLookupLanes(values, hn::IndicesFromVec(d, order)), d, column.data() + count);
        };
        keep(DU(), owners, to.owners), keep(DU(), hn::BitCast(DU(), corner), to.corners), keep(D(), width, to.width),
            keep(D(), height, to.height);
        for (std::size_t k = 0; k < 3; ++k) keep(D(), first[k], to.edges[k]), keep(D(), steps[k], to.steps[k]);
        to.count = count + hn::CountTrue(D(), some);
    }

    /// The windows of the waiting triangles from the m-th on, as many triangles as there are lanes: each line of
    /// windows from left to right.
    void addSome(std::size_t m)
    {
        const WindowList::Some& from = m_list.some;
        WindowChunk& chunk   = m_list.withRoomFor(WindowList::Some::kMost * WindowList::Some::kMost * hn::Lanes(D()));
        const auto   isThere = hn::Iota(D(), 0) < all(static_cast<std::int32_t>(from.count - m));
        const auto   owners  = hn::LoadU(DU(), from.owners.data() + m);
        const auto   width = hn::LoadU(D(), from.width.data() + m), height = hn::LoadU(D(), from.height.data() + m);
        const auto   edges = [m](const auto& columns) HWY_ATTR {
            return Edges{hn::LoadU(D(), columns[0].data() + m), hn::LoadU(D(), columns[1].data() + m),
                         hn::LoadU(D(), columns[2].data() + m)};
        };
        const Edges steps = edges(from.steps), across = growths(steps, kWindowSide, 0),
                    down = growths(steps, 0, kWindowSide);
        const Reach reach(steps);
        Edges       line = edges(from.edges);
        V           left = hn::BitCast(D(), hn::LoadU(DU(), from.corners.data() + m));
        for (int lines = 0; lines < WindowList::Some::kMost * kWindowSide;
             lines += kWindowSide, line = plus(line, down), left = left + all(pixelsAndLines(0, kWindowSide))) {
            const auto hasLine = hn::And(isThere, height > all(lines));
            if (hn::AllFalse(D(), hasLine)) break;
            const Line of   = withoutEmptyColumns(line, steps, reach, hasLine, left);
            Edges      here = of.edges;
            for (int right = 0; right < WindowList::Some::kMost * kWindowSide;
                 right += kWindowSide, here = plus(here, across)) {
                const auto exists = hn::And(hasLine, width > of.skipped + all(right));
                if (hn::AllFalse(D(), exists)) break;
                judge(here, reach, exists, owners, of.first + all(right), chunk);
            }
        }
    }

    /// From the values of edges at a first pixel to those that lie farthest inside.
    struct Reach {
        Edges inColumn, inWindow;  // of the pixels of its column, of its window

        explicit Reach(const Edges& steps)
        {
            const Edges inwards{upwards(steps[0]), upwards(steps[1]), upwards(steps[2])};
            inColumn = growths(inwards, 0, kWindowSide - 1);
            inWindow = growths(inwards, kWindowSide - 1, kWindowSide - 1);
        }
    };

    /// A line of windows.
    struct Line {
        V     skipped;  // pixels, from the left of its triangle's box
        V     first;    // corner of its first window, as in WindowChunk
        Edges edges;    // there
    };

    /// A triangle's box is wider than what it has of most lines of windows: those of `asked` begin after columns that
    /// hold nothing of it.
    static Line withoutEmptyColumns(const Edges& atBox, const Edges& steps, const Reach& reach, hn::Mask<D> asked,
                                    V left)
    {
        Line line{hn::Zero(D()), left, atBox};
        // One lane: in the order that HalfSpace shows, who goes by windows from the corner of the box.
        if (hn::MaxLanes(D()) == 1 || hn::AllFalse(D(), asked)) return line;
        const Edges perPixel = growths(steps, 1, 0);
        Edges       inColumn = plus(atBox, reach.inColumn);
        for (int column = 0; column < kWindowSide - 1; ++column, inColumn = plus(inColumn, perPixel)) {
            asked        = hn::And(asked, isOutside(inColumn));
            line.skipped = line.skipped + hn::IfThenElseZero(asked, all(1));
        }
        line.edges = after(atBox, steps, line.skipped);
        line.first = left + line.skipped;
        return line;
    }

    static Edges growths(const Edges& steps, int pixels, int lines)
    {
        return {growth(steps[0], pixels, lines), growth(steps[1], pixels, lines), growth(steps[2], pixels, lines)};
    }
    /// The values at a pixel of the picture; `rises` are the first two's least and both together's most.
    static Edges edgesAt(V corner, const Edges& steps, const Edges& rises)
    {
        return {growth(steps[0], corner) - rises[0], growth(steps[1], corner) - rises[1],
                growth(steps[2], corner) + rises[2]};
    }
    /// The values after a way (edge_steps-inl.h).
    static Edges after(const Edges& edges, const Edges& steps, V way)
    {
        return {edges[0] + growth(steps[0], way), edges[1] + growth(steps[1], way), edges[2] + growth(steps[2], way)};
    }

    /// Appends the windows that exist and are not wholly outside of an edge.
    void judge(const Edges& edges, const Reach& reach, hn::Mask<D> exists, hn::Vec<DU> owners, V corners,
               WindowChunk& to) const
    {
        append(hn::AndNot(isOutside(plus(edges, reach.inWindow)), exists), owners, corners, to);
    }

    static Edges plus(const Edges& a, const Edges& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
    /// Whether one of them is negative.
    static hn::Mask<D> isOutside(const Edges& edges) { return hn::Or3(edges[0], edges[1], edges[2]) < hn::Zero(D()); }

    /// The windows of one triangle, line of windows after line of windows.
    void addMany(std::size_t t)
    {
        const int    top     = m_triangles.top(t);
        const int    columns = (m_triangles.width(t) + kWindowSide - 1) / kWindowSide;
        const int    lines   = (m_triangles.box(t).y1 - top + kWindowSide - 1) / kWindowSide;
        const int    count = columns * lines, step = static_cast<int>(hn::Lanes(DF()));
        WindowChunk& chunk = m_list.withRoomFor(static_cast<std::size_t>(count + step));

        const auto  owner  = hn::Set(DU(), static_cast<std::uint32_t>(t));
        const auto  corner = all(pixelsAndLines(m_triangles.box(t).x0, top));
        const Edges rises{all(m_triangles.leastRise[0][t]), all(m_triangles.leastRise[1][t]),
                          all(m_triangles.mostRise[t])};
        const Edges steps{all(m_triangles.steps[0][t]), all(m_triangles.steps[1][t]), all(m_triangles.steps[2][t])};
        const Reach reach(steps);
        const auto  side = hn::Set(DF(), kWindowSide), perLine = hn::Set(DF(), static_cast<float>(columns)),
                   perColumn = hn::Set(DF(), 1 / static_cast<float>(columns));
        for (int first = 0; first < count; first += step) {
            const auto at    = countFrom(DF(), static_cast<float>(first));
            const auto line  = hn::Floor((at + hn::Set(DF(), 0.5f)) * perColumn);
            const auto right = (at - line * perLine) * side, down = line * side;
            const auto here = corner + hn::ConvertTo(D(), hn::MulAdd(down, hn::Set(DF(), 65536), right));
            judge(edgesAt(here, steps, rises), reach,
                  hn::RebindMask(D(), at < hn::Set(DF(), static_cast<float>(count))), owner, here, chunk);
        }
    }

    /// Those of these windows that `kept` names.
    static void append(hn::Mask<D> kept, hn::Vec<DU> owners, V corners, WindowChunk& to)
    {
        const auto order = hn::IndicesFromVec(DU(), keptFirst(D(), kept));
        hn::StoreU(hn::TableLookupLanes(owners, order), DU(), to.owners.data() + to.count);
        hn::StoreU(hn::TableLookupLanes(hn::BitCast(DU(), corners), order), DU(), to.corners.data() + to.count);
        to.count += hn::CountTrue(D(), kept);
    }

    const TriangleList& m_triangles;
    WindowList&         m_list;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_WINDOW_FINDER_INL_H
