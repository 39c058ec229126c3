// A probe is what an algorithm tells at each moment worth pausing on: `probe(ScanlineReady{...})`.
//
// NoProbe      full speed: an empty inline call that the optimiser drops together with the event
// Listening    hands every event to recorders, then decides whether the run stops here
// Events       small aggregates of values already at hand, declared beside the algorithm that makes them. An event
//              with a `grain` is a step; one without is only a fact for recorders and counters
// Stopping     StopAt throws RunStopped right after event k: the run unwinds, and the recorders and buffers, left as
//              they are, are the state after step k. Only serial drivers run with a probe that stops
#pragma once

#include <cstdint>
#include <tuple>

#include "core/probe/grain.h"

namespace zscope {

template <class Recorder, class Event>
concept observes = requires(Recorder recorder, const Event& event) { recorder.observe(event); };

template <class Event>
concept isStep = requires { { Event::grain } -> std::convertible_to<Grain>; };

struct NoProbe {
    static constexpr bool listens = false;

    template <class Event>
    constexpr void operator()(const Event&) const noexcept
    {
    }
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
    Grain         lastGrain() const { return m_lastGrain; }

private:
    Grain         m_grain;
    std::uint64_t m_step;
    std::uint64_t m_seen      = 0;
    Grain         m_lastGrain = Grain::Frame;
};

/// Tells each event to every recorder that observes it, in the order given; put StopAt last.
template <class... Recorders>
class Listening {
public:
    static constexpr bool listens = true;

    explicit Listening(Recorders&... recorders) : m_recorders(recorders...) {}

    template <class Event>
    void operator()(const Event& event) const
    {
        std::apply([&event](auto&... recorder) { (tell(recorder, event), ...); }, m_recorders);
    }

private:
    template <class Recorder, class Event>
    static void tell(Recorder& recorder, const Event& event)
    {
        if constexpr (observes<Recorder, Event>) recorder.observe(event);
    }

    std::tuple<Recorders&...> m_recorders;
};

}  // namespace zscope
