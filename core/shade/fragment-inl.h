// The fragment shader, several neighbouring pixels of one line side by side. Whoever shades calls this text: once per
// pixel of the finished picture, or with each fragment.
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

#include <cstdint>

#include <hwy/highway.h>

#include "core/geometry/lane_order-inl.h"
#include "core/scan/fragments.h"
#include "core/shade/painter.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kOperationsPerRound = 5;

/// The colours of fragments of the triangles `rank` at the pixels x, x + 1, ... of line y; `base` are their triangles'.
template <class U32>
hn::Vec<U32> shaded(U32 u32, hn::Vec<U32> base, hn::Vec<U32> rank, int x, int y, int operations)
{
    if (operations == 0) return base;
    const auto pixel =
        countFrom(u32, static_cast<std::uint32_t>(x)) + hn::Set(u32, static_cast<std::uint32_t>(y) << 16);
    auto chain = pixel ^ (rank * hn::Set(u32, 0x9E3779B1u));
    for (int done = 0; done < operations; done += kOperationsPerRound) {
        chain = chain + hn::ShiftLeft<10>(chain);
        chain = chain ^ hn::ShiftRight<6>(chain);
        chain = chain + hn::Set(u32, 0x7F4A7C15u);
    }
    return base ^ hn::ShiftRight<31>(chain);
}

/// What a stream method does with the fragments of one triangle if they are shaded as they come
/// (core/scan/fragments.h).
template <ShadingMoment kWhen>
class ShadedFragments {
public:
    static constexpr ShadingMoment kMoment    = kWhen;
    static constexpr bool          kPatterned = false;

    ShadedFragments(const Painter& painter, std::uint32_t rank)
        : m_painter(painter), m_rank(rank), m_base(painter.baseColour(rank))
    {}

    template <class U32>
    hn::Vec<U32> colours(U32 u32, int x, int y) const
    {
        return shaded(u32, hn::Set(u32, m_base), hn::Set(u32, m_rank), x, y, m_painter.operations);
    }

    /// Colours the pixels x, x + 1, ... of line y where `won`. Only those before the end of the line exist.
    template <class U32>
    void keep(U32 u32, hn::Mask<U32> won, hn::Vec<U32> colours, int x, int y) const
    {
        std::uint32_t* at    = m_painter.colour.row(y).data() + x;
        const int      exist = m_painter.colour.width - x;
        if (static_cast<int>(hn::Lanes(u32)) <= exist) {
            hn::StoreU(hn::IfThenElse(won, colours, hn::LoadU(u32, at)), u32, at);
            return;
        }
        HWY_ALIGN std::uint32_t colour[hn::MaxLanes(U32())];
        HWY_ALIGN std::uint32_t kept[hn::MaxLanes(U32())];
        hn::Store(colours, u32, colour);
        hn::Store(hn::VecFromMask(u32, won), u32, kept);
        for (int lane = 0; lane < exist; ++lane)
            if (kept[lane] != 0) at[lane] = colour[lane];
    }

private:
    const Painter& m_painter;
    std::uint32_t  m_rank;
    std::uint32_t  m_base;  // colour
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_FRAGMENT_INL_H
