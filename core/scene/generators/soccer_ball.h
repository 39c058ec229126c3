// The ball of the soccer scenes: a truncated icosahedron drawn out to the sphere, seams sunk a little.
//
// Size       radius 1 about the origin; 12 black pentagons and 20 white hexagons cut into rings of quads and triangles
//            around a middle pentagon or hexagon: 3,536 triangles
// Promise    closed, every face turned outwards
#pragma once

#include <memory>

#include "core/scene/mesh.h"

namespace zscope {

std::shared_ptr<const Mesh> makeSoccerBall();

}  // namespace zscope
