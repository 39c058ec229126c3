// Surfaces whose triangles have their sides in common, as meshes do and as no mesh should: three and more at a side,
// folded, the same triangle both ways, mirrored placements. Whichever sides are one edge of a sweep, all presets give
// the reference's picture.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/generators/random.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

enum class Surface {
    Sheet,     // a height field
    Crumpled,  // the same with its points pulled over each other: fronts and backs side by side
    Heap,      // any triangles of few points
};

Mesh surface(Surface kind, Random& random, const Camera& camera, int side)
{
    Mesh       mesh;
    const auto at = [side](int i, int j) { return static_cast<std::uint32_t>(i * (side + 1) + j); };
    for (int i = 0; i <= side; ++i)
        for (int j = 0; j <= side; ++j) {
            const double pull = kind == Surface::Sheet ? 0.3 : 1.5;
            double       x    = (j + random.between(-pull, pull)) * camera.width / side,
                   y          = (i + random.between(-pull, pull)) * camera.height / side;
            // on a pixel centre
            if (random.below(3) == 0) x = static_cast<int>(x) + 0.5, y = static_cast<int>(y) + 0.5;
            mesh.positions.push_back(pointAt(camera, x, y, random.between(1.5, 4)));
        }
    const auto few = [&] { return static_cast<std::uint32_t>(random.below(25) * (mesh.positions.size() - 1) / 24); };
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            if (kind == Surface::Heap) {
                std::array<std::uint32_t, 3> outline;
                for (auto& corner : outline) corner = few();
                addFan(mesh, outline);
                continue;
            }
            const bool turns = random.below(20) == 0;  // the other way round than its neighbours
            addFan(mesh, turns ? std::array{at(i, j), at(i + 1, j), at(i, j + 1)}
                               : std::array{at(i, j), at(i, j + 1), at(i + 1, j)});
            addFan(mesh, std::array{at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    return mesh;
}

class SharedSidesOf : public testing::TestWithParam<Surface> {};

TEST_P(SharedSidesOf, EveryPresetDrawsWhatTheReferenceDraws)
{
    Random        random(71 + static_cast<std::uint64_t>(GetParam()));
    std::uint64_t covered = 0;
    for (const auto& [width, height] : {std::pair{128, 128}, {61, 256}}) {
        const Camera camera = plainCamera(width, height);
        for (std::uint64_t i = 0; i < shareOf(8); ++i) {
            std::vector<Affine> places(1);
            if (i % 4 == 3) {
                places.emplace_back();
                places.back().rows[0][0] = -1;  // mirrored, and a little behind
                places.back().rows[2][3] = 0.25;
            }
            const auto scene =
                std::make_shared<const PreparedScene>(sceneOf(surface(GetParam(), random, camera,
                                                                      i % 2 == 0                    ? 9
                                                                      : GetParam() == Surface::Heap ? 15
                                                                                                    : 40),
                                                              places));
            for (const FaceCulling culling : {FaceCulling::None, FaceCulling::Back})
                covered +=
                    expectAgreement(scene, camera, culling,
                                    std::to_string(i) + " in " + std::to_string(width) + " x " + std::to_string(height),
                                    {.threads = {1, 2}});
        }
    }
    EXPECT_GT(covered, shareOf(8) * 10'000);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, SharedSidesOf, testing::Values(Surface::Sheet, Surface::Crumpled, Surface::Heap));

}  // namespace
}  // namespace zscope::tests
