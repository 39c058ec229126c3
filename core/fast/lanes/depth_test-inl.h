// The depth test, several neighbouring pixels of one line side by side: who is nearest keeps the pixel.
//
// Depth      float64 until it is stored; limited to the corners' depths, then rounded to float32 (the order does not
//            matter: rounding is monotone and the limits are float32 values)
// Winner     the larger key (core/depth/pixel_key.h): larger depth, on equal depth the lower rank. Lanes that are not
//            covered keep what they have
// Patterns   a fragment in a hole does not exist, one in a relief lies farther than its triangle. Early depth tests
//            first, looks up what passed before anything is written, and tests what was moved again; shading first
//            looks up all
// Far        free: background holds a value just below everything that may be kept
#if defined(ZSCOPE_DEPTH_TEST_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_DEPTH_TEST_INL_H
#undef ZSCOPE_DEPTH_TEST_INL_H
#else
#define ZSCOPE_DEPTH_TEST_INL_H
#endif

#include <array>

#include <hwy/highway.h>

#include "core/depth/visibility_buffer.h"
#include "core/fast/lanes/fragments.h"
#include "core/fast/lanes/key_order-inl.h"
#include "core/geometry/rules.h"
#include "core/scan/pixel_events.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F64   = hn::ScalableTag<double>;
using F32   = hn::Rebind<float, F64>;
using I32   = hn::Rebind<std::int32_t, F64>;
using U32   = hn::Rebind<std::uint32_t, F64>;
using I64   = hn::Rebind<PixelKey, F64>;
using Vec64 = hn::Vec<F64>;
using Keys  = hn::Vec<I64>;

/// Pixels tested side by side.
inline int laneCount() { return static_cast<int>(hn::Lanes(F64())); }

/// Rounded to float32 and back: the result of one float32 operation on float32 values, whichever way it was computed.
inline Vec64 inFloat32(Vec64 value) { return hn::PromoteTo(F64(), hn::DemoteTo(F32(), value)); }

/// The bits of float32 numbers, changed so that as integers they are in the order of the numbers.
inline hn::Vec<I32> orderedBits(hn::Vec<I32> bits)
{
    return hn::Xor(bits, hn::And(hn::ShiftRight<31>(bits), hn::Set(I32(), 0x7FFFFFFF)));
}

/// The upper halves of the keys of stored depths, their lower halves 0. `kMayBeNegative`: if not, a float32's own bits
/// are in order.
template <bool kMayBeNegative>
HWY_INLINE Keys upperHalves(hn::Vec<F32> depth)
{
    auto bits = hn::BitCast(I32(), depth);
    if constexpr (kMayBeNegative) bits = orderedBits(bits);
    return hn::ShiftLeft<32>(hn::PromoteTo(I64(), bits));
}

/// Depths as the format stores them, before the last rounding to float32: as DepthEncoding::stored().
inline Vec64 encoded(Vec64 z, const DepthEncoding& as)
{
    if (as.isReversed()) return z;
    const auto standard = (hn::Set(F64(), 1.0) - z) * hn::Set(F64(), as.range);
    if (!as.isFixed()) return hn::Neg(standard);
    return hn::Round(standard * hn::Set(F64(), as.steps)) * hn::Set(F64(), -1 / (as.steps + 1));
}

/// The parts of a plane's depth, by the rules.
template <class Rules>
class DepthLanes {
public:
    explicit DepthLanes(const Rules& rules) : m_rules(rules) {}

