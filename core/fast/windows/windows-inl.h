// Compact triangles to pixels by windows: a list of (triangle, window) that is worked off without asking which triangle
// comes next.
//
// Tiny       triangles with at most kTinySide x kTinySide pixels need no window: the same pixel of several of them is
//            tested side by side, and what is covered is offered sample by sample
// Window     kWindowSide x kWindowSide pixels, as window_finder-inl.h has found them
// Edges      int32, exact (core/geometry/triangle_list.h). The three of a triangle add up to the same at every pixel,
//            so that two are computed and the third falls by what they rise
// Depth      as in depth_test-inl.h: float64 until it is stored. The limits are float32 values and rounding is
//            monotone, so they may be applied after it
// List       triangles of one batch, because a loop over one triangle's few windows is mispredicted at every triangle
// Promise    the same pixels as HalfSpace and EdgeWalk. A window may reach beyond its triangle's box, never beyond the
//            lines of the stripe, and to the right no farther than the picture's padding
//            (core/depth/visibility_buffer.h)
// Source     Pineda: A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; docs/correctness.md, Coverage
#if defined(ZSCOPE_WINDOWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_WINDOWS_INL_H
#undef ZSCOPE_WINDOWS_INL_H
#else
#define ZSCOPE_WINDOWS_INL_H
#endif

#include <algorithm>
#include <array>
#include <cassert>

#include <hwy/cache_control.h>

#include "core/fast/lanes/avx512_words-inl.h"
#include "core/fast/lanes/depth_test-inl.h"
#include "core/fast/lanes/edge_steps-inl.h"
#include "core/fast/lanes/lane_order-inl.h"
#include "core/fast/lanes/pass_lanes-inl.h"
#include "core/fast/windows/window_finder-inl.h"
#include "core/fast/windows/window_list.h"
#include "core/geometry/triangle_list.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

inline constexpr int kPassColumns = std::min(kPassPixels, kWindowSide);
inline constexpr int kPassLines   = kPassPixels / kPassColumns;

/// The way from the first pixel of a window to those of the first pass.
HWY_ALIGN inline constexpr auto kWays = [] {
    constexpr PassLanes<std::int32_t, kWindowSide> kAt;
    std::array<std::int32_t, kPassPixels>          all{};
    for (std::size_t lane = 0; lane < all.size(); ++lane) all[lane] = pixelsAndLines(kAt.right[lane], kAt.down[lane]);
    return all;
}();

/// Depths are found two columns of a pass at a time, line by line, so that both vectors of float64 share their lines:
/// how far down each lane is.
HWY_ALIGN inline constexpr auto kDownOfPairs = [] {
    std::array<double, kLanes> all{};
    for (int lane = 0; lane < kLanes; ++lane) all[static_cast<std::size_t>(lane)] = lane / 2;
    return all;
}();

#if HWY_TARGET == HWY_AVX3
/// A pass in the order of its lanes, from its columns one and two and then three and four.
inline hn::Vec<Pass32> fromColumns(hn::Vec<F32> first, hn::Vec<F32> second)
{
    HWY_ALIGN static constexpr auto kPlaces = [] {
        std::array<std::int32_t, kPassPixels> all{};
        for (int lane = 0; lane < kPassPixels; ++lane) {
            const int line = pixelOfLane(lane) / kWindowSide, column = pixelOfLane(lane) % kWindowSide;
            all[static_cast<std::size_t>(lane)] = column / 2 * kPassPixels + 2 * line + column % 2;
        }
        return all;
    }();
    return joinedLanes(first, second, kPlaces.data());
}

