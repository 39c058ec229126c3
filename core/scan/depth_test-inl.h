// The depth test, several neighbouring pixels of one line side by side: who is nearest keeps the pixel.
//
// Depth      float64 until it is stored; limited to the corners' depths, then rounded to float32 (the order does not
//            matter: rounding is monotone and the limits are float32 values)
// Winner     larger depth; on equal depth the lower rank. Not-covered lanes offer kNotCovered, which never wins
// Patterns   a fragment in a hole does not exist, one in a relief lies farther than its triangle. Early depth tests first, looks
//            up what passed before anything is written, and tests what was moved again; shading first looks up all
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
#include "core/geometry/rules.h"
#include "core/scan/fragments.h"
#include "core/scan/pixel_events.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using F64   = hn::ScalableTag<double>;
using F32   = hn::Rebind<float, F64>;
using U32   = hn::Rebind<std::uint32_t, F64>;
using Vec64 = hn::Vec<F64>;

/// Pixels tested side by side.
inline int laneCount() { return static_cast<int>(hn::Lanes(F64())); }

/// Below every depth a buffer can hold.
inline constexpr double kNotCovered = -2;

/// Rounded to float32 and back: the result of one float32 operation on float32 values, whichever way it was computed.
inline Vec64 inFloat32(Vec64 value) { return hn::PromoteTo(F64(), hn::DemoteTo(F32(), value)); }

/// The lanes whose fragment takes the pixel from who holds it. `empty` is the depth of background.
template <Keep kKeep, class D, class Depths, class Ranks>
HWY_INLINE hn::Mask<D> winners(D d32, Depths depth, Depths stored, Ranks rank, Ranks holder, [[maybe_unused]] float empty)
{
    if constexpr (kKeep == Keep::DepthOnly) {
        return depth > stored;
    } else if constexpr (kKeep == Keep::Equal) {
        const auto one  = hn::Set(hn::Rebind<std::uint32_t, D>(), 1u);  // makes background, which nobody has claimed yet, the highest rank
        const auto kept = depth > hn::Set(d32, empty);  // a depth that the far test dropped equals background's
        return hn::And(hn::And(depth == stored, kept), hn::RebindMask(d32, rank - one < holder - one));
    } else {
        return hn::Or(depth > stored, hn::And(depth == stored, hn::RebindMask(d32, rank < holder)));
    }
}

/// The depth test of one triangle. `column` is a*(i + 0.5) per lane, `line` is b*(j + 0.5) + c.
template <Keep kKeep, class Rules>
class DepthTest {
public:
    /// `empty` is the depth of the background of the buffer that is tested against.
    DepthTest(const DepthPlane& plane, std::uint32_t rank, float empty, const Rules& rules)
        : m_a(plane.a), m_farthest(plane.farthest), m_nearest(plane.nearest), m_rank(rank), m_empty(empty), m_rules(rules)
    {
    }

    /// a*(i + 0.5) for the pixels x, x + 1, ... of a span or box that begins at pixel `first`; those before it do not count.
    Vec64 column(int x, [[maybe_unused]] int first) const
    {
        const auto centres = hn::Iota(F64(), 0.0) + hn::Set(F64(), x + 0.5);
        if constexpr (!Rules::kExact) {
            const float a = static_cast<float>(m_a);
            if (m_rules.depthNumbers() == DepthNumbers::Float32) return inFloat32(hn::Set(F64(), a) * centres);
            if (m_rules.depthNumbers() == DepthNumbers::Accumulated) return carried(a, x, first);
        }
        return hn::Set(F64(), m_a) * centres;
    }

