// Recorders: what keeps the reports of a run. A recorder names the events that it wants in a type `Events`, and has an
// observe() for each; or it has a hear() for all of them.
//
// Use        Listening listening(counter, judge); drawObserved(request, frame, scratch, &listening)
// Order      an event goes to the recorders in the order in which they are given; what stops the run comes last
#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include "core/probe/observer.h"

namespace zscope {

template <class... Events>
struct Wants {};

/// The event to observe(), if the recorder wants it.
template <class Recorder, class... Events>
void passOn(const Heard& heard, Recorder& recorder, Wants<Events...>)
{
    const auto observes = [&](const auto* event) {
        if (event) recorder.observe(*event);
        return event != nullptr;
    };
    (observes(heard.template as<Events>()) || ...);
}

template <class... Events>
bool isOneOf(const Heard& heard, Wants<Events...>)
{
    return (heard.template as<Events>() || ...);
}

template <class Recorder>
void passOn(const Heard& heard, Recorder& recorder)
{
    if constexpr (requires { recorder.hear(heard); })
        recorder.hear(heard);
    else
        passOn(heard, recorder, typename Recorder::Events());
}

template <class... Recorders>
class Listening final : public Observer {
public:
    explicit Listening(Recorders&... recorders) : m_recorders(recorders...) {}

    void hear(const Heard& heard) override
    {
        std::apply([&heard](auto&... recorder) { (passOn(heard, recorder), ...); }, m_recorders);
    }

private:
    std::tuple<Recorders&...> m_recorders;
};

/// Counts the steps of one grain and all coarser ones, and ends the run after the wanted one, of which it keeps the
/// sentence.
class StopAt {
public:
    static constexpr std::uint64_t kNever = ~std::uint64_t{0};

    /// `telling` outlives it; nullptr: no sentence is made.
    explicit StopAt(Grain grain, std::uint64_t step = kNever, const Telling* telling = nullptr)
        : m_grain(grain), m_step(step), m_telling(telling)
    {}

    void hear(const Heard& heard)
    {
        if (!heard.isStepOf(m_grain)) return;
        m_last   = &heard.kind;
        m_method = heard.method;
        m_part   = heard.part;
        if (m_seen++ != m_step) return;
        if (m_telling) m_sentence = heard.sentence(*m_telling);
        throw RunStopped{};
    }

    std::uint64_t seen() const { return m_seen; }
    /// So many of them have happened before the run began.
    void  beginAfter(std::uint64_t seen) { m_seen = seen; }
    Grain lastGrain() const { return m_last ? *m_last->grain : Grain::Frame; }
    /// The kind of the last step; nullptr: there was none.
    const EventKind* last() const { return m_last; }
    /// Of the step that ended the run.
    const std::string& sentence() const { return m_sentence; }
    /// Of the last step: the method's call, and the part's statement.
    const SourceLine& method() const { return m_method; }
    const SourceLine& part() const { return m_part; }

private:
    Grain            m_grain;
    std::uint64_t    m_step;
    const Telling*   m_telling;
    std::uint64_t    m_seen = 0;
    const EventKind* m_last = nullptr;
    SourceLine       m_method, m_part;
    std::string      m_sentence;
};

}  // namespace zscope