/// Of two lines.
using LineKeys = hn::Half<I64>;
inline Keys loadKeys(const PixelKey* row, std::ptrdiff_t stride)
{
    return hn::Combine(I64(), hn::LoadU(LineKeys(), row + stride), hn::LoadU(LineKeys(), row));
}
inline void storeKeys(Keys keys, PixelKey* row, std::ptrdiff_t stride)
{
    hn::StoreU(hn::LowerHalf(LineKeys(), keys), LineKeys(), row);
    hn::StoreU(hn::UpperHalf(LineKeys(), keys), LineKeys(), row + stride);
}
#else
static_assert(kLanes <= kWindowSide);
inline hn::Vec<Pass32> fromColumns(hn::Vec<F32> first, hn::Vec<F32> second) { return together(second, first); }
inline Keys            loadKeys(const PixelKey* row, std::ptrdiff_t) { return hn::LoadU(I64(), row); }
inline void            storeKeys(Keys keys, PixelKey* row, std::ptrdiff_t) { hn::StoreU(keys, I64(), row); }
#endif

/// Offers to as many pixels as there are lanes, those of one line or of two. A depth whose sign is negative wins
/// nowhere. `kNormal` as in DepthTest.
template <bool kNormal>
HWY_INLINE void offerKeys(Keys offered, PixelKey* row, std::ptrdiff_t stride)
{
#if HWY_TARGET == HWY_AVX3
    // line by line: what is held need not be brought side by side first
    if constexpr (kNormal) {
        const auto offer = [](auto keys, PixelKey* line) HWY_ATTR {
            hn::StoreU(nearerOf<kNormal>(keys, hn::LoadU(LineKeys(), line)), LineKeys(), line);
        };
        offer(hn::LowerHalf(LineKeys(), offered), row);
        offer(hn::UpperHalf(LineKeys(), offered), row + stride);
        return;
    }
#endif
    storeKeys(nearerOf<kNormal>(offered, loadKeys(row, stride)), row, stride);
}

/// By how much an edge has risen at the pixels of a pass.
using PassRises = hn::Vec<hn::RebindToSigned<Pass32>>;

// Which pixels of a pass a triangle covers: those where none of its three edges is below 0.
#if HWY_TARGET == HWY_AVX3
using Covered = hn::Mask<hn::RebindToSigned<Pass32>>;
inline Covered coveredOf(PassRises first, PassRises second, const TriangleList& triangles, std::size_t t)
{
    const hn::RebindToSigned<Pass32> i32;
    const auto                       both =
        atMost(atMost(hn::Set(i32, triangles.leastRise[0][t]), first), hn::Set(i32, triangles.leastRise[1][t]), second);
    return atMost(both, first + second, hn::Set(i32, triangles.mostRise[t]));
}
/// The depths of pixels that are covered, in the bits that are compared; in place of the others what wins nowhere.
/// `kNormal` as in DepthTest; `kMayBeNegative`: the bits of depths that are covered.
template <bool kNormal, bool kMayBeNegative>
inline hn::Vec<Pass32> onlyCovered(hn::Vec<Pass32> depth, Covered covered)
{
    if constexpr (kNormal) return hn::IfThenElseZero(hn::RebindMask(Pass32(), covered), depth);
    return hn::IfThenElse(hn::RebindMask(Pass32(), covered), depth, hn::Set(Pass32(), -0.0f));
}
#else
using Covered = PassRises;  // negative where they are not
inline Covered coveredOf(PassRises first, PassRises second, const TriangleList& triangles, std::size_t t)
{
    const hn::RebindToSigned<Pass32> i32;
    return hn::Or3(first - hn::Set(i32, triangles.leastRise[0][t]), second - hn::Set(i32, triangles.leastRise[1][t]),
                   hn::Set(i32, triangles.mostRise[t]) - (first + second));
}
/// Likewise: the sign says so, where no depth has one.
template <bool kNormal, bool kMayBeNegative>
inline hn::Vec<Pass32> onlyCovered(hn::Vec<Pass32> depth, Covered covered)
{
    if constexpr (kMayBeNegative)
        return hn::IfThenElse(hn::RebindMask(Pass32(), covered < hn::Zero(hn::RebindToSigned<Pass32>())),
                              hn::Set(Pass32(), -0.0f), depth);
    return hn::OrAnd(depth, hn::BitCast(Pass32(), covered), hn::Set(Pass32(), -0.0f));
}
#endif

/// Of two columns, side by side over and over.
inline Vec64 pairOf(const double* centres) { return hn::LoadDup128(F64(), centres); }

