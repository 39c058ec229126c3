// builtin:soccer-field: one ball at random places of a cube, turned at random; the colour of a ball is its number. The
// ball is a soccer ball, or an icosphere of 5,120 triangles.
//
// Density    one ball in 64 cubic units, whatever the count; balls may overlap
// Memory     one mesh and 116 bytes per ball

#include <cmath>

#include "core/scene/generators/icosphere.h"
#include "core/scene/generators/palette.h"
#include "core/scene/generators/random.h"
#include "core/scene/generators/registry.h"
#include "core/scene/generators/soccer_ball.h"

namespace zscope::generated {

namespace {

/// Newton's method: only operations that IEEE rounds, so the same bits everywhere. x >= 1.
double cubeRoot(double x)
{
    double root = x;
    for (int i = 0; i < 100; ++i) root = (2 * root + x / (root * root)) / 3;
    return root;
}

Result<Scene> make(const Arguments& arguments)
{
    const auto   count = static_cast<std::uint64_t>(arguments.whole("count"));
    const double bytes = static_cast<double>(count) * (sizeof(Instance) + sizeof(std::uint32_t)) + (1 << 20);
    if (bytes > static_cast<double>(arguments.memoryLimit))
        return tooLarge("a field of so many balls", bytes, arguments.memoryLimit);

    Scene scene;
    scene.meshes.push_back(arguments.word("ball") == "soccer" ? makeSoccerBall() : makeIcosphere({}));
    scene.instances.reserve(count);
    const double side = 4 * cubeRoot(static_cast<double>(count));
    const dvec3  half{side / 2, side / 2, side / 2};
    Random       random(static_cast<std::uint64_t>(arguments.whole("seed")));
    for (std::uint64_t n = 0; n < count; ++n) {
        Affine      toWorld = random.rotation();
        const dvec3 at      = random.between(-half, half);
        for (int k = 0; k < 3; ++k) toWorld.rows[static_cast<std::size_t>(k)][3] = at[k];
        scene.instances.push_back({MeshId{0}, toWorld, palette::colourOfNumber(n)});
        if (n % 65536 == 0) {
            arguments.progress.at(static_cast<double>(n) / static_cast<double>(count), "balls");
            if (arguments.progress.cancelled()) return Error{Trouble::Cancelled, "the field was not wanted any more"};
        }
    }

    ViewRequest view;  // from the middle of one side into the cube: a good quarter of the balls is in sight
    view.eye    = dvec3{0, 0.06 * side, half.z};
    view.target = dvec3{0, 0, 0};
    view.near   = 0.1;
    view.far    = 4 * side + 4;
    view.width  = 1024;
    view.height = 768;
    scene.views.push_back({"default", view});
    return scene;
}

}  // namespace

std::vector<Generator> soccer_field()
{
    return {{"soccer-field",
             "One ball in many places, a colour for each",
             {{"count", WholeNumber{1000, 1, 1'200'000}},
              {"seed", WholeNumber{1, 0, 1'000'000'000}},
              {"ball", OneOf{{"soccer", "icosphere"}}}},
             make}};
}

}  // namespace zscope::generated
