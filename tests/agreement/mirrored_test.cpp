// Mirrored instances: a matrix of negative determinant turns fronts and normals with the surface, and nothing else.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/measure/reference.h"
#include "core/measure/reference_colours.h"
#include "core/scene/generators/random.h"
#include "core/scene/load.h"
#include "tests/agreement/agreement_support.h"
#include "tests/agreement/soups.h"

namespace zscope::tests {
namespace {

constexpr std::array kBothCullings{FaceCulling::None, FaceCulling::Back};

Affine flipped(int axis)
{
    Affine flip;
    flip.rows[static_cast<std::size_t>(axis)][static_cast<std::size_t>(axis)] = -1;
    return flip;
}

Mesh meshOf(const std::string& word) { return *loadScene(word).value().meshes.front(); }

TEST(Mirrored, OnlyADeterminantBelowZeroIs)
{
    EXPECT_FALSE(Affine{}.isMirrored());
    EXPECT_FALSE(Affine::translation({-1, -2, -3}).isMirrored());
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_TRUE(flipped(axis).isMirrored()) << axis;
        EXPECT_FALSE(compose(flipped(axis), flipped((axis + 1) % 3)).isMirrored()) << "turned half round";
        Affine flat;
        flat.rows[static_cast<std::size_t>(axis)] = {0, 0, 0, 1};
        EXPECT_FALSE(flat.isMirrored());
    }
    Affine swapped;  // x and y
    swapped.rows[0] = {0, 1, 0, 0}, swapped.rows[1] = {1, 0, 0, 0};
    EXPECT_TRUE(swapped.isMirrored());
    Affine huge     = flipped(0);
    huge.rows[1][1] = huge.rows[2][2] = 1e200;  // the product of two runs over, and the sum is NaN or -infinity
    huge.rows[1][2] = huge.rows[2][1] = 1e200;
    EXPECT_FALSE(huge.isMirrored()) << "infinity less infinity is NaN, and NaN is not below 0";
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Affine turn = random.rotation();
        ASSERT_FALSE(turn.isMirrored());
        ASSERT_TRUE(compose(turn, flipped(i % 3)).isMirrored());
    }
}

TEST(Mirrored, AHundredPlacementsAreWhatTheReferenceDraws)
{
    Random              random(77);
    std::vector<Affine> places;
    for (int i = 0; i < 100; ++i) {
        Affine       place = random.rotation();
        const double size  = random.between(0.1, 0.6);
        for (std::size_t r = 0; r < 3; ++r) {
            for (std::size_t c = 0; c < 3; ++c) place.rows[r][c] *= (i % 3 == 0 && c == 1 ? -size : size);
            place.rows[r][3] = random.between(-4, 4);
        }
        places.push_back(place);
    }
    for (const char* word : {"builtin:teapot?tessellation=3", "builtin:glass", "builtin:cutouts"}) {
        const auto   scene  = sceneOf(meshOf(word), places);
        const auto   ready  = std::make_shared<const PreparedScene>(scene);
        const Camera camera = cameraFor(*scene, 160, 90);
        for (const FaceCulling culling : kBothCullings)
            EXPECT_GT(expectAgreement(ready, camera, culling, word, {.threads = {1, 2}}), 500u) << word;
    }
}

/// A closed model on the left and its mirror image on the right of x = 0, with light and eye in that plane: what stands
/// at (x, y) has its like at (width - 1 - x, y). Where an edge runs through a pixel's centre the fill rule knows left
/// from right, so single pixels may differ.
TEST(Mirrored, AClosedModelLooksLikeItsTwin)
{
    const Affine left = compose(Affine::translation({-3, 0, 0}), Affine{});
    Scene        parts;
    parts.meshes.push_back(std::make_shared<const Mesh>(meshOf("builtin:soccer-ball")));
    parts.instances = {{.mesh = MeshId{0}, .toWorld = left}, {.mesh = MeshId{0}, .toWorld = compose(flipped(0), left)}};
    parts.light.direction = {0, -0.8, -0.6};
    const auto  scene     = std::make_shared<const Scene>(assemble(std::move(parts)).value());
    ViewRequest request;
    request.eye = dvec3{0, 1.5, 8}, request.target = dvec3{0, 0, 0};
    request.width = 320, request.height = 160;
    const Camera camera = makeCamera(request, scene->bounds).value();
    for (const FaceCulling culling : kBothCullings) {
        const auto picture = referencePicture(*scene, camera, culling);
        const auto colours = referenceColours(*scene, camera, culling, *picture);
        int        covered = 0, unlike = 0;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width / 2; ++x) {
                covered += picture->ids.at(x, y) >= 0;
                unlike += colours->at(x, y) != colours->at(camera.width - 1 - x, y);
            }
        EXPECT_GT(covered, 1000);
        EXPECT_LT(unlike, 10);
        const auto both = std::make_shared<const PreparedScene>(scene);
        EXPECT_GT(expectAgreement(both, camera, culling, "twins", {.threads = {1, 2}}), 2000u);
    }
    // What is culled of a closed model was hidden anyway, but for pixels on its outline.
    const auto whole  = referencePicture(*scene, camera, FaceCulling::None);
    const auto front  = referencePicture(*scene, camera, FaceCulling::Back);
    int        unlike = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) unlike += whole->ids.at(x, y) != front->ids.at(x, y);
    EXPECT_LT(unlike, 10);
}

}  // namespace
}  // namespace zscope::tests
