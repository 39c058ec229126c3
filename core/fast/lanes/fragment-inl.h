// The fragment shader, several fragments side by side: neighbouring pixels of the finished picture, or whatever waits
// in a queue.
//
// Chain      one round is five dependent operations on 32-bit integers (shift, add, shift, exclusive or, add); the
//            lanes run side by side, so that a vector of fragments costs what one does
// Source     the mixing step is Bob Jenkins' one-at-a-time hash, Dr. Dobb's Journal, 1997
#if defined(ZSCOPE_FRAGMENT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_FRAGMENT_INL_H
#undef ZSCOPE_FRAGMENT_INL_H
#else
#define ZSCOPE_FRAGMENT_INL_H
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <hwy/highway.h>

#include "core/base/tally.h"
#include "core/depth/visibility_buffer.h"
#include "core/fast/lanes/fragment_queue.h"
#include "core/fast/lanes/fragments.h"
#include "core/fast/lanes/lane_order-inl.h"
#include "core/shade/painter.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kOperationsPerRound = 5;

/// The colours of fragments of the triangles `rank` at these pixels, x + 65536 y each; `base` are their triangles'.
template <class U32>
hn::Vec<U32> shaded(U32 u32, hn::Vec<U32> base, hn::Vec<U32> rank, hn::Vec<U32> pixel, int operations)
{
    auto chain = pixel ^ (rank * hn::Set(u32, 0x9E3779B1u));
    for (int done = 0; done < operations; done += kOperationsPerRound) {
        chain = chain + hn::ShiftLeft<10>(chain);
        chain = chain ^ hn::ShiftRight<6>(chain);
        chain = chain + hn::Set(u32, 0x7F4A7C15u);
    }
    return base ^ hn::ShiftRight<31>(chain);
}

/// Shades all that wait, and stores the colours of those whose triangle holds its pixel. The queue is empty then.
inline void shadeQueue(FragmentQueue& queue, const Painter& painter, const VisibilityBuffer& visible)
{
    const hn::ScalableTag<std::uint32_t> u32;
    const std::size_t                    count = std::exchange(queue.count, 0);
    HWY_ALIGN std::array<std::uint32_t, hn::MaxLanes(hn::ScalableTag<std::uint32_t>())> colours{};
    for (std::size_t i = 0; i < count; i += hn::Lanes(u32)) {
        const std::size_t here = std::min(hn::Lanes(u32), count - i);
        for (std::size_t k = 0; k < here; ++k) colours[k] = painter.baseColour(queue.ranks[i + k]);
        if (painter.operations != 0)
            hn::Store(shaded(u32, hn::Load(u32, colours.data()), hn::Load(u32, queue.ranks.data() + i),
                             hn::Load(u32, queue.pixels.data() + i), painter.operations),
                      u32, colours.data());
        for (std::size_t k = 0; k < here; ++k) {
            const std::uint32_t pixel = queue.pixels[i + k];
            const int           x = static_cast<int>(pixel & 0xFFFF), y = static_cast<int>(pixel >> 16);
            if (visible.rankAt(x, y) == queue.ranks[i + k]) painter.colour.at(x, y) = colours[k];
        }
    }
}

/// Where the fragments of a stripe go that are shaded as they come.
struct Shading {
    /// Operations per fragment from which the wider lanes of the queue win more than waiting costs.
    static constexpr int kWorthWaiting = 400;

    const Painter&          painter;
    const VisibilityBuffer& visible;
    FragmentQueue&          queue;
    Tally&                  tally;

    /// All fragments go through the queue.
    bool allWait() const { return painter.operations >= kWorthWaiting; }

    /// Adds what the lanes in `wanted` stand for.
    template <class U32>
    HWY_INLINE void add(U32 u32, hn::Mask<U32> wanted, hn::Vec<U32> pixels, hn::Vec<U32> ranks) const
    {
        if (queue.count + hn::Lanes(u32) > FragmentQueue::kRoom) flush();
        hn::CompressStore(ranks, wanted, u32, queue.ranks.data() + queue.count);
        queue.count += hn::CompressStore(pixels, wanted, u32, queue.pixels.data() + queue.count);
    }
    void flush() const
    {
        tally.add(Unit::Fragments, queue.count);
        shadeQueue(queue, painter, visible);
    }
};