/// What windows are drawn to.
struct WindowTarget {
    PixelKey*      picture;
    std::ptrdiff_t stride;   // keys from a pixel to the one below it
    const double*  centres;  // as in WindowList
    float          empty;    // depth of background
    int            width;

    PixelKey* at(std::uint32_t corner) const
    {
        return picture + static_cast<std::ptrdiff_t>(corner >> 16) * stride + (corner & 0xFFFF);
    }
};

/// How far as many neighbouring pixels of windows as there are keys in a vector lie from the first, x + 65536 y.
HWY_ALIGN inline constexpr auto kPixelsOfKeys = [] {
    std::array<std::uint32_t, kLanes> all{};
    for (std::uint32_t lane = 0; lane < all.size(); ++lane) all[lane] = lane % kWindowSide + (lane / kWindowSide << 16);
    return all;
}();

/// Stores a colour where keys of a window were won, which begin at pixel x of line y.
template <class Fragments>
HWY_INLINE void storeColours(hn::Mask<U32> won, const Fragments& fragments, int x, int y)
{
#if HWY_TARGET == HWY_AVX3
    using Line         = hn::Half<U32>;
    const auto colours = hn::Set(Line(), fragments.colour());
    hn::BlendedStore(colours, hn::Mask<Line>::FromBits(won.raw & 0xFu), Line(), fragments.line(y) + x);
    hn::BlendedStore(colours, hn::Mask<Line>::FromBits(won.raw >> 4), Line(), fragments.line(y + 1) + x);
#else
    hn::BlendedStore(hn::Set(U32(), fragments.colour()), won, U32(), fragments.line(y) + x);
#endif
}

/// As offerKeys(), for fragments that are shaded. `first`: the first pixel, x + 65536 y. `allExist`: all lanes lie in the
/// picture. Returns how many fragments were shaded here; the queue counts its own.
template <bool kMayBeNegative, class Fragments>
HWY_INLINE std::size_t offerShaded(Keys offered, const WindowTarget& to, PixelKey* row, std::uint32_t first,
                                   bool allExist, const Fragments& fragments)
{
    const U32 u32;
    // at least background, so that a winner is nearer than background, too
    const auto held = hn::Max(loadKeys(row, to.stride), hn::Set(I64(), keyOf(to.empty, 0)));
    const auto won  = offered > held;
    storeKeys(hn::Max(offered, held), row, to.stride);
    auto paid = narrowed(won), wanted = paid;
    if constexpr (Fragments::kMoment == ShadingMoment::BeforeTest)
        wanted = narrowed(areCovered<kMayBeNegative>(offered));
    if constexpr (!Fragments::kFree)
        if (hn::AllFalse(u32, wanted)) return 0;
    if (!allExist) {
        const auto x     = hn::And(hn::Load(u32, kPixelsOfKeys.data()) + hn::Set(u32, first), hn::Set(u32, 0xFFFF));
        const auto exist = x < hn::Set(u32, static_cast<std::uint32_t>(to.width));
        wanted = hn::And(wanted, exist), paid = hn::And(paid, exist);
    }
    if constexpr (Fragments::kFree) {
        storeColours(paid, fragments, static_cast<int>(first & 0xFFFF), static_cast<int>(first >> 16));
        return hn::CountTrue(u32, wanted);
    } else {
        fragments.shade(u32, wanted, hn::Load(u32, kPixelsOfKeys.data()) + hn::Set(u32, first));
        return 0;
    }
}

