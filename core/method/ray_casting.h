// Ray casting: from the eye through the centre of every pixel goes one ray, and the nearest triangle that it meets is
// seen. A z-buffer asks every triangle for its pixels; a ray asks every pixel for its triangles.
//
// Boxes      a bounding volume hierarchy. A ray that misses a node's box meets nothing below the node. A box is grown
//            by what snapping, and an approximation's numbers, may move a corner
// Order      near nodes first: a box that begins behind what the ray has met is left out, with everything below it
// Exact      a ray meets a triangle where the three half-spaces of its snapped corners hold the pixel's centre; then
//            the depth test decides, as everywhere
// Cost       a pixel asks some boxes for each level of the hierarchy, and no triangle that another node holds
// Memory     the nodes in view and their triangles, set up once for all rays; more than allowed is std::bad_alloc
// Source     Appel: Some Techniques for Shading Machine Renderings of Solids, SJCC 1968; Whitted: An Improved
//            Illumination Model for Shaded Display, CACM 1980; of boxes: Kay, Kajiya: Ray Tracing Complex Scenes,
//            SIGGRAPH 1986
#pragma once

#include "core/cull/cull_events.h"
#include "core/plain/parts.h"

namespace zscope::plain {

/// Casts the rays of every pixel of the stripe.
void castRays(Work& work, const Parts& parts);

/// A node was left out for one ray: nothing in it is as near as what the ray has met. No step of its own.
struct NodeBehindRay {
    NodePlace     place;
    PixelPosition pixel;
    float         nearest;  // no depth in the node is larger
    float         met;      // the depth of what the ray has met

    void mean(Meanings& to) const;
};

/// The ray of one pixel has come to its end.
struct RayCast {
    static constexpr Grain grain = Grain::Query;
    PixelPosition          pixel;
    std::uint32_t          rank;  // of the triangle that it sees, its id + 1; 0: background
    int                    boxes, missed, behind, triangles;

    About       about() const;
    std::string sentence(const Telling& telling) const;
};

}  // namespace zscope::plain
