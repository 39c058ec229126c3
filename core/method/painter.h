// The painter's algorithm: triangles are sorted by depth and painted over each other, farthest first, as a painter
// paints the mountains before the house before the tree. No depth is compared at a pixel.
//
// Order      by the depth of the farthest corner; of equal ones by that of the nearest corner; of equal ones the higher
//            id first, so that the lower one lies on top
// Wrong      one number for a triangle cannot order them all. A long triangle may reach past a small one in front of
//            it; two that pierce each other need both orders at once; three that overlap in a circle have no order.
//            So the picture is approximate, and its wrong pixels are counted like those of any other
// Cost       sorting, and every pixel of every triangle, hidden or not
// Memory     all triangles in view, set up at once; more than allowed is std::bad_alloc
// Source     Newell, Newell, Sancha: A Solution to the Hidden Surface Problem, ACM National Conference 1972, whose
//            first step this is: their tests then cut triangles until an order exists
#pragma once

#include "core/plain/parts.h"

namespace zscope::plain {

void paint(Work& work, const Parts& parts);

/// A triangle lies over all that were painted before it.
struct TrianglePainted {
    static constexpr Grain grain = Grain::Triangle;
    TriangleId             triangle;
    std::size_t            place, count;  // in the order, from 1; of so many
    float                  farthest;      // depth by which it was sorted

    About       about() const { return {.triangle = triangle}; }
    std::string sentence(const Telling& telling) const;
};

}  // namespace zscope::plain