/// Tests the window of triangle t that has its first pixel at `corner`, and stores what it wins. `kNormal` as in
/// DepthTest. Returns how many fragments it has shaded.
template <Keep kKeep, bool kNormal, class Rules, class FragmentsOf>
HWY_INLINE std::size_t testWindow(const TriangleList& triangles, std::size_t t, std::uint32_t corner,
                                  const WindowTarget& to, const Rules& rules, const FragmentsOf& fragmentsOf)
{
    constexpr bool kMayBeNegative = !Rules::kExactDepths;
    const auto     fragments      = fragmentsOf(~triangles.notRank[t]);
    constexpr bool kShades        = decltype(fragments)::kMoment != ShadingMoment::Never;
    static_assert(!kNormal || (!kMayBeNegative && !kShades));
    const F64                        d64;
    const Pass32                     f32;
    const hn::RebindToSigned<Pass32> i32;

    const std::size_t x = corner & 0xFFFF, y = corner >> 16;
    PixelKey* const   first = to.at(corner);
    const auto a = hn::Set(d64, triangles.a[t]), b = hn::Set(d64, triangles.b[t]), c = hn::Set(d64, triangles.c[t]);
    const auto farthest = hn::Set(f32, triangles.farthest[t]), nearest = hn::Set(f32, triangles.nearest[t]);
    const auto above = hn::Set(d64, to.centres[y]);
    const DepthLanes depths(rules);
    // Not needed where all may be limited in float32 afterwards.
    const auto farthest64 = hn::Set(d64, double{triangles.farthest[t]}),
               nearest64  = hn::Set(d64, double{triangles.nearest[t]});

    // At the pixels of each pass. Those of the first are computed, the others reached from there.
    const auto                   steps = [&](std::size_t k) HWY_ATTR { return hn::Set(i32, triangles.steps[k][t]); };
    const auto                   ways  = hn::Load(i32, kWays.data()) + hn::Set(i32, static_cast<std::int32_t>(corner));
    constexpr int                kColumns = kWindowSide / kPassColumns, kPasses = kWindowSide / kPassLines * kColumns;
    std::array<Covered, kPasses> inside;
    std::array<PassRises, 2>     rises{growth(steps(0), ways), growth(steps(1), ways)};
    for (int pass = 0; pass < kPasses; ++pass) {
        const int column = pass % kColumns * kPassColumns;
        if (pass > 0 && column == 0)
            for (std::size_t k = 0; k < 2; ++k) rises[k] = rises[k] + growth(steps(k), 0, kPassLines);
        const auto rise = [&](std::size_t k)
                              HWY_ATTR { return column == 0 ? rises[k] : rises[k] + growth(steps(k), column, 0); };
        inside[static_cast<std::size_t>(pass)] = coveredOf(rise(0), rise(1), triangles, t);
    }

    // a window may reach right of the picture: its last columns may be of no pixel
    [[maybe_unused]] const bool allExist = static_cast<int>(x) + kWindowSide <= to.width;
    std::size_t                 count    = 0;
    for (int line = 0, pass = 0; line < kWindowSide; line += kPassLines) {
        const auto start = depths.down(b, hn::Load(d64, kDownOfPairs.data()) + hn::Set(d64, line) + above, c);
        for (int column = 0; column < kWindowSide; column += kPassColumns, ++pass) {
            const auto covered = inside[static_cast<std::size_t>(pass)];

            const auto depth = [&](int half) HWY_ATTR {
                return depths.stored(depths.across(a, pairOf(to.centres + x + column + 2 * half)) + start, farthest64,
                                     nearest64);
            };
            const auto limited = [&](auto z) HWY_ATTR {
                if constexpr (kMayBeNegative)
                    return z;
                else
                    return hn::Min(hn::Max(z, farthest), nearest);
            };
            const auto offer = [&](Keys keys, [[maybe_unused]] int right, [[maybe_unused]] int down) HWY_ATTR {
                PixelKey* const row = first + (line + down) * to.stride + column + right;
                if constexpr (kShades)
                    count += offerShaded<kMayBeNegative>(
                        keys, to, row, corner + static_cast<std::uint32_t>(pixelsAndLines(column + right, line + down)),
                        allExist, fragments);
                else
                    offerKeys<kNormal>(keys, row, to.stride);
            };
            const auto z = limited(fromColumns(depth(0), depth(1)));
            const auto keys =
                keysOf(onlyCovered<kNormal, kMayBeNegative>(z, covered), lowerHalves<kKeep>(triangles.notRank[t]));
            offer(keys[0], 0, 0);
            offer(keys[1], kLanes % kWindowSide, kLanes / kWindowSide);
        }
    }
    return count;
}

