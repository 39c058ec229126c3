// Checkpoints of a run: copies of its structures, so that a step can be made without running from the start.
//
// Where      every so many events, at the next place where a run can begin again (core/probe/probe.h)
// What       the picture, the pyramid, the tables of a sweep's line, and everything that the recorders remember. The
//            edge table does not change once it is full, so the run that kept the checkpoints leaves it to those that
//            begin there
// Way        a run that is sent to a checkpoint walks there from the start: stages, instances and nodes as before, by
//            the verdicts that the first run came to; but it draws no batch, sweeps no line, and tells nothing
// Promise    a run from a checkpoint goes on as the first run went on
// Memory     at most what is allowed: when it is used up, every second checkpoint goes, and the next ones are kept
//            twice as far apart
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/cull/cull_events.h"
#include "core/frame/renderer.h"
#include "core/lesson/recorders.h"
#include "core/lesson/step_counter.h"
#include "core/plain/scratch.h"
#include "core/probe/recorders.h"

namespace zscope {

/// Everything that is remembered of a run that is stepped through.
struct RunRecorders {
    RunRecorders(int width, int height) : tests(width, height) {}

    StepCounter       steps;
    SweepRecorder     sweep;
    IntervalRecorder  interval;
    HierarchyRecorder hierarchy;
    TriangleRecorder  triangle;
    PixelRecorder     pixel;
    TestCounter       tests;
    CurrentStage      stage;

    void hear(const Heard& heard)
    {
        steps.hear(heard);
        if (const auto* tested = heard.as<PixelTested>()) {  // most events: straight to those who want it
            pixel.observe(*tested);
            tests.observe(*tested);
            triangle.observe(*tested);
            return;
        }
        passOn(heard, pixel);
        passOn(heard, tests);
        passOn(heard, triangle);
        passOn(heard, sweep);
        passOn(heard, interval);
        passOn(heard, hierarchy);
        passOn(heard, stage);
    }

    std::size_t bytes() const { return sizeof(*this) + sweep.bytes() + hierarchy.bytes() + tests.bytes(); }
};

/// What a run works on, as it stands.
struct RunState {
    RunRecorders        recorders;
    VisibilityBuffer    visible;
    Grid<std::uint32_t> colour;  // empty unless fragments are shaded as they come
    Pyramid             pyramid;
    plain::ActiveEdges  active;
    NodeMemory          memory;

    std::size_t bytes() const
    {
        return recorders.bytes() + visible.bytes() + colour.values().size_bytes() + pyramid.bytes() + active.bytes()
               + memory.bytes();
    }
};

struct KeptState {
    std::uint64_t place    = 0;  // of all places that the run passes
    std::size_t   verdicts = 0;  // that it has come to before
    RunState      state;
};

/// The checkpoints of one run over one request, and the verdicts it came to.
struct Checkpoints {
    std::vector<std::unique_ptr<const KeptState>> kept;  // in the order of the run
    std::vector<Verdict>                          verdicts;

    /// The last one at which at most `seen` steps of a grain have happened; nullptr: none.
    const KeptState* lastBefore(Grain grain, std::uint64_t seen) const;
};

/// A run as it works: what its checkpoints are copied from, and to.
struct RunInWork {
    RunRecorders&   recorders;
    Frame&          frame;
    plain::Scratch& scratch;
    StopAt&         stop;
    Grain           stopGrain;
};

/// What keeps the checkpoints of a run, or sends it to one of them; hears each event first.
class CheckpointKeeper {
public:
    /// `byBatches`: the run can begin again before any batch; else only where everything is set up.
    CheckpointKeeper(const RunInWork& run, bool byBatches) : m_run(run), m_byBatches(byBatches) {}

    /// Keeps one every `events` events, in at most `bytes`.
    void keepIn(Checkpoints& checkpoints, std::uint64_t events, std::size_t bytes);
    /// Sends the run to one of them; what coherence takes over from the frame before is there then.
    void beginAt(const KeptState& from, const Checkpoints& checkpoints);

    void hear(const Heard& heard)
    {
        ++m_events;
        if (!m_keepsIn) return;
        if (const auto* judged = heard.as<NodeJudged>()) m_keepsIn->verdicts.push_back(judged->verdict);
    }

    bool    isOnTheWay() const { return m_from != nullptr; }
    bool    passesBy(Checkpoint at);
    Verdict knownVerdict() { return m_checkpoints->verdicts[m_nextVerdict++]; }

private:
    void keep(std::uint64_t place);
    void restore();

    RunInWork     m_run;
    bool          m_byBatches;
    std::uint64_t m_places = 0;  // passed
    std::uint64_t m_events = 0;  // heard

    Checkpoints*  m_keepsIn = nullptr;
    std::uint64_t m_apart   = 0;  // events
    std::uint64_t m_nextAt  = 0;  // events
    std::size_t   m_bytes = 0, m_mostBytes = 0;

    const KeptState*   m_from        = nullptr;  // nullptr: the run is not on its way
    const Checkpoints* m_checkpoints = nullptr;
    std::size_t        m_nextVerdict = 0;
};

}  // namespace zscope
