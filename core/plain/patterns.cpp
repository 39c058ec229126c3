#include "core/plain/patterns.h"

#include <cmath>

namespace zscope::plain {

namespace {

/// Coordinates on the surface, in cells of the pattern.
struct InCells {
    double a, b;
};

InCells inCells(const PatternPlane& plane, double cell, int x, int y)
{
    const double right = (x + 0.5) - plane.centreX, up = plane.centreY - (y + 0.5);
    const auto   along  = [&](const dvec3& f) { return (f.x * right + f.y * up) + f.z * plane.focal; };
    const double weight = along(plane.g);
    return {(plane.u0 + along(plane.hu) / weight) / cell, (plane.v0 + along(plane.hv) / weight) / cell};
}

double fraction(double value) { return value - std::floor(value); }

/// 0 on the face, 1 at the deepest.
double depthOfRelief(ReliefPattern pattern, const InCells& at)
{
    const auto& [a, b] = at;
    switch (pattern) {
        case ReliefPattern::Bricks: {
            const double courses = b + b, course = std::floor(courses);
            const double along = a + fraction(course * 0.5);  // every other course is half a brick farther
            return fraction(along) < 0.0625 || courses - course < 0.125 ? 1 : 0;
        }
        case ReliefPattern::Louvres: {
            const double across = fraction(b);
            return across > 0 ? across : 0;
        }
        case ReliefPattern::Bowls:
            break;
    }
    const double p = fraction(a) - 0.5, q = fraction(b) - 0.5, r = p * p + q * q;
    return r < 0.25 ? 1 - r * 4 : 0;
}

}  // namespace

bool isHole(const PatternPlane& plane, int x, int y)
{
    if (!plane.cutout) return false;
    const auto [a, b] = inCells(plane, plane.cutout->size, x, y);
    switch (plane.cutout->pattern) {
        case CutoutPattern::Checker:
            return fraction((std::floor(a) + std::floor(b)) * 0.5) > 0.25;  // a half in every other cell
        case CutoutPattern::Stripes:
            return fraction(a) >= 0.5;
        case CutoutPattern::Holes:
            break;
    }
    const double p = fraction(a) - 0.5, q = fraction(b) - 0.5;
    return p * p + q * q < 0.09375;
}

double movedDepth(const PatternPlane& plane, double depth, int x, int y)
{
    const double deep = depthOfRelief(plane.relief->pattern, inCells(plane, plane.relief->size, x, y));
    return depth / (1 + depth * (plane.reliefDepth * deep));
}

}  // namespace zscope::plain
