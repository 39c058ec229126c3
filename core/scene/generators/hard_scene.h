// What the hard cases are built with: scenes whose corners land where a case wants them, on a point of the 1/256
// pixel grid, halfway between two, or far outside the picture.
//
// Camera     eye at the origin, looking along -z; at z = 1 one unit of the world is one pixel of the picture
// Exact      a corner given in pixels is seen exactly there while its depth, near and the picture's height are
//            powers of two; otherwise within 1e-12 pixels
// Source     docs/correctness.md, Hard cases
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/scene/generators/registry.h"

namespace zscope::hard {

inline constexpr double kNear     = 0.25;  // of every hard scene that does not say otherwise
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kGridUnit = 1.0 / 256;  // pixels

/// The camera described above.
Camera pixelCamera(int width, int height, double near = kNear, double far = kInfinity);

/// A point in pixels, y down.
struct Place {
    double x = 0, y = 0;
};

using Vertex = std::uint32_t;

class HardScene {
public:
    HardScene(int width, int height, double near = kNear, double far = kInfinity)
        : HardScene(pixelCamera(width, height, near, far))
    {}
    explicit HardScene(const Camera& camera);

    Camera camera;  // what the default view will be

    /// A vertex seen at `place` with depth near/z = `depth`; only for the camera of pixelCamera().
    Vertex at(const Place& place, double depth = kNear);
    /// A vertex in view space of pixelCamera(): x right, y up, z in front.
    Vertex inView(const dvec3& position) { return inWorld({position.x, position.y, -position.z}); }
    Vertex inWorld(const dvec3& position);

    /// One face of any number of corners. False: it was mended (core/scene/mesh.h), and the scene holds a warning of
    /// it.
    bool polygon(std::span<const Vertex> outline);
    bool polygon(std::span<const Place> outline, double depth = kNear);
    void triangle(Vertex a, Vertex b, Vertex c);
    void triangle(const Place& a, const Place& b, const Place& c, double depth = kNear);
    /// The triangles a b c and a c d.
    void quad(Vertex a, Vertex b, Vertex c, Vertex d);
    void quad(const std::array<Place, 4>& corners, double depth = kNear);
    /// Two triangles, counter-clockwise to the viewer.
    void rectangle(const Place& topLeft, const Place& bottomRight, double depth = kNear);

    /// The scene, seen through `camera`.
    Scene finish();
    /// The scene with a view of its own.
    Scene finish(const ViewRequest& view);

private:
    std::shared_ptr<Mesh> m_mesh;
    std::vector<Warning>  m_warnings;
};

}  // namespace zscope::hard