/// Pixels are fetched so many samples before they are tested (windows: WindowChunk::kAhead): triangles come in any
/// order, and memory answers late.
inline constexpr std::size_t kSamplesAhead = 64;

/// Keys from their halves, which stand lane by lane: first those of the lanes that `order` names, in that order.
template <class V, class Order>
HWY_INLINE void storeKeysOf(V uppers, V lowers, Order order, PixelKey* to)
{
    const hn::RebindToUnsigned<Pass32> u32;
    const hn::RebindToSigned<Pass32>   i32;
    // As lanes are interleaved.
    const auto lanes = hn::IndicesFromVec(
        u32, hn::TableLookupLanes(order, hn::IndicesFromVec(i32, hn::Load(i32, kPassPixelsOfLanes.data()))));
    const auto upper = hn::TableLookupLanes(uppers, lanes), lower = hn::TableLookupLanes(lowers, lanes);
    hn::StoreU(hn::BitCast(I64(), hn::InterleaveLower(u32, lower, upper)), I64(), to);
    hn::StoreU(hn::BitCast(I64(), hn::InterleaveUpper(u32, lower, upper)), I64(), to + kLanes);
}

/// The lower half of lanes of 32 bits, or the one that begins at `from`.
template <class V>
HWY_INLINE hn::Vec<I32> halfOf(V all, [[maybe_unused]] std::size_t from)
{
    return from == 0 ? hn::LowerHalf(I32(), all) : hn::UpperHalf(I32(), all);
}