    /// a*(i + 0.5) at these centres of pixels.
    Vec64 across(Vec64 a, Vec64 centres) const
    {
        if constexpr (!Rules::kExactDepths)
            if (isFloat32()) return inFloat32(inFloat32(a) * centres);
        return a * centres;
    }
    /// b*(j + 0.5) + c at these centres of lines.
    Vec64 down(Vec64 b, Vec64 centres, Vec64 c) const
    {
        if constexpr (!Rules::kExactDepths)
            if (isFloat32()) return inFloat32(inFloat32(inFloat32(b) * centres) + inFloat32(c));
        return b * centres + c;
    }
    /// What is stored of the sum of both, if its float32 is known to lie between the limits afterwards (exact depths),
    /// or is brought there; in the bits that are compared.
    hn::Vec<F32> stored(Vec64 z, [[maybe_unused]] Vec64 farthest, [[maybe_unused]] Vec64 nearest) const
    {
        if constexpr (Rules::kExactDepths) {
            return hn::DemoteTo(F32(), z);
        } else {
            const auto limited = hn::Min(hn::Max(z, farthest), nearest);
            const auto bits    = hn::BitCast(I32(), hn::DemoteTo(F32(), encoded(limited, m_rules.encoding())));
            return hn::BitCast(F32(), orderedBits(bits));
        }
    }

private:
    bool isFloat32() const { return m_rules.depthNumbers() == DepthNumbers::Float32; }

    const Rules& m_rules;
};

/// The lower half of the keys of a triangle's fragments: the complement of its rank. A pre-pass keeps depths only, with
/// 0 there, which is less than any triangle's. So a fragment at the kept depth is larger and wins the usual test; of
/// several, the lowest rank wins.
template <Keep kKeep>
constexpr PixelKey lowerHalf(std::uint32_t rank)
{
    return kKeep == Keep::DepthOnly ? 0 : keyOf(0, rank);
}

/// A mask of colours from one of keys.
inline hn::Mask<U32> narrowed(hn::Mask<I64> mask)
{
#if HWY_TARGET == HWY_AVX3
    return hn::Mask<U32>::FromBits(mask.raw);
#else
    const hn::Rebind<std::uint64_t, F64> u64;
    return hn::MaskFromVec(hn::TruncateTo(U32(), hn::BitCast(u64, hn::VecFromMask(I64(), mask))));
#endif
}

/// The lanes whose fragment wins its pixel. `empty` is the depth of background. `kShades`: the winner is shaded at once,
/// so it must also be nearer than background. (With StackedDepths a pixel may hold something farther.)
template <bool kShades>
HWY_INLINE hn::Mask<I64> winners(Keys offered, Keys held, [[maybe_unused]] float empty)
{
    if constexpr (kShades) return hn::And(offered > held, offered > hn::Set(I64(), keyOf(empty, 0)));
    return offered > held;
}

/// The depth test of one triangle. `column` is a*(i + 0.5) per lane, `line` is b*(j + 0.5) + c in every lane.
/// `kNormal`: so are all keys that the buffer holds (core/fast/lanes/key_order-inl.h).
template <Keep kKeep, class Rules, bool kNormal = false>
class DepthTest {
    static_assert(!kNormal || Rules::kExactDepths);

public:
    /// `empty` is the depth of the background of the buffer that is tested against.
    DepthTest(const DepthPlane& plane, std::uint32_t rank, float empty, const Rules& rules)
        : m_a(plane.a), m_farthest(plane.farthest), m_nearest(plane.nearest), m_lower(lowerHalf<kKeep>(rank)),
          m_empty(empty), m_rules(rules)
    {}

    /// a*(i + 0.5) for the pixels x, x + 1, ...
    Vec64 column(int x) const
    {
        const auto centres = hn::Iota(F64(), 0.0) + hn::Set(F64(), x + 0.5);
        return DepthLanes(m_rules).across(hn::Set(F64(), m_a), centres);
    }

