// Corners of several triangles, from the rows of their vertices to columns: as many corners side by side as there are
// lanes of float64.
//
// Promise    moves numbers and computes none: the same bits in every lane count
// Cost       per corner one load of a row and fewer than two shuffles
#if defined(ZSCOPE_CORNER_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_CORNER_ROWS_INL_H
#undef ZSCOPE_CORNER_ROWS_INL_H
#else
#define ZSCOPE_CORNER_ROWS_INL_H
#endif

#include <hwy/highway.h>

#include "core/fast/lanes/lane_loads-inl.h"
#include "core/geometry/screen_vertices.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

struct CornerColumns {
    hn::Vec<hn::ScalableTag<double>> x, y, d;
};

/// Lane i is the vertex whose place stands in the lower or the upper half of pairs[i]; there are as many pairs as
/// lanes, all places below ScreenVertices::kCapacity.
template <bool isUpper>
HWY_INLINE CornerColumns cornersAt(const ScreenVertices& vertices, const std::uint32_t* pairs)
{
    const hn::ScalableTag<double> d64;
    const auto                    row = [&](int i) {
        return vertices.rows.data() + ScreenVertices::kRow * (isUpper ? pairs[i] >> 16 : pairs[i] & 0xFFFF);
    };
#if HWY_TARGET == HWY_AVX3
    // Two rows per vector, four vertices apart, so that x and d of neighbours meet in the blocks of 128 bits where they
    // belong.
    const hn::Half<decltype(d64)> half;
    const auto                    two = [&](int i)
                         HWY_ATTR { return hn::Combine(d64, hn::LoadU(half, row(i + 4)), hn::LoadU(half, row(i))); };
    const auto a = two(0), b = two(1), c = two(2), d = two(3);
    const auto xd01 = hn::InterleaveLower(d64, a, b), xd23 = hn::InterleaveLower(d64, c, d);
    const auto y01 = hn::InterleaveUpper(d64, a, b), y23 = hn::InterleaveUpper(d64, c, d);
    return {hn::OddEvenBlocks(hn::SwapAdjacentBlocks(xd23), xd01), hn::OddEvenBlocks(hn::SwapAdjacentBlocks(y23), y01),
            hn::OddEvenBlocks(xd23, hn::SwapAdjacentBlocks(xd01))};
#elif HWY_TARGET == HWY_AVX2
    const auto a = hn::LoadU(d64, row(0)), b = hn::LoadU(d64, row(1)), c = hn::LoadU(d64, row(2)),
               d    = hn::LoadU(d64, row(3));
    const auto xd01 = hn::InterleaveLower(d64, a, b), xd23 = hn::InterleaveLower(d64, c, d);
    return {hn::ConcatLowerLower(d64, xd23, xd01),
            hn::ConcatLowerLower(d64, hn::InterleaveUpper(d64, c, d), hn::InterleaveUpper(d64, a, b)),
            hn::ConcatUpperUpper(d64, xd23, xd01)};
#else
    static_assert(hn::MaxLanes(d64) == 2);
    const auto a = hn::LoadU(d64, row(0)), b = hn::LoadU(d64, row(1));
    return {hn::InterleaveLower(d64, a, b), hn::InterleaveUpper(d64, a, b),
            hn::InterleaveLower(d64, hn::LoadU(d64, row(0) + 2), hn::LoadU(d64, row(1) + 2))};
#endif
}

/// Lane i is what stands of the snapped position of vertex places[i]: all of its bits, or the lower half of them
/// (ScreenVertices::snappedBits()).
template <class D>
HWY_INLINE hn::Vec<D> snappedAt(D d, const ScreenVertices& vertices, const std::uint16_t* places)
{
    const double* const last = vertices.rows.data() + ScreenVertices::kRow - 1;
    return loadLanes(d, [last, places](std::size_t i) {
        return reinterpret_cast<const hn::TFromD<D>*>(last + ScreenVertices::kRow * std::size_t{places[i]});
    });
}

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_CORNER_ROWS_INL_H