/// The tiny triangles among [first, end), from their edges to the picture.
template <Keep kKeep, class Rules, class FragmentsOf>
void testTiny(const TriangleList& triangles, std::size_t first, std::size_t end, SampleList& samples,
              VisibilityBuffer& visible, const Rules& rules, [[maybe_unused]] const FragmentsOf& fragmentsOf)
{
    using Fragments                            = decltype(fragmentsOf(1u));
    constexpr ShadingMoment            kMoment = Fragments::kMoment;
    const DepthLanes                   depths(rules);
    const F64                          d64;
    const F32                          half;
    const Pass32                       f32;
    const hn::RebindToSigned<Pass32>   i32;
    const hn::RebindToUnsigned<Pass32> u32;
    samples.reserve(kTinySide * kTinySide * (end - first));
    PixelKey* const      picture = visible.row(0);
    const auto           stride  = static_cast<std::uint32_t>(visible.stride());
    PixelKey* const      keys    = samples.keys.data();
    std::uint32_t* const places  = samples.places.data();
    std::uint32_t* const pixels  = samples.pixels.data();
    std::size_t          count   = 0;
    for (std::size_t i = first; i < end; i += hn::Lanes(f32)) {
        const auto load = [&, i](const TriangleList::Column<std::int32_t>& column)
                              HWY_ATTR { return hn::LoadU(i32, column.data() + i); };
        const auto kind   = load(triangles.kind),
                   judged = hn::And(
                       kind, hn::Set(i32, TriangleList::kPatterned | TriangleList::kCompact | TriangleList::kHidden));
        const auto start = load(triangles.start), size = minusHalves(load(triangles.end), start),
                   raised = hn::ShiftRight<TriangleList::kRaised>(kind);
        const auto x = lowerHalf(start), y = upperHalf(start) - raised, width = lowerHalf(size),
                   height  = upperHalf(size) + raised;
        const auto isTiny  = hn::And(judged == hn::Set(i32, TriangleList::kCompact),
                                     hn::Not(hn::Max(width, height) > hn::Set(i32, kTinySide)));
        const auto isDrawn = hn::And(isTiny, countFrom(i32, 0) < hn::Set(i32, static_cast<std::int32_t>(end - i)));
        if (hn::AllFalse(i32, isDrawn)) continue;

        const auto farthest = hn::LoadU(f32, triangles.farthest.data() + i),
                   nearest  = hn::LoadU(f32, triangles.nearest.data() + i);
        const auto lower    = kKeep == Keep::DepthOnly ? hn::Zero(u32) : hn::LoadU(u32, triangles.notRank.data() + i);
        const auto place    = hn::BitCast(u32, x) + hn::BitCast(u32, y) * hn::Set(u32, stride);
        const auto corner   = start - hn::ShiftLeft<16>(raised);
        // In float64, of half of these triangles at a time.
        const auto numbers = [&, i](const auto& column, std::size_t from)
                                 HWY_ATTR { return hn::LoadU(d64, column.data() + i + from); };
        const auto centres = [&](auto at, std::size_t from)
                                 HWY_ATTR { return hn::PromoteTo(d64, halfOf(at, from)) + hn::Set(d64, 0.5); };
        const auto lineOf = [&](int down, std::size_t from) HWY_ATTR {
            return depths.down(numbers(triangles.b, from), centres(y, from) + hn::Set(d64, down),
                               numbers(triangles.c, from));
        };
        const auto limit = [&, i](const auto& column, std::size_t from)
                               HWY_ATTR { return hn::PromoteTo(d64, hn::LoadU(half, column.data() + i + from)); };
        // a * (i + 0.5), of both halves: found before the first store, which could change what it is found from for all
        // the compiler knows.
        std::array<std::array<Vec64, 2>, kTinySide> columns;
        for (std::size_t right = 0; right < kTinySide; ++right)
            for (const std::size_t other : {0, 1}) {
                const std::size_t from = other * kOtherHalf;
                columns[right][other]  = depths.across(numbers(triangles.a, from),
                                                       centres(x, from) + hn::Set(d64, static_cast<double>(right)));
            }
        for (int down = 0; down < kTinySide; ++down) {
            const auto line = lineOf(down, 0), otherLine = lineOf(down, kOtherHalf);
            for (int right = 0; right < kTinySide; ++right) {
                const auto here    = corner + hn::Set(i32, pixelsAndLines(right, down));
                const auto rise    = [&](std::size_t k) HWY_ATTR { return growth(load(triangles.steps[k]), here); };
                const auto ofFirst = rise(0), ofSecond = rise(1);
                const auto outside =
                    hn::Or3(ofFirst - load(triangles.leastRise[0]), ofSecond - load(triangles.leastRise[1]),
                            load(triangles.mostRise) - (ofFirst + ofSecond))
                    < hn::Zero(i32);
                const auto  exists  = hn::And(width > hn::Set(i32, right), height > hn::Set(i32, down));
                const auto  covered = hn::And(hn::AndNot(outside, exists), isDrawn);
                const auto& column  = columns[static_cast<std::size_t>(right)];
                const auto  stored  = [&](Vec64 sum, std::size_t from) HWY_ATTR {
                    if constexpr (Rules::kExactDepths)
                        return depths.stored(sum, sum, sum);
                    else
                        return depths.stored(sum, limit(triangles.farthest, from), limit(triangles.nearest, from));
                };
                auto z = together(stored(column[1] + otherLine, kOtherHalf), stored(column[0] + line, 0));
                if constexpr (Rules::kExactDepths) z = hn::Min(hn::Max(z, farthest), nearest);
                const auto there =
                    place + hn::Set(u32, static_cast<std::uint32_t>(right) + static_cast<std::uint32_t>(down) * stride);
                const auto kept = keptFirst(i32, covered);
                hn::StoreU(hn::TableLookupLanes(there, hn::IndicesFromVec(u32, kept)), u32, places + count);
                if constexpr (kMoment != ShadingMoment::Never)
                    hn::StoreU(hn::TableLookupLanes(hn::BitCast(u32, here), hn::IndicesFromVec(u32, kept)), u32,
                               pixels + count);
                storeKeysOf(hn::BitCast(u32, z), lower, kept, keys + count);
                count += hn::CountTrue(i32, covered);
            }
        }
    }

    [[maybe_unused]] const FragmentsOf own        = fragmentsOf;
    [[maybe_unused]] const PixelKey    background = visible.background();
    std::size_t                        shaded     = 0;
    for (std::size_t i = 0; i < count; ++i) {
        hwy::Prefetch(picture + places[std::min(i + kSamplesAhead, count - 1)]);
        const PixelKey offered = keys[i];
        PixelKey&      held    = picture[places[i]];
        const bool     won     = offered > held && (kMoment == ShadingMoment::Never || offered > background);
        held                   = won ? offered : held;
        if constexpr (kMoment != ShadingMoment::Never) {
            const bool isShaded = won || kMoment == ShadingMoment::BeforeTest;
            if constexpr (Fragments::kFree) {
                shaded += isShaded;
                if (!won) continue;
                own.line(static_cast<int>(pixels[i] >> 16))[pixels[i] & 0xFFFF] = own.colourOf(rankOf(offered));
            } else if (isShaded) {
                fragmentsOf(rankOf(offered)).shade(pixels[i]);
            }
        }
    }
    if constexpr (Fragments::kFree) own.count(shaded);
}