    /// Offers the covered lanes at depthRow[0..], rankRow[0..]; they are the pixels x, x + 1, ... of line y.
    template <class Fragments, class Probe>
    void offer(Vec64 column, double line, hn::Mask<F64> covered, float* depthRow, std::uint32_t* rankRow,
               [[maybe_unused]] int x, [[maybe_unused]] int y, [[maybe_unused]] const Fragments& fragments,
               const Probe& probe) const
    {
        if constexpr (Fragments::kPatterned) {
            offerPatterned(column, line, covered, depthRow, rankRow, x, y, fragments, probe);
        } else {
            constexpr ShadingMoment kShading = Fragments::kMoment;
            const F64  d64;
            const F32  d32;
            const U32  u32;
            const auto z     = stored(limited(column + hn::Set(d64, line)));
            const auto depth = hn::DemoteTo(d32, hn::IfThenElse(covered, z, hn::Set(d64, kNotCovered)));

            [[maybe_unused]] auto colours = hn::Undefined(u32);
            if constexpr (kShading == ShadingMoment::BeforeTest) colours = fragments.colours(u32, x, y);

            const auto stored = hn::LoadU(d32, depthRow);
            const auto holder = hn::LoadU(u32, rankRow);
            const auto won    = wins(depth, stored, holder);
            keep(won, depth, stored, holder, depthRow, rankRow);

            if constexpr (kShading == ShadingMoment::BeforeTest) {
                fragments.keep(u32, hn::RebindMask(u32, won), colours, x, y);
            } else if constexpr (kShading == ShadingMoment::AfterTest) {
                if (!hn::AllFalse(d32, won)) fragments.keep(u32, hn::RebindMask(u32, won), fragments.colours(u32, x, y), x, y);
            }

            if constexpr (Probe::listens) {
                static_assert(!Probe::listens || hn::MaxLanes(F64()) == 1, "a run that is listened to uses one lane");
                if (hn::AllFalse(d64, covered)) return;
                const bool wins = !hn::AllFalse(d32, won);
                probe(PixelTested{.x = x, .y = y, .triangle = TriangleId{m_rank - 1}, .depth = hn::GetLane(depth), .won = wins,
                                  .rivalRank = hn::GetLane(holder), .rivalDepth = hn::GetLane(stored), .keep = kKeep,
                                  .shaded = kShading == ShadingMoment::BeforeTest || (kShading == ShadingMoment::AfterTest && wins)});
            }
        }
    }