    /// Offers the covered lanes at row[0..]; they are the pixels x, x + 1, ... of line y. Returns what is held there
    /// now.
    template <class Fragments>
    Keys offer(Vec64 column, Vec64 line, hn::Mask<F64> covered, PixelKey* row, [[maybe_unused]] int x,
               [[maybe_unused]] int y, [[maybe_unused]] const Fragments& fragments) const
    {
        if constexpr (Fragments::kPatterned) {
            return offerPatterned(column, line, covered, row, x, y, fragments);
        } else {
            constexpr ShadingMoment kShading = Fragments::kMoment;
            const auto              offered  = keysOf(limited(column + line));
            const auto              held     = hn::LoadU(I64(), row);
            if constexpr (kNormal && kShading == ShadingMoment::Never) {
                const auto kept = nearerOf<kNormal>(hn::IfThenElseZero(hn::RebindMask(I64(), covered), offered), held);
                hn::StoreU(kept, I64(), row);
                return kept;
            }
            const auto won  = hn::And(hn::RebindMask(I64(), covered), wins<Fragments>(offered, held));
            const auto kept = hn::IfThenElse(won, offered, held);
            hn::StoreU(kept, I64(), row);

            if constexpr (kShading == ShadingMoment::BeforeTest)
                fragments.shade(U32(), narrowed(hn::RebindMask(I64(), covered)), narrowed(won), x, y);
            else if constexpr (kShading == ShadingMoment::AfterTest)
                if (!hn::AllFalse(I64(), won)) fragments.shade(U32(), narrowed(won), narrowed(won), x, y);
            return kept;
        }
    }

    /// What every lane would store.
    Keys keys(Vec64 column, Vec64 line) const { return keysOf(limited(column + line)); }

    /// Stores the first `count` lanes (all of them if there are fewer) without a test.
    void store(Vec64 column, Vec64 line, int count, PixelKey* row) const
    {
        const auto inside = hn::RebindMask(I64(), hn::Iota(F64(), 0.0) < hn::Set(F64(), count));
        hn::StoreU(hn::IfThenElse(inside, keys(column, line), hn::LoadU(I64(), row)), I64(), row);
    }

private:
    /// offer() for fragments that a pattern may discard or move. It never moves them nearer, so if a fragment fails
    /// where its triangle is, it fails; if it passes there, the pattern is looked up and it is tested where it is.
    template <class Fragments>
    Keys offerPatterned(Vec64 column, Vec64 line, hn::Mask<F64> covered, PixelKey* row, int x, int y,
                        const Fragments& fragments) const
    {
        constexpr bool kShadesFirst = Fragments::kMoment == ShadingMoment::BeforeTest;
        const F64      d64;
        const auto     inside = hn::RebindMask(I64(), covered);
        const auto     flat   = limited(column + line);
        const auto     bound  = keysOf(flat);
        const auto     held   = hn::LoadU(I64(), row);
        const bool     moves  = fragments.moves();

        const auto looked  = kShadesFirst ? inside : hn::And(inside, wins<Fragments>(bound, held));
        auto       offered = bound;
        auto       exists = looked, won = looked;
        auto       kept = held;
        if (!hn::AllFalse(I64(), looked)) {
            exists = hn::AndNot(hn::RebindMask(I64(), fragments.discarded(d64, x, y)), looked);
            if (moves) offered = keysOf(fragments.moved(d64, flat, x, y));
            won  = hn::And(exists, wins<Fragments>(offered, held));
            kept = hn::IfThenElse(won, offered, held);
            hn::StoreU(kept, I64(), row);
            if constexpr (Fragments::kMoment != ShadingMoment::Never)
                if (!hn::AllFalse(I64(), exists)) fragments.shade(U32(), narrowed(exists), narrowed(won), x, y);
        }

        return kept;
    }

    /// The keys of fragments of the triangle at these depths.
    Keys keysOf(Vec64 z) const
    {
        return hn::Or(upperHalves<!Rules::kExactDepths>(hn::DemoteTo(F32(), stored(z))), hn::Set(I64(), m_lower));
    }

    template <class Fragments>
    hn::Mask<I64> wins(Keys offered, Keys held) const
    {
        return winners<Fragments::kMoment != ShadingMoment::Never>(offered, held, m_empty);
    }

