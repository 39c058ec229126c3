// What every part is handed, in one piece; and how a part reports what it does.
//
// Borrows    everything: the stripe and its rules belong to the frame, the memory to the thread
// Lines      a function that takes a Call is a step of the method: where a method passes its Work, the conversion to
//            Call notes the line of that statement in the Work. tell() notes the line of its own statement, too
#pragma once

#include "core/base/stage_clock.h"
#include "core/base/tally.h"
#include "core/geometry/rules.h"
#include "core/plain/scratch.h"
#include "core/plain/stripe.h"
#include "core/probe/observer.h"
#include "core/probe/source_line.h"

namespace zscope::plain {

struct Work {
    const Stripe&      stripe;
    const ChosenRules& rules;
    Scratch&           scratch;
    StageClock&        clock;
    Tally&             tally;
    Observer*          observer = nullptr;  // nullptr: the run is not observed

    SourceLine call = SourceLine::here();  // of the part at work, in the method

    template <class Event>
    void tell(const Event& event, SourceLine part = SourceLine::here()) const
    {
        if (observer) observer->hear({kEventKind<Event>, &event, call, part});
    }
    bool isCancelled() const { return stripe.progress.cancelled(); }
    bool leavesOut(Checkpoint at) const { return observer && observer->leavesOut(at); }
};

/// A method's call of a part.
class Call {
public:
    Call(Work& work, SourceLine line = SourceLine::here()) : m_work(work) { work.call = line; }
    Work* operator->() const { return &m_work; }
    Work& operator*() const { return m_work; }

private:
    Work& m_work;
};

}  // namespace zscope::plain
