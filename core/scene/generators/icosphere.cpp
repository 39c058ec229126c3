// builtin:icosphere: a ball of any number of nearly equal triangles, smooth or bumpy, closed or with a hole at the
// bottom.

#include "core/scene/generators/icosphere.h"

#include <array>
#include <cmath>

#include "core/scene/generators/circle.h"
#include "core/scene/generators/palette.h"
#include "core/scene/generators/registry.h"
#include "core/scene/generators/welder.h"

namespace zscope {

namespace {

dvec3 withLength(const dvec3& v, double length)
{
    return v * (length / std::sqrt((v.x * v.x + v.y * v.y) + v.z * v.z));
}

/// Corner 0 is the top, 1 to 5 the upper ring, 6 to 10 the lower ring half a corner further round, 11 the bottom.
std::array<dvec3, 12> icosahedron()
{
    // of the rings: 1 and 2 over the root of 5
    constexpr double      kHeight = 0.4472135954999579, kRadius = 0.8944271909999159;
    std::array<dvec3, 12> corners;
    corners.front() = {0, 1, 0};
    corners.back()  = {0, -1, 0};
    for (std::size_t i = 0; i < 5; ++i) {
        const auto upper = pointOnCircle(static_cast<double>(i) / 5);
        const auto lower = pointOnCircle((static_cast<double>(i) + 0.5) / 5);
        corners[1 + i]   = {kRadius * upper[1], kHeight, kRadius * upper[0]};  // counter-clockwise seen from above
        corners[6 + i]   = {kRadius * lower[1], -kHeight, kRadius * lower[0]};
    }
    return corners;
}

/// The faces from bottom to top, turned outwards; the first five begin at the bottom.
std::array<std::array<std::size_t, 3>, 20> faces()
{
    std::array<std::array<std::size_t, 3>, 20> all;
    for (std::size_t i = 0; i < 5; ++i) {
        const std::size_t j = (i + 1) % 5;
        all[i]              = {11, 6 + j, 6 + i};
        all[5 + i]          = {1 + j, 6 + i, 6 + j};
        all[10 + i]         = {6 + i, 1 + j, 1 + i};
        all[15 + i]         = {0, 1 + i, 1 + j};
    }
    return all;
}

/// How far from the middle the surface is in the direction of a unit vector.
double radiusAt(const dvec3& p, double bumps)
{
    const double waves = (pointOnCircle(0.9 * p.x + 0.5 * p.y)[1] + pointOnCircle(1.1 * p.z - 0.7 * p.x + 0.2)[1])
                         + pointOnCircle(1.3 * p.y + 0.4 * p.z + 0.6)[1];
    return 1 + bumps * waves / 3;
}

}  // namespace

std::shared_ptr<const Mesh> makeIcosphere(const IcosphereShape& shape)
{
    auto ball       = std::make_shared<Mesh>();
    ball->name      = "icosphere";
    ball->materials = {{"ball", palette::kSky}};

    Welder              welder(*ball);
    const auto          corners = icosahedron();
    const std::uint32_t n       = shape.frequency;
    std::uint32_t       met     = 0;
    const auto          at      = [&](const std::array<dvec3, 3>& face, std::uint32_t i, std::uint32_t j) {
        // Row i of a face runs from its first side, at i/n of it, to its last; rows widen towards the middle side.
        const dvec3 plane = face[0] * static_cast<double>(n - i)
                            + (face[1] * static_cast<double>(i - j) + face[2] * static_cast<double>(j));
        const dvec3 unit = withLength(plane, 1);
        return welder.vertexAt(shape.bumps == 0 ? unit : unit * radiusAt(unit, shape.bumps));
    };
    using Place    = std::array<std::uint32_t, 2>;
    const auto add = [&](const std::array<dvec3, 3>& face, Place a, Place b, Place c) {
        if (met++ < shape.leftOut) return;
        const std::uint32_t p = at(face, a[0], a[1]), q = at(face, b[0], b[1]), r = at(face, c[0], c[1]);
        ball->addPolygon(std::array{p, q, r});
    };
    for (const auto& [a, b, c] : faces()) {
        const std::array face{corners[a], corners[b], corners[c]};
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j <= i; ++j) {
                if (j > 0) add(face, {i, j - 1}, {i + 1, j}, {i, j});
                add(face, {i, j}, {i + 1, j}, {i + 1, j + 1});
            }
    }
    return ball;
}

namespace generated {

namespace {

Result<Scene> make(const Arguments& arguments)
{
    const auto   frequency = static_cast<std::uint32_t>(arguments.whole("frequency"));
    const auto   leftOut   = static_cast<std::uint32_t>(arguments.whole("left-out"));
    const double faces     = 20.0 * frequency * frequency;
    const double bytes     = meshBytes(faces / 2, faces, 3 * faces, faces) + Welder::kBytesPerVertex * faces / 2;
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("an icosphere of that frequency", bytes, arguments.memoryLimit);
    if (leftOut >= frequency * frequency)
        return Error{Trouble::Usage,
                     "the parameter 'left-out' of builtin:icosphere must be less than the square of 'frequency'"};

    Scene scene;
    scene.meshes.push_back(
        makeIcosphere({.frequency = frequency, .bumps = arguments.real("bumps"), .leftOut = leftOut}));
    scene.instances.push_back({MeshId{0}, Affine{}});
    ViewRequest view;
    view.eye         = dvec3{1.1, 1.3, 4.2};
    view.target      = dvec3{0, 0, 0};
    view.verticalFov = 32;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> icosphere()
{
    return {{"icosphere",
             "A ball of nearly equal triangles",
             {{"frequency", WholeNumber{16, 1, 700}},
              {"bumps", RealNumber{0, 0, 0.5}},
              {"left-out", WholeNumber{0, 0, 489'999}}},
             make}};
}

}  // namespace generated

}  // namespace zscope
