// Memory in large pages: where blocks begin, and that a vector in them is a vector like any other.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <vector>

#include "core/base/cache_aligned.h"
#include "core/base/large_pages.h"

namespace zscope::tests {
namespace {

struct alignas(64) Line {
    std::uint64_t value;
};
using Pages = LargePages<Line>;

bool beginsOn(std::size_t border, const void* block) { return reinterpret_cast<std::uintptr_t>(block) % border == 0; }

TEST(LargePages, LargeBlocksBeginOnABorderOfThemAndSmallOnesWhereTheirTypeAsks)
{
    for (const std::size_t bytes : {Pages::kLeast, Pages::kLeast + sizeof(Line), 5 * Pages::kPage - sizeof(Line)}) {
        const std::vector<Line, Pages> lines(bytes / sizeof(Line));
        EXPECT_TRUE(beginsOn(Pages::kPage, lines.data())) << bytes;
    }
    for (const std::size_t count : {std::size_t{1}, std::size_t{3}, Pages::kLeast / sizeof(Line) - 1}) {
        const std::vector<Line, Pages> lines(count);
        EXPECT_TRUE(beginsOn(alignof(Line), lines.data())) << count;
    }
}

TEST(CacheAligned, VectorsBeginOnACacheLineAndKeepWhatTheyHold)
{
    AlignedVector<std::uint32_t> numbers(7);
    for (std::size_t size = 7; size < 5000; size *= 3) {
        std::iota(numbers.begin(), numbers.end(), 0u);
        numbers.resize(3 * size);
        EXPECT_TRUE(beginsOn(64, numbers.data())) << size;
        for (std::uint32_t i = 0; i < size; ++i) ASSERT_EQ(numbers[i], i);
    }
}

TEST(LargePages, AVectorKeepsWhatItHoldsAsItGrowsFromSmallToLarge)
{
    std::vector<std::uint32_t, LargePages<std::uint32_t>> numbers(1000);
    std::iota(numbers.begin(), numbers.end(), 0u);
    for (std::size_t size = 1000; size < 3 * Pages::kLeast / sizeof(std::uint32_t); size *= 3) {
        numbers.resize(3 * size);
        std::iota(numbers.begin(), numbers.end(), 0u);
        numbers.shrink_to_fit();
        std::vector<std::uint32_t, LargePages<std::uint32_t>> copy(numbers);
        numbers.push_back(0);
        for (std::size_t i = 0; i < copy.size(); ++i) ASSERT_EQ(copy[i], i) << size;
        for (std::size_t i = 0; i < copy.size(); ++i) ASSERT_EQ(numbers[i], i) << size;
        numbers.pop_back();
    }
}

TEST(LargePages, MoreThanCanBeCountedIsRefused)
{
    EXPECT_THROW(Pages().allocate(std::numeric_limits<std::size_t>::max() / sizeof(Line)), std::bad_alloc);
    EXPECT_THROW(Pages().allocate(std::numeric_limits<std::size_t>::max()), std::bad_alloc);
}

}  // namespace
}  // namespace zscope::tests
