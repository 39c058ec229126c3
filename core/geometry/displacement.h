// How far a pipeline's own arithmetic may move a vertex from where exact arithmetic has it. Every reach on the screen
// and every plane of a volume grows by it, so that nothing is culled that the pipeline would draw.
//
// Exact      the defaults: float64 vertices, snapped to 1/256 pixel
// Snapping   moves a corner by half a step. `pixels` is a whole step of the coarser grid: twice as much
// float32    moves a vertex in view space by at most 12 roundings (2^-24 each) of the magnitudes that are added up: 6
//            from the model to the world, 2 for the eye, 4 for the axes. `view` is 32 of them. The other 20 also cover
//            the 2 roundings of n / z, because no z is larger than these magnitudes; so a reach's nearest depth holds.
//            From view space to pixels there are 8 more, of positions that matter: those up to two pictures away. What
//            lies farther out stays outside
// Ends       float32 may overflow or underflow where a camera or a scene is very large or very small. Then `view` is
//            infinite: no box is culled
// Depth      needs no member. Depths in float32 are limited to those of the corners, and a format keeps the order of
//            depths: stored values are compared
#pragma once

namespace zscope {

struct Approximation;
struct Camera;
class PreparedScene;

struct Displacement {
    double view      = 1e-13;      // in view space, relative to the magnitudes that are added up (ViewBox::magnitude)
    double pixels    = 1.0 / 256;  // on the screen, pixels
    double instances = 0;          // magnitudes on the way from any mesh to the world, for boxes of placed instances
};

/// Of the vertices of a scene, drawn by an approximation.
Displacement displacementOf(const Approximation& approximation, const Camera& camera, const PreparedScene& scene);

}  // namespace zscope
