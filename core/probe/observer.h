// An Observer hears the events that methods and parts report. A run at full speed has none.
//
// Event      a small aggregate of values already at hand, declared beside the text that makes it. One with a static
//            member `grain` is a step: about() says what it is about, and sentence() says what has happened and by
//            which rule. Any other is a fact for counters and recorders. One that has a member mean() says what it
//            means for triangles and pixels (core/probe/meaning.h)
// Kind       one static object per type of event: an observer compares addresses to find the events that it wants
// Source     each event carries two lines: the method's call, and the part's statement that reported it
// Stopping   an observer may throw RunStopped out of hear(): the run unwinds, and every buffer, left as it is, is the
//            state after that event
// Checkpoint a place where a run can begin again from copies of its buffers. The answers below let an observer send a
//            run ahead to one: on the way nothing is drawn or told, and verdicts are looked up
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>

#include "core/probe/about.h"
#include "core/probe/grain.h"
#include "core/probe/meaning.h"
#include "core/probe/source_line.h"
#include "core/probe/telling.h"

namespace zscope {

template <class Event>
concept isStep = requires
{
    {
        Event::grain
        } -> std::convertible_to<Grain>;
};

struct EventKind {
    std::optional<Grain> grain;  // nothing: not a step
    About (*about)(const void* event);
    std::string (*sentence)(const void* event, const Telling& telling);
    void (*mean)(const void* event, Meanings& to);  // nullptr: nothing
};

template <class Event>
constexpr EventKind eventKind()
{
    EventKind kind{
        {}, [](const void*) { return About(); }, [](const void*, const Telling&) { return std::string(); }, nullptr};
    if constexpr (isStep<Event>) {
        kind.grain    = Event::grain;
        kind.about    = [](const void* event) { return static_cast<const Event*>(event)->about(); };
        kind.sentence = [](const void* event, const Telling& telling) {
            return static_cast<const Event*>(event)->sentence(telling);
        };
    }
    if constexpr (requires(const Event& event, Meanings& to) { event.mean(to); })
        kind.mean = [](const void* event, Meanings& to) { static_cast<const Event*>(event)->mean(to); };
    return kind;
}
template <class Event>
inline constexpr EventKind kEventKind = eventKind<Event>();

/// One event, valid during the call of hear().
struct Heard {
    const EventKind& kind;
    const void*      event;
    SourceLine       method;  // the call in core/method
    SourceLine       part;    // the statement that reports the event

    /// The event, if it is one of this type; else nullptr.
    template <class Event>
    const Event* as() const
    {
        return &kind == &kEventKind<Event> ? static_cast<const Event*>(event) : nullptr;
    }
    About about() const { return kind.about(event); }
    /// Empty if it is no step.
    std::string sentence(const Telling& telling) const { return kind.sentence(event, telling); }
    void        mean(Meanings& to) const
    {
        if (kind.mean) kind.mean(event, to);
    }
    /// Whether it is a step of this grain or of a coarser one.
    bool isStepOf(Grain grain) const { return kind.grain && *kind.grain <= grain; }
};

enum class Checkpoint {
    Batch,     // before the vertices of a batch are transformed
    AllSetUp,  // every bucket of the edge table is filled
    Piece,     // everything is set up, and a part of the picture is next: a line, a triangle, a window
};

class Observer {
public:
    virtual ~Observer() = default;

    virtual void hear(const Heard& heard) = 0;

    /// The run has not yet reached the checkpoint at which it begins.
    virtual bool isOnTheWay() const { return false; }
    /// The run stands at a checkpoint; true if what follows, up to the next one, was done before.
    virtual bool leavesOut(Checkpoint) { return false; }
    /// On the way: the verdict of the next node, as the first run found it (an enumerator of Verdict).
    virtual std::optional<int> knownVerdict() { return std::nullopt; }
};

/// Thrown out of hear() to unwind a run; caught where the run was started.
struct RunStopped {};

}  // namespace zscope
