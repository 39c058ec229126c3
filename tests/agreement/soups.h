// Seeded scenes that are meant to be nasty, and the few helpers every geometric test needs: points that project to
// a wanted pixel, scenes from bare triangles.
//
// Promise    the same kind, seed and size give the same scene to the bit on every machine: plain arithmetic on
//            std::mt19937_64, no distribution of the standard library
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"
#include "core/scene/view.h"

namespace zscope::tests {

using Corners = std::array<dvec3, 3>;

/// Looks along +z from the origin with near = 1, far = inf and pixels of 2 / height at z = 1. With a height that is
/// a power of two, pointAt() is exact for coordinates and distances of few bits.
Camera plainCamera(int width, int height);

/// The world point that the camera sees at (x, y) pixels, at distance z along forward.
dvec3 pointAt(const Camera& camera, double x, double y, double z);

/// One polygon per triangle, no vertex shared, one instance that is the identity.
std::shared_ptr<const Scene> sceneOf(std::span<const Corners> triangles);
/// One mesh, placed by each matrix.
std::shared_ptr<const Scene> sceneOf(Mesh mesh, std::span<const Affine> places);
/// Appends a polygon split as a fan from its first corner.
void addFan(Mesh& mesh, std::span<const std::uint32_t> outline);

enum class SoupKind {
    Loose,           // triangles anywhere in front of the eye
    Grid,            // one height field, vertices shared
    Fan,             // many triangles about one vertex
    Coplanar,        // overlapping triangles of one plane
    NonPlanarQuads,  // quads whose corners do not lie in a plane
    EyeInside,       // a closed box and a ball about the eye
    FarFromOrigin,   // everything 1e6 away from the origin, eye too
    TinyScale,       // everything in units of 1e-6
    Huge,            // triangles 3,000 times the view
    Slivers,         // long and thinner than a pixel, down to nothing
    NearCrossing,    // corners in front of, on, behind the near plane and behind the eye
    OnTheGrid,       // corners on pixel centres, pixel corners and snapping midpoints
    Dust,            // triangles smaller than a pixel
    Turned,          // instances with rotation, scale and reflection
    Repeated,        // the same triangles again and again, in both senses of turning
    BeyondTheGuard,  // corners 2^20 to 2^58 pixels away, and out of range
    BeyondFar,       // depths about the far plane, some exactly on it
};
std::span<const SoupKind> soupKinds();
std::string_view          nameOf(SoupKind kind);

struct Soup {
    std::shared_ptr<const Scene> scene;
    Camera                       camera;
    std::string                  what;  // kind, seed and size, for failure messages
};

/// `triangles` is how many to aim at; kinds with a structure may come a little above or below.
Soup makeSoup(SoupKind kind, std::uint64_t seed, int width, int height, int triangles = 60);

}  // namespace zscope::tests
