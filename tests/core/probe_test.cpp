// Probes: silence costs nothing, listeners hear what they observe, a stop unwinds after the wanted event.
#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

#include "core/probe/probe.h"

namespace zscope {
namespace {

struct Coarse {
    static constexpr Grain grain = Grain::Line;
    int                    value;
};
struct Fine {
    static constexpr Grain grain = Grain::Pixel;
    int                    value;
};
struct Fact {
    int value;
};

static_assert(std::is_empty_v<NoProbe> && std::is_trivial_v<NoProbe> && !NoProbe::listens);
static_assert(noexcept(NoProbe{}(Coarse{1})) && std::is_void_v<decltype(NoProbe{}(Fact{1}))>);
static_assert(
    [] {
        NoProbe{}(Fine{1});
        return true;
    }(),
    "a silent call is a constant expression: it can do nothing");
static_assert(isStep<Coarse> && isStep<Fine> && !isStep<Fact>);
static_assert(observes<StopAt, Coarse> && !observes<StopAt, Fact>);

struct Recorder {
    std::vector<int> heard;
    void             observe(const Coarse& e) { heard.push_back(e.value); }
    void             observe(const Fact& e) { heard.push_back(-e.value); }
};
static_assert(observes<Recorder, Coarse> && observes<Recorder, Fact> && !observes<Recorder, Fine>);

/// Line 1 with pixels 10, 11, line 2 with pixels 20, 21, and so on, the line after its pixels; facts between.
template <class Probe>
void run(const Probe& probe)
{
    for (int line = 1; line <= 3; ++line) {
        probe(Fact{line});
        probe(Fine{line * 10});
        probe(Fine{line * 10 + 1});
        probe(Coarse{line});
    }
}

TEST(Probe, ListenersHearWhatTheyObserveInOrder)
{
    Recorder a, b;
    run(Listening(a, b));
    EXPECT_EQ(a.heard, (std::vector{-1, 1, -2, 2, -3, 3}));
    EXPECT_EQ(a.heard, b.heard);
}

TEST(Probe, StopAtCountsItsGrainAndAllCoarserOnes)
{
    StopAt lines(Grain::Line), pixels(Grain::Pixel), stages(Grain::Stage);
    run(Listening(lines, pixels, stages));
    EXPECT_EQ(lines.seen(), 3u);
    EXPECT_EQ(pixels.seen(), 9u);
    EXPECT_EQ(stages.seen(), 0u);
}

TEST(Probe, StopAtUnwindsRightAfterTheWantedEventAndOthersHaveHeardIt)
{
    for (std::uint64_t step = 0; step < 3; ++step) {
        Recorder recorder;
        StopAt   stop(Grain::Line, step);
        EXPECT_THROW(run(Listening(recorder, stop)), RunStopped);
        EXPECT_EQ(recorder.heard.back(), static_cast<int>(step) + 1);
        EXPECT_EQ(recorder.heard.size(), 2 * (step + 1));
        EXPECT_EQ(stop.seen(), step + 1);
        EXPECT_EQ(stop.lastGrain(), Grain::Line);
    }
    StopAt beyond(Grain::Line, 3);
    EXPECT_NO_THROW(run(Listening(beyond)));
}

TEST(Probe, GrainsAreNamedCoarseToFineAndReadBack)
{
    for (std::size_t i = 0; i < kGrains.size(); ++i) {
        EXPECT_EQ(grainOf(wordOf(kGrains[i])), kGrains[i]);
        if (i > 0) {
            EXPECT_LT(kGrains[i - 1], kGrains[i]);
        }
    }
    EXPECT_FALSE(grainOf("pixels").has_value());
}

}  // namespace
}  // namespace zscope