/// What a stream method does with the fragments of one triangle if they are shaded as they come
/// (core/fast/lanes/fragments.h): they wait in the queue, where lanes of different triangles are shaded side by side.
template <ShadingMoment kWhen>
class QueuedFragments {
public:
    static constexpr ShadingMoment kMoment = kWhen;
    static constexpr bool          kFree   = false;

    QueuedFragments(const Shading& shading, std::uint32_t rank) : m_shading(shading), m_rank(rank) {}

    const Shading& shading() const { return m_shading; }
    std::uint32_t  rank() const { return m_rank; }

    /// Of these pixels, x + 65536 y each, those in `wanted`.
    template <class U32>
    HWY_INLINE void shade(U32 u32, hn::Mask<U32> wanted, hn::Vec<U32> pixels) const
    {
        m_shading.add(u32, wanted, pixels, hn::Set(u32, m_rank));
    }
    void shade(std::uint32_t pixel) const
    {
        FragmentQueue& queue = m_shading.queue;
        if (queue.count == FragmentQueue::kRoom) m_shading.flush();
        queue.pixels[queue.count] = pixel, queue.ranks[queue.count] = m_rank;
        ++queue.count;
    }

private:
    const Shading& m_shading;
    std::uint32_t  m_rank;
};

template <ShadingMoment kWhen>
struct QueuedFragmentsOf {
    const Shading& shading;

    QueuedFragments<kWhen> operator()(std::uint32_t rank) const { return {shading, rank}; }
};

/// Where the colours of fragments go that cost nothing. Loops hold a copy of their own: the compiler then keeps the
/// addresses in registers, although the loop stores to memory.
struct ColourTarget {
    explicit ColourTarget(const Shading& of)
        : shading(&of), first(of.painter.colour.data), stride(static_cast<std::ptrdiff_t>(of.painter.colour.stride)),
          width(of.painter.colour.width), table(of.painter.table.isComplete() ? of.painter.table.data() : nullptr)
    {}

    const Shading*       shading;
    std::uint32_t*       first;
    std::ptrdiff_t       stride;
    int                  width;
    const std::uint32_t* table;  // nullptr: colours are computed

    /// The colours of line y.
    std::uint32_t* line(int y) const { return first + y * stride; }
    std::uint32_t colourOf(std::uint32_t rank) const { return table ? table[rank] : shading->painter.baseColour(rank); }
    void          count(std::uint64_t fragments) const { shading->tally.add(Unit::Fragments, fragments); }
};

/// The fragments of one triangle if they cost nothing: a fragment that wins its pixel stores the triangle's colour there.
template <ShadingMoment kWhen>
class FreeFragments {
public:
    static constexpr ShadingMoment kMoment    = kWhen;
    static constexpr bool          kPatterned = false;
    static constexpr bool          kFree      = true;

    FreeFragments(const ColourTarget& target, std::uint32_t rank) : m_target(target), m_colour(target.colourOf(rank)) {}

    std::uint32_t* line(int y) const { return m_target.line(y); }
    std::uint32_t  colour() const { return m_colour; }

    /// The lanes are the pixels x, x + 1, ... of line y; the first lies in the picture. Those in `wanted` are shaded.
    /// Those in `won` store their colours; they are some of `wanted`. Lanes right of the picture store nothing.
    template <class U32>
    HWY_INLINE void shade(U32 u32, hn::Mask<U32> wanted, hn::Mask<U32> won, int x, int y) const
    {
        const auto inside = hn::FirstN(u32, static_cast<std::size_t>(m_target.width - x));
        m_target.count(hn::CountTrue(u32, hn::And(wanted, inside)));
        hn::BlendedStore(hn::Set(u32, m_colour), hn::And(won, inside), u32, line(y) + x);
    }
    /// All pixels of a box that the triangle has won whole.
    void shadeAll(const PixelBox& box) const
    {
        m_target.count(box.area());
        for (int y = box.y0; y < box.y1; ++y) std::fill(line(y) + box.x0, line(y) + box.x1, m_colour);
    }

private:
    const ColourTarget& m_target;
    std::uint32_t       m_colour;
};

