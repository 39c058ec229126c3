// Tiles that are kept as planes: scenes of triangles that cover many tiles whole, in front of, behind, through and
// exactly on each other, give the reference's picture; and a picture that is asked for by its colours still knows whose
// each pixel is.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/scene/generators/random.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

enum class Lie {
    Apart,     // parallel to the picture at a few depths, many at the same
    Slanted,   // one behind another
    Crossing,  // each through the others
    Mixed,     // all of those, with small ones among them
};

/// Each triangle an instance of its own: some methods come to them in another order than others.
std::shared_ptr<const Scene> layers(Lie lie, Random& random, const Camera& camera, int count)
{
    Scene parts;
    for (int i = 0; i < count; ++i) {
        const Lie    mine  = lie == Lie::Mixed ? static_cast<Lie>(random.below(3)) : lie;
        const bool   small = lie == Lie::Mixed && random.below(4) == 0;
        const double width = camera.width, height = camera.height, reach = small ? 0.05 : 1.5;
        const double x = random.between(0, width), y = random.between(0, height),
                     z    = 2 + static_cast<double>(random.below(4));
        const double turn = random.between(0, 6.3);
        Mesh         mesh;
        for (int k = 0; k < 3; ++k) {
            const double angle = turn + 2.1 * k, depth = mine == Lie::Apart     ? z
                                                         : mine == Lie::Slanted ? z + 0.9 * random.unit()
                                                                                : random.between(1.2, 6);
            mesh.positions.push_back(
                pointAt(camera, x + reach * width * std::cos(angle), y + reach * width * std::sin(angle), depth));
        }
        addFan(mesh, std::vector<std::uint32_t>{0, 1, 2});
        parts.meshes.push_back(std::make_shared<const Mesh>(std::move(mesh)));
        parts.instances.push_back({.mesh = MeshId{static_cast<std::uint32_t>(i)}, .toWorld = Affine{}});
    }
    auto scene = assemble(std::move(parts));
    EXPECT_TRUE(scene.ok());
    return std::make_shared<const Scene>(*std::move(scene));
}

class TilePlanes : public testing::TestWithParam<Lie> {};

TEST_P(TilePlanes, EveryPresetDrawsWhatTheReferenceDraws)
{
    Random        random(17 + static_cast<std::uint64_t>(GetParam()));
    std::uint64_t covered = 0;
    for (const auto& [width, height] : {std::pair{64, 8}, {65, 9}, {257, 193}, {320, 64}}) {
        Camera camera = plainCamera(width, height);
        for (std::uint64_t i = 0; i < shareOf(10); ++i) {
            // some triangles cross it, some lie on it, some beyond
            camera.far       = std::array{kInfinity, 3.4, 4.0}[i % 3];
            const int  count = i % 3 == 0 ? 12 : 2;  // of many one is before it everywhere
            const auto scene = std::make_shared<const PreparedScene>(layers(GetParam(), random, camera, count));
            const auto what =
                "scene " + std::to_string(i) + " in " + std::to_string(width) + " x " + std::to_string(height);
            covered += expectAgreement(scene, camera, FaceCulling::None, what, {.threads = {1, 2}});
        }
    }
    EXPECT_GT(covered, shareOf(10) * 15'000);
}

/// Shaded fragment by fragment no tile is a plane.
TEST_P(TilePlanes, APictureOfColoursAnswersForItsPixelsAndIsTheSameFrameAfterFrame)
{
    Random random(71 + static_cast<std::uint64_t>(GetParam()));
    for (const auto& [width, height] : {std::pair{64, 8}, {257, 193}}) {
        DrawRequest request;
        request.camera = plainCamera(width, height);
        for (const Preset& preset : exactPresets()) {
            Renderer renderer;
            Frame    frame;
            for (std::uint64_t i = 0; i < shareOf(10); ++i) {
                request.scene   = std::make_shared<const PreparedScene>(layers(GetParam(), random, request.camera, 12));
                request.threads = 1 + static_cast<int>(i % 2);
                for (const auto& [shade, cost] : {std::pair{true, ShadingCost::None},
                                                  {true, ShadingCost::None},
                                                  {false, ShadingCost::None},
                                                  {true, ShadingCost::Ten}}) {
                    request.shade         = shade;
                    request.pipeline      = findPreset("zbuffer-early")->pipeline;
                    request.pipeline.cost = cost;
                    Frame expected;
                    ASSERT_TRUE(Renderer().draw(request, expected).ok());
                    request.pipeline      = preset.pipeline;
                    request.pipeline.cost = cost;
                    ASSERT_TRUE(renderer.draw(request, frame).ok());
                    EXPECT_TRUE(pictureOf(frame.visible) == pictureOf(expected.visible))
                        << preset.name << ", shaded " << shade;
                    EXPECT_TRUE(frame.colour == expected.colour)
                        << preset.name << ", shaded " << shade << ", " << operationsOf(cost);
                }
            }
        }
    }
}
INSTANTIATE_TEST_SUITE_P(Lying, TilePlanes, testing::Values(Lie::Apart, Lie::Slanted, Lie::Crossing, Lie::Mixed));

}  // namespace
}  // namespace zscope::tests