    /// Stores the first `count` lanes (all of them if there are fewer) without a test.
    void store(Vec64 column, double line, int count, float* depthRow, std::uint32_t* rankRow) const
    {
        const F32  d32;
        const U32  u32;
        const auto depth  = hn::DemoteTo(d32, stored(limited(column + hn::Set(F64(), line))));
        const auto inside = hn::Iota(d32, 0.0f) < hn::Set(d32, static_cast<float>(count));
        hn::StoreU(hn::IfThenElse(inside, depth, hn::LoadU(d32, depthRow)), d32, depthRow);
        hn::StoreU(hn::IfThenElse(hn::RebindMask(u32, inside), hn::Set(u32, m_rank), hn::LoadU(u32, rankRow)), u32, rankRow);
    }

private:
    /// offer() for fragments that a pattern may discard or move. It never moves them nearer, so if a fragment fails where its
    /// triangle is, it fails; if it passes there, the pattern is looked up and it is tested where it is.
    template <class Fragments, class Probe>
    void offerPatterned(Vec64 column, double line, hn::Mask<F64> covered, float* depthRow, std::uint32_t* rankRow, int x, int y,
                        const Fragments& fragments, const Probe& probe) const
    {
        constexpr bool kShadesFirst = Fragments::kMoment == ShadingMoment::BeforeTest;
        const F64  d64;
        const F32  d32;
        const U32  u32;
        const auto flat   = limited(column + hn::Set(d64, line));
        const auto bound  = hn::DemoteTo(d32, hn::IfThenElse(covered, stored(flat), hn::Set(d64, kNotCovered)));
        const auto before = hn::LoadU(d32, depthRow);
        const auto holder = hn::LoadU(u32, rankRow);
        const bool moves  = fragments.moves();

        const auto looked = kShadesFirst ? bound > hn::Set(d32, kNotCovered) : moves ? mayWin(bound, before, holder) : wins(bound, before, holder);
        auto       depth  = bound;
        auto       exists = looked, won = looked;
        if (!hn::AllFalse(d32, looked)) {
            const auto one = hn::IfThenElseZero(fragments.discarded(d64, x, y), hn::Set(d64, 1.0));
            exists         = hn::AndNot(hn::DemoteTo(d32, one) > hn::Zero(d32), looked);
            if (moves) depth = hn::DemoteTo(d32, hn::IfThenElse(covered, stored(fragments.moved(d64, flat, x, y)), hn::Set(d64, kNotCovered)));
            won = hn::And(exists, wins(depth, before, holder));
            keep(won, depth, before, holder, depthRow, rankRow);
            if constexpr (Fragments::kMoment != ShadingMoment::Never)
                if (!hn::AllFalse(d32, exists)) fragments.keep(u32, hn::RebindMask(u32, won), fragments.colours(u32, x, y), x, y);
        }

        if constexpr (Probe::listens) {
            if (hn::AllFalse(d64, covered)) return;
            const bool isLookedAt = !hn::AllFalse(d32, looked), isThere = !hn::AllFalse(d32, exists);
            probe(PixelTested{.x = x, .y = y, .triangle = TriangleId{m_rank - 1}, .depth = hn::GetLane(depth), .won = !hn::AllFalse(d32, won),
                              .rivalRank = hn::GetLane(holder), .rivalDepth = hn::GetLane(before), .keep = kKeep,
                              .shaded    = kShadesFirst || (Fragments::kMoment != ShadingMoment::Never && isThere),
                              .discarded = isLookedAt && !isThere, .moved = isThere && moves, .unmovedDepth = hn::GetLane(bound)});
        }
    }

    void keep(hn::Mask<F32> won, hn::Vec<F32> depth, hn::Vec<F32> before, hn::Vec<U32> holder, float* depthRow, std::uint32_t* rankRow) const
    {
        const F32 d32;
        const U32 u32;
        if constexpr (kKeep != Keep::Equal) hn::StoreU(hn::IfThenElse(won, depth, before), d32, depthRow);
        if constexpr (kKeep != Keep::DepthOnly)
            hn::StoreU(hn::IfThenElse(hn::RebindMask(u32, won), hn::Set(u32, m_rank), holder), u32, rankRow);
    }

    /// False only for a depth that no farther one wins from, either.
    hn::Mask<F32> mayWin(hn::Vec<F32> depth, hn::Vec<F32> stored, hn::Vec<U32> holder) const
    {
        if constexpr (kKeep == Keep::Equal)
            return depth >= stored;
        else
            return wins(depth, stored, holder);
    }

    hn::Mask<F32> wins(hn::Vec<F32> depth, hn::Vec<F32> stored, hn::Vec<U32> holder) const
    {
        const F32 d32;
        if constexpr (!Rules::kExact && kKeep == Keep::Nearest)
            if (m_rules.firstComerKeepsTie()) return depth > stored;
        if constexpr (!Rules::kExact && kKeep == Keep::Equal)
            if (m_rules.firstComerKeepsTie())
                return hn::And(hn::And(depth == stored, depth > hn::Set(d32, m_empty)), hn::RebindMask(d32, holder == hn::Zero(U32())));
        return winners<kKeep>(d32, depth, stored, hn::Set(U32(), m_rank), holder, m_empty);
    }

    Vec64 limited(Vec64 z) const
    {
        return hn::Min(hn::Max(z, hn::Set(F64(), m_farthest)), hn::Set(F64(), m_nearest));
    }

