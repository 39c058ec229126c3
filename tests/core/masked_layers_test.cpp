// Two depths and a mask against the depths of every pixel: the reference is never nearer than the farthest of them.
#include "core/depth/masked_layers.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "core/scene/generators/random.h"

namespace zscope {
namespace {

constexpr float         kNothing = 0.001f;
constexpr std::uint64_t kAll     = ~std::uint64_t{0};

TEST(MaskedLayers, NeverHoldATileToBeNearerThanItsFarthestPixel)
{
    Random random(7);
    int    risen = 0, forgotten = 0;
    for (int run = 0; run < 200; ++run) {
        // Some tiles lie on the border of the picture and have fewer pixels.
        const std::uint64_t all = run % 3 == 0 ? kAll >> (8 * (run % 8)) : run % 3 == 1 ? 0x0707070707070707u : kAll;
        MaskedLayers        layers;
        layers.reset(2, 1);
        std::array<float, 64> pixels;
        pixels.fill(kNothing);
        float reference = kNothing;
        for (int i = 0; i < 60; ++i) {
            std::uint64_t mask  = 0;
            const auto    first = random.below(64), last = first + random.below(64 - first);
            for (auto bit = first; bit <= last; ++bit) mask |= std::uint64_t{1} << bit;
            if (random.below(6) == 0) mask = kAll;
            mask &= all;
            const auto depth = static_cast<float>(random.between(0.01, 1));
            for (std::size_t bit = 0; bit < 64; ++bit)
                if (mask >> bit & 1) pixels[bit] = std::max(pixels[bit], depth);
            float farthest = 2;
            for (std::size_t bit = 0; bit < 64; ++bit)
                if (all >> bit & 1) farthest = std::min(farthest, pixels[bit]);
            if (const auto raised = layers.cover(1, 0, mask, all, depth, reference)) {
                ASSERT_GT(*raised, reference) << "depths only grow";
                reference = *raised;
                ++risen;
            }
            ASSERT_LE(reference, farthest) << run << ", " << i;
            forgotten += reference < farthest;
        }
    }
    EXPECT_GT(risen, 200);
    EXPECT_GT(forgotten, 200);
}

TEST(MaskedLayers, ATileCoveredInPiecesOfOneSurfaceIsKnownWhenTheLastPieceComes)
{
    MaskedLayers layers;
    layers.reset(1, 1);
    EXPECT_FALSE(layers.cover(0, 0, kAll >> 32, kAll, 0.50f, kNothing));
    EXPECT_FALSE(layers.cover(0, 0, kAll << 48, kAll, 0.48f, kNothing));
    EXPECT_EQ(layers.cover(0, 0, kAll << 32, kAll, 0.49f, kNothing), 0.48f);
}

TEST(MaskedLayers, ASurfaceFarInFrontBeginsANewLayerAndTheOldOneIsForgotten)
{
    MaskedLayers layers;
    layers.reset(1, 1);
    EXPECT_FALSE(layers.cover(0, 0, kAll >> 32, kAll, 0.1f, kNothing));
    EXPECT_FALSE(layers.cover(0, 0, kAll << 48, kAll, 0.9f, kNothing)) << "nearer to the eye than to the layer";
    EXPECT_FALSE(layers.cover(0, 0, (kAll << 32) >> 16, kAll, 0.9f, kNothing));
    EXPECT_FALSE(layers.cover(0, 0, 1, kAll, kNothing, kNothing)) << "what the whole tile is nearer than adds nothing";
    EXPECT_EQ(layers.cover(0, 0, kAll, kAll, 0.8f, kNothing), 0.8f);
}

}  // namespace
}  // namespace zscope
