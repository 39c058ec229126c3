// A probe is what an algorithm tells at each moment worth pausing on: `probe(ScanlineReady{...})`.
//
// NoProbe      full speed: an empty inline call that the optimiser drops together with the event
// Listening    hands every event to recorders, then decides whether the run stops here
// Events       small aggregates of values already at hand, declared beside the algorithm that makes them. An event
//              with a `grain` is a step; one without is only a fact for recorders and counters
// Stopping     StopAt throws RunStopped right after event k: the run unwinds, and the recorders and buffers, left as
//              they are, are the state after step k. Only serial drivers run with a probe that stops
// Checkpoints  places where a run can begin again from copies of its structures: what else it knows there follows from
//              its inputs and from the decisions it took before. A recorder may send it ahead to one; on the way
//              nothing is told, nothing drawn, and decisions are looked up
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <tuple>

#include "core/probe/grain.h"

namespace zscope {

template <class Recorder, class Event>
concept observes = requires(Recorder recorder, const Event& event)
{
    recorder.observe(event);
};

template <class Recorder, class... Events>
concept observesAll = (observes<Recorder, Events> && ...);

template <class Event>
concept isStep = requires
{
    {
        Event::grain
        } -> std::convertible_to<Grain>;
};

enum class Checkpoint {
    Batch,      // before the vertices of a batch are transformed
    EdgeTable,  // every bucket of the edge table is filled
    Line,       // before a line is swept
};

template <class Recorder>
concept sendsAhead = requires(Recorder recorder, Checkpoint at)
{
    {
        recorder.isOnTheWay()
        } -> std::same_as<bool>;
    {
        recorder.passesBy(at)
        } -> std::same_as<bool>;
};

struct NoProbe {
    static constexpr bool listens = false;

    static constexpr bool isOnTheWay() { return false; }
    static constexpr bool leavesOut(Checkpoint) { return false; }
    template <class Decision>
    static constexpr std::optional<Decision> decided()
    {
        return std::nullopt;
    }

    template <class Event>
    constexpr void operator()(const Event&) const noexcept
    {}
};

/// Thrown by StopAt to unwind a stepped run; caught by the serial driver that started it.
struct RunStopped {};

/// Counts the steps of one grain and all coarser ones, and ends the run after the wanted one.
class StopAt {
public:
    static constexpr std::uint64_t kNever = ~std::uint64_t{0};

    explicit StopAt(Grain grain, std::uint64_t step = kNever) : m_grain(grain), m_step(step) {}

    template <isStep Event>
    void observe(const Event&)
    {
        if (Event::grain > m_grain) return;
        m_lastGrain = Event::grain;
        if (m_seen++ == m_step) throw RunStopped{};
    }

    std::uint64_t seen() const { return m_seen; }
    /// So many of them have happened before the run began.
    void  beginAfter(std::uint64_t seen) { m_seen = seen; }
    Grain lastGrain() const { return m_lastGrain; }

private:
    Grain         m_grain;
    std::uint64_t m_step;
    std::uint64_t m_seen      = 0;
    Grain         m_lastGrain = Grain::Frame;
};

/// Tells each event to every recorder that observes it, in the order given; put StopAt last. At most the first recorder
/// sends the run ahead.
template <class First, class... Others>
class Listening {
public:
    static constexpr bool listens = true;

    explicit Listening(First& first, Others&... others) : m_recorders(first, others...) {}

    template <class Event>
    void operator()(const Event& event) const
    {
        if (isOnTheWay()) return;
        std::apply([&event](auto&... recorder) { (tell(recorder, event), ...); }, m_recorders);
    }

    /// The run is ahead of what is drawn: it has not reached the checkpoint at which it begins.
    bool isOnTheWay() const
    {
        if constexpr (sendsAhead<First>) return std::get<0>(m_recorders).isOnTheWay();
        return false;
    }
    /// The run stands at a checkpoint; true if what follows it, up to the next, was done before.
    bool leavesOut([[maybe_unused]] Checkpoint at) const
    {
        if constexpr (sendsAhead<First>) return std::get<0>(m_recorders).passesBy(at);
        return false;
    }
    /// On the way: what was decided here. Otherwise nothing.
    template <class Decision>
    std::optional<Decision> decided() const
    {
        if constexpr (sendsAhead<First>)
            if (isOnTheWay()) return std::get<0>(m_recorders).lookUp(Decision{});
        return std::nullopt;
    }

private:
    template <class Recorder, class Event>
    static void tell(Recorder& recorder, const Event& event)
    {
        if constexpr (observes<Recorder, Event>) recorder.observe(event);
    }

    std::tuple<First&, Others&...> m_recorders;
};

}  // namespace zscope
