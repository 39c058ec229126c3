#include "core/lesson/difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/lesson/colour_maps.h"

namespace zscope {
namespace {

constexpr std::uint32_t kSame = 0xFFFFFFFF, kSameBackground = 0xFFF3F5F8;

/// A depth that differs by one step is seen, one by 2^16 or more in full colour.
double strengthOf(std::uint32_t steps)
{
    return std::min(1.0, 0.25 + 0.75 * std::log2(static_cast<double>(steps)) / 16);
}

}  // namespace

Difference differenceOf(const VisibilityBuffer& a, const VisibilityBuffer& b, std::uint32_t tolerance)
{
    assert(a.width() == b.width() && a.height() == b.height());
    Difference difference;
    difference.kinds.reset(a.width(), a.height(), PixelDifference::None);
    difference.heat.reset(a.width(), a.height(), kSame);
    PixelDifference worstKind  = PixelDifference::None;
    std::uint32_t   worstSteps = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const std::int64_t  idA = a.idAt(x, y), idB = b.idAt(x, y);
            const float         depthA = a.depthAt(x, y), depthB = b.depthAt(x, y);
            const std::uint32_t steps  = stepsBetween(depthA, depthB);
            PixelDifference     kind   = PixelDifference::None;
            std::uint32_t       colour = idA < 0 ? kSameBackground : kSame;
            if (idA >= 0 && idB < 0)
                kind = PixelDifference::Hole;
            else if (idA < 0 && idB >= 0)
                kind = PixelDifference::Spill;
            else if (idA != idB)
                kind = PixelDifference::Surface;
            else if (idA >= 0) {
                difference.mostSteps = std::max(difference.mostSteps, steps);
                if (steps > tolerance)
                    kind = depthB > depthA ? PixelDifference::DepthNearer : PixelDifference::DepthFarther;
            }
            if (kind >= PixelDifference::Surface)
                colour = kWrongColour;
            else if (kind != PixelDifference::None)
                colour = diverging(kind == PixelDifference::DepthNearer ? strengthOf(steps) : -strengthOf(steps));
            difference.kinds.at(x, y) = kind;
            difference.heat.at(x, y)  = colour;
            ++difference.counts[static_cast<std::size_t>(kind)];
            if (kind == PixelDifference::None || kind < worstKind || (kind == worstKind && steps <= worstSteps))
                continue;
            worstKind        = kind;
            worstSteps       = steps;
            difference.worst = {x, y};
        }
    }
    return difference;
}

}  // namespace zscope
