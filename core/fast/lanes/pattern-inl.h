// Which fragments a cut-out leaves and how far back a relief moves them, several neighbouring pixels of one line side
// by side.
#if defined(ZSCOPE_PATTERN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ZSCOPE_PATTERN_INL_H
#undef ZSCOPE_PATTERN_INL_H
#else
#define ZSCOPE_PATTERN_INL_H
#endif

#include <hwy/highway.h>

#include "core/fast/lanes/fragments.h"
#include "core/geometry/pattern_plane.h"

HWY_BEFORE_NAMESPACE();
namespace zscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Coordinates on the surface, in cells of the pattern.
template <class F64>
struct InCells {
    hn::Vec<F64> a, b;
};

/// Of the pixels x, x + 1, ... of line y.
template <class F64>
InCells<F64> inCells(F64 d64, const PatternPlane& plane, double cell, int x, int y)
{
    const auto   right = (hn::Iota(d64, 0.0) + hn::Set(d64, x + 0.5)) - hn::Set(d64, plane.centreX);
    const double up    = plane.centreY - (y + 0.5);
    const auto   along = [&](const dvec3& f) HWY_ATTR {
        return (hn::Set(d64, f.x) * right + hn::Set(d64, f.y * up)) + hn::Set(d64, f.z * plane.focal);
    };
    const auto weight = along(plane.g);
    const auto size   = hn::Set(d64, cell);
    return {(hn::Set(d64, plane.u0) + along(plane.hu) / weight) / size,
            (hn::Set(d64, plane.v0) + along(plane.hv) / weight) / size};
}

/// True where there is a hole. No comparison is true of NaN: what cannot be told stays.
template <class F64>
hn::Mask<F64> isHole(F64 d64, CutoutPattern pattern, const InCells<F64>& at)
{
    const auto& [a, b] = at;
    const auto half    = hn::Set(d64, 0.5);
    switch (pattern) {
        case CutoutPattern::Checker: {
            const auto pairs = (hn::Floor(a) + hn::Floor(b)) * half;  // a whole number in every other cell
            return pairs - hn::Floor(pairs) > hn::Set(d64, 0.25);
        }
        case CutoutPattern::Stripes:
            return a - hn::Floor(a) >= half;
        case CutoutPattern::Holes:
            break;
    }
    const auto p = (a - hn::Floor(a)) - half, q = (b - hn::Floor(b)) - half;
    return p * p + q * q < hn::Set(d64, 0.09375);
}

/// How deep the relief is, from 0, on the face, to 1. No comparison is true of NaN: what cannot be told lies on the
/// face.
template <class F64>
hn::Vec<F64> depthOfRelief(F64 d64, ReliefPattern pattern, const InCells<F64>& at)
{
    const auto& [a, b] = at;
    const auto half = hn::Set(d64, 0.5), one = hn::Set(d64, 1.0);
    switch (pattern) {
        case ReliefPattern::Bricks: {
            const auto courses = b + b;
            const auto course  = hn::Floor(courses);
            const auto pairs   = course * half;
            const auto along   = a + (pairs - hn::Floor(pairs));  // every other course is half a brick farther
            const auto joint =
                hn::Or(along - hn::Floor(along) < hn::Set(d64, 0.0625), courses - course < hn::Set(d64, 0.125));
            return hn::IfThenElseZero(joint, one);
        }
        case ReliefPattern::Louvres: {
            const auto across = b - hn::Floor(b);
            return hn::IfThenElseZero(across > hn::Zero(d64), across);
        }
        case ReliefPattern::Bowls:
            break;
    }
    const auto p = (a - hn::Floor(a)) - half, q = (b - hn::Floor(b)) - half;
    const auto r = p * p + q * q;
    return hn::IfThenElseZero(r < hn::Set(d64, 0.25), one - r * hn::Set(d64, 4.0));
}

/// The fragments of a triangle whose material has a cut-out, a relief or both.
template <class Fragments>
class PatternedFragments : public Fragments {
public:
    static constexpr bool kPatterned = true;

    PatternedFragments(const Fragments& fragments, const PatternPlane& plane) : Fragments(fragments), m_plane(plane) {}

    /// True where a fragment does not exist.
    template <class F64>
    hn::Mask<F64> discarded(F64 d64, int x, int y) const
    {
        if (!m_plane.cutout) return hn::Zero(d64) < hn::Zero(d64);
        return isHole(d64, m_plane.cutout->pattern, inCells(d64, m_plane, m_plane.cutout->size, x, y));
    }

    bool moves() const { return m_plane.relief.has_value(); }

    /// Depths of the face, moved away from the eye; only if moves(). Never nearer than `depth`: the divisor is at least
    /// 1.
    template <class F64>
    hn::Vec<F64> moved(F64 d64, hn::Vec<F64> depth, int x, int y) const
    {
        const auto deep =
            depthOfRelief(d64, m_plane.relief->pattern, inCells(d64, m_plane, m_plane.relief->size, x, y));
        return depth / (hn::Set(d64, 1.0) + depth * (hn::Set(d64, m_plane.reliefDepth) * deep));
    }

private:
    PatternPlane m_plane;
};

}  // namespace zscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // ZSCOPE_PATTERN_INL_H
