#include "core/depth/pixel_key.h"

#include <array>
#include <limits>

#include <gtest/gtest.h>

namespace zscope {
namespace {

constexpr float                        kLeast = std::numeric_limits<float>::denorm_min();
constexpr std::array                   kDepths{-1.0f, -0.5f, -kLeast, 0.0f, kLeast, 0.25f, 0.5f, 1.0f};  // ascending
constexpr std::array<std::uint32_t, 4> kRanks{0, 1, 2, 0xFFFFFFFF};

TEST(PixelKey, ALargerDepthWinsWhateverTheRanks)
{
    for (std::size_t near = 1; near < kDepths.size(); ++near)
        for (std::size_t far = 0; far < near; ++far)
            for (const std::uint32_t a : kRanks)
                for (const std::uint32_t b : kRanks)
                    EXPECT_GT(keyOf(kDepths[near], a), keyOf(kDepths[far], b)) << kDepths[near] << " " << kDepths[far];
}

TEST(PixelKey, OnEqualDepthTheLowerRankWins)
{
    for (const float depth : kDepths)
        for (std::size_t low = 0; low < kRanks.size(); ++low)
            for (std::size_t high = low + 1; high < kRanks.size(); ++high)
                EXPECT_GT(keyOf(depth, kRanks[low]), keyOf(depth, kRanks[high]));
}

TEST(PixelKey, GivesBackWhatItWasMadeOf)
{
    for (const float depth : kDepths)
        for (const std::uint32_t rank : kRanks) {
            EXPECT_EQ(std::bit_cast<std::uint32_t>(depthOf(keyOf(depth, rank))), std::bit_cast<std::uint32_t>(depth));
            EXPECT_EQ(rankOf(keyOf(depth, rank)), rank);
        }
    EXPECT_EQ(std::bit_cast<std::uint32_t>(depthOf(keyOf(-0.0f, 3))), 0x80000000u);
}

}  // namespace
}  // namespace zscope
