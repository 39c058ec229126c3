// Laps go to the stages they are named after, and do not take longer together than the clock has lived.
#include <gtest/gtest.h>

#include <chrono>
#include <numeric>

#include "core/base/stage_clock.h"

namespace zscope {
namespace {

double msOf(const StageClock& clock, Stage stage) { return clock.ms()[static_cast<std::size_t>(stage)]; }

/// Until the processor's counter has moved on.
void pass()
{
    for (const std::uint64_t from = ticksNow(); ticksNow() <= from + 1000;) {}
}

TEST(StageClock, LapsGoToTheirStages)
{
    const auto start = std::chrono::steady_clock::now();
    StageClock clock;
    pass();
    clock.lap(Stage::Setup);
    pass();
    clock.lap(Stage::Raster);
    const double before = msOf(clock, Stage::Setup);
    clock.countAllAs(Stage::Prepass);
    pass();
    clock.lap(Stage::Raster);
    clock.countAllAs(std::nullopt);
    pass();
    clock.lap(Stage::Shade);

    const StageMs ms = clock.ms();
    for (const Stage stage : {Stage::Setup, Stage::Raster, Stage::Prepass, Stage::Shade})
        EXPECT_GT(ms[static_cast<std::size_t>(stage)], 0) << wordOf(stage);
    for (const Stage stage : {Stage::Clear, Stage::Transform, Stage::Cull, Stage::Build, Stage::Upkeep, Stage::Other})
        EXPECT_EQ(ms[static_cast<std::size_t>(stage)], 0) << wordOf(stage);
    EXPECT_GT(before, 0);
    const double lived = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    EXPECT_LE(std::accumulate(ms.begin(), ms.end(), 0.0), lived);
}

TEST(StageClock, CountsMilliseconds)
{
    const auto start = std::chrono::steady_clock::now();
    StageClock clock;
    while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(20)) {}
    clock.lap(Stage::Setup);
    EXPECT_GE(msOf(clock, Stage::Setup), 15);
}

}  // namespace
}  // namespace zscope
