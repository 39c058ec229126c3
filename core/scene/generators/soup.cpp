// builtin:soup: random triangles in a cube, made to be awkward: sizes over three orders of magnitude, triangles that
// share corners, triangles nearly in the plane of the one before, and some across the near plane of the default view.
//
// Kinds      of ten triangles: five anywhere; two hang on an edge of an earlier one; two nearly coplanar with an
//            earlier one and overlapping it; one through the near plane
// Promise    the n-th triangle depends only on seed, size and n: a smaller count is the start of a larger one

#include <algorithm>
#include <cmath>

#include "core/scene/generators/palette.h"
#include "core/scene/generators/random.h"
#include "core/scene/generators/registry.h"

namespace zscope::generated {

namespace {

constexpr double kHalf       = 10;  // of the cube about the origin
constexpr double kEyeZ       = 24;
constexpr double kNear       = 1;
constexpr double kNearPlaneZ = kEyeZ - kNear;

dvec3 within(Random& random, const dvec3& middle, double reach)
{
    return middle + random.between(dvec3{-reach, -reach, -reach}, dvec3{reach, reach, reach});
}

/// A size between 1/1000 and 1 of `size`, every order of magnitude equally often.
double mixedSize(Random& random, double size)
{
    double     reach   = size * random.between(0.1, 1.0);
    const auto decades = random.below(3);
    for (std::uint64_t i = 0; i < decades; ++i) reach *= 0.1;
    return reach;
}

Result<Scene> make(const Arguments& arguments)
{
    const std::int64_t count = arguments.whole("count");
    const double       size  = arguments.real("size");
    const double       n     = static_cast<double>(count);
    const double       bytes = meshBytes(3 * n, n, 3 * n, n);
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("so many triangles", bytes, arguments.memoryLimit);

    auto soup       = std::make_shared<Mesh>();
    soup->name      = "soup";
    soup->materials = {};
    for (std::uint64_t i = 0; i < 35; ++i)
        soup->materials.push_back({"colour " + std::to_string(i), palette::colourOf(i), 1});
    const auto vertex = [&soup](const dvec3& p) {
        soup->positions.push_back(p);
        return static_cast<std::uint32_t>(soup->positions.size() - 1);
    };

    Random      random(static_cast<std::uint64_t>(arguments.whole("seed")));
    const dvec3 corner{kHalf, kHalf, kHalf};
    for (std::int64_t i = 0; i < count; ++i) {
        const auto                   kind  = random.below(10);
        const double                 reach = mixedSize(random, size);
        std::array<std::uint32_t, 3> triangle{};
        if (kind < 5 || (kind < 9 && i == 0)) {
            const dvec3 middle = random.between(-corner, corner);
            for (auto& v : triangle) v = vertex(within(random, middle, reach));
        } else if (kind < 7) {
            const auto& other = soup->triangles[random.below(static_cast<std::uint64_t>(i))];
            const auto  side  = random.below(3);
            triangle          = {other[(side + 1) % 3], other[side], 0};  // the shared edge runs the other way
            triangle[2]       = vertex(within(random, soup->positions[triangle[0]], reach));
        } else if (kind < 9) {
            const auto&  other = soup->triangles[random.below(static_cast<std::uint64_t>(i))];
            const dvec3  a = soup->positions[other[0]], b = soup->positions[other[1]], c = soup->positions[other[2]];
            const double lift = kind == 7 ? 0 : reach * 1e-7;  // in its plane up to rounding, or just off it
            for (auto& v : triangle) {
                const double s = random.between(-0.2, 0.9);
                const double t = random.between(-0.2, 0.9);
                v              = vertex(within(random, a + (b - a) * s + (c - a) * t, lift));
            }
        } else {
            const dvec3 middle{random.between(-0.5, 0.5), random.between(-0.4, 0.4), kNearPlaneZ};
            for (auto& v : triangle) v = vertex(within(random, middle, std::min(reach, 0.5)));
            soup->positions[triangle[0]].z = kNearPlaneZ + 0.25;  // this one always before the plane, this one behind
            soup->positions[triangle[1]].z = kNearPlaneZ - 0.25;
        }
        soup->addPolygon(triangle, MaterialId{static_cast<std::uint32_t>(i % 35)});
        if (i % 65536 == 0) {
            arguments.progress.at(static_cast<double>(i) / n, "triangles");
            if (arguments.progress.cancelled()) return Error{Trouble::Cancelled, "the soup was not wanted any more"};
        }
    }

    Scene scene;
    scene.meshes.push_back(soup);
    scene.instances.push_back({MeshId{0}, Affine{}});
    ViewRequest view;
    view.eye    = dvec3{0, 0, kEyeZ};
    view.target = dvec3{0, 0, 0};
    view.near   = kNear;
    view.far    = 200;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> soup()
{
    return {{"soup",
             "Random triangles: large, tiny, joined, nearly coplanar, across the near plane",
             {{"count", WholeNumber{2000, 1, 50'000'000}},
              {"seed", WholeNumber{1, 0, 1'000'000'000}},
              {"size", RealNumber{2, 1e-6, 100}}},
             make}};
}

}  // namespace zscope::generated
