// Which fragments a cut-out leaves, several neighbouring pixels of one line side by side.
#if defined(ZSCOPE_CUTOUT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_CUTOUT_INL_H
#undef ZSCOPE_CUTOUT_INL_H
#else
#define ZSCOPE_CUTOUT_INL_H
#endif

#include <hwy/highway.h>

#include "core/geometry/cutout_plane.h"
#include "core/scan/fragments.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// True where the pattern has a hole at the pixels x, x + 1, ... of line y. No comparison is true of NaN: what cannot be
/// told stays.
template <class F64>
hn::Mask<F64> isCutOut(F64 d64, const CutoutPlane& plane, int x, int y)
{
    const auto   right = (hn::Iota(d64, 0.0) + hn::Set(d64, x + 0.5)) - hn::Set(d64, plane.centreX);
    const double up    = plane.centreY - (y + 0.5);
    const auto   along = [&](const dvec3& f) HWY_ATTR {
        return (hn::Set(d64, f.x) * right + hn::Set(d64, f.y * up)) + hn::Set(d64, f.z * plane.focal);
    };
    const auto weight = along(plane.g);
    const auto size   = hn::Set(d64, plane.cutout.size);
    const auto a      = (hn::Set(d64, plane.u0) + along(plane.hu) / weight) / size;
    const auto b      = (hn::Set(d64, plane.v0) + along(plane.hv) / weight) / size;
    const auto half   = hn::Set(d64, 0.5);
    switch (plane.cutout.pattern) {
    case CutoutPattern::Checker: {
        const auto pairs = (hn::Floor(a) + hn::Floor(b)) * half;  // a whole number in every other cell
        return pairs - hn::Floor(pairs) > hn::Set(d64, 0.25);
    }
    case CutoutPattern::Stripes: return a - hn::Floor(a) >= half;
    case CutoutPattern::Holes: break;
    }
    const auto p = (a - hn::Floor(a)) - half, q = (b - hn::Floor(b)) - half;
    return p * p + q * q < hn::Set(d64, 0.09375);
}

/// The fragments of a cut-out triangle: those of `Fragments`, less the holes.
template <class Fragments>
class DiscardingFragments : public Fragments {
public:
    static constexpr bool kDiscards = true;

    DiscardingFragments(const Fragments& fragments, const CutoutPlane& plane) : Fragments(fragments), m_plane(plane) {}

    template <class F64>
    hn::Mask<F64> discarded(F64 d64, int x, int y) const
    {
        return isCutOut(d64, m_plane, x, y);
    }

private:
    CutoutPlane m_plane;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_CUTOUT_INL_H