/// Fetches the pixels of a window. Inlined always: gcc takes out calls of what only fetches.
HWY_INLINE void fetch(const PixelKey* first, std::ptrdiff_t stride)
{
    for (int line = 0; line < kWindowSide; ++line, first += stride) {
        hwy::Prefetch(first);
        hwy::Prefetch(first + kWindowSide - 1);  // often in another cache line
    }
}

template <class ColourTarget>
HWY_INLINE void fetchColours(const ColourTarget& colours, std::uint32_t corner)
{
    const int y = static_cast<int>(corner >> 16);
    for (int line = y; line < y + kWindowSide; ++line) hwy::Prefetch(colours.line(line) + (corner & 0xFFFF));
}

/// Works the list off and empties it. `kNormal` as in DepthTest.
template <Keep kKeep, bool kNormal, class Rules, class FragmentsOf>
void testAllWindows(const TriangleList& triangles, WindowList& list, VisibilityBuffer& visible, const Rules& rules,
                    const FragmentsOf& fragmentsOf)
{
    list.knowCentres(static_cast<std::size_t>(std::max(visible.width(), visible.height())));
    const WindowTarget to{visible.row(0), visible.stride(), list.centres.data(), visible.empty(), visible.width()};
    using Fragments         = decltype(fragmentsOf(1u));
    constexpr bool    kFree = Fragments::kFree;
    const FragmentsOf own   = fragmentsOf;
    std::size_t       count = 0;
    for (std::size_t k = 0; k < list.inUse; ++k) {
        WindowChunk&      chunk   = list.chunks[k];
        const std::size_t windows = chunk.count;
        if (windows == 0) continue;
        std::fill_n(chunk.corners.begin() + static_cast<std::ptrdiff_t>(windows), WindowChunk::kAhead,
                    chunk.corners[windows - 1]);
        for (std::size_t i = 0; i < windows; ++i) {
            const std::uint32_t next = chunk.corners[i + WindowChunk::kAhead];
            fetch(to.at(next), to.stride);
            if constexpr (kFree) fetchColours(own, next);
            count += testWindow<kKeep, kNormal>(triangles, chunk.owners[i], chunk.corners[i], to, rules, own);
        }
    }
    if constexpr (kFree) own.count(count);
    list.clear();
}

/// fragmentsOf(rank): what becomes of the fragments of a triangle besides their test (core/fast/lanes/fragments.h).
template <Keep kKeep, class Rules, class FragmentsOf>
void testWindows(const TriangleList& triangles, WindowList& list, VisibilityBuffer& visible, const Rules& rules,
                 const FragmentsOf& fragmentsOf)
{
    constexpr bool kShades = decltype(fragmentsOf(1u))::kMoment != ShadingMoment::Never;
    if constexpr (Rules::kExactDepths && !kShades)
        if (areNormal(visible.empty()))
            return testAllWindows<kKeep, true>(triangles, list, visible, rules, fragmentsOf);
    testAllWindows<kKeep, false>(triangles, list, visible, rules, fragmentsOf);
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_WINDOWS_INL_H
