// A ball of nearly equal triangles: every face of an icosahedron cut into frequency x frequency triangles, their
// corners moved out to the sphere.
//
// Size       20 x frequency^2 triangles, 10 x frequency^2 + 2 vertices; frequency 16 is what four halvings of all edges
//            give: 5,120 triangles
// Shape      radius 1 about the origin; with bumps, three waves raise and sink the surface by up to that part of the
//            radius
// Promise    every triangle turned outwards; closed unless `leftOut` triangles around (0, -1, 0) are left out
#pragma once

#include <cstdint>
#include <memory>

#include "core/scene/mesh.h"

namespace zscope {

struct IcosphereShape {
    std::uint32_t frequency = 16;  // at least 1
    double        bumps     = 0;   // below 1
    std::uint32_t leftOut   = 0;   // less than frequency^2
};
std::shared_ptr<const Mesh> makeIcosphere(const IcosphereShape& shape);

}  // namespace zscope