template <ShadingMoment kWhen>
struct FreeFragmentsOf : ColourTarget {
    explicit FreeFragmentsOf(const Shading& of) : ColourTarget(of) {}

    FreeFragments<kWhen> operator()(std::uint32_t rank) const { return {*this, rank}; }
};

/// As QueuedFragments, of a triangle that fills most lanes by itself: its fragments are shaded where they are tested,
/// unless each costs Shading::kWorthWaiting operations or more. No fragment from the queue overwrites a colour that is
/// stored here, because its triangle has lost the pixel.
template <ShadingMoment kWhen>
class ShadedFragments {
public:
    static constexpr ShadingMoment kMoment    = kWhen;
    static constexpr bool          kPatterned = false;
    static constexpr bool          kFree      = false;

    explicit ShadedFragments(const QueuedFragments<kWhen>& of)
        : m_shading(of.shading()), m_rank(of.rank()), m_base(m_shading.painter.baseColour(m_rank))
    {}

    /// The lanes are the pixels x, x + 1, ... of line y; the first lies in the picture. Those in `wanted` are shaded.
    /// Those in `won` store their colours; they are some of `wanted`. Lanes right of the picture store nothing.
    template <class U32>
    void shade(U32 u32, hn::Mask<U32> wanted, hn::Mask<U32> won, int x, int y) const
    {
        const Painter& painter = m_shading.painter;
        const int      exist   = painter.colour.width - x;
        const auto     inside  = hn::FirstN(u32, static_cast<std::size_t>(exist));
        if (m_shading.allWait()) {
            const auto first = static_cast<std::uint32_t>(x) + (static_cast<std::uint32_t>(y) << 16);
            m_shading.add(u32, hn::And(wanted, inside), countFrom(u32, first), hn::Set(u32, m_rank));
            return;
        }
        m_shading.tally.add(Unit::Fragments, hn::CountTrue(u32, hn::And(wanted, inside)));
        const auto colours = shaded(
            u32, hn::Set(u32, m_base), hn::Set(u32, m_rank),
            countFrom(u32, static_cast<std::uint32_t>(x) + (static_cast<std::uint32_t>(y) << 16)), painter.operations);
        hn::BlendedStore(colours, hn::And(won, inside), u32, painter.colour.row(y).data() + x);
    }
    /// All pixels of a box that the triangle has won whole.
    void shadeAll(const PixelBox& box) const
    {
        const hn::Rebind<std::uint32_t, hn::ScalableTag<double>> u32;
        for (int y = box.y0; y < box.y1; ++y)
            for (int x = box.x0; x < box.x1; x += static_cast<int>(hn::Lanes(u32))) {
                const auto here = hn::FirstN(u32, static_cast<std::size_t>(box.x1 - x));
                shade(u32, here, here, x, y);
            }
    }

private:
    const Shading& m_shading;
    std::uint32_t  m_rank;
    std::uint32_t  m_base;  // colour
};

/// The fragments of a triangle that is drawn by itself.
inline UnshadedFragments drawnAlone(const UnshadedFragments& fragments) { return fragments; }
template <ShadingMoment kWhen>
FreeFragments<kWhen> drawnAlone(const FreeFragments<kWhen>& fragments)
{
    return fragments;
}
template <ShadingMoment kWhen>
ShadedFragments<kWhen> drawnAlone(const QueuedFragments<kWhen>& fragments)
{
    return ShadedFragments<kWhen>(fragments);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_FRAGMENT_INL_H
