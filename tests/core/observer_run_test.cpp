// Observers: recorders hear the events that they want, in order; a stop unwinds after the wanted event.
#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "core/probe/recorders.h"

namespace zscope {
namespace {

struct Coarse {
    static constexpr Grain grain = Grain::Line;
    int                    value;

    About       about() const { return {.line = value}; }
    std::string sentence(const Telling& telling) const
    {
        return "line " + std::to_string(value) + " of " + std::to_string(telling.triangles());
    }
};
struct Fine {
    static constexpr Grain grain = Grain::Pixel;
    int                    value;

    About       about() const { return {.won = value > 20}; }
    std::string sentence(const Telling&) const { return "pixel " + std::to_string(value); }
};
struct Fact {
    int value;
};
static_assert(isStep<Coarse> && isStep<Fine> && !isStep<Fact>);

struct Recorder {
    using Events = Wants<Coarse, Fact>;

    std::vector<int> heard;
    void             observe(const Coarse& e) { heard.push_back(e.value); }
    void             observe(const Fact& e) { heard.push_back(-e.value); }
};

template <class Event>
void tell(Observer& observer, const Event& event, SourceLine part = SourceLine::here())
{
    observer.hear({kEventKind<Event>, &event, {"method", 1, "method"}, part});
}

/// Line 1 with pixels 10, 11, line 2 with pixels 20, 21, and so on, the line after its pixels; facts between.
void run(Observer&& observer)
{
    for (int line = 1; line <= 3; ++line) {
        tell(observer, Fact{line});
        tell(observer, Fine{line * 10});
        tell(observer, Fine{line * 10 + 1});
        tell(observer, Coarse{line});
    }
}

TEST(Observer, RecordersHearWhatTheyWantInOrder)
{
    Recorder a, b;
    run(Listening(a, b));
    EXPECT_EQ(a.heard, (std::vector{-1, 1, -2, 2, -3, 3}));
    EXPECT_EQ(a.heard, b.heard);
}

TEST(Observer, AnEventSaysWhatItIsAboutWhateverItsType)
{
    struct Lines {
        std::vector<int> lines;
        std::size_t      won = 0;

        void hear(const Heard& heard)
        {
            const About about = heard.about();
            if (about.line) lines.push_back(*about.line);
            won += about.won.value_or(false);
        }
    } recorder;
    run(Listening(recorder));
    EXPECT_EQ(recorder.lines, (std::vector{1, 2, 3}));
    EXPECT_EQ(recorder.won, 3u);
}

TEST(Observer, AStopKnowsTheLineOfTheStatementAndTheLineOfTheCall)
{
    StopAt stop(Grain::Line, 1);
    EXPECT_THROW(run(Listening(stop)), RunStopped);
    EXPECT_TRUE(std::string_view(stop.part().file).ends_with("observer_run_test.cpp"));
    EXPECT_EQ(std::string_view(stop.part().function), "run");
    EXPECT_EQ(std::string_view(stop.method().file), "method");
}

TEST(Observer, TheSentenceIsMadeOnceWhenTheRunStops)
{
    struct Counted : Telling {
        mutable int asked = 0;

        bool          drawsFaces() const override { return false; }
        std::uint64_t triangles() const override { return ++asked, 12; }
        std::uint64_t coveredPixels() const override { return 0; }
        std::uint64_t pixelsWon() const override { return 0; }
        float         background() const override { return 0; }
    } telling;
    StopAt lines(Grain::Line, 2, &telling), pixels(Grain::Pixel, 1, &telling);
    EXPECT_THROW(run(Listening(lines)), RunStopped);
    EXPECT_EQ(lines.sentence(), "line 3 of 12");
    EXPECT_EQ(telling.asked, 1);
    EXPECT_TRUE(lines.last() == &kEventKind<Coarse>);
    EXPECT_THROW(run(Listening(pixels)), RunStopped);
    EXPECT_EQ(pixels.sentence(), "pixel 11");
    EXPECT_TRUE(pixels.last() == &kEventKind<Fine>);
    EXPECT_FALSE(pixels.last() == &kEventKind<Coarse>);
}

TEST(Observer, StopAtCountsItsGrainAndAllCoarserOnes)
{
    StopAt lines(Grain::Line), pixels(Grain::Pixel), stages(Grain::Stage);
    run(Listening(lines, pixels, stages));
    EXPECT_EQ(lines.seen(), 3u);
    EXPECT_EQ(pixels.seen(), 9u);
    EXPECT_EQ(stages.seen(), 0u);
}

TEST(Observer, StopAtUnwindsRightAfterTheWantedEventAndOthersHaveHeardIt)
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

TEST(Grain, GrainsAreNamedCoarseToFineAndReadBack)
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