    /// As DepthEncoding::stored(), before the last rounding to float32.
    Vec64 stored(Vec64 z) const
    {
        if constexpr (!Rules::kExact) {
            const DepthEncoding& as = m_rules.encoding();
            if (as.isReversed()) return z;
            const auto standard = (hn::Set(F64(), 1.0) - z) * hn::Set(F64(), as.range);
            if (!as.isFixed()) return hn::Neg(standard);
            return hn::Round(standard * hn::Set(F64(), as.steps)) * hn::Set(F64(), -1 / (as.steps + 1));
        }
        return z;
    }

    /// a*(first + 0.5), and from there a added once per pixel, in float32.
    static Vec64 carried(float a, int x, int first)
    {
        HWY_ALIGN std::array<double, hn::MaxLanes(F64())> value;
        float                                             carry = a * (static_cast<float>(first) + 0.5f);
        for (int at = first; at < x; ++at) carry += a;
        for (std::size_t lane = 0; lane < hn::Lanes(F64()); ++lane) {
            value[lane] = carry;
            if (x + static_cast<int>(lane) >= first) carry += a;
        }
        return hn::Load(F64(), value.data());
    }

    double        m_a, m_farthest, m_nearest;
    std::uint32_t m_rank;
    float         m_empty;
    const Rules&  m_rules;
};

/// The constant part of a line's depth: b*(j + 0.5) + c.
template <class Rules>
double lineDepth(const DepthPlane& plane, int y, const Rules& rules)
{
    if (rules.depthNumbers() == DepthNumbers::Float64) return plane.b * (y + 0.5) + plane.c;
    return static_cast<float>(plane.b) * (static_cast<float>(y) + 0.5f) + static_cast<float>(plane.c);
}

/// Tests the pixels [x0, x1) of line y, all of them covered; they lie inside the picture.
template <Keep kKeep = Keep::Nearest, class Fragments = UnshadedFragments, class Rules, class Probe>
void testSpan(const DepthPlane& plane, std::uint32_t rankOfSpan, int y, int x0, int x1, VisibilityBuffer& visible,
              const Rules& rules, const Probe& probe, const Fragments& fragments = {})
{
    const DepthTest<kKeep, Rules> test(plane, rankOfSpan, visible.empty(), rules);
    const double                  line  = lineDepth(plane, y, rules);
    float*                        depth = visible.depthRow(y);
    std::uint32_t*                rank  = visible.rankRow(y);
    for (int x = x0; x < x1; x += laneCount()) {
        const auto covered = hn::Iota(F64(), 0.0) < hn::Set(F64(), x1 - x);
        test.offer(test.column(x, x0), line, covered, depth + x, rank + x, x, y, fragments, probe);
    }
}

/// testSpan(), and tells that the span was filled.
template <Keep kKeep = Keep::Nearest, class Fragments = UnshadedFragments, class Rules, class Probe>
void fillSpan(const DepthPlane& plane, std::uint32_t rankOfSpan, int y, int x0, int x1, VisibilityBuffer& visible,
              const Rules& rules, const Probe& probe, const Fragments& fragments = {})
{
    if (x0 >= x1) return;
    testSpan<kKeep>(plane, rankOfSpan, y, x0, x1, visible, rules, probe, fragments);
    probe(SpanFilled{y, x0, x1, TriangleId{rankOfSpan - 1}});
}

/// Stores the pixels [x0, x1) of line y without a test: the caller knows that nothing there is nearer.
template <class Rules>
void storeSpan(const DepthPlane& plane, std::uint32_t rankOfSpan, int y, int x0, int x1, VisibilityBuffer& visible,
               const Rules& rules)
{
    const DepthTest<Keep::Nearest, Rules> test(plane, rankOfSpan, visible.empty(), rules);
    const double                          line  = lineDepth(plane, y, rules);
    float*                                depth = visible.depthRow(y);
    std::uint32_t*                        rank  = visible.rankRow(y);
    for (int x = x0; x < x1; x += laneCount()) test.store(test.column(x, x0), line, x1 - x, depth + x, rank + x);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_DEPTH_TEST_INL_H
