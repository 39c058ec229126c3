// Once sizes have settled a frame allocates nothing but the few values of its report: operator new is counted here.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "core/frame/renderer.h"
#include "tests/agreement/soups.h"

namespace {

std::atomic<std::uint64_t> allocations = 0, allocatedBytes = 0;

void* counted(std::size_t bytes)
{
    ++allocations;
    allocatedBytes += bytes;
    if (void* memory = std::malloc(bytes > 0 ? bytes : 1)) return memory;
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes); }
void* operator new[](std::size_t bytes) { return counted(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept
{
    ++allocations;
    allocatedBytes += bytes;
    return std::malloc(bytes > 0 ? bytes : 1);
}
void  operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void* operator new(std::size_t bytes, std::align_val_t alignment)
{
    ++allocations;
    allocatedBytes += bytes;
    const auto to = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(to, (bytes + to - 1) / to * to)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace zscope::tests {
namespace {

struct Cost {
    std::uint64_t count, bytes;
};

/// What one frame allocates after some of the same size.
Cost costOfSettledFrame(const Preset& preset, int size, int triangles)
{
    const Soup  soup = makeSoup(SoupKind::NearCrossing, 3, size, size, triangles);
    DrawRequest request;
    request.scene    = std::make_shared<PreparedScene>(soup.scene);
    request.camera   = soup.camera;
    request.pipeline = preset.pipeline;
    request.threads  = 1;  // with more the stripes still move, and scratch memory with them
    Renderer renderer;
    Frame    frame;
    bool     isTrial = true;
    for (int i = 0; i < 3 || isTrial; ++i) {
        const auto report = renderer.draw(request, frame);
        EXPECT_TRUE(report.ok());
        isTrial = report->isTrial;  // of a measured choice: another method follows
    }
    const Cost before{allocations, allocatedBytes};
    EXPECT_TRUE(renderer.draw(request, frame).ok());
    return {allocations - before.count, allocatedBytes - before.bytes};
}

TEST(RendererAllocation, ASettledFrameAllocatesNothingThatGrowsWithSceneOrPicture)
{
    for (const Preset& preset : presets()) {
        if (!hasFastText(preset.pipeline)) continue;
        const Cost small = costOfSettledFrame(preset, 16, 10), large = costOfSettledFrame(preset, 200, 1000);
        if (preset.pipeline.chooser == Chooser::Composed) {  // else times decide which method it is
            EXPECT_EQ(small.count, large.count) << preset.name;
            EXPECT_EQ(small.bytes, large.bytes) << preset.name;
        }
        EXPECT_LT(large.bytes, 4096u) << preset.name << ": the report";
    }
}

TEST(RendererAllocation, TheCountIsReal)
{
    const std::uint64_t before = allocations;
    const auto          value  = std::make_unique<int>(1);
    EXPECT_EQ(allocations, before + 1);
    EXPECT_EQ(*value, 1);
}

}  // namespace
}  // namespace zscope::tests