    Vec64 limited(Vec64 z) const { return hn::Min(hn::Max(z, hn::Set(F64(), m_farthest)), hn::Set(F64(), m_nearest)); }

    Vec64 stored(Vec64 z) const
    {
        if constexpr (!Rules::kExactDepths) return encoded(z, m_rules.encoding());
        return z;
    }

    double       m_a, m_farthest, m_nearest;
    PixelKey     m_lower;  // half of all its keys
    float        m_empty;
    const Rules& m_rules;
};

/// The constant part of a line's depth: b*(j + 0.5) + c.
template <class Rules>
double lineDepth(const DepthPlane& plane, int y, const Rules& rules)
{
    if (rules.depthNumbers() == DepthNumbers::Float64) return plane.b * (y + 0.5) + plane.c;
    return static_cast<float>(plane.b) * (static_cast<float>(y) + 0.5f) + static_cast<float>(plane.c);
}

/// The same of line after line, in every lane.
template <class Rules>
class LineDepths {
public:
    LineDepths(const DepthPlane& plane, int y, const Rules& rules)
        : m_plane(plane), m_rules(rules), m_y(y), m_centre(hn::Set(F64(), y + 0.5)), m_b(hn::Set(F64(), plane.b)),
          m_c(hn::Set(F64(), plane.c))
    {}

    Vec64 here() const
    {
        if constexpr (Rules::kExactDepths) return m_b * m_centre + m_c;
        return hn::Set(F64(), lineDepth(m_plane, m_y, m_rules));
    }
    void toNext()
    {
        m_centre = m_centre + hn::Set(F64(), 1.0);
        ++m_y;
    }

private:
    const DepthPlane& m_plane;
    const Rules&      m_rules;
    int               m_y;
    Vec64             m_centre, m_b, m_c;
};

/// Tests the pixels [x0, x1) of line y, all of them covered; they lie inside the picture.
template <Keep kKeep = Keep::Nearest, class Fragments = UnshadedFragments, class Rules>
void testSpan(const DepthPlane& plane, std::uint32_t rankOfSpan, int y, int x0, int x1, VisibilityBuffer& visible,
              const Rules& rules, const Fragments& fragments = {})
{
    const DepthTest<kKeep, Rules> test(plane, rankOfSpan, visible.empty(), rules);
    const auto                    line = LineDepths(plane, y, rules).here();
    PixelKey*                     row  = visible.row(y);
    for (int x = x0; x < x1; x += laneCount()) {
        const auto covered = hn::Iota(F64(), 0.0) < hn::Set(F64(), x1 - x);
        test.offer(test.column(x), line, covered, row + x, x, y, fragments);
    }
}

/// testSpan(), and tells that the span was filled.
template <Keep kKeep = Keep::Nearest, class Fragments = UnshadedFragments, class Rules>
void fillSpan(const DepthPlane& plane, std::uint32_t rankOfSpan, int y, int x0, int x1, VisibilityBuffer& visible,
              const Rules& rules, const Fragments& fragments = {})
{
    if (x0 >= x1) return;
    testSpan<kKeep>(plane, rankOfSpan, y, x0, x1, visible, rules, fragments);
}

/// Stores the pixels [x0, x1) of line y without a test: the caller knows that nothing there is nearer.
template <class Rules>
void storeSpan(const DepthPlane& plane, std::uint32_t rankOfSpan, int y, int x0, int x1, VisibilityBuffer& visible,
               const Rules& rules)
{
    const DepthTest<Keep::Nearest, Rules> test(plane, rankOfSpan, visible.empty(), rules);
    const auto                            line = LineDepths(plane, y, rules).here();
    PixelKey*                             row  = visible.row(y);
    for (int x = x0; x < x1; x += laneCount()) test.store(test.column(x), line, x1 - x, row + x);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_DEPTH_TEST_INL_H
